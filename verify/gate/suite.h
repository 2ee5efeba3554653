// SPDX-License-Identifier: MIT
// A suite: scenes and the limits that they are held to, read from a TOML file. verify/suites has
// ours; cases of dsc_bench (bench/steps/suite.h) may stand in the same file.
//
//     every_case_has = ["inverted", "min_quality"]   # a case without a limit for these is refused
//
//     [limits]                    # of every case, unless it has its own; checks are those of
//     inverted = 0                # `dsc_verify list`
//
//     [defaults]                  # what limits leave out, by check
//     min_quality = { rule = "a tenth below", orders = 51 }
//
//     [[case]]
//     scene = "swirl"             # of `dsc_scene list`, or a scene file, whose path begins at this
//                                 # file; or a list of scenes
//     name = "mine"               # of its rows; unless given, the scene's own
//     h = 0.01                    # the edge length, unless it is the scene's own; or a list: a
//                                 # case for each, called "mine h:0.01"
//     set = { insertion = "linear" }           # keys of `dsc_scene run --set`
//     starts = 4                  # for checks of the reference: the mean over so many, unless 1
//     strategies = ["cells"]      # that are compared with `sequential`; unless given, all parallel
//                                 # ones
//     threads = [1, 2]            # of these; unless given, 2, and for mesh_hash 1, 2, 3 and 5
//
//     [case.limits]
//     area_ratio = 5e-4           # at most, or for qualities and angles at least; or
//     min_quality = { at_least = 0.26, measured = 0.3, rule = "a tenth below", orders = 51 }
//     fluid_centre = { around = 1.0819, at_most = 5e-4 }    # a published figure, to so much
//
// The rules: "required" (unless given), "half as much again", "a tenth above", "a tenth below",
// "less 15 %", and "kept" from a measurement that was better. A limit that does not stand in that
// ratio to `measured` is refused. `orders` says that it was the worst of so many shuffled orders of
// the interface, `note` is for people, and `at` says by which commit, when and where it was
// measured; `dsc_verify propose --update` writes all but the note.
#pragma once

#include "checks.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dsc::gate {

using Cases = std::vector<std::shared_ptr<const Case>>;

/// Throws InputError with file, line, key, value and what is allowed; also for files that cannot be
/// read.
[[nodiscard]] Cases read_suite(const std::filesystem::path& path);
/// The same from a text that is called `path` in errors. Cases need no limits in one that is about
/// to get them.
[[nodiscard]] Cases read_suite_text(const std::string& text, const std::filesystem::path& path,
                                    bool needs_limits = true);

/// A scene file, held to its [limits]; the checks are named after the keys: `limits.sd_rel_last`,
/// or `limits.area_ratio.least` where both bounds are given. Throws InputError if it has none.
[[nodiscard]] Case case_of_file(const std::string& path);

/// The scene as it is, held to nothing yet: `scene` is of the catalogue, or a file.
[[nodiscard]] Case case_of_scene(const std::string& scene);

/// True for a file with cases; false for one with a scene. Throws InputError for what is no TOML,
/// and for files that cannot be read.
[[nodiscard]] bool is_suite(const std::string& path);

/// Throws InputError if two cases have a limit of one check under one name.
void check_names(const Cases& cases);

} // namespace dsc::gate

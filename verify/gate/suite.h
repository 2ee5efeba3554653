// SPDX-License-Identifier: MIT
// A suite: scenes and their limits, read from a TOML file. verify/suites has those of the project;
// the same file may have cases of dsc_bench (bench/steps/suite.h).
//
//     every_case_has = ["inverted", "min_quality"]   # a case without a limit for these is refused
//
//     [limits]                    # of every case, unless it has its own; checks are those of
//     inverted = 0                # `dsc_verify list`
//
//     [defaults]                  # defaults of limits, by check
//     min_quality = { rule = "a tenth below", orders = 51 }
//
//     [[case]]
//     scene = "swirl"             # of `dsc_scene list`, or a scene file, relative to this file; or
//                                 # a list of scenes
//     name = "mine"               # of its rows; default: the scene's name
//     h = 0.01                    # the edge length; default: the scene's own; a list makes a case
//                                 # for each, called "mine h:0.01"
//     set = { insertion = "linear" }           # keys of `dsc_scene run --set`
//     starts = 4                  # number averaged by checks of the reference (default 1)
//     strategies = ["cells"]      # compared with `sequential`; default: all parallel ones
//     threads = [1, 2]            # of these; default: 2, and for mesh_hash 1, 2, 3 and 5
//
//     [case.limits]
//     area_ratio = 5e-4           # at most, or for qualities and angles at least; or
//     min_quality = { at_least = 0.26, measured = 0.3, rule = "a tenth below", orders = 51 }
//     fluid_centre = { around = 1.0819, at_most = 5e-4 }    # a published figure; its error
//     median_quality = { at_most = 0.01, measured = 0.006, around = 0.87, orders = 51 }
//     quality_histogram = { at_most = 0.03, measured = 0.02, orders = 51, histogram = [0, 1, ...] }
//
// The rules: "required" (the default), "half as much again", "a tenth above", "a tenth below",
// "less 15 %", and "kept" from a better measurement. A limit whose ratio to `measured` does not
// follow its rule is refused. `orders` is the number of shuffled orders of the interface, of which
// `measured` is the worst; `note` is a comment; `at` is the commit, date and machine of the
// measurement. A stored histogram is the sum over these orders, and a stored median the median of
// them. `dsc_verify propose --update` writes all but the note.
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
/// The same from a text; errors call it `path`. Cases need no limits in a suite that is about to be
/// updated.
[[nodiscard]] Cases read_suite_text(const std::string& text, const std::filesystem::path& path,
                                    bool needs_limits = true);

/// A scene file with its [limits]; the checks are named after the keys: `limits.sd_rel_last`, or
/// `limits.area_ratio.min` where both bounds are given. Throws InputError if it has none.
[[nodiscard]] Case case_of_file(const std::string& path);

/// A scene without limits: `scene` is a scene of the catalogue, or a file.
[[nodiscard]] Case case_of_scene(const std::string& scene);

/// True for a file with cases; false for one with a scene. Throws InputError for files that are not
/// TOML or cannot be read.
[[nodiscard]] bool is_suite(const std::string& path);

/// Throws InputError if two cases of one name have a limit for the same check.
void check_names(const Cases& cases);

} // namespace dsc::gate

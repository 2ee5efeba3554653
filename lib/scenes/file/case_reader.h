// SPDX-License-Identifier: MIT
// A [[case]] of a suite, read key by key; errors name the file, line, key, value and what is
// allowed. dsc_bench and dsc_verify read the same files: each reads its own keys and ignores those
// of the other.
#pragma once

#include "dsc/base/error.h"
#include "scenes/file/scene_file.h"
#include "scenes/file/table_reader.h"

#include <string>
#include <vector>

namespace dsc::scenes {

/// The keys of a suite and of a case that only dsc_verify reads.
[[nodiscard]] std::vector<std::string> keys_of_verify();
[[nodiscard]] std::vector<std::string> case_keys_of_verify();
/// The keys of a case that only dsc_bench reads.
[[nodiscard]] std::vector<std::string> case_keys_of_bench();

/// A [[case]] and one of its `rows`, whose keys override those of the case.
class CaseReader {
public:
    CaseReader(const TableReader& whole, const TableReader* row) : whole_(&whole), row_(row) {}

    [[nodiscard]] bool has(const std::string& key) const {
        return whole_->has(key) || (row_ != nullptr && row_->has(key));
    }
    /// The table that has the key; the row's table if neither has it.
    [[nodiscard]] const TableReader& of(const std::string& key) const {
        const bool is_of_row = row_ != nullptr && (row_->has(key) || !whole_->has(key));
        return is_of_row ? *row_ : *whole_;
    }
    [[nodiscard]] bool is_text(const std::string& key) const { return of(key).is_text(key); }
    [[nodiscard]] bool is_text(const std::string& key, const std::string& text) const {
        return is_text(key) && of(key).text(key) == text;
    }
    [[nodiscard]] std::string where(const std::string& key) const { return of(key).where(key); }
    [[noreturn]] void refuse(const std::string& key, const std::string& what,
                             const std::string& allowed) const {
        of(key).refuse(of(key).has(key) ? key : "", what, allowed);
    }

private:
    const TableReader* whole_;
    const TableReader* row_;
};

/// Lists; a single value is a list of one. Throws InputError also for an empty list.
[[nodiscard]] std::vector<std::string> texts(const CaseReader& reader, const std::string& key);
[[nodiscard]] std::vector<int> integers(const CaseReader& reader, const std::string& key, int low,
                                        int high);
[[nodiscard]] std::vector<double> numbers(const CaseReader& reader, const std::string& key,
                                          Bounds bounds);

/// A size of a case: its name in rows, and the edge length; 0: the scene's default.
struct CaseSize {
    std::string name{};
    double h = 0;
};

/// The sizes in `h` or `triangles`; the scene's default if neither is given.
[[nodiscard]] std::vector<CaseSize> read_sizes(const CaseReader& reader);

/// A scene of the catalogue, or of a file whose path is relative to the suite.
[[nodiscard]] SceneFile read_scene(const CaseReader& reader, const std::string& name);

/// Sets the parameters that the table under `key` names, if there is one; `allowed`: the scene's
/// keys.
void read_settings(const CaseReader& reader, const std::string& key,
                   const std::vector<std::string>& allowed, Parameters& parameters);

} // namespace dsc::scenes

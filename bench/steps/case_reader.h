// SPDX-License-Identifier: MIT
// A [[case]] of a suite, read key by key; what is wrong is said with file, line, key, value and
// what is allowed.
#pragma once

#include "dsc/base/error.h"
#include "scenes/file/table_reader.h"
#include "scenes/scene.h"

#include <string>
#include <vector>

namespace dsc::bench {

/// A [[case]] and one of its `rows`, whose keys win over those of the case.
class CaseReader {
public:
    CaseReader(const scenes::TableReader& whole, const scenes::TableReader* row)
        : whole_(&whole), row_(row) {}

    [[nodiscard]] bool has(const std::string& key) const {
        return whole_->has(key) || (row_ != nullptr && row_->has(key));
    }
    /// The table in which the key stands, or that of the row where it stands in neither.
    [[nodiscard]] const scenes::TableReader& of(const std::string& key) const {
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
    const scenes::TableReader* whole_;
    const scenes::TableReader* row_;
};

/// Calls `what`, which may refuse what stands under a key: the error then names that place.
template <class What>
auto at_key(const scenes::TableReader& reader, const std::string& key, What what) {
    try {
        return what();
    } catch (const InputError& error) {
        throw InputError({.what = error.problem(),
                          .where = reader.where(key),
                          .value = error.value(),
                          .allowed = error.allowed()});
    }
}

/// Lists; a single value stands for a list of one. Throws InputError for an empty one, too.
[[nodiscard]] std::vector<std::string> texts(const CaseReader& reader, const std::string& key);
[[nodiscard]] std::vector<int> integers(const CaseReader& reader, const std::string& key, int low,
                                        int high);
[[nodiscard]] std::vector<double> numbers(const CaseReader& reader, const std::string& key,
                                          scenes::Bounds bounds);

/// A scene of the catalogue, or that of a file whose path begins at the suite.
[[nodiscard]] scenes::Scene read_scene(const CaseReader& reader, const std::string& name);

/// Sets the parameters that the table under `key` names, if there is one.
void read_settings(const CaseReader& reader, const std::string& key, const scenes::Scene& scene,
                   scenes::Parameters& parameters);

} // namespace dsc::bench

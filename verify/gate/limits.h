// SPDX-License-Identifier: MIT
// The limits file: what each check may measure at most (or at least), and where the figure comes
// from. It is written by hand, or proposed by `dsc_verify propose` and then looked at; a missing
// limit is never filled in automatically.
#pragma once

#include <map>
#include <string>
#include <utility>

namespace dsc::gate {

struct Limit {
    double value = 0;
    std::string note; ///< where the value comes from
};

class Limits {
public:
    /// None yet; `path` is named in errors.
    explicit Limits(std::string path) : path_(std::move(path)) {}

    /// {"limits": {CHECK: {SCENE: {"value": 1e-3, "note": "..."}}}}; a "band" beside the value is
    /// for people. Throws FileError if the file cannot be read, InputError if it is incomplete or
    /// contains something else.
    static Limits read(const std::string& path);

    void add(const std::string& check, const std::string& scene, Limit limit) {
        limits_[{check, scene}] = std::move(limit);
    }
    [[nodiscard]] bool has(const std::string& check, const std::string& scene) const {
        return limits_.contains({check, scene});
    }
    /// Throws InputError if there is none.
    [[nodiscard]] const Limit& find(const std::string& check, const std::string& scene) const;

    using Key = std::pair<std::string, std::string>; ///< check and scene
    [[nodiscard]] const std::map<Key, Limit>& all() const { return limits_; }
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
    std::map<Key, Limit> limits_;
};

} // namespace dsc::gate

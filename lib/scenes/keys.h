// SPDX-License-Identifier: MIT
// The keys of a scene's parameters, in one table: what `--set key=value` accepts and refuses, what
// help texts say about it, and what result files contain are all taken from it.
#pragma once

#include "scenes/parameters.h"

#include <functional>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

namespace dsc::scenes {

/// The value of a key, as printed in result files.
using Setting = std::variant<double, int, std::uint64_t, std::string>;

/// As --set takes it; doubles in as many digits as they need.
[[nodiscard]] std::string text_of(const Setting& setting);

struct Key {
    std::string name;
    std::string allowed; ///< the values it accepts, with their unit, for errors and help texts
    /// Sets it from text. Returns false, and sets nothing, if the text is not an allowed value.
    std::function<bool(Parameters&, const std::string& text)> parse;
    std::function<Setting(const Parameters&)> value;
    bool is_common = true; ///< every scene takes it; otherwise only those that name it
};

/// All of them, in the order used in result files.
[[nodiscard]] const std::vector<Key>& parameter_keys();

/// The names of those that every scene takes, and of more.
[[nodiscard]] std::vector<std::string> common_keys(std::initializer_list<const char*> more = {});

/// All keys with their values, " h=0.02 dt=0.01": the same for no two different parameters.
[[nodiscard]] std::string text_of(const Parameters& parameters);

/// Sets one key from text. Throws InputError for a key that is not one of `keys` (naming those), a
/// value that is not a number, or one out of range; then nothing has changed.
void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& key, const std::string& value);

/// The same for "key=value".
void apply_setting(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& setting);

} // namespace dsc::scenes

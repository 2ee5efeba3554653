// SPDX-License-Identifier: MIT
// The keys of a scene's parameters, in one table, from which `--set key=value`, help texts and
// result files are derived.
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

/// The text for --set; doubles have as many digits as needed to be read back exactly.
[[nodiscard]] std::string text_of(const Setting& setting);

struct Key {
    std::string name;
    std::string allowed; ///< allowed values with their unit, for errors and help texts
    /// Sets it from text. Returns false, and sets nothing, if the text is not an allowed value.
    std::function<bool(Parameters&, const std::string& text)> parse;
    std::function<Setting(const Parameters&)> value;
    bool is_common = true; ///< accepted by all scenes; otherwise only by those that list it
};

/// All of them, in the order used in result files.
[[nodiscard]] const std::vector<Key>& parameter_keys();

/// The names of the keys of all scenes, followed by `more`.
[[nodiscard]] std::vector<std::string> common_keys(std::initializer_list<const char*> more = {});

/// All keys with their values, " h=0.02 dt=0.01": different for different parameters.
[[nodiscard]] std::string text_of(const Parameters& parameters);

/// Sets one key from text. Throws InputError, and changes nothing, for a key that is not one of
/// `keys` (listing those), and for a value that is not allowed.
void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& key, const std::string& value);

/// The same for "key=value".
void apply_setting(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& setting);

} // namespace dsc::scenes

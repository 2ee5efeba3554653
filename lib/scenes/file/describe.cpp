// SPDX-License-Identifier: MIT
#include "scenes/file/describe.h"

#include "dsc/base/error.h"
#include "scenes/keys.h"

#include <algorithm>
#include <variant>

namespace dsc::scenes {

namespace {

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

// Names, and integers too large for TOML, are quoted.
bool needs_quotes(const Setting& setting) {
    const auto* number = std::get_if<std::uint64_t>(&setting);
    return std::holds_alternative<std::string>(setting) ||
           (number != nullptr && *number > INT64_MAX);
}

std::string options_in_toml(const Scene& scene, const Parameters& parameters) {
    std::string text = "[options]\n";
    for (const Key& key : parameter_keys()) {
        if (std::ranges::find(scene.keys, key.name) == scene.keys.end()) {
            continue;
        }
        const Setting value = key.value(parameters);
        const std::string written = text_of(value);
        // A dt, steps or period of 0 means the scene's own choice, which cannot be written.
        Parameters read;
        text +=
            key.parse(read, written)
                ? key.name + " = " + (needs_quotes(value) ? in_quotes(written) : written) + " # "
                : "# " + key.name + ": ";
        text += key.allowed + '\n';
    }
    return text;
}

} // namespace

std::string describe(const Scene& scene, const Parameters& parameters) {
    const Setup setup = scene.prepare(parameters);
    return "# The scene " + scene.name +
           " as a file: change what you like, and run it by `dsc_scene run FILE.toml`.\n# It has " +
           std::to_string(setup.steps) + " steps of " + to_text(setup.dt) +
           ". A table that you add replaces that of the scene: [domain], [[shape]] or\n"
           "# [[curve]]; [flow], [curvature], [growth] or [fluid]; [sizes]; [exact].\n"
           "name = " +
           in_quotes(scene.name) + "\nscene = " + in_quotes(scene.name) + "\n\n" +
           options_in_toml(scene, parameters);
}

} // namespace dsc::scenes

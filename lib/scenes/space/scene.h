// SPDX-License-Identifier: MIT
// Scenes in three dimensions: a shape, a flow, and the exact shape.
#pragma once

#include "dsc3/algorithm/simulation.h"
#include "dsc3/initial/initial_complex.h"
#include "scenes/parameters.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes::space {

/// A scene with its parameters filled in.
struct Setup {
    dsc3::Box domain{};
    std::vector<dsc3::Shape> shapes{}; ///< the phase of the first shape is measured
    dsc3::Velocity velocity{};
    double dt = 0;
    int steps = 0;
    std::optional<int> half_step{}; ///< step at which a flow that conserves volume turns back
    dsc3::Distance last{};          ///< the exact shape at the end; empty: unknown
    double volume_last = 0;         ///< volume of the exact shape at the end
    std::optional<std::int64_t> euler_first{}; ///< Euler number of the surface in a file
};

struct Scene {
    std::string name;
    std::string description;
    std::string section; ///< the section of the thesis, or "3D"
    Parameters defaults{};
    std::function<Setup(const Parameters&)> prepare{};
    std::vector<std::string> keys{"h", "steps", "integrator"}; ///< that --set accepts
};

/// All scenes in three dimensions.
[[nodiscard]] const std::vector<Scene>& catalogue();

/// The scene of that name; null if there is none in three dimensions.
[[nodiscard]] const Scene* find_scene(const std::string& name);

} // namespace dsc::scenes::space

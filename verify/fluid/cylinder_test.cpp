// SPDX-License-Identifier: MIT
// The benchmark 2D-1 of M. Schäfer and S. Turek, "Benchmark computations of laminar flow around a
// cylinder" (1996): the flow past a cylinder becomes steady. Exact coefficients by G. Nabh (1998).
#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace dsc::scenes::cylinder_test {
namespace {

constexpr double exact_drag = 5.57953523384;
constexpr double exact_lift = 0.010618948146;

TEST(FluidCylinder, DragAndLiftAreThoseOfTheBenchmark) {
    const SceneFile file = read_scene_file(std::filesystem::path(DSC_EXAMPLES) / "cylinder.toml");
    Parameters parameters = file.scene.defaults;
    for (const char* setting : {"h=0.005", "dt=0.02", "steps=400"}) {
        apply_setting(parameters, file.scene.keys, setting);
    }
    const RunResult result = run_scene(file.scene, parameters, {});
    EXPECT_TRUE(result.holds());
    // With a radius of 0.05, a density of 1 and a mean velocity of 0.2.
    EXPECT_NEAR(500 * number(result.fluid, "force_x_cylinder_last") / exact_drag, 1, 2e-3);
    EXPECT_NEAR(500 * number(result.fluid, "force_y_cylinder_last") / exact_lift, 1, 5e-2);
}

} // namespace
} // namespace dsc::scenes::cylinder_test

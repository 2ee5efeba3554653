// SPDX-License-Identifier: MIT
// The families of scenes, each in the file of its name, and shared parts.
#pragma once

#include "scenes/scene.h"
#include "shapes/curve.h"

namespace dsc::scenes {

[[nodiscard]] std::vector<Scene> translation_scenes();
[[nodiscard]] std::vector<Scene> scaling_scenes();
[[nodiscard]] std::vector<Scene> rotation_scenes();
[[nodiscard]] std::vector<Scene> vortex_scenes();
[[nodiscard]] std::vector<Scene> interpolation_scenes();
[[nodiscard]] std::vector<Scene> zalesak_scenes();
[[nodiscard]] std::vector<Scene> swirl_scenes();
[[nodiscard]] std::vector<Scene> speedup_scenes();
[[nodiscard]] std::vector<Scene> quality_scenes();
[[nodiscard]] std::vector<Scene> curvature_scenes();
[[nodiscard]] std::vector<Scene> growth_scenes();
[[nodiscard]] std::vector<Scene> network_scenes();
[[nodiscard]] std::vector<Scene> pool_scenes();
[[nodiscard]] std::vector<Scene> fluid_scenes();

/// An empty scene with a time step and a number of steps: given values are kept; missing ones
/// follow from the duration. Throws InputError for more than 100,000,000 steps.
[[nodiscard]] Setup scheduled(const Parameters& parameters, double duration, double default_dt);

// `about` has the name of the scene, its description and its section.

/// A circle in the middle of the domain that grows to four times its radius.
[[nodiscard]] Scene scaling_scene(Scene about, double h);
/// One rigid turn about the middle of the domain, in `steps` steps.
[[nodiscard]] Scene rotation_scene(Scene about, double h, int steps,
                                   std::function<Outline(double h)> outline);

/// A curve in a flow that turns back half-way: `steps` is the number of steps each way.
[[nodiscard]] Scene there_and_back_scene(Scene about, double h, double dt, int steps,
                                         const Velocity& velocity, const ParametricCurve& curve,
                                         std::function<Outline(double h)> outline);

} // namespace dsc::scenes

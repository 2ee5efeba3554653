// SPDX-License-Identifier: MIT
// A velocity field in world coordinates, for a complex in unit coordinates.
#pragma once

#include "dsc/geometry/unit_map.h"
#include "dsc/motion/integrator.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dsc {

/// `world` is called in world coordinates, in doubles also for a complex in float, for 128
/// positions at a time. The result is for `Simulation::step`, and as safe for threads as `world`.
template <class Real>
[[nodiscard]] Velocity<Real> velocity_to_unit(const UnitMap& map, Velocity<double> world) {
    return [map, world = std::move(world)](std::span<const Point<Real>> positions, Real time,
                                           std::span<Point<Real>> velocities) {
        constexpr std::size_t block = 128;
        std::array<Point<double>, block> at;
        std::array<Point<double>, block> speed;
        for (std::size_t begin = 0; begin < positions.size(); begin += block) {
            const std::size_t count = std::min(block, positions.size() - begin);
            for (std::size_t i = 0; i < count; ++i) {
                at[i] = to_world(map, positions[begin + i].template cast<double>());
            }
            world(std::span<const Point<double>>(at.data(), count), static_cast<double>(time),
                  std::span<Point<double>>(speed.data(), count));
            for (std::size_t i = 0; i < count; ++i) {
                velocities[begin + i] = Point<double>(length_to_unit(map, speed[i].x()),
                                                      length_to_unit(map, speed[i].y()))
                                            .template cast<Real>();
            }
        }
    };
}

} // namespace dsc

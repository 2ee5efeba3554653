// SPDX-License-Identifier: MIT
// Conversions between world coordinates and a frame.
#pragma once

#include "dsc/initial/initial_complex.h"
#include "dsc/motion/integrator.h"

#include <utility>
#include <vector>

namespace dsc::test {

inline Point<double> to_frame(const Frame& frame, const Point<double>& world) {
    return (world - frame.origin) / frame.unit;
}

/// Rounds if the origin is not zero.
inline Point<double> to_world(const Frame& frame, const Point<double>& p) {
    return frame.origin + p * frame.unit;
}

/// `world` is called with world coordinates, in doubles also for a complex in float.
template <class Real>
Velocity<Real> velocity_in(const Frame& frame, Velocity<double> world) {
    return [frame, world = std::move(world)](std::span<const Point<Real>> positions, Real time,
                                             std::span<Point<Real>> velocities) {
        std::vector<Point<double>> at;
        for (const Point<Real>& p : positions) {
            at.push_back(to_world(frame, p.template cast<double>()));
        }
        std::vector<Point<double>> speed(at.size());
        world(at, static_cast<double>(time), speed);
        for (std::size_t i = 0; i < speed.size(); ++i) {
            velocities[i] = Point<double>(speed[i] / frame.unit).template cast<Real>();
        }
    };
}

} // namespace dsc::test

// SPDX-License-Identifier: MIT
#include "flows/velocity.h"

#include "dsc/base/error.h"
#include "flows/sine_cosine.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace dsc::scenes {

namespace {

using Positions = std::span<const Point<double>>;
using Velocities = std::span<Point<double>>;

// A batch is read as one sequence of coordinates: x, y, x, y, ...
static_assert(sizeof(Point<double>) == 2 * sizeof(double));

/// Points per block of the swirl: its sines and cosines stay in the first-level cache.
constexpr std::size_t block = 128;

} // namespace

void Translation::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    std::fill_n(velocities.begin(), positions.size(), velocity);
}

void Radial::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double x = positions[i].x() - centre.x();
        const double y = positions[i].y() - centre.y();
        const double distance = std::sqrt(x * x + y * y);
        const double factor = distance > 0.0 ? speed / distance : 0.0;
        velocities[i] = {factor * x, factor * y};
    }
}

void Rotation::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double x = positions[i].x() - centre.x();
        const double y = positions[i].y() - centre.y();
        velocities[i] = {-angular_speed * y, angular_speed * x};
    }
}

void Vortex::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double x = positions[i].x() - centre.x();
        const double y = positions[i].y() - centre.y();
        const double distance = std::sqrt(x * x + y * y);
        const double factor = distance > 0.0 ? speed / distance : 0.0;
        velocities[i] = {-factor * y, factor * x};
    }
}

void Swirl::operator()(Positions positions, double time, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    const double factor =
        period != 0.0 ? amplitude * std::cos(std::numbers::pi * (time / period)) : amplitude;
    std::array<double, 2 * block> sine;
    std::array<double, 2 * block> cosine;
    for (std::size_t begin = 0; begin < positions.size(); begin += block) {
        const std::size_t count = std::min(block, positions.size() - begin);
        sine_cosine_pi(positions[begin].data(), 2 * count, sine.data(), cosine.data());
        double* out = velocities[begin].data();
        for (std::size_t i = 0; i < count; ++i) {
            const double sx = sine[2 * i];
            const double sy = sine[2 * i + 1];
            const double common = 2.0 * factor * sx * sy;
            out[2 * i] = common * sx * cosine[2 * i + 1];
            out[2 * i + 1] = -common * sy * cosine[2 * i];
        }
    }
}

void Falling::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        velocities[i] = {0, -speed * std::tanh((positions[i].y() - surface) / depth)};
    }
}

Point<double> Falling::carried(const Point<double>& point, double time) const {
    const double height =
        std::sinh((point.y() - surface) / depth) * std::exp(-time * speed / depth);
    return {point.x(), surface + depth * std::asinh(height)};
}

void Reversed::operator()(Positions positions, double time, Velocities velocities) const {
    velocity(positions, time, velocities);
    for (Point<double>& value : velocities) {
        value = -value;
    }
}

Velocity reversed(Velocity velocity) { return Reversed{std::move(velocity)}; }

Flow steady(Velocity velocity) {
    return {{std::numeric_limits<double>::infinity(), std::move(velocity)}};
}

Flow there_and_back(const Velocity& velocity, double half_time) {
    return {{half_time, velocity}, {std::numeric_limits<double>::infinity(), reversed(velocity)}};
}

const Velocity& velocity_of_step(const Flow& flow, double begin, double end) {
    if (flow.empty()) {
        throw InputError({.what = "flow without legs",
                          .where = "velocity_of_step",
                          .value = "0",
                          .allowed = "at least 1"});
    }
    const double middle = 0.5 * (begin + end);
    for (const Leg& leg : flow) {
        if (middle < leg.end) {
            return leg.velocity;
        }
    }
    return flow.back().velocity;
}

} // namespace dsc::scenes

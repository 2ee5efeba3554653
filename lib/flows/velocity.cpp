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
#include <utility>

namespace dsc::scenes {

namespace {

// A batch is read as one sequence of coordinates: x, y, x, y, ...
static_assert(sizeof(Point<double>) == 2 * sizeof(double));

/// Points per block of the swirl: its sines and cosines stay in the first-level cache.
constexpr std::size_t block = 128;

// Writes the value of `field` for the vector from the centre to each position.
template <class Field>
void write_about(const Point<double>& centre, Positions positions, Velocities velocities,
                 Field field) {
    assert(positions.size() == velocities.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        velocities[i] = field(positions[i].x() - centre.x(), positions[i].y() - centre.y());
    }
}

} // namespace

void Translation::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    assert(positions.size() == velocities.size());
    std::fill_n(velocities.begin(), positions.size(), velocity);
}

void Radial::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    write_about(centre, positions, velocities, [this](double x, double y) -> Point<double> {
        const double distance = std::sqrt(x * x + y * y);
        const double factor = distance > 0.0 ? speed / distance : 0.0;
        return {factor * x, factor * y};
    });
}

void Rotation::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    write_about(centre, positions, velocities, [this](double x, double y) -> Point<double> {
        return {-angular_speed * y, angular_speed * x};
    });
}

void Vortex::operator()(Positions positions, double /*time*/, Velocities velocities) const {
    write_about(centre, positions, velocities, [this](double x, double y) -> Point<double> {
        const double distance = std::sqrt(x * x + y * y);
        const double factor = distance > 0.0 ? speed / distance : 0.0;
        return {-factor * y, factor * x};
    });
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

Point<double> Falling::advected(const Point<double>& point, double time) const {
    const double height =
        std::sinh((point.y() - surface) / depth) * std::exp(-time * speed / depth);
    return {point.x(), surface + depth * std::asinh(height)};
}

Velocity reversed(Velocity velocity) {
    return
        [velocity = std::move(velocity)](Positions positions, double time, Velocities velocities) {
            velocity(positions, time, velocities);
            for (Point<double>& value : velocities) {
                value = -value;
            }
        };
}

Flow steady(Velocity velocity) {
    return {{std::numeric_limits<double>::infinity(), std::move(velocity)}};
}

Flow there_and_back(const Velocity& velocity, double half_time) {
    return {{half_time, velocity}, {std::numeric_limits<double>::infinity(), reversed(velocity)}};
}

const Velocity& velocity_of_step(const Flow& flow, double begin, double end) {
    require(!flow.empty(), "legs of a flow", 0, "at least 1");
    const double middle = 0.5 * (begin + end);
    for (const Leg& leg : flow) {
        if (middle < leg.end) {
            return leg.velocity;
        }
    }
    return flow.back().velocity;
}

} // namespace dsc::scenes

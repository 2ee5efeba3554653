// SPDX-License-Identifier: MIT
#include "flows/flow_map.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dsc::scenes {

namespace {

/// Points that go through all the steps together, so that they stay in the first-level cache.
constexpr std::size_t block_size = 256;

using Block = std::array<Point<double>, block_size>;

/// The part of the time that one leg covers.
struct Stretch {
    double begin, end;
    int steps;
    Velocity velocity;
};

void advance(const Stretch& stretch, std::span<Point<double>> points) {
    Block k1;
    Block k2;
    Block k3;
    Block k4;
    Block stage;
    const std::size_t count = points.size();
    const double dt = (stretch.end - stretch.begin) / stretch.steps;
    const auto evaluate = [&](std::span<const Point<double>> at, double time, Block& k) {
        stretch.velocity(at, time, std::span(k).first(count));
    };
    const auto move = [&](double time, const Block& k) {
        for (std::size_t i = 0; i < count; ++i) {
            stage[i] = points[i] + time * k[i];
        }
        return std::span<const Point<double>>(stage).first(count);
    };
    for (int step = 0; step < stretch.steps; ++step) {
        const double time = stretch.begin + dt * step;
        evaluate(points, time, k1);
        evaluate(move(0.5 * dt, k1), time + 0.5 * dt, k2);
        evaluate(move(0.5 * dt, k2), time + 0.5 * dt, k3);
        evaluate(move(dt, k3), time + dt, k4);
        for (std::size_t i = 0; i < count; ++i) {
            points[i] += (dt / 6.0) * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
}

} // namespace

FlowMap runge_kutta_map(Flow flow, double begin, double end, int steps) {
    require(begin <= end && std::isfinite(begin) && std::isfinite(end), "end of a flow map", end,
            "finite, from " + to_text(begin));
    require(steps >= 1, "steps of a flow map", steps, "at least 1");
    std::vector<double> ends;
    for (const Leg& leg : flow) {
        if (leg.end > begin && leg.end < end) {
            ends.push_back(leg.end);
        }
    }
    ends.push_back(end);
    std::vector<Stretch> stretches;
    double from = begin;
    for (const double to : ends) {
        if (to > from) {
            const double share = std::ceil(steps * ((to - from) / (end - begin)));
            stretches.push_back(
                {from, to, std::max(1, static_cast<int>(share)), velocity_of_step(flow, from, to)});
            from = to;
        }
    }
    return [stretches = std::move(stretches)](std::span<Point<double>> points) {
        for (std::size_t i = 0; i < points.size(); i += block_size) {
            const auto part = points.subspan(i, std::min(block_size, points.size() - i));
            for (const Stretch& stretch : stretches) {
                advance(stretch, part);
            }
        }
    };
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "flows/flow_map.h"

#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/util/resizer.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dsc::scenes {

namespace {

/// Number of points advanced together through all steps, so that their stages stay in the cache.
constexpr std::size_t block_size = 128;

/// Their coordinates, in one array: sums over stages use all lanes of a register.
using Block = Eigen::Array<double, 2 * block_size, 1>;
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<
    Block, double, Block, double, boost::numeric::odeint::vector_space_algebra,
    boost::numeric::odeint::default_operations, boost::numeric::odeint::never_resizer>;

/// The part of the time that one leg covers.
struct Stretch {
    double begin, end;
    int steps;
    Velocity velocity;
};

std::span<Point<double>> points_in(Block& all) {
    return {reinterpret_cast<Point<double>*>(all.data()), block_size};
}
std::span<const Point<double>> points_in(const Block& all) {
    return {reinterpret_cast<const Point<double>*>(all.data()), block_size};
}

/// Moves the first `count` points; the others stay where they are.
void advance(const Stretch& stretch, std::size_t count, Stepper& stepper, Block& points) {
    const auto evaluate = [&](const Block& at, Block& velocities, double time) {
        stretch.velocity(points_in(at).first(count), time, points_in(velocities).first(count));
        velocities.tail(velocities.size() - 2 * static_cast<Eigen::Index>(count)).setZero();
    };
    const double dt = (stretch.end - stretch.begin) / stretch.steps;
    for (int step = 0; step < stretch.steps; ++step) {
        stepper.do_step(evaluate, points, stretch.begin + dt * step, dt);
    }
}

} // namespace

FlowMap runge_kutta_map(Flow flow, double begin, double end, int steps) {
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
        Stepper stepper;
        Block together = Block::Zero();
        for (std::size_t i = 0; i < points.size(); i += block_size) {
            const auto part = points.subspan(i, std::min(block_size, points.size() - i));
            std::ranges::copy(part, points_in(together).begin());
            for (const Stretch& stretch : stretches) {
                advance(stretch, part.size(), stepper, together);
            }
            std::copy_n(points_in(together).begin(), part.size(), part.begin());
        }
    };
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "dsc3/motion/integrator.h"

#include "dsc3/complex/complex.h"

#include <algorithm>
#include <cmath>

namespace dsc3 {

namespace {

class Stages {
public:
    Stages(const Velocity& velocity, std::span<const Point> positions, Real time, Real dt,
           std::span<Point> targets, IntegratorScratch& scratch,
           std::span<const std::uint32_t> fixed)
        : velocity_(velocity), positions_(positions), time_(time), dt_(dt), targets_(targets),
          scratch_(scratch), fixed_(fixed) {
        scratch.stage.resize(positions.size());
        scratch.slope.resize(positions.size());
    }

    void euler() { advance(scratch_.first); }

    void midpoint() {
        evaluate(scratch_.first, 0.5);
        advance(scratch_.slope);
    }

    void rk4() {
        auto& [first, stage, slope, sum] = scratch_;
        sum.assign(first.begin(), first.end());
        evaluate(first, 0.5);
        add_twice();
        evaluate(slope, 0.5);
        add_twice();
        evaluate(slope, 1);
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            targets_[i] = positions_[i] + (dt_ / 6) * (sum[i] + slope[i]);
        }
    }

    // Replacing the velocity of the fourth stage by that at the target gives a method of third
    // order.
    Real adaptive() {
        rk4();
        std::swap(scratch_.sum, scratch_.slope); // `sum` is now the fourth stage
        find_velocities(targets_, time_ + dt_);
        Real largest = 0;
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            const Real square = (scratch_.sum[i] - scratch_.slope[i]).squaredNorm();
            largest = std::isfinite(square) ? std::max(largest, square) : largest;
        }
        return dt_ / 6 * std::sqrt(largest);
    }

private:
    // The next slope, at positions + share * dt * `along`.
    void evaluate(const std::vector<Point>& along, Real share) {
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            scratch_.stage[i] = positions_[i] + share * dt_ * along[i];
        }
        find_velocities(scratch_.stage, time_ + share * dt_);
    }
    void find_velocities(std::span<const Point> at, Real time) {
        velocity_(at, time, scratch_.slope);
        keep_on_sides(scratch_.slope, fixed_);
    }
    void add_twice() {
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            scratch_.sum[i] += 2 * scratch_.slope[i];
        }
    }
    void advance(const std::vector<Point>& slope) {
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            targets_[i] = positions_[i] + dt_ * slope[i];
        }
    }

    const Velocity& velocity_;
    std::span<const Point> positions_;
    Real time_;
    Real dt_;
    std::span<Point> targets_;
    IntegratorScratch& scratch_;
    std::span<const std::uint32_t> fixed_;
};

} // namespace

void keep_on_sides(std::span<Point> velocities, std::span<const std::uint32_t> fixed) {
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        keep_on_sides(velocities[i], Point::Zero(), fixed[i]);
    }
}

Real integrate(Integrator integrator, const Velocity& velocity, std::span<const Point> positions,
               Real time, Real dt, std::span<Point> targets, IntegratorScratch& scratch,
               std::span<const std::uint32_t> fixed) {
    Stages stages(velocity, positions, time, dt, targets, scratch, fixed);
    switch (integrator) {
    case Integrator::euler: stages.euler(); break;
    case Integrator::midpoint: stages.midpoint(); break;
    case Integrator::rk4: stages.rk4(); break;
    case Integrator::adaptive: return stages.adaptive();
    }
    return 0;
}

} // namespace dsc3

// SPDX-License-Identifier: MIT
#include "dsc/motion/integrator.h"

#include "dsc/base/room.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

template <class Real>
class Stages {
public:
    Stages(const Velocity<Real>& velocity, std::span<const Point<Real>> positions, Real time,
           Real dt, std::span<Point<Real>> targets, IntegratorScratch<Real>& scratch)
        : velocity_(velocity), positions_(positions), time_(time), dt_(dt), targets_(targets),
          scratch_(scratch) {
        scratch.stage.resize(positions.size());
        scratch.slope.resize(positions.size());
    }

    void euler() { advance(scratch_.first); }

    void midpoint() {
        go_along(scratch_.first, Real(0.5));
        evaluate(Real(0.5));
        advance(scratch_.slope);
    }

    void rk4() {
        auto& sum = scratch_.sum;
        assign(sum, scratch_.first);
        go_along(scratch_.first, Real(0.5));
        evaluate(Real(0.5));
        add_twice();
        go_along(scratch_.slope, Real(0.5));
        evaluate(Real(0.5));
        add_twice();
        go_along(scratch_.slope, Real(1));
        evaluate(Real(1));
        const Real sixth = dt_ / Real(6);
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            targets_[i] = positions_[i] + sixth * (sum[i] + scratch_.slope[i]);
        }
    }

    // If the velocity at the target replaces that of the fourth stage, in whole or in part, the
    // result is of third order: both satisfy sum(b c^2) = 1/3 and sum(b a c) = 1/6. The difference
    // of the two is the estimate.
    Real adaptive() {
        rk4();
        std::swap(scratch_.sum, scratch_.slope); // `sum` is now the fourth stage
        velocity_(targets_, time_ + dt_, scratch_.slope);
        Real largest = 0;
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            const Real squared = (scratch_.sum[i] - scratch_.slope[i]).squaredNorm();
            if (std::isfinite(squared) && squared > largest) {
                largest = squared;
                scratch_.worst = i;
            }
        }
        return dt_ / Real(6) * std::sqrt(largest);
    }

private:
    void go_along(const std::vector<Point<Real>>& slope, Real share) {
        const Real step = share * dt_;
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            scratch_.stage[i] = positions_[i] + step * slope[i];
        }
    }
    void evaluate(Real share) { velocity_(scratch_.stage, time_ + share * dt_, scratch_.slope); }
    void add_twice() {
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            scratch_.sum[i] += Real(2) * scratch_.slope[i];
        }
    }
    void advance(const std::vector<Point<Real>>& slope) {
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            targets_[i] = positions_[i] + dt_ * slope[i];
        }
    }

    const Velocity<Real>& velocity_;
    std::span<const Point<Real>> positions_;
    Real time_;
    Real dt_;
    std::span<Point<Real>> targets_;
    IntegratorScratch<Real>& scratch_;
};

} // namespace

template <class Real>
Real integrate(Integrator integrator, const Velocity<Real>& velocity,
               std::span<const Point<Real>> positions, Real time, Real dt,
               std::span<Point<Real>> targets, IntegratorScratch<Real>& scratch) {
    Stages<Real> stages(velocity, positions, time, dt, targets, scratch);
    switch (integrator) {
    case Integrator::euler: stages.euler(); break;
    case Integrator::midpoint: stages.midpoint(); break;
    case Integrator::rk4: stages.rk4(); break;
    case Integrator::adaptive: return stages.adaptive();
    }
    return 0;
}

template double integrate(Integrator, const Velocity<double>&, std::span<const Point<double>>,
                          double, double, std::span<Point<double>>, IntegratorScratch<double>&);
template float integrate(Integrator, const Velocity<float>&, std::span<const Point<float>>, float,
                         float, std::span<Point<float>>, IntegratorScratch<float>&);

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "watch.h"

#include "support/random/scene.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/queries/validate.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace dsc::hard {

namespace {

template <class Real>
std::unique_ptr<Executor<Real>>
watching(Complex<Real>& complex, const Options<Real>& options, const Rectangle& domain,
         std::unique_ptr<Executor<Real>> inner, Sighting& sighting) {
    if (!inner) {
        inner =
            std::make_unique<SequentialExecutor<Real>>(complex, options, default_algorithm<Real>());
    }
    return std::make_unique<WatchingExecutor<Real>>(complex, domain, std::move(inner), sighting);
}

template <class Real>
std::string words(const Complex<Real>& complex, const StepReport& report, double dt) {
    std::ostringstream text;
    text << "more sub-steps asked for than allowed, in a step of " << dt << ", by a speed of "
         << report.speed << " at vertex " << report.where.id;
    if (complex.is_alive(report.where)) {
        text << " (" << complex.position(report.where).x() << ", "
             << complex.position(report.where).y() << ")";
    }
    return text.str();
}

} // namespace

template <class Real>
WatchingExecutor<Real>::WatchingExecutor(const Complex<Real>& complex, const Rectangle& domain,
                                         std::unique_ptr<Executor<Real>> inner, Sighting& sighting)
    : complex_(complex), domain_(domain), inner_(std::move(inner)), sighting_(sighting) {}

template <class Real>
AimReport<Real> WatchingExecutor<Real>::aim(const Flow<Real>& flow, Real time, Real dt) {
    velocity_ = flow.velocity();
    time_ = time;
    dt_ = dt;
    const AimReport<Real> report = inner_->aim(flow, time, dt);
    held_ = report.held;
    return report;
}

template <class Real>
auto WatchingExecutor<Real>::aim_again(const Flow<Real>& flow, Real time, Real dt) -> Again {
    dt_ = dt;
    return inner_->aim_again(flow, time, dt);
}

// The classical scheme, in doubles and one vertex at a time.
template <class Real>
void WatchingExecutor<Real>::find_targets() {
    list_.clear();
    before_.clear();
    targets_.clear();
    inner_->append_interface(list_);
    const auto dt = static_cast<double>(dt_);
    const auto velocity_at = [&](const Point<double>& p, double time) {
        const Point<Real> at = p.cast<Real>();
        Point<Real> v;
        (*velocity_)(std::span<const Point<Real>>(&at, 1), static_cast<Real>(time),
                     std::span<Point<Real>>(&v, 1));
        return Point<double>(v.template cast<double>());
    };
    for (const std::uint32_t v : list_) {
        before_.push_back(complex_.position(Vertex{v}));
        const Point<double> p = before_.back().template cast<double>();
        const auto t = static_cast<double>(time_);
        const Point<double> k1 = velocity_at(p, t);
        const Point<double> k2 = velocity_at(p + dt / 2 * k1, t + dt / 2);
        const Point<double> k3 = velocity_at(p + dt / 2 * k2, t + dt / 2);
        const Point<double> k4 = velocity_at(p + dt * k3, t + dt);
        targets_.push_back(on_boundary(p, p + dt * ((k1 + k4) / 6 + (k2 + k3) / 3)));
    }
}

template <class Real>
Point<double> WatchingExecutor<Real>::on_boundary(const Point<double>& from,
                                                  const Point<double>& to) const {
    Point<double> target = to;
    for (int axis = 0; axis < 2; ++axis) {
        if (from[axis] == domain_.low[axis] || from[axis] == domain_.high[axis]) {
            target[axis] = from[axis];
        }
    }
    return target;
}

template <class Real>
MoveReport WatchingExecutor<Real>::move() {
    find_targets();
    const MoveReport report = inner_->move();
    std::uint64_t missed = 0;
    constexpr auto epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
    for (std::size_t i = 0; i < list_.size(); ++i) {
        const Point<double> now = complex_.position(Vertex{list_[i]}).template cast<double>();
        const Point<double> from = before_[i].template cast<double>();
        // Rounding of the coordinates, and of the way in the scalar of the complex.
        const double tolerance =
            8 * epsilon * (now.cwiseAbs().maxCoeff() + (targets_[i] - from).norm());
        const bool is_there =
            targets_[i].allFinite() && (now - targets_[i]).cwiseAbs().maxCoeff() <= tolerance;
        missed += is_there ? 0U : 1U;
    }
    const std::uint64_t counted = held_ + report.unreached;
    sighting_.missed += missed;
    sighting_.uncounted += missed > counted ? missed - counted : 0;
    sighting_.overcounted += counted > missed ? counted - missed : 0;
    return report;
}

template <class Real>
Watch<Real>::Watch(Complex<Real>& complex, const Options<Real>& options, const WatchOptions& watch,
                   HardResult& result, std::unique_ptr<Executor<Real>> inner)
    : complex_(complex), options_(options), watch_(watch), result_(result),
      simulation_(complex, options,
                  watching(complex, options, watch.domain, std::move(inner), sighting_)) {
    expect(result_, options.integrator == Integrator::rk4, "the watch only knows RK4");
    look();
}

template <class Real>
bool Watch<Real>::step(const Velocity<Real>& velocity, double time, double dt) {
    const Sighting before = sighting_;
    last_ = simulation_.step(velocity, static_cast<Real>(time), static_cast<Real>(dt));
    ++result_.steps;
    result_.sub_steps += last_.sub_steps;
    result_.most_sub_steps = std::max(result_.most_sub_steps, last_.sub_steps);
    if (last_.sub_steps > 0) {
        const std::uint32_t mean = (last_.passes + last_.sub_steps - 1) / last_.sub_steps;
        result_.most_passes = std::max(result_.most_passes, mean);
    }
    result_.unreached += last_.unreached;
    result_.held += last_.held;
    result_.missed += sighting_.missed - before.missed;
    result_.uncounted += sighting_.uncounted - before.uncounted;
    result_.overcounted += sighting_.overcounted - before.overcounted;
    if (last_.gave_up != GiveUp::none && result_.gave_up.empty()) {
        result_.gave_up =
            "step " + std::to_string(result_.steps) + ": " + words(complex_, last_, dt);
    }
    const auto bound = static_cast<std::uint32_t>(options_.max_sub_steps);
    expect(result_, last_.sub_steps <= bound, "a step has more sub-steps than allowed");
    expect(result_,
           last_.passes <= last_.sub_steps * static_cast<std::uint32_t>(options_.max_passes),
           "a sub-step has more passes than allowed");
    look();
    return sound_ && last_.gave_up == GiveUp::none;
}

template <class Real>
void Watch<Real>::look() {
    for (const Triangle t : triangles(complex_)) {
        const auto& v = complex_.triangles[t.id].v;
        result_.inverted +=
            orientation(complex_.position(Vertex{v[0]}), complex_.position(Vertex{v[1]}),
                        complex_.position(Vertex{v[2]})) > 0
                ? 0U
                : 1U;
    }
    if (result_.steps % static_cast<std::uint64_t>(watch_.thorough_every) != 0) {
        return;
    }
    std::string problem = validate(complex_).problem;
    if (problem.empty()) {
        problem = test::interface_fault(complex_, simulation_.interface());
    }
    if (!problem.empty() && sound_) {
        sound_ = false;
        result_.failures.push_back("after step " + std::to_string(result_.steps) + ": " + problem);
    }
}

template <class Real>
bool Watch<Real>::run(const Velocity<Real>& velocity, double time, double dt, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
        if (!step(velocity, time + static_cast<double>(i) * dt, dt)) {
            return false;
        }
    }
    return true;
}

void expect_sound(HardResult& result, Targets targets) {
    expect(result, result.steps > 0, "nothing was run");
    expect(result, result.inverted == 0,
           std::to_string(result.inverted) + " triangles are not positive");
    expect(result, result.uncounted == 0,
           std::to_string(result.uncounted) + " vertices were lost without being counted");
    expect(result, result.overcounted == 0,
           std::to_string(result.overcounted) + " vertices were counted and had arrived");
    if (targets == Targets::reachable) {
        expect(result, result.unreached == 0,
               std::to_string(result.unreached) + " vertices did not arrive");
        expect(result, result.gave_up.empty(), result.gave_up);
    }
}

template class WatchingExecutor<double>;
template class WatchingExecutor<float>;
template class Watch<double>;
template class Watch<float>;

} // namespace dsc::hard

// SPDX-License-Identifier: MIT
#include "watch.h"

#include "support/random/scene.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "dsc/queries/validate.h"

#include <limits>
#include <optional>
#include <utility>

namespace dsc::hard {

// The targets can be checked only for RK4 and for velocities of position and time.
template <class Real>
class WatchingStage final : public Stage<Real> {
public:
    // Vertices on the sides of the domain must slide, and corners must stay. The counts of missed
    // vertices are added to the result.
    WatchingStage(const Rectangle& domain, HardResult& result) : domain_(domain), result_(result) {}

    // The velocity of the steps that follow; must outlive them.
    void follow(const Velocity<Real>& velocity) { velocity_ = &velocity; }

    void begin(Complex<Real>& complex, const Options<Real>& /*options*/) override {
        static const std::string name = "watch.before";
        before_ = complex.attributes.contains(name)
                      ? &complex.attributes.template get<Vertex, Point<Real>>(name)
                      : &complex.attributes.template add<Vertex>(name, Point<Real>(0, 0));
    }

    // Records the positions of the vertices after remeshing.
    [[nodiscard]] std::optional<Pass<Real>> pass() override {
        const auto note = [this](Work<Real>& work) {
            for (const std::uint32_t v : work.interface) {
                (*before_)[Vertex{v}] = work.complex.position(Vertex{v});
            }
        };
        return Pass<Real>{.name = "watch", .run = note, .attends = true};
    }

    // Compares the vertices' positions with their expected ones.
    void run(const Between<Real>& between) override {
        constexpr auto epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
        const auto dt = static_cast<double>(between.dt);
        const auto time = static_cast<double>(between.time) - dt;
        std::uint64_t missed = 0;
        for (const std::uint32_t v : between.interface) {
            const Point<double> from = (*before_)[Vertex{v}].template cast<double>();
            const Point<double> target = target_of(from, time, dt);
            const Point<double> now = between.complex.position(Vertex{v}).template cast<double>();
            // Tolerance for rounding the coordinates, and the displacement in the scalar of the
            // complex.
            const double tolerance =
                8 * epsilon * (now.cwiseAbs().maxCoeff() + (target - from).norm());
            const bool is_there =
                target.allFinite() && (now - target).cwiseAbs().maxCoeff() <= tolerance;
            missed += is_there ? 0U : 1U;
        }
        const std::uint64_t counted = between.unreached;
        result_.missed += missed;
        result_.uncounted += missed > counted ? missed - counted : 0;
        result_.overcounted += counted > missed ? counted - missed : 0;
    }

private:
    // The classical RK4 scheme, in doubles and for one vertex; vertices of the domain boundary stay
    // on it.
    [[nodiscard]] Point<double> target_of(const Point<double>& from, double time, double dt) const {
        const auto velocity_at = [&](const Point<double>& p, double when) {
            const Point<Real> at = p.cast<Real>();
            Point<Real> v;
            (*velocity_)(std::span<const Point<Real>>(&at, 1), static_cast<Real>(when),
                         std::span<Point<Real>>(&v, 1));
            return Point<double>(v.template cast<double>());
        };
        const Point<double> k1 = velocity_at(from, time);
        const Point<double> k2 = velocity_at(from + dt / 2 * k1, time + dt / 2);
        const Point<double> k3 = velocity_at(from + dt / 2 * k2, time + dt / 2);
        const Point<double> k4 = velocity_at(from + dt * k3, time + dt);
        Point<double> target = from + dt * ((k1 + k4) / 6 + (k2 + k3) / 3);
        for (int axis = 0; axis < 2; ++axis) {
            if (from[axis] == domain_.low[axis] || from[axis] == domain_.high[axis]) {
                target[axis] = from[axis];
            }
        }
        return target;
    }

    Rectangle domain_;
    HardResult& result_;
    const Velocity<Real>* velocity_ = nullptr;
    VertexAttribute<Point<Real>>* before_ = nullptr;
};

template <class Real>
Watch<Real>::Watch(Complex<Real>& complex, const Options<Real>& options, const WatchOptions& watch,
                   HardResult& result, std::unique_ptr<Executor<Real>> executor)
    : complex_(complex), options_(options), watch_(watch), result_(result),
      stage_(std::make_shared<WatchingStage<Real>>(watch.domain, result)),
      simulation_(complex, options, std::move(executor)) {
    simulation_.add_stage(stage_);
    expect(result_, options.integrator == Integrator::rk4 && !options.custom_integrator,
           "the watch only knows RK4");
    look();
}

template <class Real>
bool Watch<Real>::step(const Velocity<Real>& velocity, double time, double dt) {
    stage_->follow(velocity);
    last_ = simulation_.step(velocity, static_cast<Real>(time), static_cast<Real>(dt));
    ++result_.steps;
    result_.sub_steps += last_.sub_steps;
    result_.max_sub_steps = std::max(result_.max_sub_steps, last_.sub_steps);
    result_.unreached += last_.unreached;
    result_.held += last_.held;
    if (last_.gave_up != GiveUp::none && result_.gave_up.empty()) {
        result_.gave_up = "step " + std::to_string(result_.steps) +
                          ": more sub-steps asked for than allowed, at a speed of " +
                          text(last_.speed);
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

HardResult advect(const Advected& advected,
                  const std::function<void(const Complex<double>&, HardResult&)>& more) {
    HardResult result;
    result.asked = advected.asked;
    result.happened = advected.happened;
    auto scene = scene_of<double>(advected.domain, advected.outlines, advected.h);
    Watch<double> watch(scene.complex, scene.options,
                        {.domain = advected.domain, .thorough_every = advected.thorough_every},
                        result);
    watch.run(advected.flow, 0, advected.dt, advected.steps);
    note_error(result, shape_error<double>(scene.complex, advected.exact), advected.allowed);
    if (more) {
        more(scene.complex, result);
    }
    expect_sound(result, Targets::reachable);
    return result;
}

void note_error(HardResult& result, double error, double allowed) {
    result.error = std::max(result.error.value_or(0), error);
    expect(result, error <= allowed, "error " + text(error) + ", allowed " + text(allowed));
}

void expect_sound(HardResult& result, Targets targets) {
    expect(result, result.steps > 0, "nothing was run");
    expect(result, result.inverted == 0,
           std::to_string(result.inverted) + " triangles are not positive");
    expect(result, result.uncounted == 0,
           std::to_string(result.uncounted) + " vertices were lost without being counted");
    expect(result, result.overcounted == 0,
           std::to_string(result.overcounted) + " vertices were counted and had arrived");
    expect(result, targets != Targets::reachable || result.unreached == 0,
           std::to_string(result.unreached) + " vertices did not arrive");
    expect(result, targets == Targets::too_far || result.gave_up.empty(), result.gave_up);
}

template class Watch<double>;
template class Watch<float>;

} // namespace dsc::hard

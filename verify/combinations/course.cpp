// SPDX-License-Identifier: MIT
#include "combinations/course.h"

#include "combinations/checks.h"
#include "combinations/settings.h"
#include "support/random/scene.h"

#include "dsc/complex/complex.h"
#include "dsc/operations/edge_split.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_corners.h"
#include "replay/replay.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace dsc::combinations {

namespace {

// What the application's function is to do in the step that is under way.
enum class Trouble : std::uint8_t { none, throws, not_a_number };

struct Thrown : std::runtime_error {
    Thrown() : std::runtime_error("the application gives up") {}
};

template <class Real>
class Course {
public:
    Course(const Row& row, const Scene& scene, std::uint32_t threads, bool is_unbroken)
        : row_(row), scene_(scene), threads_(threads),
          interruption_(is_unbroken ? Interruption::none : row.interruption) {}

    Outcome<Real> run() {
        outcome_.first = first_complex();
        complex_ = std::make_unique<Complex<Real>>(outcome_.first);
        simulation_ = simulation_of(*complex_);
        if (interruption_ == Interruption::listened) {
            listen();
        }
        const int middle = scene_.steps / 2;
        for (int i = 0; i < scene_.steps; ++i) {
            if (i == middle) {
                outcome_.middle = *complex_;
                switch_sizes();
                interrupt(i);
            }
            step(i);
            if (!outcome_.problems.empty()) {
                break; // what follows from it tells nothing
            }
        }
        if (interruption_ == Interruption::listened) {
            expect_replayed();
        }
        if (row_.data == Data::field) {
            note(field_fault(*complex_));
        }
        outcome_.hash = mesh_hash(*complex_);
        outcome_.threads = std::max(outcome_.threads, team_.load());
        simulation_.reset();
        outcome_.last = std::move(*complex_);
        return std::move(outcome_);
    }

private:
    [[nodiscard]] Complex<Real> first_complex() const {
        const test::ChangingOptions<Real> options = options_of<Real>(row_, scene_, 0);
        InitialOptions initial;
        initial.edge_length = scene_.h;
        initial.sizes = sizes_in<double>(options.sizes);
        auto complex =
            initial_complex<Real>(scene_.domain, std::span<const Curve>(scene_.curves), initial);
        if (row_.data == Data::field) {
            auto& field = complex.attributes.template add<Vertex, double>("place", 0.0);
            field.set_field(true);
            for (const Vertex v : vertices(complex)) {
                field[v] = linear_field(complex.position(v));
            }
        }
        return complex;
    }

    [[nodiscard]] std::unique_ptr<test::ChangingSimulation<Real>>
    simulation_of(Complex<Real>& complex) {
        const test::ChangingOptions<Real> options = options_of<Real>(row_, scene_, 0);
        auto algorithm = is_normal(row_.motion)
                             ? growth_algorithm<Real>(complex, growth_of<Real>(row_))
                             : default_algorithm<Real>();
        if (row_.way == Way::copy) {
            algorithm.motion.push_back({.name = "count threads",
                                        .run = [this](Work<Real>&) { count_team(); },
                                        .attends = true});
            const auto asked = parallel_of(row_, threads_).submeshes;
            outcome_.submeshes = asked > 0 ? asked : threads_;
        }
        std::unique_ptr<Executor<Real>> executor;
        if (row_.way == Way::sequential) {
            executor = std::make_unique<Executor<Real>>(complex, options, std::move(algorithm));
        } else {
            executor = make_executor<Real>(complex, options, parallel_of(row_, threads_),
                                           std::move(algorithm));
        }
        seen_ = dynamic_cast<const SubmeshExecutor<Real>*>(executor.get());
        return std::make_unique<test::ChangingSimulation<Real>>(complex, options,
                                                                std::move(executor));
    }

    // This executor tells nobody how many threads share its submeshes.
    void count_team() {
        const auto team = static_cast<std::uint32_t>(omp_get_num_threads());
        for (std::uint32_t most = team_; most < team && !team_.compare_exchange_weak(most, team);) {
        }
    }

    // --- flows -----------------------------------------------------------------------------------
    void make_trouble(std::span<const Point<Real>> positions, std::span<Point<Real>> values) const {
        if (trouble_ == Trouble::throws) {
            throw Thrown();
        }
        if (trouble_ == Trouble::not_a_number) {
            constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
            for (std::size_t i = 0; i < positions.size(); ++i) {
                if (across(positions[i]) >= held_from_) {
                    values[i] = Point<Real>(none, none);
                }
            }
        }
    }

    // Which side of a slanting line a place is on.
    static Real across(const Point<Real>& p) { return p.y() + Real(0.3) * p.x(); }

    // The line through the vertex in the middle: wherever the interface has gone by now, half of it
    // is held, and that vertex.
    void choose_held() {
        std::vector<Real> all;
        for (const std::uint32_t v : simulation_->interface()) {
            all.push_back(across(complex_->position(Vertex{v})));
        }
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        held_from_ = *middle;
    }

    void set_velocities(std::span<const Point<Real>> positions, Real time,
                        std::span<Point<Real>> values) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            values[i] =
                scene_.velocity(positions[i].template cast<double>(), static_cast<double>(time))
                    .template cast<Real>();
        }
        make_trouble(positions, values);
        // By Euler's method velocities are asked for at the beginning of sub-steps alone.
        if (threads_ == 1 && (outcome_.asked.empty() || time > outcome_.asked.back())) {
            outcome_.asked.push_back(time);
        }
    }

    test::ChangingReport advance(Real time, Real dt) {
        if (is_normal(row_.motion)) {
            const InterfaceFlow<Real> inner = growth<Real>(growth_of<Real>(row_));
            return simulation_->step(
                InterfaceFlow<Real>([&](const InterfaceView<Real>& view, std::size_t begin,
                                        std::size_t end, Real at, auto values) {
                    inner(view, begin, end, at, values);
                    make_trouble(view.positions.subspan(begin, end - begin),
                                 values.subspan(begin, end - begin));
                }),
                time, dt);
        }
        if (is_by_curvature(row_.motion)) {
            const InterfaceMotion<Real> inner = curvature_flow<Real>();
            return simulation_->step(InterfaceMotion<Real>([&](const InterfaceView<Real>& view,
                                                               Real at, Real for_dt, auto ways) {
                                         inner(view, at, for_dt, ways);
                                         make_trouble(view.positions, ways);
                                     }),
                                     time, dt);
        }
        const Velocity<Real> velocity = [this](auto positions, Real at, auto values) {
            set_velocities(positions, at, values);
        };
        switch (row_.told) {
        case Told::positions: break;
        case Told::seeing:
            return simulation_->step(
                InterfaceFlow<Real>([&](const InterfaceView<Real>& view, std::size_t begin,
                                        std::size_t end, Real at, auto values) {
                    set_velocities(view.positions.subspan(begin, end - begin), at,
                                   values.subspan(begin, end - begin));
                }),
                time, dt);
        case Told::motion:
            return simulation_->step(
                InterfaceMotion<Real>([&](const InterfaceView<Real>& view, Real at, Real for_dt,
                                          std::span<Point<Real>> ways) {
                    IntegratorScratch<Real> scratch;
                    scratch.first.resize(view.size());
                    velocity(view.positions, at, scratch.first);
                    integrate<Real>(Integrator::rk4, velocity, view.positions, at, for_dt, ways,
                                    scratch);
                    for (std::size_t i = 0; i < view.size(); ++i) {
                        ways[i] -= view.positions[i];
                    }
                }),
                time, dt);
        }
        return simulation_->step(velocity, time, dt);
    }

    // --- the run ---------------------------------------------------------------------------------
    void step(int i) {
        const Real dt = static_cast<Real>(scene_.end / scene_.steps);
        const Real time = static_cast<Real>(i) * dt;
        const bool is_middle = i == scene_.steps / 2;
        if (is_middle && interruption_ == Interruption::not_a_number) {
            trouble_ = Trouble::not_a_number;
            choose_held();
        }
        if (is_middle && interruption_ == Interruption::thrown) {
            trouble_ = Trouble::throws;
            try {
                (void)advance(time, dt);
                note("what the application's function throws is lost");
            } catch (const Thrown&) {
                trouble_ = Trouble::none;
            }
        }
        if (is_middle && interruption_ == Interruption::pause) {
            take(advance(time, 0), i);
        }
        if (is_middle && interruption_ == Interruption::tiny_step) {
            take(advance(time, dt * std::numeric_limits<Real>::epsilon()), i);
        }
        const test::ChangingReport report = advance(time, dt);
        take(report, i);
        for (std::uint32_t k = 0; k < report.sub_steps; ++k) {
            outcome_.times.push_back(static_cast<double>(time) +
                                     static_cast<double>(dt) * k / report.sub_steps);
        }
        trouble_ = Trouble::none;
    }

    void take(const test::ChangingReport& report, int i) {
        const std::string when = ", step " + std::to_string(i);
        outcome_.held += report.held;
        // What is held may be in the way of others.
        outcome_.unreached += trouble_ == Trouble::not_a_number ? 0 : report.unreached;
        outcome_.events += report.events.size();
        if (report.gave_up != GiveUp::none) {
            note("gave up" + when);
        }
        note(account_fault(report, row_.topology == Rule::given_back), when);
        if (threads_ == 1) { // the others end with the same mesh, or are refused for that
            note(validate(*complex_).problem, when);
            if (row_.inside == Inside::still) {
                note(test::interface_fault(*complex_, simulation_->interface()), when);
            }
        }
        if (seen_ != nullptr) {
            outcome_.threads = std::max(outcome_.threads, seen_->view().threads_used);
            outcome_.submeshes = std::max(
                outcome_.submeshes,
                static_cast<std::uint32_t>(seen_->view().partition.colours.front().regions.size()));
        }
    }

    void switch_sizes() {
        if (row_.sizes == Sizes::switched_on || row_.sizes == Sizes::switched_off) {
            simulation_->set_options(options_of<Real>(row_, scene_, 1));
        }
    }

    void interrupt(int i) {
        switch (interruption_) {
        case Interruption::resumed: resume(i); break;
        case Interruption::set_options:
            simulation_->set_options(options_of<Real>(row_, scene_, 1));
            break;
        case Interruption::renumbered: (void)renumber(*complex_); break;
        case Interruption::edited: edit(); break;
        case Interruption::none:
        case Interruption::listened:
        case Interruption::thrown:
        case Interruption::pause:
        case Interruption::tiny_step:
        case Interruption::not_a_number: break; // in the step
        }
    }

    void resume(int i) {
        Archive kept;
        simulation_->archive(kept);
        simulation_.reset();
        complex_ = std::make_unique<Complex<Real>>(first_complex());
        simulation_ = simulation_of(*complex_);
        if (row_.sizes == Sizes::switched_on || row_.sizes == Sizes::switched_off) {
            simulation_->set_options(options_of<Real>(row_, scene_, 1));
        }
        Archive again(kept.bytes(), "step " + std::to_string(i));
        simulation_->archive(again);
        again.expect_end();
    }

    // Some splits inside phases.
    void edit() {
        std::vector<Edge> some;
        for (const Edge e : edges(*complex_)) {
            const auto [a, b] = complex_->vertices_of(e);
            if (!is_interface(*complex_, a) && !is_interface(*complex_, b) &&
                !is_boundary(*complex_, e) && some.size() < 40 && e.id % 7 == 0) {
                some.push_back(e);
            }
        }
        for (const Edge e : some) {
            if (complex_->is_alive(Triangle{triangle_of(e.id)})) {
                (void)edge_split(*complex_, e);
            }
        }
    }

    void listen() {
        simulation_->add_listener([this](std::span<const Edit> some) {
            edits_.insert(edits_.end(), some.begin(), some.end());
        });
    }

    // What create and merge did is in no log.
    void expect_replayed() {
        if (row_.way == Way::copy || !outcome_.problems.empty()) {
            return;
        }
        Complex<Real> again = outcome_.first;
        if (replay<Real>(again, edits_).skipped > 0 || mesh_hash(again) != mesh_hash(*complex_)) {
            note("the edits that were told lead to another mesh");
        }
    }

    void note(const std::string& problem, const std::string& when = {}) {
        if (!problem.empty()) {
            outcome_.problems.push_back(problem + when);
        }
    }

    const Row& row_;
    const Scene& scene_;
    std::uint32_t threads_;
    Interruption interruption_;
    Trouble trouble_ = Trouble::none;
    Real held_from_ = 0;
    Outcome<Real> outcome_;
    std::unique_ptr<Complex<Real>> complex_;
    std::unique_ptr<test::ChangingSimulation<Real>> simulation_;
    const SubmeshExecutor<Real>* seen_ = nullptr;
    std::atomic<std::uint32_t> team_ = 1;
    std::vector<Edit> edits_;
};

} // namespace

template <class Real>
Outcome<Real> run_course(const Row& row, const Scene& scene, std::uint32_t threads,
                         bool is_unbroken) {
    return Course<Real>(row, scene, threads, is_unbroken).run();
}

template Outcome<double> run_course(const Row&, const Scene&, std::uint32_t, bool);
template Outcome<float> run_course(const Row&, const Scene&, std::uint32_t, bool);

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
#include "combinations/run.h"

#include "combinations/checks.h"
#include "combinations/settings.h"
#include "measures/interface_outlines.h"
#include "support/interface_view_testing.h"
#include "support/random/scene.h"

#include "dsc/algorithm/executor.h"
#include "dsc/complex/numbering.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/growth_features.h"
#include "replay/replay.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

namespace dsc::combinations {

namespace {

struct Thrown : std::runtime_error {
    Thrown() : std::runtime_error("the application gives up") {}
};

template <class Real>
Shapes shapes_of(const Complex<Real>& complex, const Scene& scene) {
    Shapes shapes;
    for (Phase phase = 0; phase < scene.phases; ++phase) {
        shapes.outlines.push_back(scenes::interface_outlines(complex, {.phase = phase}));
        shapes.areas.push_back(static_cast<double>(phase_area(complex, phase)));
    }
    return shapes;
}

template <class Real>
class Run {
public:
    Run(const Row& row, const Scene& scene, const Manner& manner)
        : row_(row), scene_(scene), manner_(manner),
          interruption_(manner.is_unbroken ? Interruption::none : row.interruption) {}

    Outcome run() {
        begin();
        // Create and merge does not log its edits.
        const bool is_replayed = manner_.threads == 1 && row_.way != Way::copy;
        std::vector<Edit> edits;
        if (is_replayed) {
            simulation_->add_listener([&](std::span<const Edit> some) {
                edits.insert(edits.end(), some.begin(), some.end());
            });
        }
        outcome_.first = shapes_of(*complex_, scene_);
        for (int i = 0; i < scene_.steps && outcome_.problems.empty(); ++i) {
            if (i == scene_.steps / 3 && manner_.is_resumed) {
                resume();
            }
            if (i == scene_.steps / 2) {
                outcome_.middle = shapes_of(*complex_, scene_);
                interrupt();
            }
            step(i);
        }
        outcome_.last = shapes_of(*complex_, scene_);
        outcome_.hash = hash_in_first_units(*complex_);
        note(field_fault(*complex_));
        if (is_replayed && outcome_.problems.empty()) {
            Complex<Real> again = first_complex();
            if (replay<Real>(again, edits).skipped > 0 || mesh_hash(again) != outcome_.hash) {
                note("the edits that were told lead to another mesh");
            }
        }
        return std::move(outcome_);
    }

private:
    void begin() {
        simulation_.reset();
        complex_ = std::make_unique<Complex<Real>>(first_complex());
        const auto options = options_of<Real>(row_, scene_, 0);
        auto algorithm = is_normal(row_)
                             ? growth_algorithm<Real>(*complex_, growth_of<Real>(row_, scene_))
                             : default_algorithm<Real>();
        std::unique_ptr<Executor<Real>> executor;
        if (row_.way == Way::sequential) {
            executor = std::make_unique<Executor<Real>>(*complex_, options, std::move(algorithm));
        } else {
            executor = make_executor<Real>(*complex_, options, parallel_of(row_, manner_.threads),
                                           std::move(algorithm));
        }
        seen_ = dynamic_cast<const SubmeshExecutor<Real>*>(executor.get());
        simulation_ = std::make_unique<test::ChangingSimulation<Real>>(*complex_, options,
                                                                       std::move(executor));
    }

    [[nodiscard]] Complex<Real> first_complex() const {
        const test::ChangingOptions<Real> options = options_of<Real>(row_, scene_, 0);
        auto complex = initial_complex<Real>(
            scene_.domain, std::span<const Curve>(scene_.curves),
            {.edge_length = scene_.h, .sizes = sizes_in<double>(options.sizes)});
        add_field(complex);
        return complex;
    }

    [[nodiscard]] std::uint64_t hash_in_first_units(Complex<Real> complex) const {
        for (auto& vertex : complex.vertices) {
            vertex.x /= static_cast<Real>(scene_.length_unit);
            vertex.y /= static_cast<Real>(scene_.length_unit);
        }
        return mesh_hash(complex);
    }

    // --- flows -----------------------------------------------------------------------------------
    void set_velocities(std::span<const Point<Real>> positions, Real time,
                        std::span<Point<Real>> values) {
        throw_if_asked();
        for (std::size_t i = 0; i < positions.size(); ++i) {
            values[i] =
                scene_.velocity(positions[i].template cast<double>(), static_cast<double>(time))
                    .template cast<Real>();
        }
        // Euler's method evaluates velocities only at the beginning of sub-steps.
        if (manner_.threads == 1 && (outcome_.asked.empty() || time > outcome_.asked.back())) {
            outcome_.asked.push_back(static_cast<double>(time));
        }
    }

    void look_at(const InterfaceView<Real>& view) {
        if (manner_.threads == 1) { // the others end with the same mesh, or are refused for that
            note(test::view_fault(view));
        }
    }

    void throw_if_asked() const {
        if (is_to_throw_) {
            throw Thrown();
        }
    }

    test::ChangingReport advance(Real time, Real dt) {
        if (is_by_curvature(row_)) {
            return simulation_->step(
                InterfaceMotion<Real>([&](const InterfaceView<Real>& view, Real at, Real for_dt,
                                          std::span<Point<Real>> ways) {
                    throw_if_asked();
                    look_at(view);
                    curvature_flow<Real>(bending_of(scene_))(view, at, for_dt, ways);
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
                    look_at(view);
                    if (is_normal(row_)) {
                        throw_if_asked();
                        growth<Real>(growth_of<Real>(row_, scene_))(view, begin, end, at, values);
                    } else {
                        velocity(view.positions.subspan(begin, end - begin), at,
                                 values.subspan(begin, end - begin));
                    }
                }),
                time, dt);
        case Told::motion:
            return simulation_->step(
                InterfaceMotion<Real>([&](const InterfaceView<Real>& view, Real at, Real for_dt,
                                          std::span<Point<Real>> ways) {
                    look_at(view);
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

    // --- steps -----------------------------------------------------------------------------------
    void step(int i) {
        const Real dt = static_cast<Real>(scene_.end / scene_.steps);
        const Real time = static_cast<Real>(i) * dt;
        const std::string when = ", step " + std::to_string(i);
        const Interruption now = i == scene_.steps / 2 ? interruption_ : Interruption::none;
        if (now == Interruption::thrown) {
            is_to_throw_ = true;
            try {
                (void)advance(time, dt);
                note("what the application's function throws is lost", when);
            } catch (const Thrown&) {
                is_to_throw_ = false;
            }
        } else if (now == Interruption::pause) {
            take(advance(time, 0), when);
        } else if (now == Interruption::tiny_step) {
            take(advance(time, dt * std::numeric_limits<Real>::epsilon()), when);
        }
        const test::ChangingReport report = advance(time, dt);
        take(report, when);
        for (std::uint32_t k = 0; k < report.sub_steps; ++k) {
            outcome_.times.push_back(static_cast<double>(time) +
                                     static_cast<double>(dt) * k / report.sub_steps);
        }
    }

    void take(const test::ChangingReport& report, const std::string& when) {
        outcome_.held += report.held;
        outcome_.unreached += report.unreached;
        outcome_.events += report.events.size();
        note(report.gave_up == GiveUp::none ? "" : "gave up", when);
        note(account_fault(report, row_.topology == Rule::given_back), when);
        if (manner_.threads == 1) { // the others end with the same mesh, or are refused for that
            note(validate(*complex_).problem, when);
            if (row_.inside == Inside::still) {
                note(test::interface_fault(*complex_, simulation_->interface()), when);
            }
        }
        if (seen_ != nullptr) {
            const auto& regions = seen_->view().partition.colours.front().regions;
            outcome_.threads = std::max(outcome_.threads, seen_->view().threads_used);
            outcome_.submeshes =
                std::max(outcome_.submeshes, static_cast<std::uint32_t>(regions.size()));
        }
    }

    void interrupt() {
        if (row_.sizes == Sizes::switched_on || row_.sizes == Sizes::switched_off ||
            interruption_ == Interruption::set_options) {
            simulation_->set_options(options_of<Real>(row_, scene_, 1));
        }
        if (interruption_ == Interruption::renumbered) {
            (void)renumber(*complex_);
        }
    }

    void resume() {
        Archive kept;
        simulation_->archive(kept);
        begin();
        Archive again(kept.bytes(), "the archive of a run");
        simulation_->archive(again);
        again.expect_end();
    }

    void note(const std::string& problem, const std::string& when = {}) {
        if (!problem.empty()) {
            outcome_.problems.push_back(problem + when);
        }
    }

    const Row& row_;
    const Scene& scene_;
    const Manner& manner_;
    Interruption interruption_;
    bool is_to_throw_ = false;
    Outcome outcome_;
    std::unique_ptr<Complex<Real>> complex_;
    std::unique_ptr<test::ChangingSimulation<Real>> simulation_;
    const SubmeshExecutor<Real>* seen_ = nullptr;
};

} // namespace

Outcome run_row(const Row& row, const Scene& scene, const Manner& manner) {
    return row.precision == Precision::in_double ? Run<double>(row, scene, manner).run()
                                                 : Run<float>(row, scene, manner).run();
}

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
// A run by the library's method, in either precision.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/phases.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
#include "measures/mesh_quality.h"
#include "replay/replay.h"
#include "scenes/output/submesh_map.h"
#include "scenes/run/fluid_run.h"
#include "scenes/run/frame_arrays.h"
#include "scenes/run/kept_value.h"
#include "scenes/run/run.h"
#include "scenes/run/start.h"
#include "topology/stage.h"

#include <algorithm>
#include <filesystem>

namespace dsc::scenes {

template <class Real>
dsc::Velocity<Real> velocity_in(const Velocity& velocity) {
    if constexpr (std::is_same_v<Real, double>) {
        return velocity;
    } else {
        // The fields are evaluated in double, whatever the precision of the mesh.
        return [&velocity](std::span<const Point<Real>> positions, Real time,
                           std::span<Point<Real>> velocities) {
            std::vector<Point<double>> in(positions.size());
            std::vector<Point<double>> out(positions.size());
            for (std::size_t i = 0; i < in.size(); ++i) {
                in[i] = positions[i].template cast<double>();
            }
            velocity(in, static_cast<double>(time), out);
            for (std::size_t i = 0; i < in.size(); ++i) {
                velocities[i] = out[i].template cast<Real>();
            }
        };
    }
}

inline void add_operations(RunResult& result, const OperationCounts& counts) {
    auto& o = result.operations;
    o["moves"] += counts.moves;
    o["flips"] += counts.flips;
    o["interface_splits"] += counts.interface_splits;
    o["interface_collapses"] += counts.interface_collapses;
    o["splits"] += counts.splits;
    o["collapses"] += counts.collapses;
    o["smoothed"] += counts.smoothed;
    o["subdivisions"] += counts.subdivisions;
    o["retriangulations"] += counts.retriangulations;
    o["examined"] += counts.examined;
}

template <class Real>
class DscMethod {
public:
    DscMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run,
              InputReport* report = nullptr)
        : DscMethod(setup, parameters, run, first_complex<Real>(setup, parameters, report)) {}
    DscMethod(const Setup& setup, const Parameters& parameters, const RunOptions& run,
              Complex<Real> complex)
        : setup_(setup), complex_(std::move(complex)),
          options_(scene_options<Real>(setup, parameters)) {
        Submeshing submeshing = run.submeshing;
        submeshing.profile = !run.frames.folder.empty(); // frames show the work of submeshes
        if (setup.value) {
            value_.emplace(complex_, *setup.value);
        }
        std::optional<Algorithm<Real>> algorithm;
        if (setup.curvature) {
            by_curvature_ = curvature_flow<Real>(curvature_of(*setup.curvature));
        }
        if (setup.growth) {
            algorithm =
                growth_algorithm(complex_, growth_of(*setup.growth, both_ways,
                                                     std::numeric_limits<double>::infinity()));
        }
        auto executor = make_executor(complex_, options_, run.strategy, submeshing,
                                      algorithm ? &*algorithm : nullptr);
        executor_ = executor.get();
        if (run.strategy == Strategy::copy) { // always uses one thread for each submesh
            threads_of_copies_ =
                std::min(submeshing.threads, submeshes_of(run.strategy, submeshing));
        }
        simulation_ = std::make_unique<Simulation<Real>>(complex_, options_, std::move(executor));
        watch_.emplace(*simulation_);
        if (const auto topology = topology_options<Real>(parameters); topology.changes()) {
            topology_ = std::make_shared<TopologyStage<Real>>(topology);
            simulation_->add_stage(topology_);
        }
        if constexpr (std::is_same_v<Real, double>) {
            if (setup.fluid) {
                fluid_ = std::make_unique<FluidRun>(complex_, setup, submeshing.threads);
                if (!topology_) {
                    fluid_->check_pairs_meet();
                }
            }
        }
        if (!run.edits.empty()) {
            edits_.emplace(run.edits);
            simulation_->add_listener(
                [this](std::span<const Edit> edits) { edits_->write(edits); });
        }
    }

    /// Saves the state in case the step fails; not part of the step's time.
    void before_step() {
        if constexpr (std::is_same_v<Real, double>) {
            if (fluid_) {
                fluid_->before_step(*simulation_);
            }
        }
    }
    /// Measures the step; not part of the step's time.
    void after_step() {
        if (fluid_) {
            fluid_->look();
        }
    }
    void step(double begin, double end, RunResult& result) {
        const auto time = static_cast<Real>(begin);
        const auto dt = static_cast<Real>(setup_.dt);
        if (fluid_) {
            step_fluid(begin, result);
        } else if (setup_.growth) {
            const double way = both_ways(*setup_.growth, begin);
            const auto flow = dsc::growth<Real>(growth_of(
                *setup_.growth, [way](const Growth&, double) { return way; }, begin));
            take(simulation_->step(flow, time, dt), begin, result);
        } else if (setup_.curvature) {
            take(simulation_->step(by_curvature_, time, dt), begin, result);
        } else {
            const Velocity& velocity = velocity_of_step(setup_.flow, begin, end);
            if (&velocity != leg_) {
                simulation_->forget();
                leg_ = &velocity;
            }
            if (value_) {
                value_->set_interface(simulation_->interface(), begin + setup_.dt);
            }
            take(simulation_->step(velocity_in<Real>(velocity), time, dt), begin, result);
        }
    }
    /// Writes or reads the whole state after this step.
    void archive(Archive& archive, int step) {
        simulation_->archive(archive);
        if (fluid_) {
            fluid_->archive(archive);
        }
        if (archive.is_reading()) {
            watch_->forget();
        }
        leg_ = velocity_before(step);
    }
    /// To be called after the last step: moves the log of edits to its path.
    void finish() {
        if (edits_) {
            edits_->commit();
        }
    }
    [[nodiscard]] const Complex<Real>& complex() const { return complex_; }
    [[nodiscard]] const Executor<Real>& executor() const { return *executor_; }
    /// The worst quality of all checks so far, and the triangles that are inverted now.
    [[nodiscard]] MeshQuality worst() { return watch_->look(); }
    /// The largest error of the value at the vertices; NaN without such a value.
    [[nodiscard]] double value_error() const {
        return value_ ? value_->largest_error() : std::numeric_limits<double>::quiet_NaN();
    }
    /// The figures of a fluid after the last step; empty without a fluid.
    [[nodiscard]] Figures fluid_now() const { return fluid_ ? fluid_->now() : Figures{}; }
    /// The figures of a fluid over the whole run.
    [[nodiscard]] Figures fluid_figures() const { return fluid_ ? fluid_->figures() : Figures{}; }
    [[nodiscard]] std::uint64_t interface_vertices() const { return simulation_->interface_size(); }
    /// Threads that the last step used.
    [[nodiscard]] std::uint32_t threads_used() const {
        const std::optional<SubmeshView> submeshes = submeshes_in(*executor_);
        return submeshes ? submeshes->threads_used : threads_of_copies_;
    }
    /// To be called before a step whose end has a frame...
    void begin_frame() { begin_displacements(complex_); }
    /// ...for its arrays.
    std::vector<VtuArray> end_frame(int step) {
        const Velocity* velocity = velocity_before(std::max(step, 1));
        const std::optional<SubmeshView> submeshes = submeshes_in(*executor_);
        FrameView<Real> view{.time = static_cast<Real>(step * setup_.dt),
                             .dt = static_cast<Real>(step > 0 ? setup_.dt : 0),
                             .edge_length = options_.edge_length,
                             .is_uniform = options_.sizes.is_uniform(),
                             .partition = submeshes ? &submeshes->partition : nullptr};
        dsc::Velocity<Real> field;
        if (velocity != nullptr) {
            field = velocity_in<Real>(*velocity);
            view.velocity = &field;
        }
        std::vector<VtuArray> arrays = frame_arrays(complex_, view);
        if (fluid_) {
            fluid_->put_into(arrays);
        }
        end_displacements(complex_);
        return arrays;
    }
    /// Writes the submeshes, if any, to a file beside a frame.
    void map_submeshes(const std::string& frame) const {
        const std::optional<SubmeshView> submeshes = submeshes_in(*executor_);
        if (submeshes && !submeshes->partition.colours.empty() && !frame.empty()) {
            write_submesh_map(*submeshes,
                              std::filesystem::path(frame).replace_extension("submeshes.json"));
        }
    }

private:
    // The velocity of the step; null if the motion is not by a velocity.
    [[nodiscard]] const Velocity* velocity_before(int step) const {
        return step == 0 || setup_.sees_interface()
                   ? nullptr
                   : &velocity_of_step(setup_.flow, (step - 1) * setup_.dt, step * setup_.dt);
    }

    void step_fluid(double time, RunResult& result) {
        if constexpr (std::is_same_v<Real, double>) {
            const StepReport report = fluid_->step(*simulation_, setup_.dt);
            if (report.gave_up != GiveUp::none || !fluid_->failure().empty()) {
                watch_->forget();
            }
            take(report, time, result);
            if (!fluid_->failure().empty()) {
                result.gave_up = fluid_->failure();
            }
        }
    }

    // A step that begins, up to rounding, at the time of the turn shrinks the phase.
    static double both_ways(const Growth& growth, double time) {
        return time < growth.turns_at * (1 - 1e-9) ? 1 : -1;
    }
    // The speeds for a step that begins at a time: a disc that begins to grow within the step grows
    // at the corresponding fraction of its speed.
    template <class Way>
    [[nodiscard]] dsc::GrowthOptions<Real> growth_of(const Growth& growth, Way way,
                                                     double begin) const {
        dsc::GrowthOptions<Real> options;
        if (!growth.discs) {
            options.speeds = {{.growing = 1, .into = exterior_phase, .speed = growth.speed}};
        } else {
            for (std::size_t i = 0; i < growth.discs->radii.size(); ++i) {
                const double share = (begin + setup_.dt - growth.discs->start(i)) / setup_.dt;
                options.speeds.push_back({.growing = static_cast<Phase>(i + 1),
                                          .into = exterior_phase,
                                          .speed = growth.speed * std::clamp(share, 0.0, 1.0)});
            }
        }
        options.factor = [growth, way](const Point<Real>&, Real time) {
            return static_cast<Real>(way(growth, static_cast<double>(time)));
        };
        return options;
    }

    [[nodiscard]] CurvatureFlowOptions curvature_of(const CurvatureMotion& motion) const {
        CurvatureFlowOptions options;
        options.pairs = motion.pairs;
        for (const Phase phase : motion.keeps) {
            options.kept_areas.push_back({phase, phase_area(complex_, phase)});
        }
        return options;
    }

    void take(const StepReport& report, double time, RunResult& result) {
        result.unreached += report.unreached;
        result.held += report.held;
        result.sub_steps += report.sub_steps;
        if (report.gave_up != GiveUp::none) {
            result.gave_up = "in a step at time " + std::to_string(time) + ", " + sentence(report);
        }
        add_operations(result, report.operations);
        if (topology_) {
            result.area += topology_->take_area();
            const std::vector<Event> events = topology_->take_events();
            result.events.insert(result.events.end(), events.begin(), events.end());
        }
    }

    const Setup& setup_;
    Complex<Real> complex_;
    Options<Real> options_;
    std::unique_ptr<Simulation<Real>> simulation_;
    std::optional<QualityWatch<Real>> watch_;       // of the simulation
    std::shared_ptr<TopologyStage<Real>> topology_; ///< null if the topology is kept
    const Executor<Real>* executor_ = nullptr;      // of the simulation
    std::uint32_t threads_of_copies_ = 1;           ///< number of threads if submeshes are copied
    const Velocity* leg_ = nullptr;                 ///< the velocity of the previous step
    InterfaceMotion<Real> by_curvature_;
    std::optional<EditFile> edits_;
    std::optional<KeptValue<Real>> value_;
    std::unique_ptr<FluidRun> fluid_; ///< null if no fluid moves the interface
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// A simulation as Python sees it: with its mesh, its stages, and what the last step did.
#pragma once

#include "python/flows.h"
#include "python/mesh.h"
#include "python/options.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc::python {

/// After each sub-step it notes how far the step has come, and lets handlers of signals run: what
/// they raise, such as KeyboardInterrupt, ends the step.
class Watch final : public Stage<double> {
public:
    StepReport so_far;
    void run(const Between<double>& between) override {
        ++so_far.sub_steps;
        so_far.unreached += between.unreached;
        so_far.reached = between.time;
        so_far.interface_vertices = static_cast<std::uint32_t>(between.interface.size());
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
};

/// A simulation with its mesh, its stages and what the last step did.
class Running {
public:
    Running(std::shared_ptr<Mesh> mesh, const AnyFlow* flow, const py::dict& keywords)
        : mesh_(std::move(mesh)) {
        apply(choices_, keywords);
        const auto change = mesh_->change();     // refused while a step of it runs
        const py::gil_scoped_release others_run; // sizes may be functions of Python
        Complex<double>& complex = mesh_->complex_to_step();
        complex.in_use.expect_free();
        forget_foreign_data(complex);
        const Options<double>& options = choices_.options;
        check_options(options);
        const std::optional<Parallel> parallel = choices_.parallel();
        std::unique_ptr<Executor<double>> executor;
        if (flow != nullptr && flow->growth) {
            const auto algorithm = growth_algorithm(complex, *flow->growth);
            executor = parallel ? make_executor(complex, options, *parallel, algorithm)
                                : std::make_unique<Executor<double>>(complex, options, algorithm);
        } else if (parallel) {
            executor = make_executor(complex, options, *parallel);
        }
        simulation_ = std::make_unique<Simulation<double>>(complex, options, std::move(executor));
        simulation_->add_stage(watch_);
        if (choices_.topology.changes()) {
            topology_ = std::make_shared<TopologyStage<double>>(choices_.topology);
            simulation_->add_stage(topology_);
        }
    }

    [[nodiscard]] const std::shared_ptr<Mesh>& mesh() const { return mesh_; }
    [[nodiscard]] py::dict options() const { return values_of(choices_); }
    [[nodiscard]] double time() const { return report_.reached; }
    /// What the last step did, by the names of dsc/records.py.
    [[nodiscard]] py::dict report() const;
    [[nodiscard]] std::size_t interface_size() const {
        (void)mesh_->complex(); // refused while a step runs
        return simulation_->interface_size();
    }

    void step(const AnyFlow& flow, double time, double dt) {
        step_by([&](auto& simulation) { return flow.step(simulation, time, dt); }, time);
    }

    /// A step of something that steps the simulation itself.
    template <class MakeStep>
    void step_by(MakeStep make_step, double time) {
        const auto change = mesh_->change();
        watch_->so_far = {};
        watch_->so_far.reached = time;
        try {
            const py::gil_scoped_release others_run;
            report_ = make_step(*simulation_);
        } catch (...) {
            report_ = watch_->so_far;
            note_events();
            throw;
        }
        note_events();
    }

    [[nodiscard]] py::bytes state() {
        (void)mesh_->complex(); // refused while a step runs
        Archive archive;
        archive(report_.reached);
        simulation_->archive(archive);
        return archive.bytes();
    }
    void restore(const std::string& bytes) {
        const auto change = mesh_->change();
        Archive archive(bytes, "simulation");
        archive(report_.reached);
        simulation_->archive(archive);
        archive.expect_end();
    }

private:
    void note_events() { events_ = topology_ ? topology_->take_events() : std::vector<Event>(); }

    std::shared_ptr<Mesh> mesh_;
    Choices choices_;
    StepReport report_;         ///< of the last step...
    std::vector<Event> events_; ///< ...and the changes of topology in it
    std::shared_ptr<Watch> watch_ = std::make_shared<Watch>();
    std::shared_ptr<TopologyStage<double>> topology_;
    std::unique_ptr<Simulation<double>> simulation_;
};

} // namespace dsc::python

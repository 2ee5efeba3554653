// SPDX-License-Identifier: MIT
#include "python/simulation.h"

#include "python/data.h"
#include "python/flows.h"
#include "python/mesh.h"
#include "python/options.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>
#include <vector>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

/// What a step did, with the changes of topology in it.
struct Report {
    StepReport step;
    std::vector<Event> events;
};

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
    Running(std::shared_ptr<Mesh> mesh, const OwnFlow* flow, const py::dict& keywords)
        : mesh_(std::move(mesh)) {
        if (flow != nullptr) {
            flow_ = *flow;
        }
        apply(choices_, keywords);
        const Mesh::Change change(*mesh_); // refused while a step of it runs
        Complex<double>& complex = mesh_->complex_to_step();
        complex.in_use.expect_free();
        forget_foreign_data(complex);
        const Options<double>& options = choices_.options;
        check_options(options);
        std::unique_ptr<Executor<double>> executor;
        if (flow != nullptr && flow->growth) {
            const auto algorithm = growth_algorithm(complex, *flow->growth);
            executor = choices_.is_parallel
                           ? make_executor(complex, options, choices_.parallel, algorithm)
                           : std::make_unique<Executor<double>>(complex, options, algorithm);
        } else if (choices_.is_parallel) {
            executor = make_executor(complex, options, choices_.parallel);
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
    [[nodiscard]] const Report& report() const { return report_; }
    [[nodiscard]] const std::optional<OwnFlow>& flow() const { return flow_; }
    [[nodiscard]] std::size_t interface_size() const {
        (void)mesh_->complex(); // refused while a step runs
        return simulation_->interface_size();
    }

    Report step(const py::object& flow, double time, double dt) {
        if (py::isinstance<OwnFlow>(flow)) {
            return std::visit([&](const auto& one) { return step_along(one, time, dt); },
                              flow.cast<const OwnFlow&>().flow);
        }
        if (PyCallable_Check(flow.ptr()) == 0) {
            throw InputError({.what = "not a flow",
                              .where = "Simulation.step",
                              .value = shown(flow),
                              .allowed = "a function of positions (n, 2) and time, or a dsc.Flow"});
        }
        return step_along(velocity_of(py::reinterpret_borrow<py::function>(flow)), time, dt);
    }

    /// A step of something that steps the simulation itself.
    template <class MakeStep>
    Report step_by(MakeStep make_step, double time) {
        const Mesh::Change busy(*mesh_);
        const py::gil_scoped_release others_run;
        watch_->so_far = {};
        watch_->so_far.reached = time;
        try {
            report_.step = make_step(*simulation_);
        } catch (...) {
            report_ = {watch_->so_far, take_events()};
            throw;
        }
        report_.events = take_events();
        return report_;
    }

    [[nodiscard]] py::bytes state() {
        (void)mesh_->complex(); // refused while a step runs
        Archive archive;
        std::vector<std::string> late = names_after_foreign_data(mesh_->complex());
        archive(late, report_.step.reached);
        simulation_->archive(archive);
        return archive.bytes();
    }
    void restore(const std::string& bytes) {
        const Mesh::Change change(*mesh_);
        Archive archive(bytes, "simulation");
        std::vector<std::string> late;
        archive(late, report_.step.reached);
        put_last(mesh_->complex_to_step(), late);
        simulation_->archive(archive);
        archive.expect_end();
    }

private:
    Report step_along(const SeeingFunction& seeing, double time, double dt) {
        return step_along(motion_of(seeing, choices_.options.integrator), time, dt);
    }
    template <class AnyFlow>
    Report step_along(const AnyFlow& flow, double time, double dt) {
        return step_by([&](auto& simulation) { return simulation.step(flow, time, dt); }, time);
    }
    [[nodiscard]] std::vector<Event> take_events() {
        return topology_ ? topology_->take_events() : std::vector<Event>();
    }

    std::shared_ptr<Mesh> mesh_;
    std::optional<OwnFlow> flow_; ///< that it was made for
    Choices choices_;
    Report report_;
    std::shared_ptr<Watch> watch_ = std::make_shared<Watch>();
    std::shared_ptr<TopologyStage<double>> topology_;
    std::unique_ptr<Simulation<double>> simulation_;
};

std::string shown_report(const Report& report) {
    const StepReport& step = report.step;
    std::string text = "<dsc.Report: " + std::to_string(step.sub_steps) + " sub-steps, " +
                       std::to_string(step.interface_vertices) + " interface vertices, " +
                       std::to_string(step.unreached) + " unreached";
    if (!report.events.empty()) {
        text += ", " + std::to_string(report.events.size()) + " events";
    }
    if (step.gave_up != GiveUp::none) {
        text += ", gave up";
    }
    return text + ">";
}

std::string shown_event(const Event& event) {
    return "<dsc.Event: " + std::string(to_string(event.kind)) + " at (" + std::to_string(event.x) +
           ", " + std::to_string(event.y) + "), time " + std::to_string(event.time) + ">";
}

} // namespace

void add_simulation(py::module_& module) {
    py::class_<Event>(module, "Event", "A change of topology.")
        .def_property_readonly(
            "kind", [](const Event& event) { return std::string(to_string(event.kind)); },
            names_in(event_names).c_str())
        .def_readonly("time", &Event::time, "at the end of the sub-step")
        .def_property_readonly(
            "place", [](const Event& event) { return std::pair(event.x, event.y); },
            "where: (x, y)")
        .def_readonly("lost", &Event::lost, "the phase whose area it was")
        .def_readonly("taken", &Event::taken, "the phases that took the area")
        .def_readonly("area", &Event::area, "that changed hands")
        .def("__repr__", &shown_event);

    py::class_<Report>(module, "Report", "What one step did.")
        .def_property_readonly(
            "unreached", [](const Report& report) { return report.step.unreached; },
            "vertices that did not arrive, summed over sub-steps")
        .def_property_readonly(
            "held", [](const Report& report) { return report.step.held; },
            "of these: vertices held because of a velocity that was not finite")
        .def_property_readonly(
            "sub_steps", [](const Report& report) { return report.step.sub_steps; },
            "how many the step was cut into")
        .def_property_readonly(
            "interface_vertices",
            [](const Report& report) { return report.step.interface_vertices; },
            "at the end of the step")
        .def_property_readonly(
            "reached", [](const Report& report) { return report.step.reached; },
            "the time at the end: earlier than asked for if the step gave up")
        .def_property_readonly(
            "gave_up", [](const Report& report) { return report.step.gave_up != GiveUp::none; },
            "whether the velocity required more than `max_sub_steps`")
        .def_readonly("events", &Report::events, "changes of topology, in their order")
        .def("__repr__", &shown_report);

    const std::string help = R"(
Moves the interface of a mesh, and keeps the mesh a valid complex around it.

One simulation of a mesh at a time.

Parameters
----------
mesh : Mesh
flow : Flow, optional
    A flow that the simulation has to be made for: `growth`.
**options
    The following ones.


)" + option_help();
    py::class_<Running>(module, "Simulation", help.c_str())
        .def(py::init(
                 [](std::shared_ptr<Mesh> mesh, const OwnFlow* flow, const py::kwargs& options) {
                     return std::make_unique<Running>(std::move(mesh), flow, options);
                 }),
             "mesh"_a, "flow"_a = py::none())
        .def("step", &Running::step, "flow"_a, "time"_a, "dt"_a, R"(
Moves the interface from `time` to `time + dt`.

Parameters
----------
flow : callable or Flow
    A function of positions (n, 2) and the time, which returns velocities (n, 2). It is called once
    in each stage of the integrator, for all vertices of the interface, by the thread that called
    `step`. What it raises comes out of `step`; the mesh is valid then, and has not arrived yet:
    `time` and `report` say how far it came.
time, dt : float

Returns
-------
Report
)")
        .def_property_readonly("mesh", &Running::mesh, "The mesh that moves.")
        .def_property_readonly(
            "time", [](const Running& simulation) { return simulation.report().step.reached; },
            "The time that the last step reached, be it by an exception.")
        .def_property_readonly("report", &Running::report,
                               "Of the last step, be it one that ended by an exception.")
        .def_property_readonly("flow", &Running::flow, "The flow that it was made for, or None.")
        .def_property_readonly("options", &Running::options, "All options: a dict.")
        .def_property_readonly("interface_size", &Running::interface_size,
                               "The number of interface vertices.")
        .def("_state", &Running::state)
        .def("_restore", &Running::restore, "state"_a)
        .def("__repr__", [](const Running& simulation) {
            return "<dsc.Simulation: " + std::to_string(simulation.interface_size()) +
                   " interface vertices, time " + to_text(simulation.report().step.reached) + ">";
        });
}

} // namespace dsc::python

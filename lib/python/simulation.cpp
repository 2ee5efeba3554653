// SPDX-License-Identifier: MIT
#include "python/simulation.h"

#include "python/flows.h"
#include "python/mesh.h"
#include "python/options.h"

#include <pybind11/stl.h>

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

class Running {
public:
    Running(std::shared_ptr<Mesh> mesh, const py::dict& keywords) : mesh_(std::move(mesh)) {
        (void)mesh_->complex(); // refused while another step of it runs
        apply(choices_, keywords);
        Complex<double>& complex = mesh_->complex_to_step();
        simulation_ =
            choices_.is_parallel
                ? std::make_unique<Simulation<double>>(complex, choices_.options, choices_.parallel)
                : std::make_unique<Simulation<double>>(complex, choices_.options);
        if (choices_.topology.changes()) {
            topology_ = std::make_shared<TopologyStage<double>>(choices_.topology);
            simulation_->add_stage(topology_);
        }
    }

    [[nodiscard]] const std::shared_ptr<Mesh>& mesh() const { return mesh_; }
    [[nodiscard]] py::dict options() const { return values_of(choices_); }
    [[nodiscard]] std::size_t interface_size() const {
        (void)mesh_->complex(); // refused while a step runs
        return simulation_->interface_size();
    }
    [[nodiscard]] double time() const { return time_; }

    Report step(const py::object& flow, double time, double dt) {
        if (py::isinstance<BuiltIn>(flow)) {
            const BuiltIn& own = flow.cast<const BuiltIn&>();
            return std::visit([&](const auto& one) { return step_along(one, time, dt); }, own.flow);
        }
        if (!py::isinstance<py::function>(flow) && !PyCallable_Check(flow.ptr())) {
            throw InputError({.what = "not a flow",
                              .where = "Simulation.step",
                              .value = shown(flow),
                              .allowed = "a function of positions (n, 2) and time, or a dsc.Flow"});
        }
        return step_along(velocity_of(py::reinterpret_borrow<py::function>(flow)), time, dt);
    }

private:
    template <class AnyFlow>
    Report step_along(const AnyFlow& flow, double time, double dt) {
        const Mesh::Step busy(*mesh_);
        const py::gil_scoped_release others_run;
        Report report;
        report.step = simulation_->step(flow, time, dt);
        time_ = report.step.reached;
        if (topology_) {
            report.events = topology_->take_events();
        }
        return report;
    }

    std::shared_ptr<Mesh> mesh_;
    Choices choices_;
    std::shared_ptr<TopologyStage<double>> topology_;
    std::unique_ptr<Simulation<double>> simulation_;
    double time_ = 0;
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

One simulation of a mesh at a time. Options are keyword arguments:

)" + option_help();
    py::class_<Running>(module, "Simulation", help.c_str())
        .def(py::init([](std::shared_ptr<Mesh> mesh, const py::kwargs& options) {
                 return std::make_unique<Running>(std::move(mesh), options);
             }),
             "mesh"_a)
        .def("step", &Running::step, "flow"_a, "time"_a, "dt"_a, R"(
Moves the interface from `time` to `time + dt`.

Parameters
----------
flow : callable or Flow
    A function of positions (n, 2) and the time, which returns velocities (n, 2). It is called once
    in each stage of the integrator, for all vertices of the interface, by the thread that called
    `step`. What it raises comes out of `step`; the mesh is valid then, and has not arrived yet.
time, dt : float

Returns
-------
Report
)")
        .def_property_readonly("mesh", &Running::mesh, "The mesh that moves.")
        .def_property_readonly("time", &Running::time, "The time that the last step reached.")
        .def_property_readonly("options", &Running::options, "All options: a dict.")
        .def_property_readonly("interface_size", &Running::interface_size,
                               "The number of interface vertices.")
        .def("__repr__", [](const Running& simulation) {
            return "<dsc.Simulation: " + std::to_string(simulation.interface_size()) +
                   " interface vertices>";
        });
}

} // namespace dsc::python

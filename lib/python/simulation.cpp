// SPDX-License-Identifier: MIT
#include "python/simulation.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>
#include <vector>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

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

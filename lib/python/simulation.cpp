// SPDX-License-Identifier: MIT
#include "python/simulation.h"

#include <pybind11/stl.h>

#include <optional>
#include <utility>
#include <vector>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

py::object event_record(const Event& event) {
    return record("Event",
                  py::dict("kind"_a = std::string(to_string(event.kind)), "time"_a = event.time,
                           "place"_a = std::pair(event.x, event.y), "lost"_a = event.lost,
                           "taken"_a = std::pair(event.taken[0], event.taken[1]),
                           "area"_a = event.area));
}

} // namespace

py::object Report::made() const {
    py::list list;
    for (const Event& event : events) {
        list.append(event_record(event));
    }
    return record("Report",
                  py::dict("unreached"_a = step.unreached, "held"_a = step.held,
                           "sub_steps"_a = step.sub_steps,
                           "interface_vertices"_a = step.interface_vertices,
                           "reached"_a = step.reached, "gave_up"_a = step.gave_up != GiveUp::none,
                           "events"_a = list));
}

void add_simulation(py::module_& module) {
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
        .def_property_readonly(
            "report", [](const Running& simulation) { return simulation.report().made(); },
            "Of the last step, be it one that ended by an exception.")
        .def_property_readonly("flow", &Running::flow, "The flow that it was made for, or None.")
        .def_property_readonly("options", &Running::options, "All options: a dict.")
        .def_property_readonly("interface_size", &Running::interface_size,
                               "The number of interface vertices.")
        .def("_state", &Running::state)
        .def("_restore", &Running::restore, "state"_a);
}

} // namespace dsc::python

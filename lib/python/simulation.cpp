// SPDX-License-Identifier: MIT
#include "python/simulation.h"

#include "python/module.h"

#include <string>

namespace dsc::python {

namespace {

py::dict event_of(const Event& event) {
    return py::dict("kind"_a = std::string(to_string(event.kind)), "time"_a = event.time,
                    "place"_a = std::pair(event.x, event.y), "lost"_a = event.lost,
                    "taken"_a = std::pair(event.taken[0], event.taken[1]), "area"_a = event.area);
}

} // namespace

py::dict Running::report() const {
    py::list events;
    for (const Event& event : events_) {
        events.append(event_of(event));
    }
    return py::dict("unreached"_a = report_.unreached, "held"_a = report_.held,
                    "sub_steps"_a = report_.sub_steps,
                    "interface_vertices"_a = report_.interface_vertices,
                    "reached"_a = report_.reached, "gave_up"_a = report_.gave_up != GiveUp::none,
                    "events"_a = events);
}

void add_simulation(py::module_& module) {
    module.attr("option_help") = option_help();

    py::class_<Running>(module, "Simulation")
        .def(py::init<std::shared_ptr<Mesh>, const AnyFlow*, const py::dict&>(),
             py::keep_alive<1, 2>()) // what the mesh is in Python
        .def("_step", &Running::step)
        .def("_report", &Running::report)
        .def("_state", &Running::state)
        .def("_restore", &Running::restore)
        .def_property_readonly("mesh", &Running::mesh, "The mesh that moves.")
        .def_property_readonly("time", &Running::time,
                               "The time that the last step reached, be it by an exception.")
        .def_property_readonly("options", &Running::options, "All options: a dict.")
        .def_property_readonly("interface_size", &Running::interface_size,
                               "The number of interface vertices.");
}

} // namespace dsc::python

// SPDX-License-Identifier: MIT
#include "python/flows.h"

#include "geometric_flows/geometric_flows.h"
#include "python/arrays.h"
#include "python/mesh.h"

#include <memory>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

VelocityAtOnce<double> velocity_of(const py::function& function) {
    // Copies of the velocity are made and dropped without the GIL.
    const std::shared_ptr<py::function> shared(new py::function(function), [](py::function* last) {
        const py::gil_scoped_acquire gil;
        delete last; // NOLINT: the deleter of a shared_ptr
    });
    return {[shared](std::span<const Point<double>> positions, double time,
                     std::span<Point<double>> velocities) {
        const py::gil_scoped_acquire gil;
        read_points((*shared)(array_of(positions), time), velocities, "what the velocity returns");
    }};
}

void add_flows(py::module_& module) {
    py::class_<BuiltIn>(module, "Flow", "A flow of the library's own, for `Simulation.step`.")
        .def("__repr__", [](const BuiltIn& flow) { return "<dsc.Flow: " + flow.name + ">"; });

    module.def(
        "curvature_flow",
        [](double tension, double mobility, const py::object& keep_areas_of) {
            CurvatureFlowOptions options{.tension = tension, .mobility = mobility};
            if (!keep_areas_of.is_none()) {
                const Mesh& mesh = keep_areas_of.cast<const Mesh&>();
                for (const Phase phase : phases(mesh.complex())) {
                    if (phase != exterior_phase) {
                        options.kept_areas.push_back({phase, phase_area(mesh.complex(), phase)});
                    }
                }
            }
            return BuiltIn{"curvature", curvature_flow<double>(options)};
        },
        py::kw_only(), "tension"_a = 1.0, "mobility"_a = 1.0, "keep_areas_of"_a = py::none(), R"(
The interface moves along its normal at tension * mobility * curvature.

Parameters
----------
tension, mobility : float
    Of all pairs of phases.
keep_areas_of : Mesh, optional
    Each phase but 0 keeps the area that it has in this mesh.
)");
}

} // namespace dsc::python

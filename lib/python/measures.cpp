// SPDX-License-Identifier: MIT
#include "python/measures.h"

#include "measures/hausdorff.h"
#include "measures/interface_outlines.h"
#include "measures/phases.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"

#include <pybind11/stl.h>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

using scenes::Outline;

// One outline, or several.
std::vector<Outline> outlines_from(const py::handle& value, const std::string& where) {
    const std::vector<py::object> list = outline_list(value);
    std::vector<Outline> outlines;
    for (const py::object& one : list) {
        outlines.push_back(points_from(one, where));
        scenes::check_outline(outlines.back(), where);
    }
    return outlines;
}

std::vector<py::array> arrays_of(const std::vector<Outline>& outlines) {
    std::vector<py::array> list;
    for (const Outline& outline : outlines) {
        list.push_back(array_of(outline));
    }
    return list;
}

// --- of outlines -------------------------------------------------------------------------------

double difference(const py::object& first, const py::object& second) {
    return scenes::symmetric_difference(outlines_from(first, "first"),
                                        outlines_from(second, "second"));
}

double distance(const py::object& first, const py::object& second) {
    return scenes::hausdorff(outlines_from(first, "first"), outlines_from(second, "second"))
        .distance();
}

// --- of a mesh ---------------------------------------------------------------------------------

std::vector<py::array> outlines_of(const Mesh& mesh, Phase phase, int samples) {
    return arrays_of(scenes::interface_outlines(
        mesh.complex(), {.reading = samples > 1 ? Reading::cubic : Reading::chords,
                         .samples = samples,
                         .phase = phase}));
}

py::array of_triangles(const Mesh& mesh, double (*value)(const Complex<double>&, Triangle)) {
    std::vector<double> list;
    for (const Triangle t : triangles(mesh.complex())) {
        list.push_back(value(mesh.complex(), t));
    }
    return array_of<double>(list);
}

py::dict figures(const Mesh& mesh) {
    const scenes::PhaseReport report = scenes::measure_phases(mesh.complex());
    py::dict phases;
    for (const scenes::PhaseFigures& one : report.phases) {
        phases[py::int_(one.phase)] =
            py::dict("area"_a = one.area, "perimeter"_a = one.perimeter, "wall"_a = one.wall,
                     "components"_a = one.components, "holes"_a = one.holes);
    }
    py::dict lengths;
    for (const scenes::PairFigures& pair : report.pairs) {
        lengths[py::make_tuple(pair.one, pair.other)] = pair.length;
    }
    return py::dict("phases"_a = phases, "lengths"_a = lengths);
}

py::array component_of(const Mesh& mesh) {
    const Components parts = components(mesh.complex());
    std::vector<std::int32_t> numbers;
    for (const Triangle t : triangles(mesh.complex())) {
        numbers.push_back(static_cast<std::int32_t>(parts.of[t.id]));
    }
    return array_of<std::int32_t>(numbers);
}

} // namespace

void add_measures(py::module_& module, py::class_<Mesh, std::shared_ptr<Mesh>>& mesh) {
    mesh.def("outlines", &outlines_of, "phase"_a, "samples"_a = 1, R"(
Closed loops around a phase, counter-clockwise, clockwise around its holes.

Parameters
----------
phase : int
samples : int
    Points to an edge, on the cubic through its neighbours; 1: the vertices alone.

Returns
-------
list of (n, 2) arrays
)")
        .def_property_readonly(
            "qualities", [](const Mesh& one) { return of_triangles(one, &quality<double>); },
            "Of each triangle: (m,), from 0 to 1 for an equilateral one.")
        .def_property_readonly(
            "min_angles", [](const Mesh& one) { return of_triangles(one, &min_angle_deg<double>); },
            "The smallest angle of each triangle, in degrees: (m,).")
        .def_property_readonly("figures", &figures, R"(
How the domain is divided among its phases: a dict.

`["phases"][phase]` is a dict of `area`, `perimeter` (with other phases), `wall` (length on the
domain boundary), `components` and `holes`; `["lengths"][one, other]` is the length of the interface
of two phases, the smaller one first.
)")
        .def_property_readonly(
            "component_of", &component_of,
            "Which connected part of its phase each triangle belongs to: (m,) int32, from 0.");

    module.def("symmetric_difference", &difference, "first"_a, "second"_a,
               R"(
The area that belongs to one of two regions alone, exact up to rounding.

Parameters
----------
first, second : (n, 2) array_like, or a list of them
    Outlines, such as `mesh.outlines(1)`; a point is inside if an odd number of them is around it.

Returns
-------
float

Examples
--------
>>> one = [(0, 0), (2, 0), (2, 1), (0, 1)]
>>> other = [(1, 0), (3, 0), (3, 1), (1, 1)]
>>> dsc.symmetric_difference(one, other)
2.0
)");
    module.def("hausdorff", &distance, "first"_a, "second"_a,
               "The largest distance from a point of either set of outlines to the other one.");
    module.def(
        "area",
        [](const py::object& outlines) {
            return scenes::signed_area(outlines_from(outlines, "outlines"));
        },
        "outlines"_a,
        "The area inside outlines that run counter-clockwise, clockwise around holes.");
    module.def(
        "circle",
        [](const py::object& centre, double radius, double edge_length) {
            return array_of(scenes::circle(point_from(centre, "centre"), radius, edge_length));
        },
        "centre"_a, "radius"_a, "edge_length"_a,
        "An outline (n, 2), counter-clockwise, whose edges are at most `edge_length` long. The "
        "first vertex is at angle 0.");
}

} // namespace dsc::python

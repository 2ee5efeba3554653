// SPDX-License-Identifier: MIT
#include "python/module.h"

#include "measures/hausdorff.h"
#include "measures/interface_outlines.h"
#include "measures/phases.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"

#include <vector>

namespace dsc::python {

namespace {

using Outlines = std::vector<Points>;

double difference(const Outlines& first, const Outlines& second) {
    return scenes::symmetric_difference(first, second);
}
double distance(const Outlines& first, const Outlines& second) {
    return scenes::hausdorff(first, second).distance();
}
double area(const Outlines& outlines) { return scenes::signed_area(outlines); }
Points circle(double x, double y, double radius, double edge_length) {
    return scenes::circle({x, y}, radius, edge_length);
}

Outlines outlines_of(const Mesh& mesh, Phase phase, int samples) {
    return scenes::interface_outlines(mesh.complex(),
                                      {.reading = samples > 1 ? Reading::cubic : Reading::chords,
                                       .samples = samples,
                                       .phase = phase});
}

// A measure of each triangle, as a property of meshes.
template <double (*measure)(const Complex<double>&, Triangle)>
py::array of_triangles(const Mesh& mesh) {
    const Complex<double>& complex = mesh.complex();
    return array_over(triangles(complex), [&](Triangle t) { return measure(complex, t); });
}

py::array component_of(const Mesh& mesh) {
    const Complex<double>& complex = mesh.complex();
    const Components parts = components(complex);
    const auto number = [&](Triangle t) { return static_cast<std::int32_t>(parts.of[t.id]); };
    return array_over(triangles(complex), number);
}

py::dict figures(const Mesh& mesh) {
    const scenes::PhaseReport report = scenes::measure_phases(mesh.complex());
    py::dict phases;
    for (const scenes::PhaseFigures& one : report.phases) {
        phases[py::int_(one.phase)] = py::dict(
            "area"_a = one.area, "perimeter"_a = one.perimeter, "boundary"_a = one.boundary,
            "components"_a = one.components, "holes"_a = one.holes);
    }
    py::dict lengths;
    for (const scenes::PairFigures& pair : report.pairs) {
        lengths[py::make_tuple(pair.one, pair.other)] = pair.length;
    }
    return py::dict("phases"_a = phases, "lengths"_a = lengths);
}

} // namespace

void add_measures(py::module_& module, MeshClass& mesh) {
    module.def("symmetric_difference", &difference);
    module.def("hausdorff", &distance);
    module.def("area", &area);
    module.def("circle", &circle);
    module.def("check_outline", &scenes::check_outline);

    mesh.def("_outlines", &outlines_of)
        .def("_area", [](const Mesh& one, Phase phase) { return phase_area(one.complex(), phase); })
        .def_property_readonly("figures", &figures, R"(
How the domain is divided among its phases: a dict.

`["phases"][phase]` is a dict of `area`, `perimeter` (with other phases), `boundary` (length on the
domain boundary), `components` and `holes`; `["lengths"][one, other]` is the length of the interface
of two phases, the smaller one first.
)")
        .def_property_readonly(
            "qualities", &of_triangles<&quality<double>>,
            "The quality of each triangle: (m,), from 0 to 1 for an equilateral one.")
        .def_property_readonly("min_angles", &of_triangles<&min_angle_deg<double>>,
                               "The smallest angle of each triangle, in degrees: (m,).")
        .def_property_readonly("component_of", &component_of,
                               "The connected component of its phase to which each triangle "
                               "belongs: (m,) int32, from 0.");
}

} // namespace dsc::python

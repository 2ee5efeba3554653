// SPDX-License-Identifier: MIT
#include "python/mesh.h"

#include "python/data.h"
#include "python/measures.h"
#include "python/options.h"
#include "replay/mesh_hash.h"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

py::list curves_of(const Mesh& mesh) {
    py::list list;
    for (const InterfaceCurve& curve : interface_curves(mesh.complex())) {
        std::vector<Point<double>> points;
        for (const Vertex v : curve.vertices) {
            points.push_back(mesh.complex().position(v));
        }
        const Phase right = curve.right == border_phase ? exterior_phase : curve.right;
        list.append(
            record("Curve", py::dict("points"_a = array_of(points), "is_closed"_a = curve.is_closed,
                                     "left"_a = curve.left, "right"_a = right)));
    }
    return list;
}

std::shared_ptr<Mesh> mesh_from_arrays(const py::object& points, const py::object& triangles,
                                       const py::object& phases) {
    const std::vector<Point<double>> places = points_from(points, "points");
    const auto rows = whole_numbers(triangles, "triangles", "(m, 3)", 2);
    const auto numbers = whole_numbers(phases, "phases", "(m,)", 1);
    if (rows.shape(1) != 3 || rows.shape(0) != numbers.shape(0)) {
        refuse("arrays that do not fit", "Mesh",
               std::to_string(rows.shape(0)) + " triangles of " + std::to_string(rows.shape(1)) +
                   " and " + std::to_string(numbers.shape(0)) + " phases",
               "triangles (m, 3) and phases (m,)");
    }
    std::vector<std::array<std::uint32_t, 3>> corners(static_cast<std::size_t>(rows.shape(0)));
    std::memcpy(corners.data(), rows.data(), corners.size() * sizeof(corners[0]));
    return std::make_shared<Mesh>(make_complex<double>(
        places, corners, {numbers.data(), static_cast<std::size_t>(numbers.shape(0))}));
}

// --- the first complex -----------------------------------------------------------------------

Phase phase_from(const py::handle& value, const std::string& where) {
    if (!py::isinstance<py::int_>(value) || !(value >= py::int_(0)) ||
        !(value < py::int_(border_phase))) {
        refuse("not a phase", where, shown(value), "whole numbers from 0, below 4294967295");
    }
    return value.cast<Phase>();
}

// One polygon, or a list of polygons, for each phase.
std::vector<Shape> shapes_from(const py::dict& given) {
    std::vector<Shape> shapes;
    for (const auto& [key, value] : given) {
        const Phase phase = phase_from(key, "shapes");
        const std::string where = "shapes[" + std::to_string(phase) + "]";
        for (const py::object& one : outline_list(value)) {
            shapes.push_back({points_from(one, where), phase});
        }
    }
    return shapes;
}

std::vector<Curve> curves_from(const py::iterable& given) {
    std::vector<Curve> curves;
    for (const py::handle& one : given) {
        const auto parts = py::reinterpret_borrow<py::sequence>(one);
        const std::string where = "curves[" + std::to_string(curves.size()) + "]";
        if (!py::isinstance<py::sequence>(one) || py::len(parts) != 3) {
            refuse("not a curve", where, shown(one),
                   "(points, phase on the left, phase on the right)");
        }
        curves.push_back({points_from(parts[0], where), phase_from(parts[1], where),
                          phase_from(parts[2], where)});
    }
    return curves;
}

std::shared_ptr<Mesh> make_mesh(const py::handle& domain, const py::dict& shapes,
                                const py::object& curves, const py::kwargs& keywords) {
    const std::vector<Point<double>> corners = points_from(domain, "domain");
    if (corners.size() != 2) {
        refuse("not a rectangle", "domain", std::to_string(corners.size()) + " points",
               "two: the lower left corner and the upper right one");
    }
    const Rectangle rectangle{corners[0], corners[1]};
    Choices choices;
    apply(choices, keywords, Use::initial_complex);
    const InitialOptions options{.edge_length = choices.options.edge_length,
                                 .sizes = choices.options.sizes};
    const auto made_of = [&](const auto& list) {
        const py::gil_scoped_release others_run;
        return std::make_shared<Mesh>(
            initial_complex<double>(rectangle, std::span(list.data(), list.size()), options));
    };
    if (curves.is_none()) {
        return made_of(shapes_from(shapes));
    }
    if (!shapes.empty()) {
        refuse("shapes and curves", "initial_complex", "both", "either");
    }
    return made_of(curves_from(curves));
}

} // namespace

// --- the arrays ------------------------------------------------------------------------------

const Complex<double>& Mesh::complex() const {
    if (is_busy_) {
        throw std::runtime_error("a step of this mesh runs: read the mesh after it");
    }
    return complex_;
}

std::shared_ptr<void> Mesh::change() {
    (void)complex(); // throws if it is busy
    is_busy_ = true;
    arrays_.reset();
    ++revision_;
    return {this, [this](void* /*mesh*/) { is_busy_ = false; }};
}

const Mesh::Arrays& Mesh::arrays() {
    const Complex<double>& complex = this->complex();
    if (arrays_) {
        return *arrays_;
    }
    const auto rows = std::make_unique_for_overwrite<std::int32_t[]>(complex.vertex_bound());
    py::array_t<double> points({static_cast<py::ssize_t>(complex.vertex_count()), py::ssize_t{2}});
    double* place = points.mutable_data();
    std::int32_t row = 0;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const VertexRecord<double>& vertex = complex.vertices[v];
        if ((vertex.flags & vertex_dead) == 0) {
            rows[v] = row++;
            *place++ = vertex.x;
            *place++ = vertex.y;
        }
    }
    const auto count = static_cast<py::ssize_t>(complex.triangle_count());
    py::array_t<std::int32_t> corners({count, py::ssize_t{3}});
    py::array_t<std::uint32_t> numbers(count);
    std::int32_t* corner = corners.mutable_data();
    std::uint32_t* number = numbers.mutable_data();
    for (std::uint32_t t = border_triangle + 1; t < complex.triangle_bound(); ++t) {
        const TriangleRecord& triangle = complex.triangles[t];
        if (triangle.v[0] != no_id) {
            for (const std::uint32_t v : triangle.v) {
                *corner++ = rows[v];
            }
            *number++ = triangle.phase;
        }
    }
    arrays_ = Arrays{frozen(points), frozen(corners), frozen(numbers)};
    return *arrays_;
}

// --- the module ------------------------------------------------------------------------------

void add_mesh(py::module_& module) {
    py::class_<Mesh, std::shared_ptr<Mesh>> type(module, "Mesh", R"(
A triangle mesh whose triangles have phases: a 2D simplicial complex.

Made by `initial_complex`, changed by the steps of a `Simulation`. Arrays are without gaps,
C-contiguous and not writable; those of before a step stay as they were.

Parameters
----------
points : (n, 2) array_like
triangles : (m, 3) array_like of int
    Rows of `points`, either way round. An edge has at most two triangles.
phases : (m,) array_like of int
)");
    type.def(py::init(&mesh_from_arrays), "points"_a, "triangles"_a, "phases"_a)
        .def_property_readonly("points", &Mesh::points, "Vertices: (n, 2) float64.")
        .def_property_readonly("triangles", &Mesh::triangles,
                               "Rows of `points`, counter-clockwise: (m, 3) int32.")
        .def_property_readonly("phases", &Mesh::phases, "Of each triangle: (m,) uint32.")
        .def("interface_curves", &curves_of,
             "The interface as curves, cut where more than two phases meet: a list of `Curve`.")
        .def(
            "validate", [](const Mesh& mesh) { return validate(mesh.complex()).problem; },
            "What is wrong with the complex, '' if nothing is. Exact.")
        .def_property_readonly(
            "mesh_hash", [](const Mesh& mesh) { return mesh_hash(mesh.complex()); },
            "A number of 64 bits, equal for equal coordinates and phases, whatever their order.")
        .def(
            "write_svg",
            [](const Mesh& mesh, const std::string& path) { write_svg(mesh.complex(), path); },
            "path"_a, "Writes a picture.")
        .def(
            "write_vtu",
            [](const Mesh& mesh, const std::string& path) { write_vtu(mesh.complex(), path); },
            "path"_a, "Writes a file for ParaView.")
        .def(
            "copy", [](const Mesh& mesh) { return std::make_shared<Mesh>(mesh); },
            "A mesh of its own.")
        .def("__copy__", [](const Mesh& mesh) { return std::make_shared<Mesh>(mesh); })
        .def("__deepcopy__",
             [](const Mesh& mesh, const py::dict&) { return std::make_shared<Mesh>(mesh); })
        .def_property_readonly("revision", &Mesh::revision,
                               "How often the mesh has been changed: equal while its triangles are "
                               "the same.")
        .def("_state", [](const Mesh& mesh) { return py::bytes(bytes_of(mesh.complex())); })
        .def_static(
            "_from_state",
            [](const std::string& bytes) { return std::make_shared<Mesh>(complex_from(bytes)); },
            "state"_a);

    add_data(type);
    add_measures(module, type);

    const std::string help = R"(
The mesh that a simulation starts from.

Parameters
----------
domain : array_like (2, 2)
    The lower left corner of a rectangle, and the upper right one.
shapes : dict
    For each phase a polygon (n, 2), or a list of polygons. The innermost polygon counts; outside of
    all the phase is 0.
curves : sequence of (points, left, right), optional
    In place of shapes: curves from junction to junction with the phases on both sides.
**options
    The following ones.

)" + option_help(Use::initial_complex) +
                             R"(
Returns
-------
Mesh
)";
    module.def("initial_complex", &make_mesh, "domain"_a, "shapes"_a = py::dict(), py::kw_only(),
               "curves"_a = py::none(), help.c_str());
}

} // namespace dsc::python

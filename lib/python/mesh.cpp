// SPDX-License-Identifier: MIT
#include "python/mesh.h"

#include "python/module.h"
#include "python/options.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

namespace dsc::python {

namespace {

using CurveParts = std::tuple<Points, bool, Phase, Phase>;

std::vector<CurveParts> curves_of(const Mesh& mesh) {
    std::vector<CurveParts> list;
    for (const InterfaceCurve& curve : interface_curves(mesh.complex())) {
        Points points;
        for (const Vertex v : curve.vertices) {
            points.push_back(mesh.complex().position(v));
        }
        const Phase right = curve.right == border_phase ? exterior_phase : curve.right;
        list.emplace_back(points, curve.is_closed, curve.left, right);
    }
    return list;
}

// --- constructors of meshes --------------------------------------------------------------------

using MadeMesh = std::shared_ptr<Mesh>;
using WholeNumbers = ArrayLike<std::uint32_t>;

// Makes a mesh from triangles (m, 3) with a phase each.
MadeMesh from_arrays(const Points& points, const WholeNumbers& triangles,
                     const WholeNumbers& phases) {
    std::vector<std::array<std::uint32_t, 3>> corners(static_cast<std::size_t>(phases.shape(0)));
    std::memcpy(corners.data(), triangles.data(), corners.size() * sizeof(corners[0]));
    return std::make_shared<Mesh>(
        make_complex<double>(points, corners, {phases.data(), corners.size()}));
}

InitialOptions initial_options(const py::dict& keywords) {
    Choices choices;
    apply(choices, keywords, Use::initial_complex);
    return {.edge_length = choices.options.edge_length,
            .sizes = choices.options.sizes,
            .detail = choices.detail,
            .border_tolerance = choices.border_tolerance,
            .coverage = choices.coverage};
}

// A domain: a rectangle by two points, or a polygon by its rings.
template <class Piece>
Complex<double> first_complex(const std::vector<Points>& domain, std::span<const Piece> pieces,
                              const InitialOptions& options, InputReport& report) {
    const Points& first = domain.at(0);
    if (domain.size() == 1 && first.size() == 2) {
        return initial_complex<double>(Rectangle{first[0], first[1]}, pieces, options, &report);
    }
    if constexpr (std::is_same_v<Piece, Shape>) {
        return initial_complex<double>(Polygon{first, {domain.begin() + 1, domain.end()}}, pieces,
                                       options, &report);
    } else {
        throw InputError({.what = "curves in a domain that is no rectangle",
                          .where = "initial_complex",
                          .value = to_text(domain.size()) + " rings",
                          .allowed = "shapes, which are clipped at the domain boundary"});
    }
}

// The first complex from shapes (outline, phase inside) or from curves (points, left, right).
template <class Piece, class... Phases>
MadeMesh from_pieces(const std::vector<Points>& domain,
                     const std::vector<std::tuple<Points, Phases...>>& list,
                     const py::dict& keywords) {
    std::vector<Piece> pieces;
    for (const auto& one : list) {
        pieces.push_back(std::apply([](const auto&... parts) { return Piece{parts...}; }, one));
    }
    const InitialOptions options = initial_options(keywords);
    InputReport report;
    const py::gil_scoped_release others_run; // sizes may be functions of Python
    const auto mesh = std::make_shared<Mesh>(
        first_complex(domain, std::span<const Piece>(pieces), options, report));
    mesh->input_report = report;
    return mesh;
}

// The first complex from an image, given by rows from the top.
MadeMesh from_labels(const Points& domain, const WholeNumbers& labels, std::size_t min_pixels,
                     const py::dict& keywords) {
    const LabelImage image{static_cast<std::size_t>(labels.shape(0)),
                           static_cast<std::size_t>(labels.shape(1)),
                           {labels.data(), labels.data() + labels.size()},
                           min_pixels};
    InputReport report;
    const InitialOptions options = initial_options(keywords);
    const py::gil_scoped_release others_run;
    const auto mesh = std::make_shared<Mesh>(
        initial_complex<double>({domain.at(0), domain.at(1)}, image, options, &report));
    mesh->input_report = report;
    return mesh;
}

} // namespace

// --- the arrays ------------------------------------------------------------------------------

MeshArrays arrays_of(const Complex<double>& complex) {
    // Visits triangles by id, because ranges of handles take four times as long.
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
    return {frozen(points), frozen(corners), frozen(numbers)};
}

// --- the module ------------------------------------------------------------------------------

void add_mesh(py::module_& module) {
    MeshClass type(module, "Mesh");
    type.def(py::init(&from_pieces<Shape, Phase, std::vector<Points>, std::string>))
        .def(py::init(&from_pieces<Curve, Phase, Phase>))
        .def(py::init(&from_labels))
        .def(py::init(&from_arrays))
        .def("_interface_curves", &curves_of)
        .def("_input_report",
             [](const Mesh& mesh) {
                 const InputReport& report = mesh.input_report;
                 return std::tuple(report.points, report.thinned, report.deviation,
                                   report.area_changed, report.dropped, report.area_dropped,
                                   report.clipped);
             })
        .def_property_readonly(
            "points", [](Mesh& mesh) { return mesh.arrays().points; }, "Vertices: (n, 2) float64.")
        .def_property_readonly(
            "triangles", [](Mesh& mesh) { return mesh.arrays().corners; },
            "Rows of `points`, counter-clockwise: (m, 3) int32.")
        .def(
            "write_svg",
            [](const Mesh& mesh, const std::filesystem::path& path) {
                write_svg(mesh.complex(), path.string());
            },
            "path"_a, "Writes a picture.");
    add_common(type);
    module.def("sentences",
               [](std::size_t points, std::size_t thinned, double deviation, double area_changed,
                  std::size_t dropped, double area_dropped, std::size_t clipped) {
                   return sentences(
                       {points, thinned, deviation, area_changed, dropped, area_dropped, clipped});
               });
    module.def("current_option", &current_option, "name"_a,
               "The current name of an option; warns if `name` is the one of release 0.1.");
    module.attr("size_help") = option_help(Use::initial_complex);
    add_data(type);
    add_measures(module, type);
}

} // namespace dsc::python

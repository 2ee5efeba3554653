// SPDX-License-Identifier: MIT
// Meshes of tets for Python, and the shapes of which they are made.
#include "python/module.h"
#include "python/options3.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace dsc::python {

namespace {

using MadeMesh3 = std::shared_ptr<Mesh3>;
using Indices = ArrayLike<std::uint32_t>;

template <std::size_t n>
std::vector<std::array<std::uint32_t, n>> rows_of(const Indices& array) {
    std::vector<std::array<std::uint32_t, n>> rows(static_cast<std::size_t>(array.shape(0)));
    std::memcpy(rows.data(), array.data(), rows.size() * sizeof(rows[0]));
    return rows;
}

// --- shapes --------------------------------------------------------------------------------------

// A signed distance, as a class of its own: functions of this type would be converted to Python's.
struct Shape3 {
    dsc3::Distance distance;
};

py::array distances(const Shape3& shape, const Points3& points) {
    return array_over(points, [&](const dsc3::Point& p) { return shape.distance(p); });
}

Shape3 shape_by(const py::function& function) {
    return {[shared = share(function)](const dsc3::Point& p) {
        const py::gil_scoped_acquire gil;
        const py::object result = (*shared)(array_of(Points3{p}));
        const auto array = ArrayLike<double>::ensure(result);
        if (!array || array.size() != 1) {
            PyErr_Clear();
            throw InputError({.what = "not a signed distance for each point",
                              .where = "what the shape returns",
                              .value = py::repr(result).cast<std::string>(),
                              .allowed = "numbers of the shape (n,) for points (n, 3)"});
        }
        return array.data()[0];
    }};
}

// A phase, or what a shape makes of the phases that it divides.
using PhaseInside = std::variant<Phase, std::map<Phase, Phase>>;

MadeMesh3 from_shapes(const Points3& box, const std::vector<std::pair<Shape3, PhaseInside>>& list,
                      const py::dict& keywords) {
    std::vector<dsc3::Shape> shapes;
    for (const auto& [shape, inside] : list) {
        dsc3::Shape& one = shapes.emplace_back(dsc3::Shape{shape.distance});
        if (const auto* const divided = std::get_if<1>(&inside)) {
            for (const auto& [from, to] : *divided) {
                one.divides.push_back({from, to});
            }
        } else {
            one.phase = std::get<0>(inside);
        }
    }
    Choices3 choices;
    apply(choices, keywords, Use::initial_complex);
    const py::gil_scoped_release others_run; // shapes may be functions of Python
    return std::make_shared<Mesh3>(
        dsc3::initial_complex({box.at(0), box.at(1)}, shapes, choices.initial));
}

MadeMesh3 from_tets(const Points3& points, const Indices& tets, const Indices& phases) {
    const auto rows = rows_of<4>(tets);
    return std::make_shared<Mesh3>(dsc3::make_complex(points, rows, {phases.data(), rows.size()}));
}

// --- what a mesh has -----------------------------------------------------------------------------

// The row of each vertex in the array of points.
std::vector<std::int32_t> rows_of_vertices(const dsc3::Complex& complex) {
    std::vector<std::int32_t> rows(complex.vertex_bound());
    std::int32_t row = 0;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        rows[v] = complex.is_alive(dsc3::Vertex{v}) ? row++ : 0;
    }
    return rows;
}

template <class Visit>
void for_each_tet(const dsc3::Complex& complex, Visit visit) {
    for (std::uint32_t t = dsc3::border_tet + 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(dsc3::Tet{t})) {
            visit(dsc3::Tet{t});
        }
    }
}

// A measure of the four points of each tet.
template <class Measure>
py::array of_tets(const Mesh3& mesh, Measure measure) {
    const dsc3::Complex& complex = mesh.complex();
    py::array_t<double> values(static_cast<py::ssize_t>(complex.tet_count()));
    double* place = values.mutable_data();
    for_each_tet(complex, [&](dsc3::Tet t) { *place++ = measure(complex.positions_of(t)); });
    return values;
}

std::map<Phase, double> volumes(const Mesh3& mesh) {
    const dsc3::Complex& complex = mesh.complex();
    std::map<Phase, double> sums;
    for_each_tet(complex, [&](dsc3::Tet t) {
        const auto [a, b, c, d] = complex.positions_of(t);
        sums[complex.phase(t)] += dsc3::volume(a, b, c, d);
    });
    return sums;
}

// Triangles (k, 3), the phases inside and those outside.
std::tuple<py::array, py::array, py::array> faces(const Mesh3& mesh) {
    const auto list = dsc3::interface_faces(mesh.complex());
    const auto rows = rows_of_vertices(mesh.complex());
    return {array_over<std::int32_t>(
                list,
                [&](const dsc3::InterfaceFace& face) {
                    return std::array{rows[face.v[0]], rows[face.v[1]], rows[face.v[2]]};
                }),
            array_over(list, [](const dsc3::InterfaceFace& face) { return face.inside; }),
            array_over(list, [](const dsc3::InterfaceFace& face) { return face.outside; })};
}

template <void (*write)(const dsc3::Complex&, const std::string&)>
void write_file(const Mesh3& mesh, const std::filesystem::path& path) {
    write(mesh.complex(), path.string());
}

} // namespace

MeshArrays arrays_of(const dsc3::Complex& complex) {
    const auto rows = rows_of_vertices(complex);
    py::array_t<double> points({static_cast<py::ssize_t>(complex.vertex_count()), py::ssize_t{3}});
    double* place = points.mutable_data();
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.is_alive(dsc3::Vertex{v})) {
            for (const double x : complex.at(v)) {
                *place++ = x;
            }
        }
    }
    const auto count = static_cast<py::ssize_t>(complex.tet_count());
    py::array_t<std::int32_t> corners({count, py::ssize_t{4}});
    py::array_t<std::uint32_t> numbers(count);
    std::int32_t* corner = corners.mutable_data();
    std::uint32_t* number = numbers.mutable_data();
    for_each_tet(complex, [&](dsc3::Tet t) {
        for (const std::uint32_t v : complex.tets[t.id].v) {
            *corner++ = rows[v];
        }
        *number++ = complex.phase(t);
    });
    return {frozen(points), frozen(corners), frozen(numbers)};
}

void add_mesh3(py::module_& module) {
    py::class_<Shape3>(module, "Shape3").def("__call__", &distances);
    module.def("ball", [](const Points3& centre, double radius) {
        return Shape3{dsc3::ball(centre.at(0), radius)};
    });
    module.def("box", [](const Points3& corners) {
        return Shape3{dsc3::box({corners.at(0), corners.at(1)})};
    });
    module.def("ellipsoid", [](const Points3& centre, const Points3& radii) {
        return Shape3{dsc3::ellipsoid(centre.at(0), radii.at(0))};
    });
    module.def("torus", [](const Points3& centre, const Points3& axis, double circle, double tube) {
        return Shape3{dsc3::torus(centre.at(0), axis.at(0), circle, tube)};
    });
    module.def("closed_surface",
               [](const Points3& points, const Indices& triangles, const std::string& name) {
                   return Shape3{dsc3::closed_surface({points, rows_of<3>(triangles), name})};
               });
    module.def("shape", &shape_by);

    Mesh3Class type(module, "Mesh3");
    type.def(py::init(&from_shapes))
        .def(py::init(&from_tets))
        .def("_faces", &faces)
        .def("_volumes", &volumes)
        .def_property_readonly(
            "points", [](Mesh3& mesh) { return mesh.arrays().points; }, "Vertices: (n, 3) float64.")
        .def_property_readonly(
            "tetrahedra", [](Mesh3& mesh) { return mesh.arrays().corners; },
            "Rows of `points`, positively oriented: (m, 4) int32.")
        .def_property_readonly(
            "qualities",
            [](const Mesh3& mesh) {
                return of_tets(mesh, [](const std::array<dsc3::Point, 4>& p) {
                    return dsc3::quality(p[0], p[1], p[2], p[3]);
                });
            },
            "The quality of each tet: (m,), from 0 to 1 for a regular one.")
        .def_property_readonly(
            "min_dihedrals",
            [](const Mesh3& mesh) {
                return of_tets(mesh, [](const std::array<dsc3::Point, 4>& p) {
                    return dsc3::dihedral_angles(p).smallest;
                });
            },
            "The smallest dihedral angle of each tet, in degrees: (m,).")
        .def("write_interface_vtu", &write_file<dsc3::write_interface_vtu>, "path"_a,
             "Writes the interface with the phases on both sides, for ParaView.")
        .def("write_ply", &write_file<dsc3::write_ply>, "path"_a,
             "Writes the interface as binary PLY.")
        .def("write_stl", &write_file<dsc3::write_stl>, "path"_a,
             "Writes the interface as binary STL, which has single precision.");
    module.attr("size3_help") = option3_help(Use::initial_complex);
    add_common(type);
    add_data(type);
}

} // namespace dsc::python

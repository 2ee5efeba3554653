// SPDX-License-Identifier: MIT
#include "python/data.h"

#include "replay/sealed_file.h"
#include "scenes/run/standard_archive.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

// The living simplices, in the order of the arrays.
auto range_of(const Complex<double>& complex, Vertex /*kind*/) { return vertices(complex); }
auto range_of(const Complex<double>& complex, Triangle /*kind*/) { return triangles(complex); }

// The kinds of data, by number: calls `visit` with a simplex and a value of the kind's types.
constexpr std::uint32_t kinds_of_data = 4;
template <class Visit>
void with_kind(std::uint32_t kind, Visit visit) {
    switch (kind) {
    case 0: visit(Vertex(), 0.0); break;
    case 1: visit(Vertex(), Point<double>(0, 0)); break;
    case 2: visit(Triangle(), 0.0); break;
    default: visit(Triangle(), Point<double>(0, 0)); break;
    }
}

// Nothing for an attribute of the library's own.
std::optional<std::uint32_t> kind_of_data(const AttributeBase& one) {
    std::optional<std::uint32_t> found;
    for (std::uint32_t kind = 0; kind < kinds_of_data; ++kind) {
        with_kind(kind, [&]<class Simplex, class T>(Simplex /*of*/, const T& /*value*/) {
            if (dynamic_cast<const Attribute<T, Simplex>*>(&one) != nullptr) {
                found = kind;
            }
        });
    }
    return found;
}

py::array listed(std::span<const double> values) { return array_of(values); }
py::array listed(std::span<const Point<double>> values) { return array_of(values); }

template <class Simplex>
std::vector<std::string> names_of(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const auto& one : mesh.complex().attributes.list()) {
        if (one->kind() == kind_of<Simplex> && kind_of_data(*one)) {
            names.push_back(one->name());
        }
    }
    return names;
}

template <class Simplex>
std::optional<py::array> values_of(const Mesh& mesh, const std::string& name) {
    std::optional<py::array> array;
    for (const auto& one : mesh.complex().attributes.list()) {
        const auto kind = kind_of_data(*one);
        if (kind && one->kind() == kind_of<Simplex> && one->name() == name) {
            with_kind(*kind, [&]<class Of, class T>(Of of, const T&) {
                const auto& attribute = static_cast<const Attribute<T, Of>&>(*one);
                std::vector<T> values;
                for (const Of each : range_of(mesh.complex(), of)) {
                    values.push_back(attribute[each]);
                }
                array = listed(values);
            });
        }
    }
    return array;
}

template <class Simplex, class T>
void write(Mesh& mesh, const std::string& name, std::span<const T> values, const T& initial) {
    AttributeSet& attributes = mesh.complex_to_step().attributes;
    if (!attributes.contains(name)) {
        attributes.add<Simplex>(name, initial);
    }
    auto& attribute = attributes.get<Simplex, T>(name); // refused if it is of another kind or type
    std::size_t i = 0;
    for (const Simplex each : range_of(mesh.complex(), Simplex())) {
        attribute[each] = values[i++];
    }
}

template <class Simplex>
void set_values(Mesh& mesh, const std::string& name, const py::handle& value) {
    const Complex<double>& complex = mesh.complex();
    const std::size_t count =
        std::is_same_v<Simplex, Vertex> ? complex.vertex_count() : complex.triangle_count();
    const py::array given = py::array::ensure(value);
    if (given && given.ndim() == 2) {
        std::vector<Point<double>> points(count);
        read_points(value, points, name);
        write<Simplex, Point<double>>(mesh, name, points, {0.0, 0.0});
        return;
    }
    const auto numbers =
        py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
    if (!numbers || numbers.ndim() != 1 || static_cast<std::size_t>(numbers.shape(0)) != count) {
        PyErr_Clear();
        const std::string n = std::to_string(count);
        refuse("not the data of these simplices", name, shown(value),
               "numbers of the shape (" + n + ",) or (" + n + ", 2)");
    }
    write<Simplex, double>(mesh, name, {numbers.data(), count}, 0.0);
}

void remove(Mesh& mesh, const std::string& name) {
    (void)mesh.complex(); // refused while a step runs
    mesh.complex_to_step().attributes.remove(name);
}

constexpr const char* sealed_kind = "dsc-mesh";

} // namespace

// --- state -------------------------------------------------------------------------------------

void forget_foreign_data(Complex<double>& complex) {
    std::vector<std::string> names;
    for (const auto& one : complex.attributes.list()) {
        if (!kind_of_data(*one)) {
            names.push_back(one->name());
        }
    }
    for (const std::string& name : names) {
        complex.attributes.remove(name);
    }
}

std::string bytes_of(const Complex<double>& complex) {
    Complex<double> copy(complex);
    forget_foreign_data(copy);
    std::vector<std::pair<std::string, std::uint32_t>> data;
    for (const auto& one : copy.attributes.list()) {
        data.emplace_back(one->name(), *kind_of_data(*one));
    }
    Archive archive;
    archive(data, copy);
    return sealed({sealed_kind}, archive.bytes());
}

Complex<double> complex_from(std::string bytes) {
    Archive archive(unsealed(std::move(bytes), {sealed_kind}, "mesh"), "mesh");
    std::vector<std::pair<std::string, std::uint32_t>> data;
    archive(data);
    Complex<double> complex;
    for (const auto& [name, kind] : data) {
        with_kind(kind, [&]<class Of, class T>(Of /*of*/, const T& initial) {
            complex.attributes.add<Of>(name, initial);
        });
    }
    archive(complex);
    archive.expect_end();
    if (const ValidationReport report = validate(complex); !report.ok()) {
        archive.refuse("holds no valid complex: " + report.problem);
    }
    return complex;
}

// --- the module --------------------------------------------------------------------------------

void add_data(py::class_<Mesh, std::shared_ptr<Mesh>>& mesh) {
    mesh.def("_vertex_data_names", &names_of<Vertex>)
        .def("_triangle_data_names", &names_of<Triangle>)
        .def("_vertex_data", &values_of<Vertex>, "name"_a)
        .def("_triangle_data", &values_of<Triangle>, "name"_a)
        .def("_set_vertex_data", &set_values<Vertex>, "name"_a, "values"_a)
        .def("_set_triangle_data", &set_values<Triangle>, "name"_a, "values"_a)
        .def("_remove_data", &remove, "name"_a);
}

} // namespace dsc::python

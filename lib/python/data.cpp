// SPDX-License-Identifier: MIT
#include "python/data.h"

#include "dsc/io/part_file.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

// The living simplices, in the order of the arrays.
template <class Simplex>
auto range_of(const Complex<double>& complex) {
    if constexpr (std::is_same_v<Simplex, Vertex>) {
        return vertices(complex);
    } else {
        return triangles(complex);
    }
}

template <class Simplex, class T>
bool holds(const AttributeBase& attribute) {
    return dynamic_cast<const Attribute<T, Simplex>*>(&attribute) != nullptr;
}

// The kinds of data, by number; nothing for an attribute of the library's own.
std::optional<std::uint32_t> kind_of_data(const AttributeBase& one) {
    const std::array is{holds<Vertex, double>(one), holds<Vertex, Point<double>>(one),
                        holds<Triangle, double>(one), holds<Triangle, Point<double>>(one)};
    const auto found = std::ranges::find(is, true);
    return found == is.end() ? std::nullopt
                             : std::optional(static_cast<std::uint32_t>(found - is.begin()));
}

void add_kind(AttributeSet& attributes, const std::string& name, std::uint32_t kind) {
    switch (kind) {
    case 0: attributes.add<Vertex>(name, 0.0); break;
    case 1: attributes.add<Vertex>(name, Point<double>(0, 0)); break;
    case 2: attributes.add<Triangle>(name, 0.0); break;
    default: attributes.add<Triangle>(name, Point<double>(0, 0)); break;
    }
}

template <class Simplex>
std::vector<std::string> names_of(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const auto& one : mesh.complex().attributes.list()) {
        if (holds<Simplex, double>(*one) || holds<Simplex, Point<double>>(*one)) {
            names.push_back(one->name());
        }
    }
    return names;
}

template <class Simplex, class T>
Attribute<T, Simplex>* find(const Mesh& mesh, const std::string& name) {
    for (const auto& one : mesh.complex().attributes.list()) {
        if (one->name() == name) {
            return dynamic_cast<Attribute<T, Simplex>*>(one.get());
        }
    }
    return nullptr;
}

template <class Simplex, class T>
py::array listed(const Mesh& mesh, const Attribute<T, Simplex>& attribute) {
    std::vector<T> values;
    for (const Simplex s : range_of<Simplex>(mesh.complex())) {
        values.push_back(attribute[s]);
    }
    if constexpr (std::is_same_v<T, double>) {
        return array_of<double>(values);
    } else {
        return array_of(values);
    }
}

template <class Simplex>
std::optional<py::array> values_of(const Mesh& mesh, const std::string& name) {
    if (const auto* numbers = find<Simplex, double>(mesh, name)) {
        return listed(mesh, *numbers);
    }
    if (const auto* points = find<Simplex, Point<double>>(mesh, name)) {
        return listed(mesh, *points);
    }
    return std::nullopt;
}

template <class Simplex, class T>
void write(Mesh& mesh, const std::string& name, std::span<const T> values, T initial) {
    Attribute<T, Simplex>* attribute = find<Simplex, T>(mesh, name);
    if (attribute == nullptr) { // refused if the name is that of another kind or type
        attribute = &mesh.complex_to_step().attributes.template add<Simplex>(name, initial);
    }
    std::size_t i = 0;
    for (const Simplex s : range_of<Simplex>(mesh.complex())) {
        (*attribute)[s] = values[i++];
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
        write<Simplex, Point<double>>(mesh, name, points, Point<double>(0, 0));
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
        add_kind(complex.attributes, name, kind);
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

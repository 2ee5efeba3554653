// SPDX-License-Identifier: MIT
#include "python/data.h"

#include <pybind11/stl.h>

#include <optional>
#include <type_traits>

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

template <class Simplex>
std::vector<std::string> names_of(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const auto& one : mesh.complex().attributes.list()) {
        const auto* base = one.get();
        if (dynamic_cast<const Attribute<double, Simplex>*>(base) != nullptr ||
            dynamic_cast<const Attribute<Point<double>, Simplex>*>(base) != nullptr) {
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
        throw InputError({.what = "not the data of these simplices",
                          .where = name,
                          .value = shown(value),
                          .allowed = "numbers of the shape (" + n + ",) or (" + n + ", 2)"});
    }
    write<Simplex, double>(mesh, name, {numbers.data(), count}, 0.0);
}

template <class Simplex>
void remove(Mesh& mesh, const std::string& name) {
    (void)mesh.complex(); // refused while a step runs
    mesh.complex_to_step().attributes.remove(name);
}

} // namespace

void add_data(py::class_<Mesh, std::shared_ptr<Mesh>>& mesh) {
    mesh.def("_vertex_data_names", &names_of<Vertex>)
        .def("_triangle_data_names", &names_of<Triangle>)
        .def("_vertex_data", &values_of<Vertex>, "name"_a)
        .def("_triangle_data", &values_of<Triangle>, "name"_a)
        .def("_set_vertex_data", &set_values<Vertex>, "name"_a, "values"_a)
        .def("_set_triangle_data", &set_values<Triangle>, "name"_a, "values"_a)
        .def("_remove_data", &remove<Vertex>, "name"_a);
}

} // namespace dsc::python

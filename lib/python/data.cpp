// SPDX-License-Identifier: MIT
// Attributes as arrays: numbers and points of vertices and of triangles, which dsc/data.py presents
// as dictionaries.
#include "python/module.h"

#include <string>
#include <type_traits>
#include <vector>

namespace dsc::python {

namespace {

// The living simplices, in the order of the arrays.
auto range_of(const Complex<double>& complex, Vertex /*kind*/) { return vertices(complex); }
auto range_of(const Complex<double>& complex, Triangle /*kind*/) { return triangles(complex); }

// Calls `visit` with the attribute in its own type. Returns false for an attribute of the library.
template <class Visit>
bool visit_data(const AttributeBase& one, Visit visit) {
    const auto visit_as = [&]<class T, class Simplex>(std::type_identity<Attribute<T, Simplex>>) {
        const auto* const attribute = dynamic_cast<const Attribute<T, Simplex>*>(&one);
        if (attribute != nullptr) {
            visit(*attribute);
        }
        return attribute != nullptr;
    };
    return visit_as(std::type_identity<Attribute<double, Vertex>>()) ||
           visit_as(std::type_identity<Attribute<Point<double>, Vertex>>()) ||
           visit_as(std::type_identity<Attribute<double, Triangle>>()) ||
           visit_as(std::type_identity<Attribute<Point<double>, Triangle>>());
}

bool is_data(const AttributeBase& one) {
    return visit_data(one, [](const auto& /*attribute*/) {});
}

// For each name of data, whether they belong to vertices; otherwise to triangles.
py::dict data_names(const Mesh& mesh) {
    py::dict names;
    for (const auto& one : mesh.complex().attributes.list()) {
        if (is_data(*one)) {
            names[py::str(one->name())] = one->kind() == SimplexKind::vertex;
        }
    }
    return names;
}

// The data of that name, which must exist.
py::array data_of(const Mesh& mesh, const std::string& name) {
    const Complex<double>& complex = mesh.complex();
    py::array values;
    for (const auto& one : complex.attributes.list()) {
        if (one->name() == name) {
            visit_data(*one, [&]<class T, class Simplex>(const Attribute<T, Simplex>& attribute) {
                values = array_over(range_of(complex, Simplex()),
                                    [&](Simplex each) { return attribute[each]; });
            });
        }
    }
    return values;
}

template <class Simplex, class T>
void write(Complex<double>& complex, const std::string& name, const double* values, T initial) {
    if (!complex.attributes.contains(name)) {
        complex.attributes.add<Simplex>(name, initial);
    }
    auto& attribute = complex.attributes.get<Simplex, T>(name); // throws for another type
    constexpr int width = std::is_same_v<T, double> ? 1 : 2;
    for (const Simplex each : range_of(complex, Simplex())) {
        std::memcpy(static_cast<void*>(&attribute[each]), values, sizeof(T));
        values += width;
    }
}

// The array must have a number, or a row of two, for each simplex.
template <class Simplex>
void set_data(Mesh& mesh, const std::string& name, const ArrayLike<double>& values) {
    (void)mesh.complex(); // refused while a step runs
    if (values.ndim() == 1) {
        write<Simplex>(mesh.complex_to_step(), name, values.data(), 0.0);
    } else {
        write<Simplex>(mesh.complex_to_step(), name, values.data(), Point<double>(0.0, 0.0));
    }
}

void remove_data(Mesh& mesh, const std::string& name) {
    (void)mesh.complex(); // refused while a step runs
    mesh.complex_to_step().attributes.remove(name);
}

} // namespace

void forget_foreign_data(Complex<double>& complex) {
    std::vector<std::string> names;
    for (const auto& one : complex.attributes.list()) {
        if (!is_data(*one)) {
            names.push_back(one->name());
        }
    }
    for (const std::string& name : names) {
        complex.attributes.remove(name);
    }
}

void add_data(MeshClass& mesh) {
    mesh.def("_data_names", &data_names)
        .def("_data", &data_of)
        .def("_set_vertex_data", &set_data<Vertex>)
        .def("_set_triangle_data", &set_data<Triangle>)
        .def("_remove_data", &remove_data);
}

} // namespace dsc::python

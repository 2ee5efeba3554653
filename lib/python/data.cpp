// SPDX-License-Identifier: MIT
// Attributes as arrays: numbers and points of vertices and of triangles or tets, which dsc/data.py
// presents as dictionaries.
#include "python/module.h"

#include <string>
#include <type_traits>
#include <vector>

namespace dsc::python {

namespace {

// The living simplices, in the order of the arrays.
auto range_of(const Complex<double>& complex, Vertex /*kind*/) { return vertices(complex); }
auto range_of(const Complex<double>& complex, Triangle /*kind*/) { return triangles(complex); }

template <class Simplex>
std::vector<Simplex> living(const dsc3::Complex& complex, std::uint32_t bound) {
    std::vector<Simplex> list;
    for (std::uint32_t id = 0; id < bound; ++id) {
        if (complex.is_alive(Simplex{id})) {
            list.push_back(Simplex{id});
        }
    }
    return list;
}
auto range_of(const dsc3::Complex& complex, dsc3::Vertex /*kind*/) {
    return living<dsc3::Vertex>(complex, complex.vertex_bound());
}
auto range_of(const dsc3::Complex& complex, dsc3::Tet /*kind*/) {
    return living<dsc3::Tet>(complex, complex.tet_bound());
}

// The types of a mesh.
template <class AnyMesh>
struct TypesOf {
    using Vertex = dsc::Vertex;
    using Cell = dsc::Triangle;
    using Row = dsc::Point<double>;
};
template <>
struct TypesOf<Mesh3> {
    using Vertex = dsc3::Vertex;
    using Cell = dsc3::Tet;
    using Row = dsc3::Point;
};

// Calls `visit` with the attribute in its own type. Returns false for an attribute of the library.
template <class Types, class Visit>
bool visit_data(const AttributeBase& one, Visit visit) {
    const auto visit_as = [&]<class T, class Simplex>(std::type_identity<Attribute<T, Simplex>>) {
        const auto* const attribute = dynamic_cast<const Attribute<T, Simplex>*>(&one);
        if (attribute != nullptr) {
            visit(*attribute);
        }
        return attribute != nullptr;
    };
    using Vertex = typename Types::Vertex;
    using Cell = typename Types::Cell;
    using Row = typename Types::Row;
    return visit_as(std::type_identity<Attribute<double, Vertex>>()) ||
           visit_as(std::type_identity<Attribute<Row, Vertex>>()) ||
           visit_as(std::type_identity<Attribute<double, Cell>>()) ||
           visit_as(std::type_identity<Attribute<Row, Cell>>());
}

template <class AnyMesh>
bool is_data(const AttributeBase& one) {
    return visit_data<TypesOf<AnyMesh>>(one, [](const auto& /*attribute*/) {});
}

// For each name of data, whether they belong to vertices; otherwise to triangles or tets.
template <class AnyMesh>
py::dict data_names(const AnyMesh& mesh) {
    py::dict names;
    for (const auto& one : mesh.complex().attributes.list()) {
        if (is_data<AnyMesh>(*one)) {
            names[py::str(one->name())] = one->kind() == SimplexKind::vertex;
        }
    }
    return names;
}

// The data of that name, which must exist.
template <class AnyMesh>
py::array data_of(const AnyMesh& mesh, const std::string& name) {
    const auto& complex = mesh.complex();
    py::array values;
    for (const auto& one : complex.attributes.list()) {
        if (one->name() == name) {
            visit_data<TypesOf<AnyMesh>>(
                *one, [&]<class T, class Simplex>(const Attribute<T, Simplex>& attribute) {
                    values = array_over(range_of(complex, Simplex()),
                                        [&](Simplex each) { return attribute[each]; });
                });
        }
    }
    return values;
}

template <class Simplex, class T, class AnyComplex>
void write(AnyComplex& complex, const std::string& name, const double* values, T initial) {
    AttributeSet& attributes = complex.attributes;
    if (!attributes.contains(name)) {
        attributes.add<Simplex>(name, initial);
    }
    auto& attribute = attributes.get<Simplex, T>(name); // throws for another type
    constexpr std::size_t width = sizeof(T) / sizeof(double);
    for (const Simplex each : range_of(complex, Simplex())) {
        std::memcpy(static_cast<void*>(&attribute[each]), values, sizeof(T));
        values += width;
    }
}

// The array must have a number, or a row of coordinates, for each simplex.
template <class Simplex, class AnyMesh>
void set_data(AnyMesh& mesh, const std::string& name, const ArrayLike<double>& values) {
    using Row = typename TypesOf<AnyMesh>::Row;
    (void)mesh.complex(); // refused while a step runs
    if (values.ndim() == 1) {
        write<Simplex>(mesh.complex_to_step(), name, values.data(), 0.0);
    } else {
        write<Simplex>(mesh.complex_to_step(), name, values.data(), Row(Row::Zero()));
    }
}

template <class AnyMesh>
void remove_data(AnyMesh& mesh, const std::string& name) {
    (void)mesh.complex(); // refused while a step runs
    mesh.complex_to_step().attributes.remove(name);
}

} // namespace

void forget_foreign_data(Complex<double>& complex) {
    std::vector<std::string> names;
    for (const auto& one : complex.attributes.list()) {
        if (!is_data<Mesh>(*one)) {
            names.push_back(one->name());
        }
    }
    for (const std::string& name : names) {
        complex.attributes.remove(name);
    }
}

template <class AnyMesh>
void add_data(py::class_<AnyMesh, std::shared_ptr<AnyMesh>>& mesh) {
    mesh.def("_data_names", &data_names<AnyMesh>)
        .def("_data", &data_of<AnyMesh>)
        .def("_set_vertex_data", &set_data<typename TypesOf<AnyMesh>::Vertex, AnyMesh>)
        .def("_set_cell_data", &set_data<typename TypesOf<AnyMesh>::Cell, AnyMesh>)
        .def("_remove_data", &remove_data<AnyMesh>);
}
template void add_data(MeshClass& mesh);
template void add_data(Mesh3Class& mesh);

} // namespace dsc::python

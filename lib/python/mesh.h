// SPDX-License-Identifier: MIT
// Complexes for Python, with dense arrays instead of ids with gaps.
#pragma once

#include "python/arrays.h"
#include "replay/mesh_hash.h"

#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace dsc::python {

/// The arrays of a mesh: read-only, without gaps.
struct MeshArrays {
    py::array points;  ///< living vertices in the order of their ids: (n, 2) or (n, 3)
    py::array corners; ///< rows of `points`, positively oriented: (m, 3) or (m, 4) of int32
    py::array phases;  ///< of each triangle or tet: (m,) of uint32
};
[[nodiscard]] MeshArrays arrays_of(const Complex<double>& complex);
[[nodiscard]] MeshArrays arrays_of(const dsc3::Complex& complex);

/// A complex with its arrays, which are made on first use and cached until the complex changes.
/// While a step runs, the mesh is busy and cannot be read.
template <class ComplexOfMesh>
class MeshOf {
public:
    using Held = ComplexOfMesh;

    explicit MeshOf(ComplexOfMesh complex) : complex_(std::move(complex)) {}
    /// A copy of the complex. Throws as `complex`.
    MeshOf(const MeshOf& other) : complex_(other.complex()) {}
    MeshOf& operator=(const MeshOf&) = delete;
    MeshOf(MeshOf&&) = delete;
    MeshOf& operator=(MeshOf&&) = delete;
    ~MeshOf() = default;

    /// Throws std::runtime_error while a step runs.
    [[nodiscard]] const ComplexOfMesh& complex() const {
        if (is_busy_) {
            throw std::runtime_error(
                "a step of this mesh is running: read the mesh after the step");
        }
        return complex_;
    }
    /// The complex, for its simulation.
    [[nodiscard]] ComplexOfMesh& complex_to_step() { return complex_; }

    [[nodiscard]] const MeshArrays& arrays() {
        const ComplexOfMesh& current = complex();
        if (!arrays_) {
            arrays_ = arrays_of(current);
        }
        return *arrays_;
    }

    /// The number of changes of the mesh: equal numbers mean the same mesh.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    /// To be called before a change: drops the arrays, and keeps the mesh busy until the result is
    /// destroyed. Throws std::runtime_error if another change is running.
    [[nodiscard]] std::shared_ptr<void> change() {
        (void)complex(); // throws if it is busy
        is_busy_ = true;
        arrays_.reset();
        ++revision_;
        return {this, [this](void* /*mesh*/) { is_busy_ = false; }};
    }

private:
    ComplexOfMesh complex_;
    std::optional<MeshArrays> arrays_;
    std::uint64_t revision_ = 0;
    bool is_busy_ = false;
};

/// A mesh of triangles.
class Mesh : public MeshOf<Complex<double>> {
public:
    using MeshOf::MeshOf;
    InputReport input_report; ///< on the shapes or curves of the mesh, if any
};
/// A mesh of tets.
using Mesh3 = MeshOf<dsc3::Complex>;

using MeshClass = py::class_<Mesh, std::shared_ptr<Mesh>>;
using Mesh3Class = py::class_<Mesh3, std::shared_ptr<Mesh3>>;

// --- what meshes of both dimensions have ---------------------------------------------------------

/// The complex as bytes, without data, which dsc/mesh.py adds.
template <class AnyMesh>
[[nodiscard]] py::bytes bytes_of(const AnyMesh& mesh) {
    typename AnyMesh::Held copy(mesh.complex());
    while (!copy.attributes.empty()) {
        copy.attributes.remove(std::string(copy.attributes.list().back()->name()));
    }
    Archive archive;
    archive(copy);
    return archive.bytes();
}

/// A mesh from these bytes.
template <class AnyMesh>
[[nodiscard]] std::shared_ptr<AnyMesh> from_bytes(const py::bytes& bytes) {
    Archive archive(bytes, "mesh");
    typename AnyMesh::Held complex;
    archive(complex);
    archive.expect_end();
    return std::make_shared<AnyMesh>(std::move(complex));
}

/// Defines them.
template <class AnyMesh>
void add_common(py::class_<AnyMesh, std::shared_ptr<AnyMesh>>& type) {
    type.def(py::init<const AnyMesh&>())
        .def(py::init(&from_bytes<AnyMesh>))
        .def("_bytes", &bytes_of<AnyMesh>)
        .def_property_readonly(
            "phases", [](AnyMesh& mesh) { return mesh.arrays().phases; },
            "The phase of each triangle, or of each tet: (m,) uint32.")
        .def_property_readonly("revision", &AnyMesh::revision,
                               "The number of changes of the mesh: equal numbers mean the same "
                               "mesh.")
        .def_property_readonly(
            "mesh_hash", [](const AnyMesh& mesh) { return mesh_hash(mesh.complex()); },
            "A hash of 64 bits, equal for equal coordinates and phases in any order.")
        .def(
            "validate", [](const AnyMesh& mesh) { return validate(mesh.complex()).problem; },
            "The first error of the complex, '' if it is valid. Exact.")
        .def(
            "write_vtu",
            [](const AnyMesh& mesh, const std::filesystem::path& path) {
                write_vtu(mesh.complex(), path.string());
            },
            "path"_a, "Writes a file for ParaView.");
}

/// Removes attributes left by earlier simulations that are not data of Python.
void forget_foreign_data(Complex<double>& complex);

} // namespace dsc::python

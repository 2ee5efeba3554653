// SPDX-License-Identifier: MIT
// A complex for Python, with dense arrays instead of ids with gaps.
#pragma once

#include "python/arrays.h"

#include <memory>
#include <optional>

namespace dsc::python {

/// A complex with its arrays, which are made on first use and cached until the complex changes.
/// While a step runs, the mesh is busy and cannot be read.
class Mesh {
public:
    explicit Mesh(Complex<double> complex) : complex_(std::move(complex)) {}
    /// A copy of the complex. Throws as `complex`.
    Mesh(const Mesh& other) : input_report(other.input_report), complex_(other.complex()) {}
    Mesh& operator=(const Mesh&) = delete;
    Mesh(Mesh&&) = delete;
    Mesh& operator=(Mesh&&) = delete;
    ~Mesh() = default;

    /// Throws std::runtime_error while a step runs.
    [[nodiscard]] const Complex<double>& complex() const;
    /// The complex, for its simulation.
    [[nodiscard]] Complex<double>& complex_to_step() { return complex_; }

    /// Living vertices in the order of their ids: (n, 2), read-only.
    [[nodiscard]] py::array points() { return arrays().points; }
    /// Rows of `points`, counter-clockwise: (m, 3) of int32, read-only.
    [[nodiscard]] py::array triangles() { return arrays().triangles; }
    /// The phase of each triangle: (m,) of uint32, read-only.
    [[nodiscard]] py::array phases() { return arrays().phases; }

    /// The number of changes of the mesh: equal numbers mean the same triangles.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    /// To be called before a change: drops the arrays, and keeps the mesh busy until the result is
    /// destroyed. Throws std::runtime_error if another change is running.
    [[nodiscard]] std::shared_ptr<void> change();

    InputReport input_report; ///< on the shapes or curves of the mesh, if any

private:
    struct Arrays {
        py::array points;
        py::array triangles;
        py::array phases;
    };
    const Arrays& arrays();

    Complex<double> complex_;
    std::optional<Arrays> arrays_;
    std::uint64_t revision_ = 0;
    bool is_busy_ = false;
};

using MeshClass = py::class_<Mesh, std::shared_ptr<Mesh>>;

/// Removes attributes left by earlier simulations that are not data of Python.
void forget_foreign_data(Complex<double>& complex);

} // namespace dsc::python

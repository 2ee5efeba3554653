// SPDX-License-Identifier: MIT
// A complex as Python sees it: dense arrays in place of ids with gaps.
#pragma once

#include "python/arrays.h"

#include <memory>
#include <optional>

namespace dsc::python {

/// A complex with its arrays, which are made when somebody asks for them, and kept until the
/// complex changes. While a step runs the mesh is busy: nobody else may read it.
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
    /// For a simulation of it.
    [[nodiscard]] Complex<double>& complex_to_step() { return complex_; }

    /// Vertices in the order of their ids, without those that have vanished: (n, 2), frozen.
    [[nodiscard]] py::array points() { return arrays().points; }
    /// Rows of `points`, counter-clockwise: (m, 3) of int32, frozen.
    [[nodiscard]] py::array triangles() { return arrays().triangles; }
    /// Of each triangle: (m,) of uint32, frozen.
    [[nodiscard]] py::array phases() { return arrays().phases; }

    /// How often the mesh has been changed: two equal numbers, the same triangles.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    /// Drops the arrays, and keeps the mesh busy until the result is dropped: for a change. Throws
    /// std::runtime_error if another one is under way.
    [[nodiscard]] std::shared_ptr<void> change();

    InputReport input_report; ///< of the shapes or curves that the mesh was made of, if it was

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

/// Removes attributes that are no data of Python, which simulations before have left.
void forget_foreign_data(Complex<double>& complex);

} // namespace dsc::python

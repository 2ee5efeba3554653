// SPDX-License-Identifier: MIT
// Attributes as arrays: numbers and points of vertices and of triangles.
#pragma once

#include "python/mesh.h"

namespace dsc::python {

/// Removes attributes that are no data of Python, which simulations before have left.
void forget_foreign_data(Complex<double>& complex);

/// The complex with its data as bytes, sealed; and back. Throws FileError where a byte has changed.
[[nodiscard]] std::string bytes_of(const Complex<double>& complex);
[[nodiscard]] Complex<double> complex_from(std::string bytes);

/// Adds the functions behind `Mesh.vertex_data` and `Mesh.triangle_data`, which dsc/data.py makes a
/// dictionary of.
void add_data(py::class_<Mesh, std::shared_ptr<Mesh>>& mesh);

} // namespace dsc::python

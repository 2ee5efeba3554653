// SPDX-License-Identifier: MIT
// Arrays of numpy from lists of points and numbers, and back. Arrays are C-contiguous; points have
// the shape (n, 2). All of it needs the GIL.
#pragma once

#include "dsc/dsc.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <vector>

namespace dsc::python {

namespace py = pybind11;

/// A copy of an array-like of the shape (n, 2). `where` names the argument. Throws InputError where
/// it is no such array.
[[nodiscard]] std::vector<Point<double>> points_from(const py::handle& value,
                                                     const std::string& where);

/// Writes the rows of an array-like of the shape (points.size(), 2). Throws as `points_from`.
void read_points(const py::handle& value, std::span<Point<double>> points,
                 const std::string& where);

/// A new array of the shape (n, 2).
[[nodiscard]] py::array_t<double> array_of(std::span<const Point<double>> points);

/// A new array of numbers.
template <class Number>
[[nodiscard]] py::array_t<Number> array_of(std::span<const Number> numbers) {
    return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// The array, which nobody may write to any more.
[[nodiscard]] py::array frozen(py::array array);

/// As Python would print it, cut after 60 characters.
[[nodiscard]] std::string shown(const py::handle& value);

} // namespace dsc::python

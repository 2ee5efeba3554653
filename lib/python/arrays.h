// SPDX-License-Identifier: MIT
// Arrays of numpy from lists of points and numbers, and back. Arrays are C-contiguous; points have
// the shape (n, 2). All of it needs the GIL.
#pragma once

#include "dsc/dsc.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dsc::python {

namespace py = pybind11;

/// Throws InputError.
[[noreturn]] void refuse(const std::string& what, const std::string& where,
                         const std::string& value, const std::string& allowed);

/// A record of dsc/records.py, such as `Report`, with these fields.
[[nodiscard]] py::object record(const char* name, const py::dict& fields);

/// A copy of an array-like of the shape (n, 2). `where` names the argument. Throws InputError where
/// it is no such array.
[[nodiscard]] std::vector<Point<double>> points_from(const py::handle& value,
                                                     const std::string& where);

/// Writes the rows of an array-like of the shape (points.size(), 2). Throws as `points_from`.
void read_points(const py::handle& value, std::span<Point<double>> points,
                 const std::string& where);

/// One outline, or those of a list or tuple of arrays.
[[nodiscard]] std::vector<py::object> outline_list(const py::handle& value);

/// Numbers from 0 that fit into 32 bits, with so many dimensions. Throws InputError.
[[nodiscard]] py::array_t<std::uint32_t> whole_numbers(const py::handle& value,
                                                       const std::string& where,
                                                       const std::string& shape, int dimensions);

/// A new array of the shape (n, 2).
[[nodiscard]] py::array_t<double> array_of(std::span<const Point<double>> points);

/// A point from anything with two numbers. Throws as `points_from`.
[[nodiscard]] Point<double> point_from(const py::handle& value, const std::string& where);

/// A new array of numbers.
template <class Number>
[[nodiscard]] py::array_t<Number> array_of(std::span<const Number> numbers) {
    return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// The array, which nobody may write to any more.
[[nodiscard]] py::array frozen(py::array array);

/// An object of Python that C++ copies and drops without the GIL.
template <class Object>
using Shared = std::shared_ptr<Object>;
template <class Object>
[[nodiscard]] Shared<Object> share(const Object& object) {
    return {new Object(object), [](Object* last) {
                const py::gil_scoped_acquire gil;
                delete last; // NOLINT: the deleter of a shared_ptr
            }};
}

/// As Python would print it, cut after 60 characters.
[[nodiscard]] std::string shown(const py::handle& value);

} // namespace dsc::python

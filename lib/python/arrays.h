// SPDX-License-Identifier: MIT
// Conversions between numpy arrays and lists of numbers and points. Arrays are C-contiguous; points
// have the shape (n, 2) or (n, 3), and functions of the module accept and return them as `Points`
// or `Points3`. dsc/arrays.py checks the arguments of users before. All functions here need the
// GIL.
#pragma once

#include "dsc/dsc.h"
#include "dsc3/dsc3.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace dsc::python {

namespace py = pybind11;
using namespace py::literals; // NOLINT: "name"_a

/// Points of the plane, or of space.
template <int N>
using PointList = std::vector<Eigen::Matrix<double, N, 1>>;
using Points = PointList<2>;
using Points3 = PointList<3>;
static_assert(sizeof(Point<double>) == 2 * sizeof(double));
static_assert(sizeof(dsc3::Point) == 3 * sizeof(double));

/// Any object that numpy can cast to an array of these numbers.
template <class Number>
using ArrayLike = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// A new array of `value(one)` for the elements of a range: of numbers (n,), or of rows of
/// `Number`, such as points (n, 2).
template <class Number = double, class Range, class Value>
[[nodiscard]] py::array array_over(const Range& range, Value value) {
    using Entry = std::decay_t<decltype(value(*range.begin()))>;
    constexpr bool is_row = !std::is_arithmetic_v<Entry>;
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(std::ranges::distance(range))};
    if (is_row) {
        shape.push_back(sizeof(Entry) / sizeof(Number));
    }
    py::array_t<std::conditional_t<is_row, Number, Entry>> array(shape);
    auto* to = reinterpret_cast<std::byte*>(array.mutable_data());
    for (auto&& one : range) {
        const Entry entry = value(one);
        std::memcpy(to, &entry, sizeof(Entry));
        to += sizeof(Entry);
    }
    return array;
}

/// A new array of these numbers or points.
template <class List>
[[nodiscard]] py::array array_of(const List& list) {
    return array_over(list, std::identity());
}

/// The array, which can only be read from now on.
[[nodiscard]] inline py::array frozen(py::array array) {
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// A Python function that C++ can copy and release without the GIL.
using SharedFunction = std::shared_ptr<py::function>;
[[nodiscard]] inline SharedFunction share(const py::function& function) {
    return {new py::function(function), [](py::function* last) {
                const py::gil_scoped_acquire gil;
                delete last; // NOLINT: the deleter of a shared_ptr
            }};
}

} // namespace dsc::python

/// How pybind11 converts points.
template <int N>
struct pybind11::detail::type_caster<std::vector<Eigen::Matrix<double, N, 1>>> {
    using List = dsc::python::PointList<N>;
    PYBIND11_TYPE_CASTER(List, const_name<N == 2>("points (n, 2)", "points (n, 3)"));

    bool load(handle source, bool /*convert*/) {
        const auto rows = dsc::python::ArrayLike<double>::ensure(source);
        if (!rows || rows.ndim() != 2 || rows.shape(1) != N) {
            return false;
        }
        value.resize(static_cast<std::size_t>(rows.shape(0)));
        std::memcpy(static_cast<void*>(value.data()), rows.data(), value.size() * sizeof(value[0]));
        return true;
    }
    static handle cast(const List& points, return_value_policy, handle /*parent*/) {
        return dsc::python::array_of(points).release();
    }
};

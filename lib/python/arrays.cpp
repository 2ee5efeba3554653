// SPDX-License-Identifier: MIT
#include "python/arrays.h"

#include <cstring>

namespace dsc::python {

namespace {

static_assert(sizeof(Point<double>) == 2 * sizeof(double));

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::string shape_of(const py::array& array) {
    std::string text = "an array of the shape (";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) {
        text += (i == 0 ? "" : ", ") + std::to_string(array.shape(i));
    }
    return text + ")";
}

Doubles rows_of_two(const py::handle& value, const std::string& where, py::ssize_t rows) {
    const std::string shape =
        "numbers of the shape (" + (rows < 0 ? std::string("n") : std::to_string(rows)) + ", 2)";
    // Complex numbers and texts would be cast in silence, or by a warning.
    const py::array given = py::array::ensure(value);
    const char kind = given ? given.dtype().kind() : 'O';
    if (!given || !(kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b')) {
        PyErr_Clear();
        refuse("not an array of points", where, shown(value), shape);
    }
    if (given.ndim() != 2 || given.shape(1) != 2 || (rows >= 0 && given.shape(0) != rows)) {
        refuse("points of another shape", where, shape_of(given), shape);
    }
    return Doubles::ensure(given);
}

} // namespace

void refuse(const std::string& what, const std::string& where, const std::string& value,
            const std::string& allowed) {
    throw InputError({.what = what, .where = where, .value = value, .allowed = allowed});
}

py::object record(const char* name, const py::dict& fields) {
    return py::module_::import("dsc.records").attr(name)(**fields);
}

std::vector<Point<double>> points_from(const py::handle& value, const std::string& where) {
    const Doubles rows = rows_of_two(value, where, -1);
    std::vector<Point<double>> points(static_cast<std::size_t>(rows.shape(0)));
    std::memcpy(static_cast<void*>(points.data()), rows.data(), points.size() * sizeof(points[0]));
    return points;
}

void read_points(const py::handle& value, std::span<Point<double>> points,
                 const std::string& where) {
    const Doubles rows = rows_of_two(value, where, static_cast<py::ssize_t>(points.size()));
    std::memcpy(static_cast<void*>(points.data()), rows.data(), points.size_bytes());
}

Point<double> point_from(const py::handle& value, const std::string& where) {
    std::array<Point<double>, 1> one;
    read_points(py::make_tuple(value), one, where);
    return one[0];
}

std::vector<py::object> outline_list(const py::handle& value) {
    std::vector<py::object> list;
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        for (const py::handle& one : value) {
            const py::array array = py::array::ensure(one);
            if (array && array.ndim() == 1) { // a point: the value is an outline itself
                list.clear();
                break;
            }
            list.push_back(py::reinterpret_borrow<py::object>(one));
        }
    }
    return list.empty() ? std::vector{py::reinterpret_borrow<py::object>(value)} : list;
}

py::array_t<std::uint32_t> whole_numbers(const py::handle& value, const std::string& where,
                                         const std::string& shape, int dimensions) {
    const py::array given = py::array::ensure(value);
    const char kind = given ? given.dtype().kind() : 'O';
    const bool fits = given && (kind == 'i' || kind == 'u') && given.ndim() == dimensions;
    if (!fits || (given.size() > 0 && given.attr("min")().cast<double>() < 0) ||
        (given.size() > 0 && given.attr("max")().cast<double>() > 0xffffffff)) {
        PyErr_Clear();
        refuse("not an array of numbers of 32 bits", where, shown(value),
               "whole numbers from 0 of the shape " + shape);
    }
    return py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>::ensure(given);
}

py::array_t<double> array_of(std::span<const Point<double>> points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
    std::memcpy(array.mutable_data(), points.data(), points.size_bytes());
    return array;
}

py::array frozen(py::array array) {
    array.attr("flags").attr("writeable") = false;
    return array;
}

std::string shown(const py::handle& value) {
    constexpr std::size_t longest = 60;
    const auto text = py::repr(value).cast<std::string>();
    return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

} // namespace dsc::python

// SPDX-License-Identifier: MIT
// Keyword arguments from a table of options: a function `for_each_option(visit)` that calls
// `visit(name, field, meaning)` for each option is used for setting, reading, errors and help
// texts.
#pragma once

#include "python/options.h"

#include "dsc/base/names.h"
#include "thesis/divisions.h"

#include <algorithm>
#include <optional>
#include <string>

namespace dsc::python {

/// The repr of a value, cut after 60 characters.
inline std::string shown(const py::handle& value) {
    constexpr std::size_t longest = 60;
    const auto text = py::repr(value).cast<std::string>();
    return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

/// The call of a size function, for errors.
inline std::string call_of(const SizeOptions<double>::ByPlace& /*type*/) {
    return "f(x, y, time, phase)";
}
inline std::string call_of(const SizeOptions<double>::OnInterface& /*type*/) {
    return "f(x, y, time)";
}
inline std::string call_of(const SizeOptions<double>::ByDistance& /*type*/) {
    return "f(distance)";
}

/// The names of the values of an option.
inline const auto& names_of(Integrator /*type*/) { return integrator_names; }
inline const auto& names_of(Insertion /*type*/) { return insertion_names; }
inline const auto& names_of(Coarsening /*type*/) { return coarsening_names; }
inline const auto& names_of(Reading /*type*/) { return reading_names; }
inline const auto& names_of(Detail /*type*/) { return detail_names; }
inline const auto& names_of(Coverage /*type*/) { return coverage_names; }
inline const auto& names_of(Topology /*type*/) { return topology_names; }
inline const auto& names_of(ChosenDivision /*type*/) {
    static const auto table = [] {
        EnumTable<ChosenDivision, in_place_divisions.size()> list;
        std::ranges::transform(in_place_divisions, list.begin(), [](const Division* one) {
            return Named<ChosenDivision>{{one}, one->name};
        });
        return list;
    }();
    return table;
}

/// An option that is chosen by name.
template <class Field>
concept IsNamed = requires(Field field) {
    names_of(field);
};

} // namespace dsc::python

/// How pybind11 converts choices.
template <dsc::python::IsNamed Choice>
struct pybind11::detail::type_caster<Choice> {
    PYBIND11_TYPE_CASTER(Choice, const_name("str"));

    bool load(handle source, bool /*convert*/) {
        if (isinstance<str>(source)) {
            const auto found =
                dsc::value_in(dsc::python::names_of(value), source.cast<std::string>());
            value = found.value_or(value);
            return found.has_value();
        }
        return false;
    }
    static handle cast(const Choice& choice, return_value_policy /*policy*/, handle /*parent*/) {
        return str(std::string(dsc::name_in(dsc::python::names_of(choice), choice))).release();
    }
};

namespace dsc::python {

/// The allowed values of a field: names of Python types, except for choices and functions.
template <class Field>
std::string allowed(const Field& field) {
    if constexpr (IsNamed<Field>) {
        return names_in(names_of(field));
    } else if constexpr (requires { call_of(field); }) {
        return "a function " + call_of(field);
    } else {
        return py::detail::make_caster<Field>::name.text;
    }
}
template <class Field>
std::string allowed(const std::optional<Field>& /*field*/) {
    return allowed(Field()) + " or None";
}

/// Sets a field. Throws InputError for a value of the wrong type.
template <class Field>
void set(Field& field, const std::string& name, const py::handle& value) {
    try {
        field = value.cast<Field>();
    } catch (const py::cast_error&) {
        throw InputError(
            {.what = "bad value", .where = name, .value = shown(value), .allowed = allowed(field)});
    }
}

/// Sets options from keywords. Throws InputError for an unknown keyword or a value of the wrong
/// type. `where` is the function with these keywords.
template <class Table>
void set_keywords(const py::dict& given, const std::string& where, Table for_each_option) {
    for (const auto& keyword : given) {
        const auto wanted = keyword.first.cast<std::string>();
        bool is_known = false;
        std::string names;
        for_each_option([&](const std::string& name, auto& field, auto) {
            names += (names.empty() ? "" : ", ") + name;
            if (name == wanted) {
                is_known = true;
                set(field, name, keyword.second);
            }
        });
        if (!is_known) {
            throw InputError({.what = "unknown option",
                              .where = where,
                              .value = "'" + wanted + "'",
                              .allowed = names});
        }
    }
}

/// All values, by name.
template <class Table>
[[nodiscard]] py::dict values_in(Table for_each_option) {
    py::dict values;
    for_each_option([&](const char* name, const auto& field, auto) { values[name] = field; });
    return values;
}

/// The help text: name, type, default and meaning of each option, in the style of numpydoc.
template <class Table>
[[nodiscard]] std::string help_of(Table for_each_option) {
    std::string text;
    for_each_option([&](const std::string& name, const auto& field, const std::string& meaning) {
        text += name + " : " + allowed(field) + ", default " + shown(py::cast(field)) + "\n    " +
                meaning + "\n";
    });
    return text;
}

} // namespace dsc::python

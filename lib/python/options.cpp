// SPDX-License-Identifier: MIT
#include "python/options.h"

#include "python/arrays.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace dsc::python {

namespace {

struct Keyword {
    std::string name;
    std::string meaning;
    std::function<void(Choices&, const py::handle&)> set;
    std::function<py::object(const Choices&)> value;
    bool is_size = false; ///< `initial_complex` takes it, too
};

[[noreturn]] void refuse(const std::string& name, const py::handle& value,
                         const std::string& allowed) {
    throw InputError(
        {.what = "bad value", .where = name, .value = shown(value), .allowed = allowed});
}

// In these rows `field` gives a reference to the field of a keyword, for const and non-const.

template <class Field>
Keyword plain(std::string name, std::string meaning, const char* allowed, Field field) {
    using Value = std::remove_cvref_t<decltype(field(std::declval<Choices&>()))>;
    return {name, std::move(meaning),
            [=](Choices& choices, const py::handle& value) {
                try {
                    field(choices) = value.cast<Value>();
                } catch (const py::cast_error&) {
                    refuse(name, value, allowed);
                }
            },
            [=](const Choices& choices) { return py::cast(field(choices)); }};
}

template <class Field>
Keyword number(std::string name, std::string meaning, Field field) {
    return plain(std::move(name), std::move(meaning), "a number", field);
}

template <class Enum, std::size_t n, class Field>
Keyword choice(std::string name, std::string meaning, const EnumTable<Enum, n>& table,
               Field field) {
    return {name, std::move(meaning) + ": " + names_in(table),
            [=, &table](Choices& choices, const py::handle& value) {
                const auto found = py::isinstance<py::str>(value)
                                       ? value_in(table, value.cast<std::string>())
                                       : std::nullopt;
                if (!found) {
                    refuse(name, value, names_in(table));
                }
                field(choices) = *found;
            },
            [=, &table](const Choices& choices) {
                return py::object(py::str(std::string(name_in(table, field(choices)))));
            }};
}

Keyword size(Keyword keyword) {
    keyword.is_size = true;
    return keyword;
}

/// A function of Python that returns a number, called by whichever thread needs it.
struct NumberFunction {
    Shared<py::function> function;

    double operator()(const Point<double>& p, double time, Phase phase) const {
        return call(p.x(), p.y(), time, phase);
    }
    double operator()(const Point<double>& p, double time) const {
        return call(p.x(), p.y(), time);
    }
    double operator()(double distance) const { return call(distance); }

private:
    template <class... Arguments>
    [[nodiscard]] double call(Arguments... arguments) const {
        const py::gil_scoped_acquire gil;
        const py::object result = (*function)(arguments...);
        try {
            return result.cast<double>();
        } catch (const py::cast_error&) {
            refuse("what a size function returns", result, "a number");
        }
    }
};

template <class Field>
Keyword function(std::string name, std::string meaning, const char* form, Field field) {
    return size({name, std::move(meaning) + ", as " + form,
                 [=](Choices& choices, const py::handle& value) {
                     if (value.is_none()) {
                         field(choices) = nullptr;
                     } else if (PyCallable_Check(value.ptr()) != 0) {
                         field(choices) =
                             NumberFunction{share(py::reinterpret_borrow<py::function>(value))};
                     } else {
                         refuse(name, value, std::string("a function ") + form);
                     }
                 },
                 [=](const Choices& choices) {
                     const auto* set = field(choices).template target<NumberFunction>();
                     return set == nullptr ? py::object(py::none()) : py::object(*set->function);
                 }});
}

// None stands for a sequential simulation, which these do not concern.
Keyword parallel(Keyword keyword) {
    keyword.set = [set = keyword.set](Choices& choices, const py::handle& value) {
        if (!value.is_none()) {
            set(choices, value);
            choices.is_parallel = true;
        }
    };
    keyword.value = [value = keyword.value](const Choices& choices) {
        return choices.is_parallel ? value(choices) : py::object(py::none());
    };
    return keyword;
}

Keyword division() {
    const auto names = [] {
        std::string all;
        for (const Division one : divisions()) {
            all += (all.empty() ? "" : ", ") + std::string(one->name);
        }
        return all;
    };
    return {"division", "how the mesh is divided among threads: " + names(),
            [=](Choices& choices, const py::handle& value) {
                const auto found = std::ranges::find_if(divisions(), [&](const Division one) {
                    return py::isinstance<py::str>(value) && one->name == value.cast<std::string>();
                });
                if (found == divisions().end()) {
                    refuse("division", value, names());
                }
                choices.parallel.division = *found;
            },
            [](const Choices& choices) {
                return py::object(py::str(std::string(choices.parallel.division->name)));
            }};
}

std::vector<Keyword> make_keywords() {
    return {
        size(number(
            "edge_length", "target length of edges, in units of the domain",
            [](auto& c) -> auto& { return c.options.edge_length; })),
        size(number(
            "growth", "how much longer an edge may be than the next one, 1 to 2; 0: of one length",
            [](auto& c) -> auto& { return c.options.sizes.growth; })),
        size(number(
            "longest", "the longest edge where they grow; 0: as long as the domain",
            [](auto& c) -> auto& { return c.options.sizes.longest; })),
        function(
            "by_place", "a target by place where edges grow", "f(x, y, time, phase)",
            [](auto& c) -> auto& { return c.options.sizes.by_place; }),
        function(
            "by_distance", "a target by the distance to the interface", "f(distance)",
            [](auto& c) -> auto& { return c.options.sizes.by_distance; }),
        function(
            "on_interface", "a target for the interface's own edges", "f(x, y, time)",
            [](auto& c) -> auto& { return c.options.sizes.on_interface; }),
        size(plain(
            "changes_in_time", "whether these functions do", "True or False",
            [](auto& c) -> auto& { return c.options.sizes.changes_in_time; })),
        choice(
            "integrator", "how targets are found from velocities", integrator_names,
            [](auto& c) -> auto& { return c.options.integrator; }),
        number(
            "tolerance", "of the adaptive integrator, in edge lengths",
            [](auto& c) -> auto& { return c.options.tolerance; }),
        choice(
            "insertion", "where new interface vertices go", insertion_names,
            [](auto& c) -> auto& { return c.options.insertion; }),
        choice(
            "coarsening", "which interface vertices may go", coarsening_names,
            [](auto& c) -> auto& { return c.options.interface.coarsening; }),
        choice(
            "reading", "what the deviation of the interface is measured from", reading_names,
            [](auto& c) -> auto& { return c.options.interface.reading; }),
        number(
            "deviation", "by which coarsening may move the interface, in edge lengths",
            [](auto& c) -> auto& { return c.options.interface.deviation; }),
        number(
            "corner_degrees", "sharper turns at the start are corners, which are kept",
            [](auto& c) -> auto& { return c.options.interface.corner_degrees; }),
        number(
            "turn_degrees", "interface edges along which it turns by more are split; 0: none",
            [](auto& c) -> auto& { return c.options.interface.turn_degrees; }),
        number(
            "gap", "interface edges longer than this times a gap are split; 0: none",
            [](auto& c) -> auto& { return c.options.interface.gap; }),
        plain(
            "carried_phases", "phases whose inside moves with the flow", "a list of phases",
            [](auto& c) -> auto& { return c.options.carried_phases; }),
        number(
            "sub_step", "the farthest that a vertex moves at a time, in edge lengths",
            [](auto& c) -> auto& { return c.options.sub_step; }),
        plain(
            "max_sub_steps", "of one step, which gives up then", "a whole number",
            [](auto& c) -> auto& { return c.options.max_sub_steps; }),
        choice(
            "topology", "what happens where a phase becomes thin", topology_names,
            [](auto& c) -> auto& { return c.topology.rule; }),
        number(
            "contact", "thickness at which a film opens, a length; 0: 0.4 edge lengths",
            [](auto& c) -> auto& { return c.topology.contact; }),
        number(
            "least_area", "smaller pieces vanish where topology is change; 0: edge_length**2",
            [](auto& c) -> auto& { return c.topology.least_area; }),
        plain(
            "gives_back_area", "whether area that changes hands is given back", "True or False",
            [](auto& c) -> auto& { return c.topology.gives_back_area; }),
        parallel(plain(
            "threads", "None: sequential; 1 to 1024: in submeshes, to one result for any number",
            "None or a whole number", [](auto& c) -> auto& { return c.parallel.threads; })),
        parallel(division()),
        parallel(plain(
            "submeshes", "0: the division's own choice", "a whole number",
            [](auto& c) -> auto& { return c.parallel.submeshes; })),
    };
}

const std::vector<Keyword>& keywords() {
    static const std::vector<Keyword> list = make_keywords();
    return list;
}

bool is_for(const Keyword& keyword, Use use) { return use == Use::simulation || keyword.is_size; }

} // namespace

void apply(Choices& choices, const py::dict& given, Use use) {
    for (const auto& [key, value] : given) {
        const auto name = key.cast<std::string>();
        const auto found = std::ranges::find(keywords(), name, &Keyword::name);
        if (found == keywords().end() || !is_for(*found, use)) {
            std::string names;
            for (const Keyword& one : keywords()) {
                if (is_for(one, use)) {
                    names += (names.empty() ? "" : ", ") + one.name;
                }
            }
            throw InputError({.what = "unknown option",
                              .where = use == Use::simulation ? "Simulation" : "initial_complex",
                              .value = "'" + name + "'",
                              .allowed = names});
        }
        found->set(choices, value);
    }
}

py::dict values_of(const Choices& choices) {
    py::dict values;
    for (const Keyword& one : keywords()) {
        values[py::str(one.name)] = one.value(choices);
    }
    return values;
}

std::string option_help(Use use) {
    std::string text;
    const Choices defaults;
    for (const Keyword& one : keywords()) {
        if (is_for(one, use)) {
            text += one.name + " : default " + shown(one.value(defaults)) + "\n    " + one.meaning +
                    "\n";
        }
    }
    return text;
}

} // namespace dsc::python

// SPDX-License-Identifier: MIT
#include "python/options.h"

#include "python/arrays.h"
#include "thesis/divisions.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
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
            refuse("not a length", "what a size function returns", shown(result), "a number");
        }
    }
};

// --- types of fields ---------------------------------------------------------------------------
// For each its values in words, and its way from Python and back.

const auto& table_of(Integrator /*type*/) { return integrator_names; }
const auto& table_of(Insertion /*type*/) { return insertion_names; }
const auto& table_of(Coarsening /*type*/) { return coarsening_names; }
const auto& table_of(Reading /*type*/) { return reading_names; }
const auto& table_of(Topology /*type*/) { return topology_names; }

std::string division_names() {
    std::string all;
    for (const Division* one : in_place_divisions) {
        all += (all.empty() ? "" : ", ") + std::string(one->name);
    }
    return all;
}

std::string form_of(const SizeOptions<double>::ByPlace& /*type*/) { return "f(x, y, time, phase)"; }
std::string form_of(const SizeOptions<double>::OnInterface& /*type*/) { return "f(x, y, time)"; }
std::string form_of(const SizeOptions<double>::ByDistance& /*type*/) { return "f(distance)"; }

template <class Field>
concept IsFunction = requires(Field field) {
    form_of(field);
};

template <class Field>
std::string allowed_for(const Field& field) {
    if constexpr (std::is_enum_v<Field>) {
        return names_in(table_of(field));
    } else if constexpr (std::is_same_v<Field, const Division*>) {
        return division_names();
    } else if constexpr (IsFunction<Field>) {
        return "a function " + form_of(field);
    } else if constexpr (std::is_same_v<Field, bool>) {
        return "True or False";
    } else if constexpr (std::is_arithmetic_v<Field>) {
        return std::is_integral_v<Field> ? "a whole number" : "a number";
    } else {
        return "a list of phases";
    }
}

// Returns whether the value is one of the field.
template <class Field>
bool take(const py::handle& value, Field& field) {
    if constexpr (std::is_enum_v<Field>) {
        const auto found = py::isinstance<py::str>(value)
                               ? value_in(table_of(field), value.cast<std::string>())
                               : std::nullopt;
        field = found.value_or(field);
        return found.has_value();
    } else if constexpr (std::is_same_v<Field, const Division*>) {
        const auto found = std::ranges::find_if(in_place_divisions, [&](const Division* one) {
            return py::isinstance<py::str>(value) && one->name == value.cast<std::string>();
        });
        field = found == in_place_divisions.end() ? field : *found;
        return found != in_place_divisions.end();
    } else if constexpr (IsFunction<Field>) {
        field = nullptr;
        if (PyCallable_Check(value.ptr()) != 0) {
            field = NumberFunction{share(py::reinterpret_borrow<py::function>(value))};
        }
        return field || value.is_none();
    } else {
        try {
            field = value.cast<Field>();
            return true;
        } catch (const py::cast_error&) {
            return false;
        }
    }
}

template <class Field>
py::object shown_in_python(const Field& field) {
    if constexpr (std::is_enum_v<Field>) {
        return py::str(std::string(name_in(table_of(field), field)));
    } else if constexpr (std::is_same_v<Field, const Division*>) {
        return py::str(std::string(field->name));
    } else if constexpr (IsFunction<Field>) {
        const auto* set = field.template target<NumberFunction>();
        return set == nullptr ? py::object(py::none()) : py::object(*set->function);
    } else {
        return py::cast(field);
    }
}

// --- the table ---------------------------------------------------------------------------------

// `place` gives a reference to the field of some choices, const or not.
template <class Place>
Keyword keyword(std::string name, std::string meaning, Place place) {
    using Field = std::remove_cvref_t<decltype(place(std::declval<Choices&>()))>;
    if constexpr (std::is_enum_v<Field> || std::is_same_v<Field, const Division*> ||
                  IsFunction<Field>) {
        meaning += ": " + allowed_for(place(static_cast<const Choices&>(Choices())));
    }
    return {name, std::move(meaning),
            [=](Choices& choices, const py::handle& value) {
                if (!take(value, place(choices))) {
                    refuse("bad value", name, shown(value), allowed_for(place(choices)));
                }
            },
            [=](const Choices& choices) { return shown_in_python(place(choices)); }};
}

Keyword size(Keyword keyword) {
    keyword.is_size = true;
    return keyword;
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

#define DSC_ROW(name, place, meaning)                                                              \
    keyword(                                                                                       \
        name, meaning, [](auto& choices) -> auto& { return choices.place; })

// clang-format off: a row is a line or two
std::vector<Keyword> make_keywords() {
    return {
        size(DSC_ROW("edge_length", options.edge_length,
                     "target length of edges, in units of the domain")),
        size(DSC_ROW("growth", options.sizes.growth,
                     "how much longer an edge may be than the next one, 1 to 2; 0: of one length")),
        size(DSC_ROW("longest", options.sizes.longest,
                     "the longest edge where they grow; 0: as long as the domain")),
        size(DSC_ROW("by_place", options.sizes.by_place, "a target by place where edges grow")),
        size(DSC_ROW("by_distance", options.sizes.by_distance,
                     "a target by the distance to the interface")),
        size(DSC_ROW("on_interface", options.sizes.on_interface,
                     "a target for the interface's own edges")),
        size(DSC_ROW("changes_in_time", options.sizes.changes_in_time,
                     "whether these functions do")),
        DSC_ROW("integrator", options.integrator, "how targets are found from velocities"),
        DSC_ROW("tolerance", options.tolerance, "of the adaptive integrator, in edge lengths"),
        DSC_ROW("insertion", options.insertion, "where new interface vertices go"),
        DSC_ROW("coarsening", options.interface.coarsening, "which interface vertices may go"),
        DSC_ROW("reading", options.interface.reading,
                "what the deviation of the interface is measured from"),
        DSC_ROW("deviation", options.interface.deviation,
                "by which coarsening may move the interface, in edge lengths"),
        DSC_ROW("corner_degrees", options.interface.corner_degrees,
                "sharper turns at the start are corners, which are kept"),
        DSC_ROW("turn_degrees", options.interface.turn_degrees,
                "interface edges along which it turns by more are split; 0: none"),
        DSC_ROW("gap", options.interface.gap,
                "interface edges longer than this times a gap are split; 0: none"),
        DSC_ROW("carried_phases", options.carried_phases,
                "phases whose inside moves with the flow"),
        DSC_ROW("sub_step", options.sub_step,
                "the farthest that a vertex moves at a time, in edge lengths"),
        DSC_ROW("max_sub_steps", options.max_sub_steps, "of one step, which gives up then"),
        DSC_ROW("topology", topology.rule, "what happens where a phase becomes thin"),
        DSC_ROW("contact", topology.contact,
                "thickness at which a film opens, a length; 0: 0.4 edge lengths"),
        DSC_ROW("least_area", topology.least_area,
                "smaller pieces vanish where topology is change; 0: edge_length**2"),
        DSC_ROW("gives_back_area", topology.gives_back_area,
                "whether area that changes hands is given back"),
        parallel(
            DSC_ROW("threads", parallel.threads,
                    "None: sequential; 1 to 1024: in submeshes, with one result for any number")),
        parallel(DSC_ROW("division", parallel.division, "how the mesh is divided among threads")),
        parallel(DSC_ROW("submeshes", parallel.submeshes, "0: the division's own choice")),
    };
}
// clang-format on
#undef DSC_ROW

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
            refuse("unknown option", use == Use::simulation ? "Simulation" : "initial_complex",
                   "'" + name + "'", names);
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

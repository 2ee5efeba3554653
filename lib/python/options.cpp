// SPDX-License-Identifier: MIT
#include "python/options.h"

#include "python/arrays.h"
#include "thesis/divisions.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc::python {

namespace {

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

template <class Field>
using Is = std::type_identity<Field>;

const auto& table_of(Is<Integrator> /*type*/) { return integrator_names; }
const auto& table_of(Is<Insertion> /*type*/) { return insertion_names; }
const auto& table_of(Is<Coarsening> /*type*/) { return coarsening_names; }
const auto& table_of(Is<Reading> /*type*/) { return reading_names; }
const auto& table_of(Is<Topology> /*type*/) { return topology_names; }
const auto& table_of(Is<const Division*> /*type*/) {
    static const auto table = [] {
        std::array<Named<const Division*>, in_place_divisions.size()> list;
        std::ranges::transform(in_place_divisions, list.begin(), [](const Division* one) {
            return Named<const Division*>{one, one->name};
        });
        return list;
    }();
    return table;
}

std::string form_of(Is<SizeOptions<double>::ByPlace> /*type*/) { return "f(x, y, time, phase)"; }
std::string form_of(Is<SizeOptions<double>::OnInterface> /*type*/) { return "f(x, y, time)"; }
std::string form_of(Is<SizeOptions<double>::ByDistance> /*type*/) { return "f(distance)"; }

template <class Field>
concept IsNamed = requires {
    table_of(Is<Field>());
};
template <class Field>
concept IsFunction = requires {
    form_of(Is<Field>());
};

template <class Field>
std::string allowed() {
    if constexpr (IsNamed<Field>) {
        return names_in(table_of(Is<Field>()));
    } else if constexpr (IsFunction<Field>) {
        return "a function " + form_of(Is<Field>());
    } else if constexpr (std::is_same_v<Field, bool>) {
        return "True or False";
    } else if constexpr (std::is_arithmetic_v<Field>) {
        return std::is_integral_v<Field> ? "a whole number" : "a number";
    } else {
        return "a list of phases";
    }
}

// Nothing if the value is none of the field.
template <class Field>
std::optional<Field> read(const py::handle& value) {
    if constexpr (IsNamed<Field>) {
        return py::isinstance<py::str>(value)
                   ? value_in(table_of(Is<Field>()), value.cast<std::string>())
                   : std::nullopt;
    } else if constexpr (IsFunction<Field>) {
        if (PyCallable_Check(value.ptr()) != 0) {
            return NumberFunction{share(py::reinterpret_borrow<py::function>(value))};
        }
        return value.is_none() ? std::optional(Field()) : std::nullopt;
    } else {
        try {
            return value.cast<Field>();
        } catch (const py::cast_error&) {
            return std::nullopt;
        }
    }
}

template <class Field>
Field required(const std::string& name, const py::handle& value) {
    std::optional<Field> one = read<Field>(value);
    if (!one) {
        refuse("bad value", name, shown(value), allowed<Field>());
    }
    return *std::move(one);
}
template <class Field>
void set(Field& field, const std::string& name, const py::handle& value) {
    field = required<Field>(name, value);
}
template <class Field>
void set(std::optional<Field>& field, const std::string& name, const py::handle& value) {
    if (value.is_none()) {
        field.reset();
    } else {
        field = required<Field>(name, value);
    }
}

template <class Field>
py::object in_python(const Field& field) {
    if constexpr (IsNamed<Field>) {
        return py::str(std::string(name_in(table_of(Is<Field>()), field)));
    } else if constexpr (IsFunction<Field>) {
        const auto* function = field.template target<NumberFunction>();
        return function == nullptr ? py::object(py::none()) : py::object(*function->function);
    } else {
        return py::cast(field);
    }
}
template <class Field>
py::object in_python(const std::optional<Field>& field) {
    return field ? in_python(*field) : py::none();
}

// What the help adds to the meaning.
template <class Field>
std::string choice() {
    return IsNamed<Field> || IsFunction<Field> ? ": " + allowed<Field>() : "";
}
template <class Field>
std::string choice_of(const Field& /*field*/) {
    return choice<Field>();
}
template <class Field>
std::string choice_of(const std::optional<Field>& /*field*/) {
    return choice<Field>();
}

// --- the table ---------------------------------------------------------------------------------
// `visit(name, field, meaning)` for each; the choices may be const.

// clang-format off: a row is a line or two
template <class AnyChoices, class Visit>
void for_each_option(AnyChoices& choices, Use use, Visit visit) {
    auto& [options, topology, threads, division, submeshes] = choices;
    auto& sizes = options.sizes;
    auto& interface = options.interface;
    visit("edge_length", options.edge_length, "target length of edges, in units of the domain");
    visit("growth", sizes.growth,
          "how much longer an edge may be than the next one, 1 to 2; 0: of one length");
    visit("longest", sizes.longest, "the longest edge where they grow; 0: as long as the domain");
    visit("shortest", sizes.shortest,
          "the shortest edge that these functions may ask for; 0: the edge length");
    visit("by_place", sizes.by_place, "a target by place where edges grow");
    visit("by_distance", sizes.by_distance, "a target by the distance to the interface");
    visit("on_interface", sizes.on_interface, "a target for the interface's own edges");
    visit("changes_in_time", sizes.changes_in_time, "whether these functions do");
    if (use == Use::initial_complex) {
        return;
    }
    visit("integrator", options.integrator, "how targets are found from velocities");
    visit("tolerance", options.tolerance, "of the adaptive integrator, in edge lengths");
    visit("insertion", options.insertion, "where new interface vertices go");
    visit("coarsening", interface.coarsening, "which interface vertices may go");
    visit("reading", interface.reading, "what the deviation of the interface is measured from");
    visit("deviation", interface.deviation,
          "by which coarsening may move the interface, in edge lengths");
    visit("corner_degrees", interface.corner_degrees,
          "sharper turns at the start are corners, which are kept");
    visit("turn_degrees", interface.turn_degrees,
          "interface edges along which it turns by more are split; 0: none");
    visit("gap", interface.gap, "interface edges longer than this times a gap are split; 0: none");
    visit("carried_phases", options.carried_phases, "phases whose inside moves with the flow");
    visit("sub_step", options.sub_step,
          "the farthest that a vertex moves at a time, in edge lengths");
    visit("max_sub_steps", options.max_sub_steps, "of one step, which gives up then");
    visit("topology", topology.rule, "what happens where a phase becomes thin");
    visit("contact", topology.contact,
          "thickness at which a film opens, a length; 0: 0.4 edge lengths");
    visit("least_area", topology.least_area,
          "smaller pieces vanish where topology is change; 0: edge_length**2");
    visit("follows_seams", topology.follows_seams,
          "whether a film goes on opening beside where it has opened");
    visit("gives_back_area", topology.gives_back_area,
          "whether area that changes hands is given back");
    visit("threads", threads,
          "None: sequential; 1 to 1024: in submeshes, with one result for any number");
    visit("division", division, "how the mesh is divided among threads");
    visit("submeshes", submeshes, "0: the division's own choice");
}
// clang-format on

} // namespace

std::optional<Parallel> Choices::parallel() const {
    if (!threads && !division && !submeshes) {
        return std::nullopt;
    }
    Parallel parallel;
    parallel.threads = threads.value_or(parallel.threads);
    parallel.division = division.value_or(parallel.division);
    parallel.submeshes = submeshes.value_or(parallel.submeshes);
    return parallel;
}

void apply(Choices& choices, const py::dict& given, Use use) {
    for (const auto& [key, value] : given) {
        const auto wanted = key.cast<std::string>();
        bool is_known = false;
        std::string names;
        const auto try_one = [&](const std::string& name, auto& field, const char* /*meaning*/) {
            names += (names.empty() ? "" : ", ") + name;
            if (name == wanted) {
                is_known = true;
                set(field, name, value);
            }
        };
        for_each_option(choices, use, try_one);
        if (!is_known) {
            refuse("unknown option", use == Use::simulation ? "Simulation" : "initial_complex",
                   "'" + wanted + "'", names);
        }
    }
}

py::dict values_of(const Choices& choices) {
    py::dict values;
    for_each_option(choices, Use::simulation, [&](const char* name, const auto& field, auto) {
        values[name] = in_python(field);
    });
    return values;
}

std::string option_help(Use use) {
    std::string text;
    const Choices defaults;
    for_each_option(defaults, use,
                    [&](const std::string& name, const auto& field, const std::string& meaning) {
                        text += name + " : default " + shown(in_python(field)) + "\n    " +
                                meaning + choice_of(field) + "\n";
                    });
    return text;
}

} // namespace dsc::python

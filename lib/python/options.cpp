// SPDX-License-Identifier: MIT
#include "python/options.h"

#include "dsc/base/renamed.h"
#include "dsc/parallel/executors.h"
#include "python/option_table.h"

#include <functional>

namespace dsc::python {

namespace {

// --- sizes: Python functions that return a number, called by any thread --------------------------

struct SizeFunction {
    SharedFunction function;

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
            throw InputError({.what = "a size function must return a number",
                              .where = "the result of a size function",
                              .value = shown(result),
                              .allowed = "a number"});
        }
    }
};

} // namespace

} // namespace dsc::python

// --- conversions by pybind11 ---------------------------------------------------------------------

template <class... Arguments>
struct pybind11::detail::type_caster<std::function<double(Arguments...)>> {
    using Function = std::function<double(Arguments...)>;
    PYBIND11_TYPE_CASTER(Function, const_name("function"));

    bool load(handle source, bool /*convert*/) {
        if (PyCallable_Check(source.ptr()) == 0) {
            return source.is_none();
        }
        value = dsc::python::SizeFunction{
            dsc::python::share(reinterpret_borrow<pybind11::function>(source))};
        return true;
    }
    static handle cast(const Function& function, return_value_policy /*policy*/,
                       handle /*parent*/) {
        const auto* own = function.template target<dsc::python::SizeFunction>();
        return own == nullptr ? none().release() : handle(*own->function).inc_ref();
    }
};

namespace dsc::python {

namespace {

// --- the table ---------------------------------------------------------------------------------
// Calls `visit(name, field, meaning)` for each option; the choices may be const.

// clang-format off: a row is a line or two
template <class AnyChoices, class Visit>
void for_each_option(AnyChoices& choices, Use use, Visit visit) {
    auto& [options, topology, detail, border_tolerance, coverage, threads, division, submeshes] =
        choices;
    auto& sizes = options.sizes;
    auto& interface = options.interface;
    visit("edge_length", options.edge_length, "target length of edges, in units of the domain");
    visit("growth", sizes.growth,
          "ratio of the lengths of neighbouring edges, 1 to 2; 0: uniform lengths");
    visit("longest", sizes.longest, "the longest edge if edges grow; 0: no limit but the domain");
    visit("shortest", sizes.shortest, "lower bound of the functions below; 0: the edge length");
    visit("by_place", sizes.by_place, "a target length by place, if edges grow");
    visit("by_distance", sizes.by_distance, "a target length by the distance to the interface");
    visit("on_interface", sizes.on_interface, "a target length of interface edges");
    visit("changes_in_time", sizes.changes_in_time, "whether these functions depend on time");
    if (use == Use::initial_complex) {
        visit("detail", detail, "treatment of detail of shapes that is finer than the mesh");
        visit("border_tolerance", border_tolerance,
              "borders of shapes nearer than this are merged, in edge lengths; 0.001 to 0.1");
        visit("coverage", coverage, "treatment of wider gaps and overlaps of shapes");
        return;
    }
    visit("integrator", options.integrator, "how targets are found from velocities");
    visit("tolerance", options.tolerance, "of the adaptive integrator, in edge lengths");
    visit("insertion", options.insertion, "where new interface vertices go");
    visit("coarsening", interface.coarsening, "which interface vertices may be removed");
    visit("reading", interface.reading, "the curve from which the deviation is measured");
    visit("deviation", interface.deviation,
          "by which coarsening may move the interface, in edge lengths");
    visit("feature_degrees", interface.feature_degrees,
          "sharper turns at the start are features, which are kept");
    visit("turn_degrees", interface.turn_degrees,
          "interface edges along which it turns by more are split; 0: none");
    visit("gap", interface.gap, "interface edges longer than this times a gap are split; 0: none");
    visit("advected_phases", options.advected_phases, "phases whose inside moves with the flow");
    visit("sub_step", options.sub_step,
          "the largest displacement of a vertex in a sub-step, in edge lengths");
    visit("max_sub_steps", options.max_sub_steps, "a step that needs more gives up");
    visit("topology", topology.rule, "whether the topology is kept or may change");
    visit("contact", topology.contact,
          "thickness at which a film opens, a length; 0: 0.4 edge lengths");
    visit("min_area", topology.min_area,
          "smaller pieces vanish where topology is change; 0: edge_length**2");
    visit("follows_seams", topology.follows_seams, "whether an opening continues along the film");
    visit("gives_back_area", topology.gives_back_area,
          "whether area lost in changes of topology is given back");
    visit("threads", threads,
          "None: sequential; 1 to 1024: in submeshes, with the same result for any number");
    visit("division", division, "how the mesh is divided among threads");
    visit("submeshes", submeshes, "0: chosen by the division");
}
// clang-format on

} // namespace

std::optional<Parallel> Choices::parallel() const {
    if (!threads && !division && !submeshes) {
        return std::nullopt;
    }
    Parallel parallel;
    parallel.threads = threads.value_or(parallel.threads);
    parallel.division = division.value_or(ChosenDivision{parallel.division}).division;
    parallel.submeshes = submeshes.value_or(parallel.submeshes);
    return parallel;
}

std::string current_option(const std::string& name) {
    const RenamedOption* renamed = renamed_option(name);
    if (renamed == nullptr) {
        return name;
    }
    if (PyErr_WarnEx(PyExc_FutureWarning, renamed->warning().c_str(), 1) != 0) {
        throw py::error_already_set();
    }
    return std::string(renamed->now);
}

void apply(Choices& choices, const py::dict& given, Use use) {
    py::dict current;
    for (const auto& [name, value] : given) {
        current[py::str(current_option(name.cast<std::string>()))] = value;
    }
    set_keywords(current, use == Use::simulation ? "Simulation" : "initial_complex",
                 [&](auto visit) { for_each_option(choices, use, visit); });
}

py::dict values_of(const Choices& choices) {
    return values_in([&](auto visit) { for_each_option(choices, Use::simulation, visit); });
}

std::string option_help(Use use) {
    const Choices defaults;
    return help_of([&](auto visit) { for_each_option(defaults, use, visit); });
}

} // namespace dsc::python

// SPDX-License-Identifier: MIT
#include "python/flows.h"

#include "flows/velocity.h"
#include "python/mesh.h"

#include <pybind11/stl.h>

#include <map>
#include <utility>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

VelocityAtOnce<double> velocity_of(const py::function& function) {
    return {[shared = share(function)](std::span<const Point<double>> positions, double time,
                                       std::span<Point<double>> velocities) {
        const py::gil_scoped_acquire gil;
        read_points((*shared)(array_of(positions), time), velocities, "what the velocity returns");
    }};
}

// --- flows that see the interface --------------------------------------------------------------

namespace {

// -1 for what is none: a neighbour of a junction, the outside of the domain.
constexpr auto number_or_none = [](std::uint32_t number) {
    return number == no_id || number == border_phase ? std::int64_t{-1} : std::int64_t{number};
};

template <class Number, class Of>
py::array_t<Number> listed(std::size_t size, Of of) {
    py::array_t<Number> array(static_cast<py::ssize_t>(size));
    Number* to = array.mutable_data();
    for (std::size_t i = 0; i < size; ++i) {
        to[i] = of(i);
    }
    return array;
}

py::array arms_in(const InterfaceView<double>& view) {
    py::array_t<std::int64_t> rows({static_cast<py::ssize_t>(view.arms.size()), py::ssize_t{4}});
    std::int64_t* to = rows.mutable_data();
    for (const std::uint32_t junction : view.junctions) {
        for (const InterfaceArm& arm : arms_of(view, junction)) {
            for (const std::uint32_t one : {junction, arm.neighbour, arm.left, arm.right}) {
                *to++ = number_or_none(one);
            }
        }
    }
    return rows;
}

py::object interface_of(const InterfaceView<double>& view) {
    const std::size_t n = view.size();
    const auto numbers = [&](std::span<const std::uint32_t> list) {
        return listed<std::int64_t>(n, [&](std::size_t i) { return number_or_none(list[i]); });
    };
    const auto flag = [&](InterfaceFlag one) {
        return listed<bool>(n, [&](std::size_t i) { return (view.flags[i] & one) != 0; });
    };
    std::vector<Point<double>> normals(n);
    for (std::size_t i = 0; i < n; ++i) {
        normals[i] = normal(view, i);
    }
    return record(
        "Interface",
        py::dict(
            "positions"_a = array_of(view.positions), "previous"_a = numbers(view.previous),
            "next"_a = numbers(view.next), "left"_a = numbers(view.left),
            "right"_a = numbers(view.right), "normals"_a = array_of(normals),
            "curvatures"_a = listed<double>(n, [&](std::size_t i) { return curvature(view, i); }),
            "lengths"_a = listed<double>(n, [&](std::size_t i) { return length(view, i); }),
            "arms"_a = arms_in(view), "is_junction"_a = flag(interface_junction),
            "is_corner"_a = flag(interface_corner), "is_on_boundary"_a = flag(interface_boundary),
            "is_locked"_a = flag(interface_locked)));
}

} // namespace

InterfaceMotion<double> motion_of(const SeeingFunction& seeing, Integrator integrator) {
    if (integrator == Integrator::adaptive) {
        refuse("a flow that sees the interface has no estimate of the error", "integrator",
               "adaptive", "euler, midpoint, rk4");
    }
    return [function = seeing.function, integrator](const InterfaceView<double>& view, double time,
                                                    double dt,
                                                    std::span<Point<double>> displacements) {
        const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double t,
                                              std::span<Point<double>> velocities) {
            // A failure at one vertex must not affect its neighbours.
            std::vector<Point<double>> seen(positions.begin(), positions.end());
            for (std::size_t i = 0; i < seen.size(); ++i) {
                seen[i] = seen[i].allFinite() ? seen[i] : view.positions[i];
            }
            InterfaceView<double> stage = view;
            stage.positions = seen;
            const py::gil_scoped_acquire gil;
            read_points((*function)(interface_of(stage), t), velocities, "what the flow returns");
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if ((view.flags[i] & interface_locked) != 0) {
                    velocities[i].setZero();
                }
            }
        };
        IntegratorScratch<double> scratch;
        scratch.first.resize(view.size());
        velocity(view.positions, time, scratch.first);
        std::vector<Point<double>> targets(view.size());
        integrate<double>(integrator, velocity, view.positions, time, dt, targets, scratch);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            displacements[i] = targets[i] - view.positions[i];
        }
    };
}

// --- the library's own -------------------------------------------------------------------------

namespace {

std::vector<KeptArea> areas_from(const py::object& keep) {
    std::map<Phase, double> areas;
    if (py::isinstance<Mesh>(keep)) {
        const auto& complex = keep.cast<const Mesh&>().complex();
        for (const Phase phase : phases(complex)) {
            areas[phase] = phase_area(complex, phase);
        }
        areas.erase(exterior_phase);
    } else if (!keep.is_none()) {
        areas = keep.cast<std::map<Phase, double>>();
    }
    std::vector<KeptArea> list;
    for (const auto& [phase, area] : areas) {
        list.push_back({phase, area});
    }
    return list;
}

using Speeds = std::map<std::pair<Phase, Phase>, double>;

OwnFlow growth_of(const Speeds& speeds) {
    GrowthOptions<double> options;
    for (const auto& [pair, speed] : speeds) {
        options.speeds.push_back({.growing = pair.first, .into = pair.second, .speed = speed});
    }
    return {"growth", py::make_tuple(speeds), growth(options), options};
}

} // namespace

void add_flows(py::module_& module) {
    py::class_<OwnFlow>(module, "Flow", R"(
A flow for `Simulation.step`, other than a function of positions and time.
)")
        .def_readonly("_name", &OwnFlow::name)
        .def_readonly("_given", &OwnFlow::given);

    module.def(
        "interface_flow",
        [](const py::function& function) {
            return OwnFlow{"interface_flow", py::make_tuple(function),
                           SeeingFunction{share(function)}};
        },
        "function"_a, R"(
A flow that sees the interface.

Parameters
----------
function : callable
    Called as `function(interface, time)` with an `Interface`, once in each stage of the integrator
    (`euler`, `midpoint` or `rk4`) for all of the interface, by the thread that called `step`;
    returns velocities (n, 2).

Returns
-------
Flow

Notes
-----
Explicit integrators limit the step of a flow that smooths: where the velocity is -curvature *
normal, dt * 4 / l**2 must stay below 2, with l the shortest edge. `curvature_flow` has no limit.

Examples
--------
>>> @dsc.interface_flow
... def grow(interface, time):
...     return 0.1 * interface.normals
>>> sim.step(grow, 0, 0.1).unreached
0
)");
    module.def(
        "swirl",
        [](double amplitude, double period) {
            return OwnFlow{"swirl", py::make_tuple(amplitude, period),
                           Velocity<double>(scenes::Swirl{amplitude, period})};
        },
        "amplitude"_a = 1.0, "period"_a = 0.0, R"(
amplitude * f(t) * (sin(pi x)**2 sin(2 pi y), -sin(pi y)**2 sin(2 pi x)).

Parameters
----------
amplitude : float
period : float
    f is cos(pi t / period), or 1 if this is 0.

Returns
-------
Flow
)");
    module.def("growth", &growth_of, "speeds"_a, R"(
Phases grow along their normals; convex corners open into arcs.

The simulation must be made for it: `dsc.Simulation(mesh, flow, edge_length=h)`.

Parameters
----------
speeds : dict
    `{(growing, into): speed}`, in lengths per time; interfaces of other pairs stay.

Returns
-------
Flow
)");
    module.def(
        "curvature_flow",
        [](double tension, double mobility, const py::object& keep_areas_of) {
            CurvatureFlowOptions options{.tension = tension, .mobility = mobility};
            options.kept_areas = areas_from(keep_areas_of);
            py::dict areas;
            for (const KeptArea& kept : options.kept_areas) {
                areas[py::int_(kept.phase)] = kept.area;
            }
            return OwnFlow{"curvature_flow", py::make_tuple(tension, mobility, areas),
                           curvature_flow<double>(options)};
        },
        "tension"_a = 1.0, "mobility"_a = 1.0, "keep_areas_of"_a = py::none(), R"(
The interface moves along its normal at tension * mobility * curvature.

Parameters
----------
tension, mobility : float
    Of all pairs of phases.
keep_areas_of : Mesh or dict, optional
    Each phase but 0 keeps the area that it has in this mesh, or the area that is given by phase.

Returns
-------
Flow
)");
}

} // namespace dsc::python

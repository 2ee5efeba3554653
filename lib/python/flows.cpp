// SPDX-License-Identifier: MIT
#include "python/flows.h"

#include "flows/velocity.h"
#include "python/module.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace dsc::python {

namespace {

// --- flows that depend on the interface--------------------------------------------------------

// Indices, with -1 for none: for the neighbours of a junction, and the outside of the domain.
std::int64_t number_or_none(std::uint32_t number) {
    return number == no_id || number == border_phase ? -1 : std::int64_t{number};
}

py::array arms_in(const InterfaceView<double>& view) {
    std::vector<std::array<std::int64_t, 4>> rows;
    for (const std::uint32_t junction : view.junctions) {
        for (const InterfaceArm& arm : arms_of(view, junction)) {
            rows.push_back({junction, number_or_none(arm.neighbour), number_or_none(arm.left),
                            number_or_none(arm.right)});
        }
    }
    return array_over<std::int64_t>(rows, std::identity());
}

py::object interface_of(const InterfaceView<double>& view) {
    std::vector<std::size_t> vertices(view.size());
    std::iota(vertices.begin(), vertices.end(), 0U);
    const auto numbers = [](auto list) { return array_over(list, number_or_none); };
    const auto flags = [&](InterfaceFlag flag) {
        return array_over(view.flags, [=](std::uint8_t all) { return (all & flag) != 0; });
    };
    const auto measured = [&](auto measure) { return array_over(vertices, measure); };
    return py::module_::import("dsc.records")
        .attr("Interface")("positions"_a = array_of(view.positions),
                           "previous"_a = numbers(view.previous), "next"_a = numbers(view.next),
                           "left"_a = numbers(view.left), "right"_a = numbers(view.right),
                           "normals"_a = measured([&](std::size_t i) { return normal(view, i); }),
                           "curvatures"_a =
                               measured([&](std::size_t i) { return curvature(view, i); }),
                           "lengths"_a = measured([&](std::size_t i) { return length(view, i); }),
                           "arms"_a = arms_in(view), "is_junction"_a = flags(interface_junction),
                           "is_feature"_a = flags(interface_feature),
                           "is_on_boundary"_a = flags(interface_boundary),
                           "is_locked"_a = flags(interface_locked));
}

// Calls `function(interface, t)` in each stage of the integrator, once for the whole interface.
// Throws InputError for `adaptive`, because motions have no error estimate.
InterfaceMotion<double> motion_of(const SharedFunction& function, Integrator integrator) {
    if (integrator == Integrator::adaptive) {
        throw InputError(
            {.what = "the adaptive integrator does not support flows that depend on the interface",
             .where = "integrator",
             .value = "adaptive",
             .allowed = "euler, midpoint, rk4"});
    }
    return [function, integrator](const InterfaceView<double>& view, double time, double dt,
                                  std::span<Point<double>> displacements) {
        const Velocity<double> velocity = [&](std::span<const Point<double>> positions, double t,
                                              std::span<Point<double>> velocities) {
            // Copies the positions and replaces those that are not finite, so that a failure at one
            // vertex does not affect its neighbours.
            Points seen(positions.begin(), positions.end());
            for (std::size_t i = 0; i < seen.size(); ++i) {
                seen[i] = seen[i].allFinite() ? seen[i] : view.positions[i];
            }
            InterfaceView<double> stage = view;
            stage.positions = seen;
            const py::gil_scoped_acquire gil;
            read<2>((*function)(interface_of(stage), t), "what the flow returns", velocities);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if ((view.flags[i] & interface_locked) != 0) {
                    velocities[i].setZero();
                }
            }
        };
        IntegratorScratch<double> scratch;
        scratch.first.resize(view.size());
        velocity(view.positions, time, scratch.first);
        Points targets(view.size());
        integrate<double>(integrator, velocity, view.positions, time, dt, targets, scratch);
        std::ranges::transform(targets, view.positions, displacements.begin(), std::minus());
    };
}

// --- the module ----------------------------------------------------------------------------------

template <class Flow>
AnyFlow along(const Flow& flow, const std::optional<GrowthOptions<double>>& growth = {}) {
    const auto step = [flow](Simulation<double>& simulation, double time, double dt) {
        return simulation.step(flow, time, dt);
    };
    return {step, growth};
}

AnyFlow interface_flow_of(const py::function& function) {
    return {[shared = share(function)](Simulation<double>& simulation, double time, double dt) {
        return simulation.step(motion_of(shared, simulation.options().integrator), time, dt);
    }};
}

AnyFlow growth_of(const std::map<std::pair<Phase, Phase>, double>& speeds) {
    GrowthOptions<double> options;
    for (const auto& [pair, speed] : speeds) {
        options.speeds.push_back({.growing = pair.first, .into = pair.second, .speed = speed});
    }
    return along(growth(options), options);
}

using TensionAndMobility = std::pair<double, double>;

AnyFlow curvature_flow_of(double tension, double mobility,
                          const std::map<std::pair<Phase, Phase>, TensionAndMobility>& pairs,
                          const std::map<Phase, double>& areas) {
    CurvatureFlowOptions options{.tension = tension, .mobility = mobility};
    for (const auto& [pair, values] : pairs) {
        options.pairs.push_back({pair.first, pair.second, values.first, values.second});
    }
    for (const auto& [phase, area] : areas) {
        options.kept_areas.push_back({phase, area});
    }
    return along(curvature_flow<double>(options));
}

} // namespace

void add_flows(py::module_& module) {
    const py::class_<AnyFlow> type(module, "Flow");
    module.def("velocity", [](const py::function& f) {
        return along(VelocityAtOnce<double>{velocity_of<2>(f)});
    });
    module.def("interface_flow", &interface_flow_of);
    module.def("swirl", [](double amplitude, double period) {
        return along(Velocity<double>(scenes::Swirl{amplitude, period}));
    });
    module.def("growth", &growth_of);
    module.def("curvature_flow", &curvature_flow_of);
}

} // namespace dsc::python

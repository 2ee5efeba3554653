// SPDX-License-Identifier: MIT
#include "python/fluid.h"

#include "fluid/fluid.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

// (density, viscosity); none: a void.
using Properties = std::map<Phase, std::optional<std::pair<double, double>>>;
// A tension, alone or with the angle at which its interface meets a wall that slips.
using Tension = std::variant<double, std::pair<double, double>>;
using Tensions = std::map<std::pair<Phase, Phase>, Tension>;

FluidOptions options_from(const Properties& phases, const Tensions& tensions,
                          const py::object& gravity, const std::set<std::string>& slip,
                          bool has_inertia, double tolerance, std::uint32_t threads) {
    FluidOptions options{.tolerance = tolerance, .threads = threads};
    for (const auto& [phase, one] : phases) {
        const auto [density, viscosity] = one.value_or(std::pair(1.0, 1.0));
        options.phases.push_back({phase, density, viscosity, !one});
    }
    for (const auto& [pair, one] : tensions) {
        FluidTension& tension = options.tensions.emplace_back();
        tension.one = pair.first;
        tension.other = pair.second;
        if (const auto* both = std::get_if<1>(&one)) {
            std::tie(tension.tension, tension.contact_angle) = *both;
        } else {
            tension.tension = std::get<0>(one);
        }
    }
    options.gravity = point_from(gravity, "gravity");
    const std::map<std::string, Wall*> walls{{"left", &options.walls.left},
                                             {"right", &options.walls.right},
                                             {"bottom", &options.walls.bottom},
                                             {"top", &options.walls.top}};
    for (const std::string& side : slip) {
        if (!walls.contains(side)) {
            refuse("no side of the domain", "slip", "'" + side + "'", "left, right, bottom, top");
        }
        *walls.at(side) = Wall::slip;
    }
    options.equations = has_inertia ? FluidEquations::navier_stokes : FluidEquations::stokes;
    return options;
}

class FlowingFluid {
public:
    FlowingFluid(Running& simulation, const FluidOptions& options)
        : simulation_(simulation), fluid_(simulation.mesh()->complex(), options),
          revision_(simulation.mesh()->revision()) {}

    [[nodiscard]] const Fluid& fluid() const { return fluid_; }
    py::object step(double dt) {
        py::object report = simulation_.step_by(
            [&](Simulation<double>& simulation) { return fluid_.advance(simulation, dt).moved; },
            fluid_.time());
        revision_ = simulation_.mesh()->revision();
        return report;
    }
    [[nodiscard]] py::array velocities() const {
        const Complex<double>& complex = mesh_of_solution();
        std::vector<Point<double>> list;
        for (const Vertex v : vertices(complex)) {
            list.push_back(fluid_.field().velocity[v.id]);
        }
        return array_of(list);
    }
    [[nodiscard]] py::array pressures() const {
        (void)mesh_of_solution();
        const auto& pressure = fluid_.field().pressure;
        return py::array_t<double>({static_cast<py::ssize_t>(pressure.size()), py::ssize_t{3}},
                                   pressure.empty() ? nullptr : pressure.front().data());
    }
    [[nodiscard]] py::dict energies() const {
        const FluidEnergy one = energy(fluid_.field(), fluid_.options());
        return py::dict("kinetic"_a = one.kinetic, "potential"_a = one.potential,
                        "surface"_a = one.surface);
    }

private:
    [[nodiscard]] const Complex<double>& mesh_of_solution() const {
        const Complex<double>& complex = simulation_.mesh()->complex();
        if (simulation_.mesh()->revision() != revision_) {
            throw std::runtime_error("the mesh has changed since the fluid's last step");
        }
        return complex;
    }

    Running& simulation_;
    Fluid fluid_;
    std::uint64_t revision_; ///< of the mesh, at the last solution
};

} // namespace

void add_fluid(py::module_& module) {
    py::register_exception<SolveError>(module, "SolveError", PyExc_RuntimeError).attr("__doc__") =
        "Equations of a fluid that cannot be solved: triangles have degenerated, or it is too "
        "fast.";
    py::class_<FlowingFluid>(module, "Fluid", R"(
Incompressible flow of two and more phases, which moves the interface of a simulation.

Parameters
----------
sim : Simulation
phases : dict
    `{phase: (density, viscosity)}`, for each phase; None in their place: a void, with a free
    surface around it.
tensions : dict
    `{(one, other): tension}`, for each pair that meets, or `(tension, angle)`: in degrees, between
    the interface and a wall that slips, inside `other`.
gravity : (2,) array_like
slip : set of {'left', 'right', 'bottom', 'top'}
    The sides of the domain along which the fluid slides; it rests at the others.
inertia : bool
    Whether it has any: else the equations are those of Stokes.
tolerance : float
    Error per step, as a share of the edge length, from which the steps are chosen; 0: those asked for.
threads : int
    Any number gives the same bits.
)")
        .def(py::init([](Running& sim, const Properties& phases, const Tensions& tensions,
                         const py::object& gravity, const std::set<std::string>& slip, bool inertia,
                         double tolerance, std::uint32_t threads) {
                 return std::make_unique<FlowingFluid>(
                     sim,
                     options_from(phases, tensions, gravity, slip, inertia, tolerance, threads));
             }),
             "sim"_a, "phases"_a, "tensions"_a, py::kw_only(),
             "gravity"_a = py::make_tuple(0.0, 0.0), "slip"_a = py::set(), "inertia"_a = true,
             "tolerance"_a = 0.0, "threads"_a = 1, py::keep_alive<1, 2>())
        .def("step", &FlowingFluid::step, "dt"_a,
             "Moves on by dt, with a tolerance in as many steps as it takes; returns a `Report` of "
             "them "
             "all.")
        .def_property_readonly(
            "time", [](const FlowingFluid& one) { return one.fluid().time(); },
            "Of the last solution.")
        .def_property_readonly("velocities", &FlowingFluid::velocities,
                               "At the points of the mesh: (n, 2).")
        .def_property_readonly("pressures", &FlowingFluid::pressures,
                               "At the three corners of each triangle, with jumps between phases: "
                               "(m, 3); none before the first step.")
        .def_property_readonly("energies", &FlowingFluid::energies,
                               "`kinetic`, `potential` and `surface`: a dict.")
        .def(
            "mean_velocity",
            [](const FlowingFluid& one, Phase phase) {
                const Point<double> mean = mean_velocity(one.fluid().field(), phase);
                return std::pair(mean.x(), mean.y());
            },
            "phase"_a, "Of a phase: (x, y).");
}

} // namespace dsc::python

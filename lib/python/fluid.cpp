// SPDX-License-Identifier: MIT
#include "python/fluid.h"

#include "fluid/fluid.h"

#include <pybind11/stl.h>

#include <map>
#include <set>
#include <utility>

namespace dsc::python {

using namespace py::literals; // NOLINT: "name"_a

namespace {

using Properties = std::map<Phase, std::pair<double, double>>;
using Tensions = std::map<std::pair<Phase, Phase>, double>;

FluidOptions options_from(const Properties& phases, const Tensions& tensions,
                          const py::object& gravity, const std::set<std::string>& slip,
                          bool has_inertia) {
    FluidOptions options;
    for (const auto& [phase, one] : phases) {
        options.phases.push_back({phase, one.first, one.second});
    }
    for (const auto& [pair, tension] : tensions) {
        options.tensions.push_back({pair.first, pair.second, tension});
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
            [&](Simulation<double>& simulation) { return fluid_.step(simulation, dt).moved; },
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
    `{phase: (density, viscosity)}`, for each phase.
tensions : dict
    `{(phase, phase): tension}`, for each pair that meets.
gravity : (2,) array_like
slip : set of {'left', 'right', 'bottom', 'top'}
    The sides of the domain along which the fluid slides; it rests at the others.
inertia : bool
    Whether it has any: else the equations are those of Stokes.
)")
        .def(py::init([](Running& sim, const Properties& phases, const Tensions& tensions,
                         const py::object& gravity, const std::set<std::string>& slip,
                         bool inertia) {
                 return std::make_unique<FlowingFluid>(
                     sim, options_from(phases, tensions, gravity, slip, inertia));
             }),
             "sim"_a, "phases"_a, "tensions"_a, py::kw_only(),
             "gravity"_a = py::make_tuple(0.0, 0.0), "slip"_a = py::set(), "inertia"_a = true,
             py::keep_alive<1, 2>())
        .def("step", &FlowingFluid::step, "dt"_a, "Moves on by dt; returns a `Report`.")
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

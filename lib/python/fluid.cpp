// SPDX-License-Identifier: MIT
// A fluid for Python: a flow with its fields and figures.
#include "fluid/fluid.h"
#include "python/flows.h"
#include "python/module.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace dsc::python {

namespace {

// (phase, density, viscosity, whether it is a void)
using Phases = std::vector<std::tuple<Phase, double, double, bool>>;
// (phase, other phase, tension, contact angle)
using Tensions = std::vector<std::tuple<Phase, Phase, double, std::optional<double>>>;
// (name, kind, function of x, y and the time that returns a speed or a velocity, or None)
using Sides = std::vector<std::tuple<std::string, std::string, py::object>>;

class FlowingFluid : public AnyFlow {
public:
    FlowingFluid(std::shared_ptr<Mesh> mesh, const FluidOptions& options)
        : mesh_(std::move(mesh)), fluid_(mesh_->complex(), options), revision_(mesh_->revision()) {
        step = [this](Simulation<double>& simulation, double /*time*/, double dt) {
            const StepReport report = fluid_.advance(simulation, dt).moved;
            revision_ = mesh_->revision();
            return report;
        };
    }

    [[nodiscard]] double time() const { return fluid_.time(); }
    [[nodiscard]] py::array velocities() const {
        return array_over(vertices(mesh_of_solution()),
                          [&](Vertex v) { return fluid_.field().velocity[v.id]; });
    }
    [[nodiscard]] py::array pressures() const {
        (void)mesh_of_solution();
        return array_of(fluid_.field().pressure);
    }
    [[nodiscard]] py::dict energies() const {
        const FluidEnergy one = energy(fluid_.field(), fluid_.options());
        return py::dict("kinetic"_a = one.kinetic, "potential"_a = one.potential,
                        "surface"_a = one.surface);
    }
    [[nodiscard]] std::pair<double, double> mean_velocity(Phase phase) const {
        const Point<double> mean = dsc::mean_velocity(fluid_.field(), phase);
        return {mean.x(), mean.y()};
    }

    [[nodiscard]] std::pair<double, double> force_on(const std::string& side) const {
        (void)mesh_->complex(); // refused while a step runs
        const Point<double> force = fluid_.force_on(side);
        return {force.x(), force.y()};
    }

    [[nodiscard]] py::bytes state() {
        (void)mesh_->complex(); // refused while a step runs
        Archive archive;
        bool is_of_mesh = mesh_->revision() == revision_;
        archive(is_of_mesh);
        fluid_.archive(archive);
        return archive.bytes();
    }
    void restore(const std::string& bytes) {
        Archive archive(bytes, "fluid");
        bool is_of_mesh = false;
        archive(is_of_mesh);
        fluid_.archive(archive);
        archive.expect_end();
        revision_ = mesh_->revision() - (is_of_mesh ? 0 : 1);
    }

private:
    [[nodiscard]] const Complex<double>& mesh_of_solution() const {
        const Complex<double>& complex = mesh_->complex();
        if (mesh_->revision() != revision_) {
            throw std::runtime_error("the mesh has changed since the fluid's last step: "
                                     "read the flow before the mesh is changed");
        }
        return complex;
    }

    std::shared_ptr<Mesh> mesh_;
    Fluid fluid_;
    std::uint64_t revision_; ///< revision of the mesh at the last solution
};

FluidSide side_of(const std::string& name, const std::string& kind, const py::object& function) {
    FluidSide side{.name = name,
                   .wall = kind == "slip"   ? Wall::slip
                           : kind == "open" ? Wall::open
                                            : Wall::no_slip};
    if (function.is_none()) {
        return side;
    }
    // May be called while others run.
    const auto call = [shared = share(function)]<class Result>(const Point<double>& p, double time,
                                                               Result /*type*/) {
        const py::gil_scoped_acquire gil;
        return (*shared)(p.x(), p.y(), time).template cast<Result>();
    };
    if (kind == "inflow") {
        side.inflow = [call](const Point<double>& p, double time) {
            return call(p, time, double());
        };
    } else {
        side.velocity = [call](const Point<double>& p, double time) {
            const auto [x, y] = call(p, time, std::pair<double, double>());
            return Point<double>(x, y);
        };
    }
    return side;
}

// `edges`: from and to of each edge of the domain, of which `names` has the sides.
std::unique_ptr<FlowingFluid> fluid_of(const std::shared_ptr<Mesh>& mesh, const Phases& phases,
                                       const Tensions& tensions,
                                       const std::pair<double, double>& gravity, const Sides& sides,
                                       const Points& edges, const std::vector<std::string>& names,
                                       bool has_inertia, double tolerance, std::uint32_t threads) {
    FluidOptions options{.tolerance = tolerance, .threads = threads};
    for (const auto& [phase, density, viscosity, is_void] : phases) {
        options.phases.push_back({phase, density, viscosity, is_void});
    }
    for (const auto& [one, other, tension, angle] : tensions) {
        options.tensions.push_back(
            {one, other, tension, angle.value_or(FluidTension().contact_angle)});
    }
    for (const auto& [name, kind, function] : sides) {
        options.sides.push_back(side_of(name, kind, function));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        options.domain_edges.push_back({edges.at(2 * i), edges.at(2 * i + 1), names[i]});
    }
    options.gravity = {gravity.first, gravity.second};
    options.equations = has_inertia ? FluidEquations::navier_stokes : FluidEquations::stokes;
    return std::make_unique<FlowingFluid>(mesh, options);
}

} // namespace

void add_fluid(py::module_& module) {
    py::class_<FlowingFluid, AnyFlow>(module, "Fluid")
        .def(py::init(&fluid_of))
        .def_property_readonly("time", &FlowingFluid::time, "The time of the last solution.")
        .def_property_readonly("velocities", &FlowingFluid::velocities,
                               "The velocity at the points of the mesh: (n, 2).")
        .def_property_readonly(
            "pressures", &FlowingFluid::pressures,
            "The pressure at the three corners of each triangle, with jumps between "
            "phases: (m, 3); 0 before the first step with inertia.")
        .def_property_readonly("energies", &FlowingFluid::energies,
                               "The energies: a dict of `kinetic`, `potential` and `surface`.")
        .def("_state", &FlowingFluid::state)
        .def("_restore", &FlowingFluid::restore)
        .def(
            "force_on", &FlowingFluid::force_on, "side"_a,
            "The force of the fluid on a side, (x, y): drag and lift; 0 before the first step with "
            "inertia.")
        .def("mean_velocity", &FlowingFluid::mean_velocity, "phase"_a,
             "The mean velocity of a phase: (x, y).");
}

} // namespace dsc::python

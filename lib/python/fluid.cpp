// SPDX-License-Identifier: MIT
// A fluid for Python: a flow with its fields and figures.
#include "fluid/fluid.h"
#include "python/flows.h"
#include "python/module.h"

#include <array>
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
// Whether the fluid slips along the left, right, bottom and top side.
using Slip = std::array<bool, 5>;

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

std::unique_ptr<FlowingFluid> fluid_of(const std::shared_ptr<Mesh>& mesh, const Phases& phases,
                                       const Tensions& tensions,
                                       const std::pair<double, double>& gravity, const Slip& slip,
                                       bool has_inertia, double tolerance, std::uint32_t threads) {
    FluidOptions options{.tolerance = tolerance, .threads = threads};
    for (const auto& [phase, density, viscosity, is_void] : phases) {
        options.phases.push_back({phase, density, viscosity, is_void});
    }
    for (const auto& [one, other, tension, angle] : tensions) {
        options.tensions.push_back(
            {one, other, tension, angle.value_or(FluidTension().contact_angle)});
    }
    const auto wall = [&](std::size_t side) { return slip[side] ? Wall::slip : Wall::no_slip; };
    options.walls = {
        .left = wall(0), .right = wall(1), .bottom = wall(2), .top = wall(3), .other = wall(4)};
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
        .def("mean_velocity", &FlowingFluid::mean_velocity, "phase"_a,
             "The mean velocity of a phase: (x, y).");
}

} // namespace dsc::python

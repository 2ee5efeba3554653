// SPDX-License-Identifier: MIT
// A velocity from a solver: a field u with -div grad u = 1 inside phase 1 and u = 0 on its
// interface is solved on the triangles, and the interface moves outwards at -du/dn. A disc of
// radius r then grows at r / 2, and any shape at the rate of its own area.
#include "dsc/dsc.h"
#include "support/random/scene.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>

using namespace dsc;

// The flux of u out of phase 1 near each vertex, by vertex id: linear elements; on the interface
// the load that the equations of the other vertices leave over, which is of second order.
static Eigen::VectorXd outflow(const Complex<double>& mesh) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.vertex_bound());
    for (const Triangle t : triangles(mesh, 1)) {
        const auto v = mesh.vertices_of(t);
        const double size = area(mesh, t);
        std::array<Point<double>, 3> opposite; // the edge opposite to each vertex
        for (std::size_t i = 0; i < 3; ++i) {
            opposite[i] = mesh.position(v[(i + 2) % 3]) - mesh.position(v[(i + 1) % 3]);
            load[v[i].id] += size / 3;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                entries.emplace_back(v[i].id, v[j].id, opposite[i].dot(opposite[j]) / (4 * size));
            }
        }
    }
    Eigen::SparseMatrix<double> stiffness(load.size(), load.size());
    stiffness.setFromTriplets(entries.begin(), entries.end());

    // u = 0 wherever a vertex is not inside phase 1: these rows and columns become the identity's.
    Eigen::VectorXd inside = Eigen::VectorXd::Zero(load.size());
    for (const Vertex v : vertices(mesh)) {
        inside[v.id] = load[v.id] > 0 && !is_interface(mesh, v) ? 1 : 0;
    }
    Eigen::SparseMatrix<double> system = inside.asDiagonal() * stiffness * inside.asDiagonal();
    system += Eigen::SparseMatrix<double>((1 - inside.array()).matrix().asDiagonal());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    const Eigen::VectorXd u = solver.solve(inside.cwiseProduct(load));
    return load - stiffness * u;
}

static void move_by_field(const InterfaceView<double>& view, double, double dt,
                          std::span<Point<double>> displacements) {
    const Eigen::VectorXd flux = outflow(view.complex);
    for (std::size_t i = 0; i < view.size(); ++i) {
        const double speed = flux[view.vertices[i].id] / length(view, i);
        displacements[i] = dt * speed * normal(view, i);
    }
}

TEST(Recipe, AVelocityMayComeFromASolver) {
    auto complex = test::disc_complex<double>(0.03);
    Simulation<double> simulation(complex, {.edge_length = 0.03});
    const double before = phase_area(complex, 1);
    for (int step = 0; step < 20; ++step) {
        simulation.step(move_by_field, 0.01 * step, 0.01); // the line
    }
    EXPECT_NEAR(phase_area(complex, 1) / before, std::exp(0.2), 2e-3);
    for (const std::uint32_t v : simulation.interface()) {
        const double radius = (complex.position(Vertex{v}) - Point<double>(0.5, 0.5)).norm();
        EXPECT_NEAR(radius, 0.25 * std::exp(0.1), 5e-4);
    }
    EXPECT_TRUE(validate(complex).ok());
}

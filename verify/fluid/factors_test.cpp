// SPDX-License-Identifier: MIT
// The factorisation, checked against the equations that it factorises.
#include "fluid/scenes.h"
#include "fluid/solve/factors.h"
#include "fluid/system/share_out.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace dsc::factors_test {
namespace {

constexpr double mass = 1e-4; // weight of the pressure block: large enough that one solve is exact

// The equations of a drop at rest, and the data for their solution.
struct Equations {
    explicit Equations(double edge_length, std::uint32_t threads = 1)
        : tank(fluid_scenes::static_drop(edge_length, 25)), mesh(snapshot_of(tank.complex)),
          dissection(dissect(mesh)),
          numbers(number_unknowns(mesh, dissection, tank.fluid.options(), 0.1, nullptr)) {
        assemble(mesh, numbers, tank.fluid.options(), {&tank.fluid.field(), nullptr}, 0.1, system);
        factors = factorise(system, dissection, numbers, mass, threads);
    }

    // The matrix that was factorised, times a vector.
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& vector) const {
        Eigen::VectorXd product = Eigen::VectorXd::Zero(system.size);
        for (const FluidElement& element : system.elements) {
            for (std::size_t i = 0; i < 15; ++i) {
                for (std::size_t j = 0; j < 15; ++j) {
                    const double scale = i == j && i >= 12 ? mass * element.pressure_scale : 0;
                    if (element.unknowns[i] != no_unknown && element.unknowns[j] != no_unknown) {
                        product[element.unknowns[i]] +=
                            (element.matrix(static_cast<Eigen::Index>(i),
                                            static_cast<Eigen::Index>(j)) -
                             scale) *
                            vector[element.unknowns[j]];
                    }
                }
            }
        }
        return product;
    }

    fluid_scenes::Tank tank;
    MeshSnapshot mesh;
    Dissection dissection;
    FluidNumbering numbers;
    FluidSystem system;
    Factors factors;
};

Eigen::VectorXd some_vector(int size) {
    Eigen::VectorXd vector(size);
    for (int i = 0; i < size; ++i) {
        vector[i] = i % 7 - 3;
    }
    return vector;
}

// g++ 12 wrongly warns that Eigen's own sum reads uninitialised AVX-512 registers.
double norm(const Eigen::VectorXd& vector) {
    return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

TEST(FluidFactors, SolveWhatTheyWereMadeFrom) {
    for (const auto& [h, threads] : {std::pair(0.3, 1U), {0.1, 1U}, {0.05, 1U}, {0.05, 3U}}) {
        const Equations equations(h, threads);
        ASSERT_TRUE(equations.factors.has_all_pivots);
        const Eigen::VectorXd exact = some_vector(equations.system.size);
        Eigen::VectorXd solution = equations.times(exact);
        const double size = norm(solution);
        solve_in_place(equations.factors, solution);
        solution -= exact;
        EXPECT_LT(norm(equations.times(solution)), 1e-9 * size)
            << "edge length " << h << ", threads " << threads;
    }
}

TEST(FluidFactors, APivotOfZeroIsTold) {
    Equations equations(0.3);
    for (FluidElement& element : equations.system.elements) {
        element.matrix.setZero();
    }
    const Factors factors =
        factorise(equations.system, equations.dissection, equations.numbers, 0, 1);
    EXPECT_FALSE(factors.has_all_pivots);
}

TEST(FluidFactors, SharedWorkIsDoneOnceAndRethrows) {
    std::vector<int> times(1000, 0);
    share_out(times.size(), 3, [&](std::size_t i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(1000, 1));
    const auto refuse = [](std::size_t i) {
        if (i == 700) {
            throw std::runtime_error("the 700th");
        }
    };
    EXPECT_THROW(share_out(1000, 3, refuse), std::runtime_error);
}

} // namespace
} // namespace dsc::factors_test

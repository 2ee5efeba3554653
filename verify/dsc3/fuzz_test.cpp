// SPDX-License-Identifier: MIT
// Random shapes in random flows, with random operations between the steps: whatever happens, the
// complex is valid, and no phase changes its topology. The same seed gives the same run.
#include "dsc3/random_mesh.h"
#include "support/environment.h"

#include <numbers>

namespace dsc3::test::fuzz_test {
namespace {

using dsc::test::are_asked_for;

Point random_point(Random& random) { return {random.unit(), random.unit(), random.unit()}; }

// A shape well inside the unit cube.
Shape random_shape(Random& random) {
    const Point centre = Point::Constant(0.4) + 0.2 * random_point(random);
    const Point size = Point::Constant(0.12) + 0.12 * random_point(random);
    switch (random.below(4)) {
    case 0: return {ball(centre, size.x()), 1};
    case 1: return {ellipsoid(centre, size), 1};
    case 2: return {box({centre - size, centre + size}), 1};
    default:
        return {torus(centre, random_point(random) - Point::Constant(0.501), size.x(), 0.08), 1};
    }
}

// Three waves that vanish at the sides of the unit cube, up to `fastest` together; not free of
// divergence.
Velocity random_flow(Random& random, double fastest) {
    std::array<Point, 3> amplitudes;
    std::array<Point, 3> waves;
    for (std::uint32_t i = 0; i < 3; ++i) {
        amplitudes[i] = (2 * random_point(random) - Point::Ones()) * fastest / 3;
        waves[i] = Point(1 + random.below(3), 1 + random.below(3), 1 + random.below(3));
    }
    return [amplitudes, waves](std::span<const Point> positions, double, std::span<Point> out) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            out[i].setZero();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto phase = std::numbers::pi * waves[k].cwiseProduct(positions[i]).array();
                out[i] += phase.sin().prod() * amplitudes[k];
            }
        }
    };
}

Options random_options(Random& random, double h) {
    Options options{.edge_length = h};
    options.sub_step = 0.2 + 0.3 * random.unit();
    options.layers = int(random.below(5));
    options.interface.deviation = 0.005 + 0.04 * random.unit();
    options.integrator = random.chance(0.5) ? Integrator::rk4 : Integrator::euler;
    return options;
}

// Operations that leave the interface alone or keep its topology.
void edit(Complex& complex, Random& random, double h) {
    Workspace work;
    for (int i = 0; i < 30; ++i) {
        const std::uint32_t t = 1 + random.below(complex.tet_bound() - 1);
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        const auto v = complex.tets[t].v;
        const EdgeAt edge{t, v[random.below(2)], v[2 + random.below(2)]};
        switch (random.below(7)) {
        case 0:
            (void)edge_split(complex, work, edge, midpoint(complex.at(edge.a), complex.at(edge.b)));
            break;
        case 1:
            edge_collapse(complex, work, Vertex{edge.a}, Vertex{edge.b}, {.floor = 1e-3});
            break;
        case 2: edge_removal(complex, work, edge); break;
        case 3: face_flip(complex, work, corner_of(t, random.below(4))); break;
        case 4: interface_flip(complex, work, edge, {.min_cos = 0.5}); break;
        case 5: smooth(complex, work, Vertex{edge.a}); break;
        default:
            smooth_along_interface(complex, work, Vertex{edge.a},
                                   {.enough = 1, .farthest = 0.3 * h, .deviation = 0.05 * h});
        }
    }
}

TEST(Fuzz3, ComplexesStayValid) {
    const std::uint64_t seeds = are_asked_for("long") ? 400 : are_asked_for("few") ? 2 : 8;
    const int steps = are_asked_for("long") ? 20 : 5;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Random random(seed);
        const double h = 0.06 + 0.04 * random.unit();
        Complex complex = initial_complex({}, {random_shape(random)}, {.edge_length = h});
        const std::int64_t euler = validate(complex).surfaces.back().euler_characteristic;
        Simulation simulation(complex, random_options(random, h));
        const Velocity flow = random_flow(random, 1);
        for (int step = 0; step < steps; ++step) {
            // A step may fail to bring all vertices to their targets, but not break the complex.
            const StepReport report = simulation.step(flow, 0, random.unit() * 1.5 * h);
            ASSERT_EQ(report.gave_up, GiveUp::none) << "seed " << seed << ", step " << step;
            ValidationReport valid = validate(complex);
            ASSERT_TRUE(valid.ok()) << "seed " << seed << ", step " << step << valid.problem;
            edit(complex, random, h);
            valid = validate(complex);
            ASSERT_TRUE(valid.ok()) << "seed " << seed << ", edits " << step << valid.problem;
            ASSERT_EQ(valid.surfaces.back().euler_characteristic, euler) << "seed " << seed;
        }
    }
}

} // namespace
} // namespace dsc3::test::fuzz_test

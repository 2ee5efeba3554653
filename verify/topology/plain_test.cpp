// SPDX-License-Identifier: MIT
// `vertex_plain` says that a star need not be looked at: it must be true of each vertex that has
// it, whatever has happened to the mesh, and most vertices must have it.
#include "support/topology/growing_discs.h"
#include "support/ways.h"

#include "dsc/complex/gather.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/interface/suspects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace dsc::plain_test {
namespace {

using namespace test::growing_discs;

// By the phases of its triangles, not by its mark.
bool is_of_interface(const Complex<double>& complex, std::uint32_t v) {
    Ring<double> ring;
    return gather(complex, Region{}, v, ring) && interface_spokes(ring).count > 0;
}

// Expects what the flags say to be so. Returns the number of plain vertices among those of the
// interface.
std::size_t expect_as_flagged(const Complex<double>& complex, const std::string& when) {
    std::size_t plain = 0;
    Ring<double> ring;
    for (const Vertex v : vertices(complex)) {
        const std::uint32_t flags = complex.vertices[v.id].flags;
        if (!is_of_interface(complex, v.id)) {
            continue;
        }
        EXPECT_NE(flags & vertex_on_interface, 0U) << when << ", vertex " << v.id;
        if ((flags & vertex_plain) == 0) {
            continue;
        }
        ++plain;
        (void)gather(complex, Region{}, v.id, ring);
        const Spokes spokes = interface_spokes(ring);
        if (!is_simple(ring, spokes)) {
            continue; // it is looked at for that
        }
        for (std::uint32_t i = 0; i < ring.size; ++i) {
            EXPECT_TRUE(i == spokes.first || i == spokes.second ||
                        !is_of_interface(complex, ring.link[i]))
                << when << ", vertex " << v.id << ", neighbour " << ring.link[i];
        }
    }
    return plain;
}

// Towards each other, through the merger, and on.
void expect_in_run(Complex<double>& complex, Simulation<double>& simulation,
                   const std::string& name) {
    std::size_t events = 0;
    for (int step = 0; step < 14; ++step) {
        const StepReport report = simulation.step(grow(), 0, 0.3 * h);
        events += report.events.size();
        const std::size_t plain =
            expect_as_flagged(complex, name + ", step " + std::to_string(step));
        if (step == 3) { // the first sub-step marks them, the second one finds out
            EXPECT_GT(3 * plain, simulation.interface_size()) << name;
        }
    }
    EXPECT_GT(events, 0U) << name;
}

TEST(Plain, AreThoseWithNoOtherInterfaceInTheirLink) {
    auto complex = discs_nearby();
    Simulation<double> simulation(complex, options());
    expect_in_run(complex, simulation, "sequential");
}

TEST(Plain, AreTheSameInSubmeshes) {
    for (const Division division : test::all_divisions()) {
        auto complex = discs_nearby(2);
        Simulation<double> simulation(complex, options(),
                                      make_executor(complex, options(),
                                                    Parallel{.threads = 2,
                                                             .division = division,
                                                             .submeshes = 6,
                                                             .always_all_threads = true}));
        expect_in_run(complex, simulation, std::string(division->name));
    }
}

// Two discs with a film of one triangle between them, before the topology may change.
Complex<double> thin_film() {
    auto complex = discs_nearby();
    Simulation<double> simulation(complex, options(Topology::keep));
    (void)run(complex, simulation, 0.0235);
    return complex;
}

Velocity<double> aside() {
    return [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {0.3, 0.1};
        }
    };
}

TEST(Plain, AreNotThoseOfAFilmThatIsThereAtFirst) {
    auto complex = thin_film();
    Simulation<double> simulation(complex, options());
    for (int step = 0; step < 3; ++step) {
        (void)simulation.step(aside(), 0, 0.1 * h);
        EXPECT_EQ(expect_as_flagged(complex, "step " + std::to_string(step)) > 0, step > 0);
    }
}

// While the topology is kept, nobody keeps the flag; from then on it counts again.
TEST(Plain, AreForgottenWhereTheTopologyIsKept) {
    auto complex = discs_nearby();
    Simulation<double> simulation(complex, options());
    (void)simulation.step(grow(), 0, 0.1 * h);
    (void)simulation.step(grow(), 0, 0.1 * h);
    EXPECT_GT(expect_as_flagged(complex, "before"), 0U);
    simulation.set_options(options(Topology::keep));
    for (double time = 0; time < 0.0235; time += 0.3 * h) {
        (void)simulation.step(grow(), time, 0.3 * h);
    }
    simulation.set_options(options());
    for (int step = 0; step < 3; ++step) {
        (void)simulation.step(aside(), 0, 0.1 * h);
        (void)expect_as_flagged(complex, "step " + std::to_string(step));
    }
}

// An edge away from the first disc: no vertex is of the interface.
bool is_beside_disc(const Complex<double>& complex, Triangle t) {
    const Point<double> p = complex.position(complex.vertices_of(t)[0]);
    return complex.phase(t) == exterior_phase && (p - Point<double>(0.375, 0.6)).norm() < 3 * h &&
           std::ranges::none_of(complex.vertices_of(t),
                                [&](Vertex v) { return is_of_interface(complex, v.id); });
}

// The same by a pass of the application, in the middle of a step.
TEST(Plain, AreNotThoseBesideAPieceThatAPassHasLabelled) {
    for (const bool in_submeshes : {false, true}) {
        auto complex = discs_nearby();
        auto with_pieces = options();
        with_pieces.topology.least_area = 1e-12;
        bool labels = false;
        auto algorithm = default_algorithm<double>();
        algorithm.motion.push_back(
            {"label", [&labels](Work<double>& work) {
                 for (const Triangle t : triangles(work.complex)) {
                     if (labels && owns_triangle(work.complex, work.submesh.region, t.id) &&
                         is_beside_disc(work.complex, t)) {
                         rewire::relabel(work.complex, work.log, t, 2);
                     }
                 }
             }});
        std::unique_ptr<Executor<double>> executor =
            std::make_unique<SequentialExecutor<double>>(complex, with_pieces, algorithm);
        if (in_submeshes) {
            executor = make_executor(
                complex, with_pieces,
                Parallel{.division = Division::fixed, .submeshes = 3, .always_all_threads = true},
                algorithm);
        }
        Simulation<double> simulation(complex, with_pieces, std::move(executor));
        std::size_t before = 0;
        for (int step = 0; step < 5; ++step) {
            labels = step == 2;
            (void)simulation.step(aside(), 0, 0.01 * h);
            const std::size_t plain = expect_as_flagged(complex, "step " + std::to_string(step));
            EXPECT_TRUE(step < 2 || plain < before) << in_submeshes;
            before = step < 2 ? plain : before;
        }
        EXPECT_TRUE(std::ranges::any_of(triangles(complex), [&](Triangle t) {
            return complex.phase(t) == 2;
        })) << in_submeshes;
    }
}

// A piece that the application labels beside a disc, an edge away from it.
TEST(Plain, AreNotThoseBesideANewPiece) {
    auto complex = discs_nearby();
    auto with_pieces = options();
    with_pieces.topology.least_area = 1e-12; // they stay
    Simulation<double> simulation(complex, with_pieces);
    (void)simulation.step(aside(), 0, 0.1 * h);
    (void)simulation.step(aside(), 0, 0.1 * h);
    const std::size_t before = expect_as_flagged(complex, "before");
    for (const Triangle t : triangles(complex)) {
        if (is_beside_disc(complex, t)) {
            complex.set_phase(t, 2);
        }
    }
    for (int step = 0; step < 2; ++step) {
        (void)simulation.step(aside(), 0, 0.01 * h);
        EXPECT_LT(expect_as_flagged(complex, "step " + std::to_string(step)), before);
    }
}

// Flips of the application, between two steps, that join the two discs by edges.
TEST(Plain, AreNotThoseThatAnEdgeHasJoined) {
    auto complex = thin_film();
    Simulation<double> simulation(complex, options());
    (void)simulation.step(aside(), 0, 0.01 * h);
    (void)simulation.step(aside(), 0, 0.01 * h);
    std::size_t flips = 0;
    for (const Triangle t : triangles(complex, exterior_phase)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            const bool joins = is_of_interface(complex, complex.vertex(c)) &&
                               !is_border(complex.twin(c)) &&
                               is_of_interface(complex, complex.vertex(complex.twin(c)));
            flips += joins && edge_flip(complex, complex.edge(c)) == Verdict::legal ? 1U : 0U;
        }
    }
    EXPECT_GT(flips, 0U);
    (void)expect_as_flagged(complex, "after the flips");
}

} // namespace
} // namespace dsc::plain_test

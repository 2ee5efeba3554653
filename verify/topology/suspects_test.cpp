// SPDX-License-Identifier: MIT
// Which vertices a step notes for the change of topology: all at which there is a thin triangle,
// whoever owns them, also those that have just come into another submesh.
#include "support/topology/growing_discs.h"

#include "dsc/complex/gather.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "topology/notes.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

namespace dsc::suspects_test {
namespace {

using namespace test::growing_discs;

// By a look at each of them.
std::set<std::uint32_t> at_thin_triangles(const Complex<double>& complex, double contact) {
    std::set<std::uint32_t> found;
    Ring<double> ring;
    for (const Vertex v : vertices(complex)) {
        if (gather(complex, Region{}, v.id, ring) && !ring.one_phase &&
            has_thin_triangle(ring, contact * contact)) {
            found.insert(v.id);
        }
    }
    return found;
}

// Two discs with a film between them that is thin and stays so, carried across all cuts. Stars are
// noted where the upkeep shows them, or all of them afterwards.
void expect_all_noted(Complex<double>& complex, Executor<double>& executor, bool are_shown) {
    constexpr Notability<double> notable{.contact = default_contact * h, .curvature = 1e9};
    std::uint32_t round = 1;
    Pass<double> pass{"notes", [&](Work<double>& work) { note_stars(work, notable, round); }, true};
    const Notebook<double> book{&notes_of(complex), &places_of(complex)};
    if (are_shown) {
        pass.watch = [&](Work<double>& work, const Ring<double>& ring, const Spokes& spokes) {
            note_star(work, ring, spokes, notable, round, book);
        };
    }
    executor.add_upkeep(pass);
    const Velocity<double> carry = [](auto positions, double, auto velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {1, 0.3};
        }
    };
    std::size_t count = 0;
    for (int step = 0; step < 40; ++step) {
        executor.begin_step();
        ++round;
        (void)executor.aim(carry, 0, 0.25 * h); // upkeep first: the mesh is as it was noted
        for (const std::uint32_t v : at_thin_triangles(complex, default_contact * h)) {
            const Note note = notes_of(complex)[Vertex{v}];
            EXPECT_TRUE(note.round == round && (note.what & noted_thin) != 0)
                << "step " << step << ", vertex " << v;
            ++count;
        }
        (void)executor.move();
        executor.end_step();
    }
    EXPECT_GT(count, 100U);
}

Complex<double> thin_film() {
    auto complex = discs_nearby();
    test::ChangingSimulation<double> simulation(complex, options(Topology::keep));
    (void)run(complex, simulation, 0.0235);
    return complex;
}

TEST(Suspects, AreAllThatAreThinSequentially) {
    for (const bool are_shown : {false, true}) {
        auto complex = thin_film();
        auto thin = options();
        thin.interface.coarsening = Coarsening::never;
        Executor<double> executor(complex, thin, default_algorithm<double>());
        expect_all_noted(complex, executor, are_shown);
    }
}

TEST(Suspects, AreAllThatAreThinInSubmeshes) {
    for (const Division division : {Division::fixed, Division::cells}) {
        auto complex = thin_film();
        auto thin = options();
        thin.interface.coarsening = Coarsening::never;
        const auto executor = make_executor(
            complex, thin,
            Parallel{.division = division, .submeshes = 6, .always_all_threads = true});
        expect_all_noted(complex, *executor, division == Division::cells);
    }
}

// Every set of noted vertices, on links of all sizes up to nine, against a look at each pair of
// neighbours. A vertex that was noted in the last round counts, one of the round before does not.
TEST(Suspects, MayFaceASheetWhereTwoNeighboursOfTheLinkAreOfTheInterface) {
    constexpr std::uint32_t round = 5;
    for (const bool closed : {true, false}) {
        for (std::uint32_t n = 3; n <= 9; ++n) {
            Complex<double> complex;
            auto& notes = notes_of(complex);
            notes.resize(n);
            Ring<double> ring;
            ring.closed = closed;
            ring.size = closed ? n : n - 1;
            for (std::uint32_t i = 0; i < n; ++i) {
                ring.link[i] = i;
            }
            for (std::uint32_t marks = 0; marks < 1U << n; ++marks) {
                const auto is_marked = [&](std::uint32_t i) { return (marks >> i & 1U) != 0; };
                bool expected = closed && is_marked(n - 1) && is_marked(0);
                for (std::uint32_t i = 0; i < n; ++i) {
                    notes[Vertex{i}].round = is_marked(i) ? round - i % 2 : round - 2;
                    expected |= i > 0 && is_marked(i - 1) && is_marked(i);
                }
                EXPECT_EQ(may_face_a_sheet(notes, round, ring), expected)
                    << (closed ? "closed" : "open") << " link of " << n << ", marks " << marks;
            }
        }
    }
}

// The cosine of 45.57 degrees is 0.7.
TEST(Suspects, AreSharpWhereTheInterfaceTurnsByMoreThanAnEighth) {
    Ring<double> ring;
    ring.closed = true;
    ring.size = 6;
    const Spokes spokes{2, 1, 4};
    ring.x[1] = -2;
    ring.y[1] = 0;
    for (const auto& [degrees, is_sharp] : {std::pair{0.0, false},
                                            {45.5, false},
                                            {45.7, true},
                                            {90.0, true},
                                            {134.5, true},
                                            {180.0, true},
                                            {-45.5, false},
                                            {-45.7, true},
                                            {-135.0, true}}) {
        ring.x[4] = 0.1 * std::cos(degrees * std::numbers::pi / 180);
        ring.y[4] = 0.1 * std::sin(degrees * std::numbers::pi / 180);
        EXPECT_EQ(turns_sharply(Bend(ring, spokes)), is_sharp) << degrees;
    }
    ring.x[4] = ring.y[4] = 0;
    EXPECT_TRUE(turns_sharply(Bend(ring, spokes))) << "an edge of no length";
}

// Three points of a circle, in float so small that the product of three squares would be none.
TEST(Suspects, AreTightOnCirclesOfTheCurvatureOrMore) {
    Ring<float> ring;
    ring.closed = true;
    ring.size = 6;
    const Spokes spokes{2, 1, 4};
    const float radius = 1e-9F;
    for (const float from : {-0.1F, -0.5F}) {
        for (const float to : {0.1F, 0.4F}) {
            ring.x[1] = radius * (1 - std::cos(from));
            ring.y[1] = radius * std::sin(from);
            ring.x[4] = radius * (1 - std::cos(to));
            ring.y[4] = radius * std::sin(to);
            EXPECT_TRUE(turns_tightly(Bend(ring, spokes), 0.98F / radius)) << from << ", " << to;
            EXPECT_FALSE(turns_tightly(Bend(ring, spokes), 1.02F / radius)) << from << ", " << to;
        }
    }
    EXPECT_FLOAT_EQ(curvature_around(std::numbers::pi_v<float>), 0.5F);
}

} // namespace
} // namespace dsc::suspects_test

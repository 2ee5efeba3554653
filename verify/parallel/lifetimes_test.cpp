// SPDX-License-Identifier: MIT
// A complex is a value: it may be copied, moved from, assigned to, renumbered and replayed at any
// time, while a simulation of it exists and afterwards. In each case it is valid, and further steps
// are too.
#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/stage.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "replay/edits.h"
#include "replay/mesh_hash.h"
#include "thesis/sets/insertion_removal.h"

#include "support/courses.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace dsc::lifetimes_test {
namespace {

using test::Course;

Options<double> disc_options() { return {.edge_length = test::disc_h}; }

// A simulation in five submeshes, each of which holds a pool of ids.
std::unique_ptr<Simulation<double>> simulate(Complex<double>& complex, const Course& way) {
    if (way.division == nullptr) {
        return std::make_unique<Simulation<double>>(complex, disc_options());
    }
    const Parallel parallel{.division = way.division, .submeshes = 5, .always_all_threads = true};
    return std::make_unique<Simulation<double>>(complex, disc_options(), parallel);
}

void step(Simulation<double>& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        (void)simulation.step(test::swirl, 0.02 * i, 0.02);
    }
}

// Checks that the complex is valid and that its free ids can be used, by edits of the application
// and by a run in submeshes.
void expect_sound(Complex<double>& complex) {
    ASSERT_EQ(validate(complex).problem, "");
    const std::uint32_t triangles = complex.triangle_count();
    std::uint32_t splits = 0;
    std::vector<Edge> some;
    for (const Edge e : edges(complex)) {
        if (e.id % 7 == 0) {
            some.push_back(e);
        }
    }
    for (const Edge e : some) {
        const bool is_inner = complex.is_alive(e) && !is_border(complex.twin(e.id));
        if (is_inner) {
            const auto [a, b] = complex.vertices_of(e);
            const Point<double> middle = (complex.position(a) + complex.position(b)) / 2;
            splits += edge_split(complex, e, middle).verdict == Verdict::legal ? 1U : 0U;
        }
    }
    EXPECT_EQ(complex.triangle_count(), triangles + 2 * splits);
    ASSERT_EQ(validate(complex).problem, "");
    {
        Simulation<double> simulation(complex, disc_options(),
                                      Parallel{.submeshes = 5, .always_all_threads = true});
        step(simulation, 2);
    }
    EXPECT_EQ(validate(complex).problem, "");
}

struct Happening {
    const char* name;
    std::function<void(Complex<double>&)> happens;
};

void take_place_of(Complex<double>& complex) {
    complex = test::disc_complex<double>(1.3 * test::disc_h, {0.4, 0.5}, 0.15);
}

const std::vector<Happening> happenings{
    {"renumbered", [](auto& complex) { (void)renumber(complex); }},
    {"assigned", [](auto& complex) { take_place_of(complex); }},
    {"assigned_a_copy_of_itself",
     [](auto& complex) {
         const Complex<double> copy = complex;
         complex = copy;
     }},
    {"moved_from_and_back",
     [](auto& complex) {
         Complex<double> other = std::move(complex);
         complex = std::move(other);
     }},
    {"moved_from", [](auto& complex) { const Complex<double> other = std::move(complex); }},
    {"repeated",
     [](auto& complex) {
         const std::array edits{Edit{.kind = EditKind::renumber}};
         (void)replay<double>(complex, edits);
     }},
    {"given_to_another_executor",
     [](auto& complex) {
         auto copy = complex;
         (void)make_executor(copy, disc_options(), Parallel{.submeshes = 3});
         complex = copy;
     }},
};

class Lifetimes : public testing::TestWithParam<Course> {};

TEST_P(Lifetimes, WhateverHappensBetweenTheLastStepAndTheEndOfASimulation) {
    for (const Happening& one : happenings) {
        SCOPED_TRACE(one.name);
        auto complex = test::disc();
        auto simulation = simulate(complex, GetParam());
        step(*simulation, 3);
        one.happens(complex);
        simulation.reset();
        expect_sound(complex);
    }
}

TEST_P(Lifetimes, WhateverHappensBetweenTwoSteps) {
    for (const Happening& one : happenings) {
        SCOPED_TRACE(one.name);
        auto complex = test::disc();
        const auto simulation = simulate(complex, GetParam());
        step(*simulation, 3);
        one.happens(complex);
        step(*simulation, 3);
        EXPECT_EQ(validate(complex).problem, "");
    }
}

TEST_P(Lifetimes, ACopyOfALivingSimulationsComplexIsWhole) {
    auto complex = test::disc();
    const auto simulation = simulate(complex, GetParam());
    step(*simulation, 3);
    auto copy = complex;
    EXPECT_EQ(copy.vertex_count(), complex.vertex_count());
    EXPECT_EQ(copy.triangle_count(), complex.triangle_count());
    EXPECT_EQ(mesh_hash(copy), mesh_hash(complex));
    auto renumbered = complex;
    (void)renumber(renumbered);
    expect_sound(renumbered);
    expect_sound(copy);
    step(*simulation, 3); // the copies do not affect it
    EXPECT_EQ(validate(complex).problem, "");
}

// A stage may renumber the complex too.
TEST_P(Lifetimes, AStageRenumbersInTheMiddleOfAStep) {
    struct Renumbering : Stage<double> {
        void run(const Between<double>& between) override { (void)renumber(between.complex); }
    };
    auto complex = test::disc();
    auto simulation = simulate(complex, GetParam());
    simulation->add_stage(std::make_shared<Renumbering>());
    step(*simulation, 3);
    simulation.reset();
    expect_sound(complex);
}

INSTANTIATE_TEST_SUITE_P(All, Lifetimes, testing::ValuesIn(test::all_courses), test::course_name);

TEST(Executors, TheLastOneThatWasMadeHasTheIds) {
    auto complex = test::disc();
    const Parallel parallel{.submeshes = 4, .always_all_threads = true};
    auto first = make_executor(complex, disc_options(), parallel);
    auto second = make_executor(complex, disc_options(), parallel);
    EXPECT_EQ(validate(complex).problem, "");
    {
        Simulation<double> simulation(complex, disc_options(), std::move(first));
        step(simulation, 2); // takes them back
        EXPECT_EQ(validate(complex).problem, "");
        second.reset();
        step(simulation, 2);
    }
    expect_sound(complex);
}

TEST(Executors, OneThatWasMadeBeforeAnEditRunsAsOneThatWasMadeAfterIt) {
    const auto run = [](bool is_made_before) {
        auto complex = test::disc();
        const Parallel parallel{.submeshes = 4, .always_all_threads = true};
        std::unique_ptr<Executor<double>> executor;
        if (is_made_before) {
            executor = make_executor(complex, disc_options(), parallel);
        }
        take_place_of(complex);
        if (!is_made_before) {
            executor = make_executor(complex, disc_options(), parallel);
        }
        Simulation<double> simulation(complex, disc_options(), std::move(executor));
        step(simulation, 3);
        EXPECT_EQ(validate(complex).problem, "");
        return phase_area(complex, 1);
    };
    EXPECT_NEAR(run(true), run(false), 1e-4);
}

TEST(Executors, OneOfAnotherComplexIsRefused) {
    auto complex = test::disc();
    auto other = test::disc();
    const std::uint64_t before = mesh_hash(other);
    test::expect_refusal(
        [&] {
            Simulation<double> simulation(complex, disc_options(),
                                          make_executor(other, disc_options(), Parallel{}));
        },
        "Simulation", "the executor belongs to another complex");
    EXPECT_EQ(mesh_hash(other), before);
    Simulation<double> simulation(other, disc_options());
    EXPECT_EQ(&simulation.complex(), &other);
    EXPECT_EQ(&std::as_const(simulation).complex(), &other);
}

TEST(Complexes, OneThatWasMovedFromIsEmptyAndCanBeUsed) {
    auto complex = test::disc();
    complex.attributes.add<Triangle, double>("heat", 1.0);
    const Complex<double> other = std::move(complex);
    EXPECT_TRUE(other.attributes.contains("heat"));
    // NOLINTBEGIN(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(complex.vertex_count(), 0U);
    EXPECT_EQ(complex.triangle_count(), 0U);
    EXPECT_FALSE(complex.attributes.contains("heat"));
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(renumber(complex).triangles.size(), 1U);
    complex.attributes.add<Triangle, double>("heat", 2.0);
    const Vertex a = insert_vertex(complex, Point<double>(0, 0));
    const Vertex b = insert_vertex(complex, Point<double>(1, 0));
    const Vertex c = insert_vertex(complex, Point<double>(0, 1));
    insert_triangle(complex, a, b, c, 1);
    EXPECT_EQ(validate(complex).problem, "");
    // NOLINTEND(bugprone-use-after-move)
}

} // namespace
} // namespace dsc::lifetimes_test

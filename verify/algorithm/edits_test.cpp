// SPDX-License-Identifier: MIT
// Edits in and out of a simulation: listeners, replay, and what the application does between steps
// and in passes of its own.
#include "support/courses.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/numbering.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "replay/replay.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

namespace dsc::edits_test {
namespace {

using namespace test;

class Edits : public testing::TestWithParam<Course> {};
class EditsInPlace : public testing::TestWithParam<Course> {};

// --- out -------------------------------------------------------------------------------------

struct Heard {
    std::vector<Edit> edits;
    OperationCounts counts;
};

Heard hear(const Course& way, int steps) {
    Complex<double> complex = disc();
    Heard heard;
    auto simulation = make_simulation(complex, {.edge_length = disc_h}, way);
    simulation->add_listener([&](std::span<const Edit> edits) {
        heard.edits.insert(heard.edits.end(), edits.begin(), edits.end());
    });
    for (int step = 0; step < steps; ++step) {
        heard.counts += simulation->step(swirl, 0.04 * step, 0.04).operations;
    }
    return heard;
}

TEST_P(EditsInPlace, AreAsManyAsTheCountsSay) {
    const Heard heard = hear(GetParam(), 25);
    std::map<EditKind, std::uint64_t> kinds;
    std::map<MoveReason, std::uint64_t> reasons;
    std::uint64_t on_interface = 0;
    for (const Edit& edit : heard.edits) {
        ++kinds[edit.kind];
        if (edit.kind == EditKind::move) {
            ++reasons[edit.reason];
        }
        on_interface += edit.kind == EditKind::split && edit.on_interface ? 1U : 0U;
    }
    EXPECT_GT(on_interface, 20U);
    EXPECT_EQ(on_interface, heard.counts.interface_splits);
    EXPECT_EQ(kinds[EditKind::split], heard.counts.interface_splits + heard.counts.splits);
    EXPECT_EQ(kinds[EditKind::collapse], heard.counts.interface_collapses + heard.counts.collapses);
    EXPECT_EQ(kinds[EditKind::flip], heard.counts.flips);
    EXPECT_EQ(reasons[MoveReason::flow], heard.counts.moves);
    EXPECT_EQ(reasons[MoveReason::smoothing], heard.counts.smoothed);
}

TEST(EditLogs, OfCreateAndMergeSayThatAllIdsAreNew) {
    const Heard heard = hear({"copy", &copy_division}, 2);
    const auto rebuilds = std::ranges::count(heard.edits, EditKind::rebuild, &Edit::kind);
    EXPECT_GE(rebuilds, 4); // red and black in each step
    Complex<double> complex = disc();
    EXPECT_THROW(replay<double>(complex, heard.edits), InputError);
}

void expect_skipped(const Complex<double>& first, const Edit& edit) {
    Complex<double> again = first;
    EXPECT_EQ(replay<double>(again, std::span(&edit, 1)).skipped, 1U);
    EXPECT_EQ(mesh_hash(again), mesh_hash(first));
    EXPECT_EQ(validate(again).problem, "");
}

// As in a file that is damaged: memory is not filled up to such an id, the border stays the border,
// no triangle is made twice, and no vertex vanishes that is no end of the edge.
TEST(EditLogs, WithRecordsThatNoRunHasAreSkipped) {
    constexpr std::uint32_t absurd = 4'000'000'000;
    const Complex<double> first = disc();
    const auto record_of = [&](const auto& operate) {
        Complex<double> complex = first;
        complex.journal.readers = 1;
        for (std::uint32_t t = 1; complex.journal.records.empty(); ++t) {
            if (!is_boundary(complex, Triangle{t})) {
                (void)operate(complex, complex.edges_of(Triangle{t})[0]);
            }
        }
        return complex.journal.records.front();
    };
    const Edit split = record_of([](auto& complex, Edge e) { return edge_split(complex, e); });
    Edit edit = split;
    edit.vertex = Vertex{absurd};
    expect_skipped(first, edit);
    for (const auto& made :
         {std::array{absurd, split.made[1]}, std::array{split.made[0], absurd},
          std::array{0U, split.made[1]}, std::array{split.made[0], split.made[0]}}) {
        edit = split;
        edit.made = made;
        expect_skipped(first, edit);
    }
    expect_skipped(first, {.kind = EditKind::insert_vertex, .vertex = Vertex{absurd}});
    edit = record_of([](auto& complex, Edge e) { return edge_collapse(complex, e); });
    edit.vertex = edit.apexes[0];
    expect_skipped(first, edit);
}

// The core does not have the operations of these.
TEST(EditLogs, OfModulesNeedAFunctionThatRepeatsThem) {
    const Complex<double> first = disc();
    for (const EditKind kind :
         {EditKind::retriangulate, EditKind::insert_triangle, EditKind::remove_triangle}) {
        const std::array edits{Edit{.kind = EditKind::remove_vertex, .vertex = Vertex{1}},
                               Edit{.kind = kind, .corner = corner_of(7, 0)}};
        Complex<double> again = first;
        EXPECT_THROW(replay<double>(again, edits), InputError);
        EXPECT_EQ(mesh_hash(again), mesh_hash(first));
    }
}

// --- in --------------------------------------------------------------------------------------

TEST_P(Edits, OfTheApplicationBetweenStepsAreTakenUp) {
    Complex<double> complex = disc();
    auto simulation = make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->step(swirl, 0, 0.02);
    expect_sound(complex, *simulation);

    // An interface edge is split, another one collapsed.
    const std::vector<std::uint32_t> list = simulation->interface();
    const auto interface_edge = [&](std::uint32_t v) {
        for (const std::uint32_t w : list) {
            const Edge e = complex.find_edge(Vertex{v}, Vertex{w});
            if (e.is_valid() && is_interface(complex, e)) {
                return e;
            }
        }
        return Edge{};
    };
    EXPECT_EQ(edge_split(complex, interface_edge(list[0])).verdict, Verdict::legal);
    EXPECT_EQ(edge_collapse(complex, interface_edge(list[list.size() / 2])), Verdict::legal);
    // A triangle beside the interface changes its phase, and becomes a bump of the disc.
    const Edge base = interface_edge(list[list.size() / 4]);
    const Triangle beside{triangle_of(base.id)};
    const Triangle other{triangle_of(complex.twin(base.id))};
    const Triangle outer = complex.phase(beside) == exterior_phase ? beside : other;
    complex.set_phase(outer, 1);
    simulation->step(still, 0.02, 0.001);
    expect_sound(complex, *simulation);

    // A disc of its own, far from the first.
    Triangle seed;
    for (std::uint32_t t = 1; t < complex.triangle_bound() && !seed.is_valid(); ++t) {
        if (complex.is_alive(Triangle{t}) &&
            (complex.position(complex.vertices_of(Triangle{t})[0]) - Point<double>(0.8, 0.2))
                    .norm() < disc_h) {
            seed = Triangle{t};
        }
    }
    ASSERT_TRUE(seed.is_valid());
    complex.set_phase(seed, 2);
    const std::size_t before = simulation->interface_size();
    simulation->step(swirl, 0.03, 0.02);
    expect_sound(complex, *simulation);
    EXPECT_GE(simulation->interface_size(), before + 3);

    renumber(complex);
    const double area = phase_area(complex, 2);
    for (int step = 0; step < 3; ++step) {
        const StepReport report = simulation->step(swirl, 0.05 + 0.02 * step, 0.02);
        EXPECT_EQ(report.unreached, 0U);
        expect_sound(complex, *simulation);
    }
    EXPECT_NEAR(phase_area(complex, 2), area, 0.3 * area);
}

// Stars that the application spoilt are mended by the next step.
TEST_P(Edits, OfTheApplicationAreLookedAtByTheMeshUpdate) {
    Complex<double> complex = disc();
    auto simulation = make_simulation(complex, {.edge_length = disc_h}, GetParam());
    simulation->step(swirl, 0, 0.01);
    Vertex victim;
    for (std::uint32_t v = 0; v < complex.vertex_bound() && !victim.is_valid(); ++v) {
        if (complex.is_alive(Vertex{v}) &&
            (complex.position(Vertex{v}) - Point<double>(0.75, 0.25)).norm() < disc_h) {
            victim = Vertex{v};
        }
    }
    ASSERT_TRUE(victim.is_valid());
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, victim.id, star));
    // Moves the victim almost onto one of its neighbours.
    const Point<double> near(star.x[0], star.y[0]);
    complex.set_position(victim, near + 0.06 * (complex.position(victim) - near));
    ASSERT_EQ(validate(complex).problem, "");
    const auto worst = [&] {
        double smallest = 1;
        for (const Triangle t : triangles(complex)) {
            smallest = std::min(smallest, quality(complex, t));
        }
        return smallest;
    };
    const double spoilt = worst();
    ASSERT_LT(spoilt, 0.2);
    // Also if a step in between gives up or throws: it has learned of the edit, and moves nothing.
    const Velocity<double> absurd = [](auto, double, auto velocities) {
        std::ranges::fill(velocities, Point<double>(1e9, 0));
    };
    EXPECT_EQ(simulation->step(absurd, 0.01, 1).gave_up, GiveUp::too_many_sub_steps);
    EXPECT_EQ(worst(), spoilt);
    expect_sound(complex, *simulation);
    const Velocity<double> broken = [](auto, double, auto) { throw std::domain_error("broken"); };
    EXPECT_THROW((void)simulation->step(broken, 0.01, 1), std::domain_error);
    expect_sound(complex, *simulation);
    simulation->step(swirl, 0.01, 0.001);
    EXPECT_GT(worst(), 2 * spoilt);
    expect_sound(complex, *simulation);
}

TEST_P(Edits, OfAPassOfTheApplicationNeedNoBookkeeping) {
    Complex<double> complex = disc();
    const Options<double> options{.edge_length = disc_h};
    Algorithm<double> algorithm = default_algorithm<double>();
    // Triangles of the exterior that lie deep in a box become phase 2: a new interface.
    algorithm.motion.insert(
        algorithm.motion.begin(),
        {"freeze", [](Work<double>& work) {
             Complex<double>& mesh = work.complex;
             std::vector<Triangle> doomed;
             for (std::uint32_t t = 1; t < mesh.triangle_bound(); ++t) {
                 if (!mesh.is_alive(Triangle{t}) || mesh.phase(Triangle{t}) != exterior_phase ||
                     !owns_triangle(mesh, work.submesh.region, t)) {
                     continue;
                 }
                 const auto v = mesh.vertices_of(Triangle{t});
                 if (std::ranges::all_of(v, [&](Vertex one) {
                         const Point<double> p = mesh.position(one);
                         return p.x() > 0.55 && p.x() < 0.9 && p.y() > 0.1 && p.y() < 0.4;
                     })) {
                     doomed.push_back(Triangle{t});
                 }
             }
             for (const Triangle t : doomed) {
                 rewire::relabel(mesh, *work.submesh.log, t, 2);
             }
         }});
    const Course way = GetParam();
    std::unique_ptr<Executor<double>> executor;
    if (way.division != nullptr) {
        executor = make_executor(complex, options, Parallel{.division = way.division}, algorithm);
    } else {
        executor = std::make_unique<Executor<double>>(complex, options, algorithm);
    }
    Simulation<double> simulation(complex, options, std::move(executor));
    for (int step = 0; step < 4; ++step) {
        simulation.step(swirl, 0.02 * step, 0.02);
        expect_sound(complex, simulation);
    }
    EXPECT_GT(phase_area(complex, 2), 0.04);
}

const std::vector<Course> in_place{
    {"sequential", {}},           {"fixed", &fixed_division},   {"counting", &counting_division},
    {"active", &active_division}, {"blocks", &blocks_division}, {"cells", &cells_division}};
INSTANTIATE_TEST_SUITE_P(Ways, EditsInPlace, testing::ValuesIn(in_place), course_name);
INSTANTIATE_TEST_SUITE_P(Ways, Edits, testing::ValuesIn(all_courses), course_name);

// A vertex that has missed its targets may arrive from where the application has put it.
TEST(EditsInSteps, AMovedVertexIsInContactNoMore) {
    Complex<double> complex = disc();
    const Options<double> options{.edge_length = disc_h};
    Simulation<double> simulation(complex, options);
    const std::vector<std::uint32_t> interface = simulation.interface();
    for (const std::uint32_t v : {interface[0], interface[1]}) {
        complex.vertices[v].flags |= vertex_contact;
    }
    const Vertex moved{interface[0]};
    complex.set_position(moved, complex.position(moved) + Point<double>(1e-3 * disc_h, 0));
    simulation.step(still, 0, 1);
    EXPECT_EQ(complex.vertices[moved.id].flags & vertex_contact, 0U);
    EXPECT_EQ(complex.vertices[interface[1]].flags & vertex_contact, std::uint32_t{vertex_contact});
}

} // namespace
} // namespace dsc::edits_test

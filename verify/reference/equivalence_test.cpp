// SPDX-License-Identifier: MIT
// Every operation of chapter 7 of the thesis against the literal one of the reference: the same
// verdict and the same mesh, on thousands of random complexes, whole ones and submeshes.
#include "support/equivalence_testing.h"

#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "reference/operations/edge_collapse.h"
#include "reference/operations/edge_flip.h"
#include "reference/operations/edge_split.h"
#include "reference/operations/laplacian_smoothing.h"
#include "reference/operations/local_retriangulation.h"
#include "reference/operations/loop_subdivision.h"
#include "thesis/local_retriangulation.h"
#include "thesis/loop_subdivision.h"
#include "thesis/smoothing.h"

#include <gtest/gtest.h>

namespace dsc::test::equivalence_test {
namespace {

template <class Real>
void compare_edge(Equivalence<Real>& equivalence, const Complex<Real>& K, Edge e,
                  bool exact_middle) {
    const auto [a, b] = K.vertices_of(e);
    const reference::EdgeKey key = reference::edge_key(a, b);
    equivalence.compare(
        Operation::flip, {a, b}, [&](const auto& submesh) { return edge_flip(submesh, e); },
        [&](reference::Complex& copied) { return reference::edge_flip(key, copied); });
    equivalence.compare(
        Operation::collapse, {a, b}, [&](const auto& submesh) { return edge_collapse(submesh, e); },
        [&](reference::Complex& copied) { return reference::edge_collapse(key, copied); });
    if (exact_middle) {
        equivalence.compare(
            Operation::split, {a, b},
            [&](const auto& submesh) { return edge_split(submesh, e).verdict; },
            [&](reference::Complex& copied) {
                return reference::edge_split(key, copied, std::nullopt);
            });
    }
}

template <class Real>
void compare_triangle(Equivalence<Real>& equivalence, const Complex<Real>& K, Triangle t,
                      bool exact_middle) {
    const auto [a, b, c] = K.vertices_of(t);
    const reference::TriangleKey key = reference::triangle_key(a, b, c);
    equivalence.compare(
        Operation::retriangulation, {a, b, c},
        [&](const auto& submesh) { return local_retriangulation(submesh, t).verdict; },
        [&](reference::Complex& copied) { return reference::local_retriangulation(key, copied); });
    if (exact_middle) {
        equivalence.compare(
            Operation::subdivision, {a, b, c},
            [&](const auto& submesh) { return loop_subdivision(submesh, t).verdict; },
            [&](reference::Complex& copied) { return reference::loop_subdivision(key, copied); });
    }
}

// `exact_middle`: midpoints are the same numbers in Real and in double; `with_smoothing`: sums in
// another order, and rounded to Real, are nearly the same.
template <class Real>
void compare_all(const Case<Real>& given, Tally& tally, bool exact_middle, bool with_smoothing) {
    const Complex<Real>& K = given.complex;
    Equivalence<Real> equivalence(given, tally);
    for (const Triangle t : triangles(K)) {
        compare_triangle(equivalence, K, t, exact_middle);
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (K.is_alive(Edge{corner_of(t.id, i)})) {
                compare_edge(equivalence, K, Edge{corner_of(t.id, i)}, exact_middle);
            }
        }
    }
    if (with_smoothing) {
        for (const Vertex v : vertices(K)) {
            if (K.vertices[v.id].corner != no_id) {
                equivalence.compare(
                    Operation::smoothing, {v},
                    [&](const auto& submesh) { return laplacian_smoothing(submesh, v); },
                    [&](reference::Complex& copied) {
                        return reference::laplacian_smoothing(v, copied);
                    });
            }
        }
    }
}

template <class Real>
void compare_many(std::uint64_t first_seed, int count, Tally& tally) {
    for_each_case<Real>(
        first_seed, count, [&](const Case<Real>& given, const RandomComplexOptions& options) {
            const bool is_double = std::is_same_v<Real, double>;
            compare_all(given, tally, is_double || (options.grid > 0 && !options.at_resolution),
                        is_double && !options.at_resolution);
        });
}

void expect_coverage(Tally& tally, bool with_smoothing) {
    using enum Verdict;
    expect_all_met(tally, Operation::flip,
                   {legal, on_boundary, on_submesh_boundary, on_interface, inverts}, 50);
    expect_all_met(tally, Operation::split, {legal, on_submesh_boundary}, 50);
    if (with_smoothing) { // double, that is: float leaves out where midpoints are rounded
        expect_all_met(tally, Operation::split, {inverts}, 50);
        expect_all_met(tally, Operation::subdivision, {inverts}, 50);
    }
    expect_all_met(
        tally, Operation::collapse,
        {legal, on_boundary, on_submesh_boundary, on_interface, locked, changes_topology, inverts},
        50);
    expect_all_met(tally, Operation::subdivision, {legal, on_submesh_boundary, on_interface}, 50);
    expect_all_met(tally, Operation::retriangulation,
                   {legal, on_submesh_boundary, on_interface, locked, not_a_simple_polygon}, 20);
    if (with_smoothing) {
        expect_all_met(
            tally, Operation::smoothing,
            {legal, on_boundary, on_submesh_boundary, on_interface, locked, inverts, no_gain}, 20);
    }
    EXPECT_LT(tally.excused, tally.compared / 100);
    testing::Test::RecordProperty("compared", tally.compared);
    testing::Test::RecordProperty("excused", tally.excused);
    for (const auto& [key, count] : tally.verdicts) {
        testing::Test::RecordProperty(
            to_string(key.first) + "_" + std::string(dsc::to_string(key.second)), count);
    }
}

TEST(Equivalence, DoubleWithReference) {
    Tally tally;
    compare_many<double>(1, 1500, tally);
    expect_coverage(tally, true);
}

TEST(Equivalence, FloatWithReference) {
    Tally tally;
    compare_many<float>(1000001, 750, tally);
    expect_coverage(tally, false);
}

} // namespace
} // namespace dsc::test::equivalence_test

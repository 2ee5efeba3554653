// SPDX-License-Identifier: MIT
// Every operation of chapter 7 of the thesis against the literal one of the reference: the same
// verdict and mesh, on thousands of random complexes and submeshes.
#include "support/equivalence_testing.h"

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "reference/operations/edge_collapse.h"
#include "reference/operations/edge_flip.h"
#include "reference/operations/edge_split.h"
#include "reference/operations/laplacian_smoothing.h"
#include "reference/operations/local_retriangulation.h"
#include "reference/operations/loop_subdivision.h"
#include "reference/operations/triangle_collapse.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/smoothing.h"
#include "thesis/operations/triangle_collapse.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace dsc::test::equivalence_test {
namespace {

template <class Real>
void compare_edge(Equivalence<Real>& equivalence, const Complex<Real>& K, Edge e,
                  bool exact_middle) {
    const auto [a, b] = K.vertices_of(e);
    const reference::EdgeKey key = reference::edge_key(a, b);
    equivalence.compare(
        "flip", {a, b}, [&](const auto& submesh) { return edge_flip(submesh, e); },
        [&](reference::Complex& copied) { return reference::edge_flip(key, copied); });
    equivalence.compare(
        "collapse", {a, b}, [&](const auto& submesh) { return edge_collapse(submesh, e); },
        [&](reference::Complex& copied) { return reference::edge_collapse(key, copied); });
    if (exact_middle) {
        equivalence.compare(
            "split", {a, b}, [&](const auto& submesh) { return edge_split(submesh, e).verdict; },
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
        "retriangulation", {a, b, c},
        [&](const auto& submesh) {
            const Verdict said = local_retriangulation_guard(submesh.complex, t, submesh.region);
            const Verdict verdict = local_retriangulation(submesh, t).verdict;
            EXPECT_EQ(said, verdict);
            return verdict;
        },
        [&](reference::Complex& copied) { return reference::local_retriangulation(key, copied); });
    if (exact_middle) {
        equivalence.compare(
            "subdivision", {a, b, c},
            [&](const auto& submesh) { return loop_subdivision(submesh, t).verdict; },
            [&](reference::Complex& copied) { return reference::loop_subdivision(key, copied); });
    }
}

// `exact_middle`: midpoints are exact in Real. `with_smoothing`: also compares operations that add
// coordinates, whose results depend on the order and on rounding to Real.
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
                    "smoothing", {v},
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
    expect_all_met(tally, "flip", {legal, on_boundary, on_submesh_boundary, on_interface, inverts},
                   50);
    expect_all_met(tally, "split", {legal, on_submesh_boundary}, 50);
    if (with_smoothing) { // double only: float skips rounded midpoints
        expect_all_met(tally, "split", {inverts}, 50);
        expect_all_met(tally, "subdivision", {inverts}, 50);
    }
    expect_all_met(
        tally, "collapse",
        {legal, on_boundary, on_submesh_boundary, on_interface, locked, changes_topology, inverts},
        50);
    expect_all_met(tally, "subdivision", {legal, on_submesh_boundary, on_interface}, 50);
    expect_all_met(tally, "retriangulation",
                   {legal, on_submesh_boundary, on_interface, locked, not_a_simple_polygon}, 20);
    if (with_smoothing) {
        expect_all_met(
            tally, "smoothing",
            {legal, on_boundary, on_submesh_boundary, on_interface, locked, inverts, no_gain}, 20);
    }
    EXPECT_LT(tally.excused, tally.compared / 100);
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

// --- triangle collapse ---------------------------------------------------------------------------

// The library's triangle collapse makes two edge collapses; the reference inserts a vertex and
// replaces triangles as in figure 13.1 of the thesis.

// Positions of the collapsed vertex: a corner, the centroid rounded to Real, and for double the
// default.
template <class Real>
std::vector<std::optional<Point<Real>>> places_in(const Complex<Real>& K, Triangle t) {
    const auto [a, b, c] = K.vertices_of(t);
    const Point<Real> centroid = (K.position(a) + K.position(b) + K.position(c)) / Real(3);
    std::vector<std::optional<Point<Real>>> places{K.position(a), centroid};
    if (std::is_same_v<Real, double>) {
        places.push_back(std::nullopt); // the default; in float, the reference's centroid differs
    }
    return places;
}

template <class Real>
void compare_collapses(Equivalence<Real>& equivalence, const Complex<Real>& K, Triangle t) {
    const auto [a, b, c] = K.vertices_of(t);
    const reference::TriangleKey key = reference::triangle_key(a, b, c);
    for (const auto& place : places_in(K, t)) {
        std::optional<Point<double>> literal_place;
        if (place) {
            literal_place = place->template cast<double>();
        }
        for (const InterfaceRule rule : {InterfaceRule::keep, InterfaceRule::change}) {
            const bool may_change = rule == InterfaceRule::change;
            equivalence.compare(
                may_change ? "interface_triangle_collapse" : "triangle_collapse", {a, b, c},
                [&](const auto& submesh) {
                    const TriangleCollapseOptions<Real> options{place, rule};
                    const Verdict said =
                        triangle_collapse_guard(submesh.complex, t, options, submesh.region);
                    const auto result = triangle_collapse(submesh, t, options);
                    EXPECT_EQ(said, result.verdict);
                    EXPECT_EQ(said == Verdict::legal, submesh.complex.is_alive(result.vertex));
                    return result.verdict;
                },
                [&](reference::Complex& copied) {
                    return reference::triangle_collapse(key, copied, literal_place, may_change);
                });
        }
    }
}

template <class Real>
void compare_many_collapses(std::uint64_t first_seed, int count) {
    Tally tally;
    for_each_case<Real>(first_seed, count, [&](const Case<Real>& given, const auto&) {
        Equivalence<Real> equivalence(given, tally);
        for (const Triangle t : triangles(given.complex)) {
            compare_collapses(equivalence, given.complex, t);
        }
    });
    using enum Verdict;
    for (const char* operation : {"triangle_collapse", "interface_triangle_collapse"}) {
        expect_all_met(tally, operation,
                       {legal, on_boundary, on_submesh_boundary, locked, changes_topology, inverts},
                       50);
    }
    expect_all_met(tally, "triangle_collapse", {on_interface}, 50);
    EXPECT_LT(tally.excused, tally.compared / 100);
}

TEST(Equivalence, TriangleCollapseInDouble) { compare_many_collapses<double>(1, 1000); }

TEST(Equivalence, TriangleCollapseInFloat) { compare_many_collapses<float>(1000001, 500); }

} // namespace
} // namespace dsc::test::equivalence_test

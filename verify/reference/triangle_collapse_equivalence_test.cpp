// SPDX-License-Identifier: MIT
// Triangle collapse, which the library makes of two edge collapses, against the reference, which
// inserts a vertex and replaces triangles as figure 13.1 of the thesis shows it: the same verdict
// and the same mesh on thousands of random complexes, whole ones and submeshes.
#include "support/equivalence_testing.h"

#include "reference/operations/triangle_collapse.h"
#include "thesis/triangle_collapse.h"

#include <gtest/gtest.h>

#include <optional>

namespace dsc::test::triangle_collapse_equivalence_test {
namespace {

// At the default place, at a vertex, and where the centroid is in Real.
template <class Real>
std::vector<std::optional<Point<Real>>> places_in(const Complex<Real>& K, Triangle t) {
    const auto [a, b, c] = K.vertices_of(t);
    const Point<Real> centroid = (K.position(a) + K.position(b) + K.position(c)) / Real(3);
    std::vector<std::optional<Point<Real>>> places{K.position(a), centroid};
    if (std::is_same_v<Real, double>) {
        places.push_back(std::nullopt); // in float, the centroid of the reference is another
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
                may_change ? Operation::interface_triangle_collapse : Operation::triangle_collapse,
                {a, b, c},
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
void compare_many(std::uint64_t first_seed, int count) {
    Tally tally;
    for_each_case<Real>(first_seed, count, [&](const Case<Real>& given, const auto&) {
        Equivalence<Real> equivalence(given, tally);
        for (const Triangle t : triangles(given.complex)) {
            compare_collapses(equivalence, given.complex, t);
        }
    });
    using enum Verdict;
    for (const Operation operation :
         {Operation::triangle_collapse, Operation::interface_triangle_collapse}) {
        expect_all_met(tally, operation,
                       {legal, on_boundary, on_submesh_boundary, locked, changes_topology, inverts},
                       50);
    }
    expect_all_met(tally, Operation::triangle_collapse, {on_interface}, 50);
    EXPECT_LT(tally.excused, tally.compared / 100);
    for (const auto& [key, times] : tally.verdicts) {
        testing::Test::RecordProperty(
            to_string(key.first) + "_" + std::string(dsc::to_string(key.second)), times);
    }
}

TEST(Equivalence, TriangleCollapseInDouble) { compare_many<double>(1, 1000); }

TEST(Equivalence, TriangleCollapseInFloat) { compare_many<float>(1000001, 500); }

} // namespace
} // namespace dsc::test::triangle_collapse_equivalence_test

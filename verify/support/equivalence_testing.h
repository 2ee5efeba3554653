// SPDX-License-Identifier: MIT
// Compares an operation of the library with the literal one of the reference: verdict and mesh must
// be the same. As in sections 8.4 to 8.6 of the thesis, the reference works on a copy of the
// submesh, and knows the rest only by flags.
#pragma once

#include "snapshot.h"
#include "support/random/complex.h"

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/validate.h"
#include "reference/algorithm/quality.h"
#include "thesis/sets/mesh_functions.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dsc::test {

/// Counts of verdicts: a verdict that never occurs is not tested.
struct Tally {
    std::map<std::pair<std::string, Verdict>, int> verdicts; ///< by operation
    int compared = 0;
    int excused = 0;
};

template <class Real>
struct Case {
    Complex<Real> complex;
    Region region;
    reference::Complex copied;
    std::set<Vertex> half_seen; // on the domain boundary, with a part of the star outside
};

/// The submesh for the reference. Vertices keep their ids, so "the smaller id first" means the same
/// in both.
template <class Real>
reference::Complex copy_out(const Complex<Real>& complex, const Region& region) {
    reference::Complex K;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        K.insert(complex.position(Vertex{v}).template cast<double>());
    }
    std::vector<bool> in_use(complex.vertex_bound(), region.is_whole());
    for (const Triangle t : triangles(complex)) {
        if (!owns_triangle(complex, region, t.id)) {
            continue;
        }
        const auto [a, b, c] = complex.vertices_of(t);
        K.set_phase(K.insert(a, b, c), complex.phase(t));
        for (const Vertex v : {a, b, c}) {
            in_use[v.id] = true;
        }
        for (const Edge e : complex.edges_of(t)) {
            if (is_submesh_boundary(complex, region, e)) {
                const auto [p, q] = complex.vertices_of(e);
                K.submesh_boundary_edges.insert(reference::edge_key(p, q));
                if (is_interface(complex, e)) {
                    K.submesh_boundary_interface.insert(reference::edge_key(p, q));
                }
            }
        }
    }
    for (std::uint32_t id = 0; id < complex.vertex_bound(); ++id) {
        const Vertex v{id};
        if (!complex.is_alive(v) || !in_use[id]) {
            K.remove(v);
            continue;
        }
        if (is_submesh_boundary(complex, region, v)) {
            K.submesh_boundary_vertices.insert(v);
        }
        if (complex.is_locked(v)) {
            K.locked.insert(v);
        }
        if (complex.is_boundary_feature(v)) {
            K.boundary_features.insert(v);
        }
    }
    return K;
}

inline std::vector<PlacedTriangle> placed_literally(const reference::Complex& K) {
    std::vector<PlacedTriangle> list;
    for (const auto& [key, oriented] : K.triangles()) {
        std::array<std::array<double, 2>, 3> at;
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = {K.coord(oriented[i]).x(), K.coord(oriented[i]).y()};
        }
        list.push_back(placed(at, K.phase(key)));
    }
    return list;
}

template <class Real>
class Equivalence {
public:
    Equivalence(const Case<Real>& given, Tally& tally) : given_(given), tally_(tally) {}

    // `library` and `literal` perform the operation on copies; `vertices` are those of the simplex.
    void compare(const std::string& operation, const std::vector<Vertex>& vertices,
                 const std::function<Verdict(const Submesh<Real>&)>& library,
                 const std::function<Verdict(reference::Complex&)>& literal) {
        Complex<Real> complex = given_.complex;
        const std::string before = snapshot(complex);
        const Verdict verdict = library({complex, given_.region, complex.ids, complex.journal});
        reference::Complex copied = given_.copied;
        Verdict expected = literal(copied);
        if (expected == Verdict::not_a_simplex) {
            expected = Verdict::on_submesh_boundary; // the simplex is not in the submesh
        }
        ++tally_.verdicts[{operation, verdict}];
        ++tally_.compared;
        const auto what = [&] {
            std::string words = operation + " of";
            for (const Vertex v : vertices) {
                words += " " + std::to_string(v.id);
            }
            return words + ": library " + std::string(dsc::to_string(verdict)) + ", reference " +
                   std::string(dsc::to_string(expected));
        };
        if (verdict != Verdict::legal) {
            ASSERT_EQ(before, snapshot(complex)) << what() << ", and changed something";
        } else {
            const ValidationReport report = validate(complex);
            ASSERT_TRUE(report.ok()) << what() << ": " << report.problem;
        }
        if (verdict != expected) {
            ASSERT_TRUE(excused(operation, verdict, expected, vertices, copied)) << what();
            ++tally_.excused;
            return;
        }
        if (verdict == Verdict::legal) {
            if (operation == "smoothing") {
                // Sums in a different order are rounded differently.
                const Vertex v = vertices.front();
                const Point<double> p = complex.position(v).template cast<double>();
                ASSERT_LT((copied.coord(v) - p).norm(), 1e-12 * (1 + p.norm())) << what();
                copied.set_coord(v, p);
            }
            compare_meshes(complex, copied, what());
        }
    }

private:
    // Allowed differences. The reference does not know the mesh outside its submesh, neither the
    // domain boundary nor edges there. If a collapse would put the vertex onto such an edge, the
    // reference refuses it because triangles would be inverted. And gains below rounding error may
    // be detected or not.
    bool excused(const std::string& operation, Verdict verdict, Verdict expected,
                 const std::vector<Vertex>& vertices, const reference::Complex& after) const {
        const auto is_pair = [&](Verdict a, Verdict b) {
            return (verdict == a && expected == b) || (verdict == b && expected == a);
        };
        if (operation == "smoothing" && is_pair(Verdict::legal, Verdict::no_gain)) {
            const Vertex v = vertices.front();
            return std::abs(reference::star_quality(after, v) -
                            reference::star_quality(given_.copied, v)) < 1e-14;
        }
        if (operation == "collapse" && verdict == Verdict::changes_topology &&
            expected == Verdict::inverts) {
            return std::any_of(vertices.begin(), vertices.end(), [&](Vertex v) {
                return given_.copied.submesh_boundary_vertices.contains(v);
            });
        }
        return is_pair(Verdict::on_boundary, Verdict::on_submesh_boundary) &&
               std::any_of(vertices.begin(), vertices.end(),
                           [&](Vertex v) { return given_.half_seen.contains(v); });
    }

    void compare_meshes(const Complex<Real>& complex, const reference::Complex& copied,
                        const std::string& what) const {
        std::vector<PlacedTriangle> expected =
            placed_triangles(given_.complex, [&](std::uint32_t t) {
                return !owns_triangle(given_.complex, given_.region, t);
            });
        const std::vector<PlacedTriangle> inside = placed_literally(copied);
        expected.insert(expected.end(), inside.begin(), inside.end());
        std::sort(expected.begin(), expected.end());
        ASSERT_TRUE(expected == placed_triangles(complex, [](std::uint32_t) { return true; }))
            << what << ": the meshes differ";
    }

    const Case<Real>& given_;
    Tally& tally_;
};

/// Calls `compare(case, random options)` for the complex of each seed, alternately whole and with a
/// submesh, until a comparison fails.
template <class Real, class Compare>
void for_each_case(std::uint64_t first_seed, int count, Compare compare) {
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const RandomComplexOptions options = random_options(seed, 24);
        Case<Real> given;
        given.complex = random_complex<Real>(seed, options);
        const ValidationReport report = validate(given.complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        const std::vector<std::uint32_t> labels = random_labels(seed, given.complex);
        if (i % 2 == 1) {
            given.region.kind = Region::Kind::labels;
            given.region.labels = labels.data();
            given.region.label = 1;
        }
        given.copied = copy_out(given.complex, given.region);
        for (const Vertex v : vertices(given.complex)) {
            if (is_boundary(given.complex, v) &&
                is_submesh_boundary(given.complex, given.region, v)) {
                given.half_seen.insert(v);
            }
        }
        compare(given, options);
        if (::testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

/// Checks that every possible verdict has occurred.
inline void expect_all_met(Tally& tally, const std::string& operation,
                           const std::vector<Verdict>& verdicts, int at_least) {
    for (const Verdict verdict : verdicts) {
        EXPECT_GE((tally.verdicts[{operation, verdict}]), at_least)
            << operation << ' ' << dsc::to_string(verdict);
    }
}

} // namespace dsc::test

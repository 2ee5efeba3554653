// SPDX-License-Identifier: MIT
// Random sequences of operations on random complexes: the data of vertices, edges and triangles
// follow as attributes.h promises. Expected values are computed from the complex before the
// operation and from vertex ids, independently of how records are rewritten. An attribute class of
// the application, a conserved quantity, goes through all operations and through steps.
#include "support/conserved.h"
#include "support/copy_testing.h"
#include "support/operations_testing.h"
#include "support/random/complex.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/rewire.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

namespace dsc::test::operations_attributes_test {
namespace {

template <class Real>
void give_density_one(const Complex<Real>& complex, Conserved& mass) {
    for (const Triangle t : triangles(complex)) {
        mass[t] = static_cast<double>(area(complex, t));
    }
}

template <class Real>
double total(const Complex<Real>& complex, Conserved& mass) {
    double sum = 0;
    for (const Triangle t : triangles(complex)) {
        sum += mass[t];
    }
    return sum;
}

// The effect of an operation, in terms of vertices and edges that existed before.
struct Change {
    Vertex made{}; // made on the edge `split`, at this fraction of it
    Edge split{};
    double share = 0;
    Vertex gone{}, kept{};   // of a collapse
    bool is_polygon = false; // a polygon was retriangulated
};

constexpr double edge_default = -1;

template <class Real>
class Data {
public:
    explicit Data(Complex<Real>& complex)
        : complex_(complex), vertex_(complex.attributes.template add<Vertex, double>("vertex")),
          edge_(complex.attributes.template add<Edge, double>("edge", edge_default)),
          triangle_(complex.attributes.template add<Triangle, double>("triangle")),
          mass_(complex.attributes.add(std::make_unique<Conserved>("mass"))) {}

    // Writes new, distinct values everywhere, also in free ids, so that values left by earlier
    // operations cannot make a test pass.
    void write() {
        for (auto* list : {&vertex_.data(), &edge_.data(), &triangle_.data()}) {
            std::ranges::generate(*list, [&] { return ++counter_; });
        }
        for (const Edge e : edges(complex_)) {
            edge_.set(complex_, e, ++counter_);
        }
        give_density_one(complex_, mass_);
        whole_ = total(complex_, mass_);
    }

    void expect_followed(const Complex<Real>& before, const Change& change) const {
        const auto& vertex = before.attributes.template get<Vertex, double>("vertex");
        const auto& triangle = before.attributes.template get<Triangle, double>("triangle");
        for (const Vertex v : vertices(complex_)) {
            if (v != change.made) {
                EXPECT_EQ(vertex_[v], vertex[v]) << "vertex " << v.id;
            } else {
                const auto [a, b] = before.vertices_of(change.split);
                const double mixed = (1 - change.share) * vertex[a] + change.share * vertex[b];
                EXPECT_NEAR(vertex_[v], mixed, sizeof(Real) == 8 ? 1e-6 : 0.05);
            }
        }
        for (const Triangle t : triangles(complex_)) {
            Triangle whole = t; // a part of a cut triangle has the data of the whole
            if (change.made.is_valid() && contains(t, change.made)) {
                const Corner c = change.split.id;
                const bool is_here = contains(t, Vertex{before.vertex(c)});
                whole = Triangle{triangle_of(is_here ? c : before.twin(c))};
            }
            EXPECT_EQ(triangle_[t], triangle[whole]) << "triangle " << t.id;
        }
    }

    // An edge of a retriangulated polygon may have the default, even if its two ends had an edge
    // before.
    void expect_edges_followed(const Complex<Real>& before, const Change& change) const {
        const auto& edge = before.attributes.template get<Edge, double>("edge");
        for (const Edge e : edges(complex_)) {
            const Edge from = origin_of(e, before, change);
            const Corner twin = complex_.twin(e.id);
            const bool is_reset = change.is_polygon && edge_[e] == edge_default;
            EXPECT_EQ(edge_[e], from.is_valid() && !is_reset ? edge[from] : edge_default)
                << "edge " << e.id;
            EXPECT_TRUE(is_border(twin) || edge_.at_corner(twin) == edge_[e]) << "edge " << e.id;
        }
    }

    // Cuts and flips keep a density of 1, so each triangle's value is its area. If vertices are
    // removed, only the total stays.
    void expect_conserved(bool are_there_all_vertices) const {
        EXPECT_NEAR(total(complex_, mass_), whole_, rounding * whole_);
        for (const Triangle t : triangles(complex_)) {
            if (are_there_all_vertices) {
                EXPECT_NEAR(mass_[t], area(complex_, t), rounding * whole_);
            }
        }
    }

private:
    static constexpr double rounding = 1e-11;

    [[nodiscard]] bool contains(Triangle t, Vertex v) const {
        return std::ranges::count(complex_.triangles[t.id].v, v.id) == 1;
    }

    // The earlier edge whose data an edge must have, or none.
    Edge origin_of(Edge e, const Complex<Real>& before, const Change& change) const {
        const auto old = [&](Vertex a, Vertex b) {
            return before.is_alive(a) && before.is_alive(b) ? before.find_edge(a, b) : Edge{};
        };
        const auto [a, b] = complex_.vertices_of(e);
        for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
            if (one == change.made) {
                const auto ends = before.vertices_of(change.split);
                return std::ranges::count(ends, other) == 1 ? change.split : Edge{};
            }
            if (one == change.kept && !old(a, b).is_valid()) {
                return old(change.gone, other);
            }
        }
        return old(a, b);
    }

    Complex<Real>& complex_;
    VertexAttribute<double>& vertex_;
    EdgeAttribute<double>& edge_;
    TriangleAttribute<double>& triangle_;
    Conserved& mass_;
    double counter_ = 0;
    double whole_ = 0;
};

template <class Real>
class OperationsStorm : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(OperationsStorm, Reals);

TYPED_TEST(OperationsStorm, CarriesAttributesAlong) {
    enum { flip, split, cut, collapse, subdivide, retriangulate, kinds };
    std::array<int, kinds> done{};
    for (std::uint64_t seed = 1; seed <= 100 && !this->HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        RandomComplexOptions options = random_options(seed, 40);
        options.scramble = 0;
        options.at_resolution = false; // rounded positions would change the area
        auto K = random_complex<TypeParam>(seed, options);
        Data<TypeParam> data(K);
        for (int step = 0; step < 60; ++step) {
            const Triangle t{random.below(K.triangle_bound())};
            const Corner corner = corner_of(t.id, random.below(3));
            const std::uint32_t what = random.below(kinds);
            if (!K.is_alive(t)) {
                continue;
            }
            data.write();
            const Complex<TypeParam> before = K;
            const Edge e = K.edge(corner);
            const auto [a, b] = K.vertices_of(e);
            const Point<TypeParam> third = (2 * K.position(a) + K.position(b)) / 3;
            Change change;
            Verdict verdict{};
            if (what == flip) {
                verdict = edge_flip(K, e);
            } else if (what == split || what == cut) {
                const auto result = what == split ? edge_split(K, e) : edge_split(K, e, third);
                verdict = result.verdict;
                change = {
                    .made = result.vertex, .split = e, .share = what == split ? 0.5 : 1 / 3.0};
            } else if (what == collapse) {
                verdict = edge_collapse(K, e);
                change = {.gone = K.is_alive(a) ? b : a, .kept = K.is_alive(a) ? a : b};
            } else if (what == subdivide) {
                verdict = loop_subdivision(K, t).verdict;
            } else {
                verdict =
                    local_retriangulation(Submesh(K), t, RetriangulationMethod::delaunay).verdict;
                change.is_polygon = true;
            }
            if (verdict == Verdict::legal) {
                ++done[what];
                if (what < subdivide) {
                    data.expect_followed(before, change);
                }
                if (what != subdivide) {
                    data.expect_edges_followed(before, change);
                }
                // In float some areas round to nothing.
                constexpr bool is_double = std::is_same_v<TypeParam, double>;
                data.expect_conserved(is_double && what != collapse && what != retriangulate);
            }
        }
    }
    EXPECT_GT(std::ranges::min(done), 12) << "an operation was hardly tested";
}

// For a point beside the edge, the nearest point of the edge counts.
TEST(Blending, OfAVertexBesideItsEdge) {
    EXPECT_EQ((rewire::split_fraction<double>({0.25, 0.5}, {0, 0}, {1, 0})), 0.25);
    EXPECT_EQ((rewire::split_fraction<double>({2, 0.5}, {0, 0}, {1, 0})), 1);
}

// A reference to an attribute stays valid through steps, in place and with copied submeshes,
// through a renumbering, and after the complex is copied.
TEST(OwnAttributes, FollowASimulation) {
    constexpr double h = 0.05;
    for (const bool by_copies : {false, true}) {
        auto complex = disc_complex<double>(h);
        auto& mass = complex.attributes.add(std::make_unique<Conserved>("mass"));
        give_density_one(complex, mass);
        const double whole = total(complex, mass);
        const Options<double> options = options_for<double>(h);
        auto simulation = by_copies ? in_copies(complex, options, {.submeshes = 3, .threads = 2})
                                    : Simulation<double>(complex, options);
        std::uint64_t edits = 0;
        for (int step = 0; step < 6; ++step) {
            const auto report = simulation.step(constant<double>(0.4 * h, 0.3 * h), 0, 1);
            edits += report.operations.splits + report.operations.collapses;
        }
        EXPECT_GT(edits, 10U);
        EXPECT_NEAR(total(complex, mass), whole, 1e-11);
        Complex<double> copy = complex;
        auto& copied = copy.attributes.get<Conserved>("mass");
        EXPECT_NE(&copied, &mass);
        renumber(copy);
        EXPECT_NEAR(total(copy, copied), whole, 1e-11);
        EXPECT_NEAR(total(complex, mass), whole, 1e-11);
    }
}

} // namespace
} // namespace dsc::test::operations_attributes_test

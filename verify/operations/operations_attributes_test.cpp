// SPDX-License-Identifier: MIT
// Long random sequences of all operations on random complexes: valid after each, area and phases
// kept, and the data of vertices, edges and triangles follow as attributes.h promises. What the
// data must be is worked out from vertex ids alone, without a look at how the records were
// rewritten.
#include "support/operations_testing.h"
#include "support/random/complex.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/phases.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace dsc::test::operations_attributes_test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Corners = std::array<std::uint32_t, 3>;

Pair sorted(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

Corners sorted(Corners v) {
    std::sort(v.begin(), v.end());
    return v;
}

constexpr double edge_default = -1;
constexpr double triangle_default = -2;

struct Data {
    std::map<std::uint32_t, double> vertices;
    std::map<Pair, double> edges;
    std::set<Pair> border;                                         // edges of the domain boundary
    std::map<std::uint32_t, std::pair<Corners, double>> triangles; // by id
    std::map<Corners, double> placed;                              // by vertices
};

template <class Real>
struct Fields {
    VertexAttribute<double>& vertex;
    EdgeAttribute<double>& edge;
    TriangleAttribute<double>& triangle;
};

template <class Real>
Fields<Real> fields_of(Complex<Real>& K) {
    return {K.attributes.template get<Vertex, double>("v"),
            K.attributes.template get<Edge, double>("e"),
            K.attributes.template get<Triangle, double>("t")};
}

// Reads all data; both corners of an edge must agree.
template <class Real>
Data read(Complex<Real>& K) {
    const Fields<Real> fields = fields_of(K);
    Data data;
    for (const Vertex v : vertices(K)) {
        data.vertices[v.id] = fields.vertex[v];
    }
    for (const Triangle t : triangles(K)) {
        const double value = fields.triangle[t];
        data.triangles[t.id] = {sorted(K.triangles[t.id].v), value};
        data.placed[sorted(K.triangles[t.id].v)] = value;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            const Pair key = sorted(K.vertex(next(c)), K.vertex(prev(c)));
            const double here = fields.edge.at_corner(c);
            if (is_border(K.twin(c))) {
                data.border.insert(key);
            }
            const auto [at, is_new] = data.edges.insert({key, here});
            EXPECT_EQ(at->second, here)
                << "the two sides of edge " << key.first << '-' << key.second << " differ";
        }
    }
    return data;
}

// Fresh distinct values everywhere: stale ones of earlier operations must not help.
template <class Real>
void write(Complex<Real>& K, double& counter) {
    const Fields<Real> fields = fields_of(K);
    for (std::uint32_t v = 0; v < K.vertex_bound(); ++v) {
        fields.vertex[Vertex{v}] = ++counter;
    }
    for (std::uint32_t t = 1; t < K.triangle_bound(); ++t) {
        fields.triangle[Triangle{t}] = ++counter;
        for (std::uint32_t i = 0; i < 3; ++i) {
            fields.edge.data()[corner_of(t, i)] = ++counter; // garbage in free ids, too
        }
    }
    for (const Triangle t : triangles(K)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            fields.edge.set(K, K.edge(c), fields.edge[K.edge(c)]);
        }
    }
}

// What an operation did, in terms of vertices that lived before.
struct Change {
    std::map<std::uint32_t, Pair> middles; // new vertex: the edge it lies on
    std::optional<Pair> collapsed;         // vanished, kept
    std::optional<Corners> filled;         // retriangulation: around these three vertices
    std::optional<Pair> flipped;           // ids of the two triangles
};

bool touches(const Corners& t, std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; }

void check(const Data& before, const Data& after, const Change& change) {
    for (const auto& [v, value] : after.vertices) {
        if (const auto at = change.middles.find(v); at != change.middles.end()) {
            const auto [a, b] = at->second;
            EXPECT_DOUBLE_EQ(value, 0.5 * (before.vertices.at(a) + before.vertices.at(b)));
        } else {
            EXPECT_EQ(value, before.vertices.at(v)) << "vertex " << v;
        }
    }
    for (const auto& edge : after.edges) {
        const auto key = edge.first;
        const double value = edge.second;
        double expected = edge_default;
        const auto look = [&](Pair old) {
            const auto at = before.edges.find(old);
            return at == before.edges.end() ? std::nullopt : std::optional<double>(at->second);
        };
        const auto other_than = [&](std::uint32_t v) {
            return key.first == v ? key.second : key.first;
        };
        const auto has = [&](std::uint32_t v) { return key.first == v || key.second == v; };
        if (change.filled && !before.border.contains(key) &&
            (touches(*change.filled, key.first) || touches(*change.filled, key.second))) {
            expected = edge_default; // as new, though there may have been one before
        } else if (change.middles.empty() && look(key)) {
            expected = *look(key);
        } else if (change.collapsed && has(change.collapsed->second)) {
            const auto moved =
                look(sorted(change.collapsed->first, other_than(change.collapsed->second)));
            expected = moved.value_or(edge_default);
        } else {
            bool half = false;
            for (const auto& [m, split] : change.middles) {
                if (has(m)) {
                    const std::uint32_t other = other_than(m);
                    if (other == split.first || other == split.second) {
                        expected = *look(sorted(split.first, split.second));
                    }
                    half = true;
                }
            }
            if (!half && look(key)) {
                expected = *look(key);
            }
        }
        EXPECT_EQ(value, expected) << "edge " << key.first << '-' << key.second;
    }
    for (const auto& [id, entry] : after.triangles) {
        const auto& [corners, value] = entry;
        double expected = triangle_default;
        const auto at = before.placed.find(corners);
        const bool replaced =
            change.filled && std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
                return touches(*change.filled, v);
            });
        if (at != before.placed.end() && !replaced) {
            expected = at->second;
        } else if (change.filled) {
            expected = before.placed.at(*change.filled);
        } else if (change.flipped || change.collapsed) {
            expected = before.triangles.at(id).second;
        } else {
            // A part: its old corners, and the ends of the edges that its new ones lie on, are the
            // corners of the triangle that was cut.
            std::vector<std::uint32_t> all;
            for (const std::uint32_t v : corners) {
                if (const auto m = change.middles.find(v); m != change.middles.end()) {
                    all.insert(all.end(), {m->second.first, m->second.second});
                } else {
                    all.push_back(v);
                }
            }
            std::sort(all.begin(), all.end());
            all.erase(std::unique(all.begin(), all.end()), all.end());
            ASSERT_EQ(all.size(), 3U);
            expected = before.placed.at({all[0], all[1], all[2]});
        }
        EXPECT_EQ(value, expected) << "triangle " << id;
    }
}

template <class Real>
double area_of(const Complex<Real>& K) {
    double area = 0;
    for (const Phase p : phases(K)) {
        area += phase_area(K, p);
    }
    return area;
}

// Performs one operation at random; the change, or nothing where it was refused.
template <class Real>
std::optional<Change> operate(Random& random, Complex<Real>& K, const Data& before,
                              std::array<int, 8>& done) {
    const Triangle t{random.below(K.triangle_bound())};
    if (!K.is_alive(t)) {
        return std::nullopt;
    }
    const Corner c = corner_of(t.id, random.below(3));
    const Edge e = K.edge(c);
    const auto [a, b] = K.vertices_of(e);
    const Submesh whole = Submesh(K);
    Change change;
    const std::uint32_t what = random.below(8);
    switch (what) {
    case 0:
        change.flipped = Pair{triangle_of(c), triangle_of(K.twin(c))};
        if (edge_flip(K, e) != Verdict::legal) {
            return std::nullopt;
        }
        break;
    case 1: {
        const auto split = edge_split(K, e);
        if (split.verdict != Verdict::legal) {
            return std::nullopt;
        }
        change.middles[split.vertex.id] = {a.id, b.id};
        break;
    }
    case 2:
    case 3:
        if (edge_collapse(K, e) != Verdict::legal) {
            return std::nullopt;
        }
        change.collapsed = K.is_alive(a) ? Pair{b.id, a.id} : Pair{a.id, b.id};
        break;
    case 4: {
        const auto v = K.triangles[t.id].v;
        const auto result = loop_subdivision(K, t);
        if (result.verdict != Verdict::legal) {
            return std::nullopt;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            change.middles[result.vertices[i].id] = {v[(i + 1) % 3], v[(i + 2) % 3]};
        }
        break;
    }
    case 5:
    case 6: {
        const auto method =
            what == 5 ? RetriangulationMethod::ear_clipping : RetriangulationMethod::delaunay;
        change.filled = before.triangles.at(t.id).first;
        if (local_retriangulation(whole, t, method).verdict != Verdict::legal) {
            return std::nullopt;
        }
        break;
    }
    default:
        if (laplacian_smoothing(K, a) != Verdict::legal &&
            interface_smoothing(K, a, {.corner_degrees = 150}) != Verdict::legal) {
            return std::nullopt;
        }
    }
    ++done[what];
    return change;
}

template <class Real>
void run_storms(std::uint64_t first_seed) {
    constexpr int storms = 100;
    std::array<int, 8> done{};
    for (std::uint64_t seed = first_seed; seed < first_seed + std::uint64_t{storms}; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        RandomComplexOptions options = random_options(seed, 40);
        options.scramble = 0;
        options.at_resolution = false; // rounded midpoints do not keep the area
        auto K = random_complex<Real>(seed, options);
        K.attributes.template add<Vertex, double>("v");
        K.attributes.template add<Edge, double>("e", edge_default);
        K.attributes.template add<Triangle, double>("t", triangle_default);
        // Straight sides of a convex grid keep the area through boundary collapses; real
        // coordinates are almost never collinear, so that those do not collapse at all.
        const double area = area_of(K);
        double counter = 0;
        for (int step = 0; step < 60; ++step) {
            write(K, counter);
            const Data before = read(K);
            const std::string bytes = snapshot(K);
            const auto change = operate(random, K, before, done);
            if (!change) {
                ASSERT_EQ(bytes == snapshot(K), true) << "a refused operation changed something";
                continue;
            }
            const ValidationReport report = validate(K);
            ASSERT_TRUE(report.ok()) << report.problem;
            check(before, read(K), *change);
            ASSERT_NEAR(area_of(K), area, 1e-5 * area);
            if (testing::Test::HasFailure()) {
                return;
            }
        }
    }
    for (std::size_t what = 0; what < done.size(); ++what) {
        EXPECT_GT(done[what], storms / 8) << "operation " << what << " was hardly tested";
    }
}

TEST(OperationsStorm, Double) { run_storms<double>(1); }
TEST(OperationsStorm, Float) { run_storms<float>(5001); }

} // namespace
} // namespace dsc::test::operations_attributes_test

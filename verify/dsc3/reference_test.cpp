// SPDX-License-Identifier: MIT
// A literal reference for the guards, on unordered lists of tets: to decide whether an operation is
// legal, the complex after it is made and checked as a whole.
#include "dsc3/geometry/tet.h"
#include "dsc3/literal_tets.h"
#include "dsc3/random_mesh.h"
#include "support/environment.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

namespace dsc3::test::reference_test {
namespace {

const std::uint64_t seeds = dsc::test::are_asked_for("few") ? 2 : 40;
constexpr int tries = 100;

Real quality_of(const Complex& complex, const SetTet& tet) {
    return quality(complex.at(tet.v[0]), complex.at(tet.v[1]), complex.at(tet.v[2]),
                   complex.at(tet.v[3]));
}
Real worst(const Complex& complex, const Tets& tets) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const SetTet& tet : tets) {
        least = std::min(least, quality_of(complex, tet));
    }
    return least;
}

// Whether a quality is so near to its limit that rounding may decide.
bool is_near(Real quality, Real limit) { return std::abs(quality - limit) < 1e-9; }

// The reference's answer whether an operation is legal, with which the guard's is compared; empty
// where rounding may decide.
using Answer = std::optional<bool>;
struct Asked {
    int legal = 0;
    int refused = 0;
};
Asked compare(const std::function<Answer(const Complex&, const EdgeAt&)>& reference,
              const std::function<Verdict(Complex&, Workspace&, const EdgeAt&)>& operation) {
    Asked asked;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Complex complex = random_mesh(seed);
        Workspace work;
        Random random(seed);
        for (int i = 0; i < tries; ++i) {
            const std::uint32_t t = 1 + random.below(complex.tet_bound() - 1);
            const std::uint32_t a = random.below(4);
            const std::uint32_t b = (a + 1 + random.below(3)) % 4;
            if (!complex.is_alive(Tet{t})) {
                continue;
            }
            const EdgeAt edge{t, complex.tets[t].v[a], complex.tets[t].v[b]};
            const Answer answer = reference(complex, edge);
            const Verdict verdict = operation(complex, work, edge);
            if (answer) {
                EXPECT_EQ(*answer, verdict == Verdict::legal)
                    << "seed " << seed << ", try " << i << ": " << dsc::to_string(verdict);
                ++(*answer ? asked.legal : asked.refused);
            }
            if (testing::Test::HasFailure()) {
                return asked;
            }
        }
    }
    return asked;
}

TEST(Reference3, CollapsesAreLegalWhereWhatTheyLeaveIsAComplex) {
    for (const Real floor : {1e-3, 0.2}) {
        const CollapseRules rules{.floor = floor, .enough = floor, .min_cos = -1};
        const Asked asked = compare(
            [&](const Complex& complex, const EdgeAt& edge) -> Answer {
                const std::uint32_t v = edge.a;
                const std::uint32_t to = edge.b;
                const Tets before = tets_of(complex);
                const bool on_interface = is_interface(before, v);
                const Sides sides = sides_of(complex);
                const bool is_free = !sides.contains(v);
                if ((!is_free && common(sides, {v, to}) != sides.at(v)) ||
                    (on_interface && !is_interface(before, to))) {
                    return false;
                }
                Tets after;
                Tets made;
                for (SetTet each : before) {
                    if (each.has(v) && each.has(to)) {
                        continue;
                    }
                    if (each.has(v)) {
                        *std::find(each.v.begin(), each.v.end(), v) = to;
                        made.push_back(each);
                    }
                    after.push_back(each);
                }
                const Real was = worst(complex, with(before, {v}));
                const Real limit = was < floor ? std::max(1.5 * was, std::min(floor, 1e-7)) : floor;
                if (is_near(worst(complex, made), limit) || is_near(was, floor)) {
                    return std::nullopt;
                }
                if (worst(complex, made) < limit) {
                    return false;
                }
                if (!on_interface && is_free) {
                    return true;
                }
                const Ids of_v = neighbours_on_surface(before, v);
                const Ids of_to = neighbours_on_surface(before, to);
                Ids of_both;
                std::set_intersection(of_v.begin(), of_v.end(), of_to.begin(), of_to.end(),
                                      std::inserter(of_both, of_both.end()));
                const std::size_t faces = surface_at(before, {v, to}).size();
                const auto keeps_faces = [&](std::uint32_t x) {
                    return x == to || surface_at(before, {v, to, x}).empty() ||
                           surface_at(before, {x}).size() > 3;
                };
                const auto vanishes = [&](Ids face) { // it falls onto another one
                    face.erase(v);
                    face.insert(to);
                    return face.size() == 3 && !surface_at(before, face).empty();
                };
                const std::set<Ids> of_faces = surface_at(before, {v});
                const bool keeps_surface =
                    std::none_of(of_faces.begin(), of_faces.end(), vanishes) && faces > 0 &&
                    of_both.size() == faces &&
                    ((is_sheet(before, sides, v) &&
                      (of_faces.size() > 3 || !is_sheet(before, sides, to))) ||
                     (of_faces.size() > 3 && is_on_curve(before, sides, v, to) &&
                      is_curve(before, sides, v))) &&
                    std::all_of(of_v.begin(), of_v.end(), keeps_faces) &&
                    std::none_of(of_both.begin(), of_both.end(), [&](std::uint32_t x) {
                        return is_on_curve(before, sides, v, x) &&
                               is_on_curve(before, sides, to, x);
                    });
                if (keeps_surface) {
                    for (const std::uint32_t x : of_v) {
                        EXPECT_TRUE(!is_sheet(before, sides, x) || is_sheet(after, sides, x));
                        EXPECT_TRUE(!is_curve(before, sides, x) || is_curve(after, sides, x));
                    }
                }
                return keeps_surface;
            },
            [&](Complex& complex, Workspace& work, const EdgeAt& edge) {
                return edge_collapse(complex, work, Vertex{edge.a}, Vertex{edge.b}, rules);
            });
        EXPECT_TRUE(asked.legal > 50 || seeds < 40) << asked.legal;
        EXPECT_TRUE(asked.refused > 50 || seeds < 40) << asked.refused;
    }
}

// The link of an edge, in order, such that (a, b, x, next) has positive orientation; it is open if
// the edge is on the domain boundary.
std::vector<std::uint32_t> link_of(const Complex& complex, const Tets& ring, std::uint32_t a,
                                   std::uint32_t b) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const SetTet& tet : ring) {
        std::vector<std::uint32_t> others;
        std::copy_if(tet.v.begin(), tet.v.end(), std::back_inserter(others),
                     [&](std::uint32_t x) { return x != a && x != b; });
        if (quality_of(complex, {{a, b, others[0], others[1]}, 0}) < 0) {
            std::swap(others[0], others[1]);
        }
        next[others[0]] = others[1];
    }
    std::uint32_t first = next.begin()->first;
    for (const auto& pair : next) {
        const bool is_after_none = std::none_of(next.begin(), next.end(), [&](const auto& other) {
            return other.second == pair.first;
        });
        first = is_after_none ? pair.first : first;
    }
    std::vector<std::uint32_t> link{first};
    for (auto at = next.find(first); at != next.end() && at->second != first;
         at = next.find(at->second)) {
        link.push_back(at->second);
    }
    return link;
}

// The largest worst quality over all triangulations of a polygon, each triangle with a and with b.
Real best_of_all(const Complex& complex, std::uint32_t a, std::uint32_t b,
                 const std::vector<std::uint32_t>& polygon) {
    if (polygon.size() < 3) {
        return std::numeric_limits<Real>::infinity();
    }
    Real best = -std::numeric_limits<Real>::infinity();
    const std::uint32_t first = polygon.front();
    const std::uint32_t last = polygon.back();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const auto apex = polygon.begin() + static_cast<std::ptrdiff_t>(k);
        const Real here =
            worst(complex, {{{first, *apex, last, b}, 0}, {{*apex, first, last, a}, 0}});
        best =
            std::max(best, std::min({here, best_of_all(complex, a, b, {polygon.begin(), apex + 1}),
                                     best_of_all(complex, a, b, {apex, polygon.end()})}));
    }
    return best;
}

TEST(Reference3, EdgesAreRemovedWhereOneOfAllTriangulationsIsBetter) {
    const Asked asked = compare(
        [](const Complex& complex, const EdgeAt& edge) -> Answer {
            const Tets before = tets_of(complex);
            const Ids ends{edge.a, edge.b};
            const Tets ring = with(before, ends);
            const auto link = link_of(complex, ring, edge.a, edge.b);
            if (!interface_at(before, ends).empty() || link.size() > polygon_limit ||
                (is_boundary(before, ends) &&
                 (link.size() < 3 ||
                  common(sides_of(complex), {edge.a, edge.b, link.front(), link.back()})
                      .empty()))) {
                return false;
            }
            const Real best = best_of_all(complex, edge.a, edge.b, link);
            const Real limit = 1.0001 * worst(complex, ring);
            return is_near(best, limit) ? std::nullopt : Answer(best > limit);
        },
        [](Complex& complex, Workspace& work, const EdgeAt& edge) {
            return edge_removal(complex, work, edge);
        });
    EXPECT_TRUE(asked.legal > 50 || seeds < 40) << asked.legal;
    EXPECT_TRUE(asked.refused > 50 || seeds < 40) << asked.refused;
}

TEST(Reference3, FacesFlipWhereThreeTetsAreBetterThanTwo) {
    // The face opposite to the first vertex of the edge.
    const Asked asked = compare(
        [](const Complex& complex, const EdgeAt& edge) -> Answer {
            const Tets before = tets_of(complex);
            Ids face(complex.tets[edge.tet].v.begin(), complex.tets[edge.tet].v.end());
            face.erase(edge.a);
            const Tets two = with(before, face);
            if (two.size() < 2 || two[0].phase != two[1].phase) {
                return false;
            }
            std::uint32_t beyond = no_id;
            for (const SetTet& tet : two) {
                for (const std::uint32_t x : tet.v) {
                    beyond = x != edge.a && face.count(x) == 0 ? x : beyond;
                }
            }
            Real best = std::numeric_limits<Real>::infinity();
            for (const std::uint32_t left_out : face) {
                SetTet tet{complex.tets[edge.tet].v, 0};
                *std::find(tet.v.begin(), tet.v.end(), left_out) = beyond;
                best = std::min(best, quality_of(complex, tet));
            }
            const Real limit = 1.0001 * worst(complex, two);
            return is_near(best, limit) ? std::nullopt : Answer(best > limit);
        },
        [](Complex& complex, Workspace& work, const EdgeAt& edge) {
            return face_flip(complex, work,
                             corner_of(edge.tet, index_in(complex.tets[edge.tet], edge.a)));
        });
    EXPECT_TRUE(asked.legal > 5 || seeds < 40) << asked.legal;
    EXPECT_TRUE(asked.refused > 50 || seeds < 40) << asked.refused;
}

TEST(Reference3, InterfaceEdgesFlipWhereBothSidesCanBeFilled) {
    const FlipRules rules{.floor = 0.01, .min_cos = -1, .slack = 0};
    const Asked asked = compare(
        [&](const Complex& complex, const EdgeAt& edge) -> Answer {
            const Tets before = tets_of(complex);
            const auto [tet, a, b] = edge;
            const Ids ends{a, b};
            const auto cut = interface_at(before, ends);
            if (is_boundary(before, ends) || cut.size() != 2) {
                return false;
            }
            Ids thirds;
            for (Ids face : cut) {
                face.erase(a);
                face.erase(b);
                thirds.insert(*face.begin());
            }
            const std::uint32_t c = *thirds.begin();
            const std::uint32_t d = *thirds.rbegin();
            const Real angles = angle_degrees(complex.at(c), complex.at(a), complex.at(b)) +
                                angle_degrees(complex.at(d), complex.at(a), complex.at(b));
            if (std::abs(angles - 180) < 1e-6) {
                return std::nullopt;
            }
            const Ids crossing{c, d};
            if (angles < 180 || !surface_at(before, crossing).empty() ||
                surface_at(before, {a}).size() < 4 || surface_at(before, {b}).size() < 4) {
                return false;
            }
            const Tets ring = with(before, ends);
            std::vector<std::uint32_t> link = link_of(complex, ring, a, b);
            const Real limit = std::min(rules.floor, std::max(worst(complex, ring), 1e-4));
            for (const auto& [from, to] : {std::pair(c, d), std::pair(d, c)}) {
                std::rotate(link.begin(), std::find(link.begin(), link.end(), from), link.end());
                const auto end = std::find(link.begin(), link.end(), to) + 1;
                const std::vector<std::uint32_t> piece(link.begin(), end);
                if (piece.size() == 2) { // the tet (a, b, c, d) exists and changes its phase
                    const Ids at_a{a, c, d};
                    const Ids at_b{b, c, d};
                    return interface_at(before, at_a).empty() && !is_boundary(before, at_a) &&
                           interface_at(before, at_b).empty() && !is_boundary(before, at_b);
                }
                if (piece.size() > polygon_limit) {
                    return false;
                }
                const Real best = best_of_all(complex, a, b, piece);
                if (is_near(best, limit)) {
                    return std::nullopt;
                }
                if (best < limit) {
                    return false;
                }
            }
            return true;
        },
        [&](Complex& complex, Workspace& work, const EdgeAt& edge) {
            return interface_flip(complex, work, edge, rules);
        });
    EXPECT_TRUE(asked.legal > 20 || seeds < 40) << asked.legal;
    EXPECT_TRUE(asked.refused > 50 || seeds < 40) << asked.refused;
}

} // namespace
} // namespace dsc3::test::reference_test

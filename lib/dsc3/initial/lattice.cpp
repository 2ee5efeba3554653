// SPDX-License-Identifier: MIT
#include "dsc3/initial/lattice.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/operations/edge_split.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace dsc3::initial {

namespace {

constexpr Real cubes_along_side = 4;

using Index = std::array<std::uint32_t, 3>;

} // namespace

Complex lattice(const Box& domain) {
    const Point size = domain.high - domain.low;
    const Real cube = size.minCoeff() / cubes_along_side;
    Index n{};
    for (std::uint32_t i = 0; i < 3; ++i) {
        n[i] = static_cast<std::uint32_t>(std::max(1.0, std::round(size[i] / cube)));
    }
    const auto number = [&](const Index& at) {
        return (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0];
    };
    std::vector<Point> points;
    Index at{};
    for (at[2] = 0; at[2] <= n[2]; ++at[2]) {
        for (at[1] = 0; at[1] <= n[1]; ++at[1]) {
            for (at[0] = 0; at[0] <= n[0]; ++at[0]) {
                Point p;
                for (std::uint32_t i = 0; i < 3; ++i) { // exactly on the sides
                    p[i] = at[i] == n[i] ? domain.high[i] : domain.low[i] + size[i] * at[i] / n[i];
                }
                points.push_back(p);
            }
        }
    }
    constexpr std::array<Index, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    std::vector<std::array<std::uint32_t, 4>> tets;
    for (at[2] = 0; at[2] < n[2]; ++at[2]) {
        for (at[1] = 0; at[1] < n[1]; ++at[1]) {
            for (at[0] = 0; at[0] < n[0]; ++at[0]) {
                for (const Index& order : orders) { // along the sides from one corner to the other
                    Index corner = at;
                    std::array<std::uint32_t, 4> tet{number(corner)};
                    for (std::uint32_t i = 0; i < 3; ++i) {
                        ++corner[order[i]];
                        tet[i + 1] = number(corner);
                    }
                    tets.push_back(tet);
                }
            }
        }
    }
    return make_complex(points, tets, std::vector<Phase>(tets.size(), exterior_phase));
}

namespace {

// The longest edge of a tet. Ties are broken by the vertices in the same way in all tets, so the
// longest edges on a path from tet to tet grow, and the path ends.
EdgeAt longest_edge(const Complex& complex, std::uint32_t t) {
    std::tuple<Real, std::uint32_t, std::uint32_t> best{-1, 0, 0};
    const auto& v = complex.tets[t].v;
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (std::uint32_t j = i + 1; j < 4; ++j) {
            const Real square = squared_distance(complex.at(std::min(v[i], v[j])),
                                                 complex.at(std::max(v[i], v[j])));
            best = std::max(best, {square, std::min(v[i], v[j]), std::max(v[i], v[j])});
        }
    }
    return {t, std::get<1>(best), std::get<2>(best)};
}

// Bisects the tet; first, the tets around its longest edge that have a longer edge.
void bisect(Complex& complex, Workspace& work, std::uint32_t t) {
    for (;;) {
        const EdgeAt edge = longest_edge(complex, t);
        if (!gather(complex, edge, work.ring)) {
            throw InvariantError("bisect: too many tets around an edge");
        }
        const auto end = work.ring.tets.begin() + work.ring.size;
        const auto other = std::find_if(work.ring.tets.begin(), end, [&](std::uint32_t o) {
            const EdgeAt its = longest_edge(complex, o);
            return its.a != edge.a || its.b != edge.b;
        });
        if (other == end) {
            if (!edge_split(complex, work, edge, midpoint(complex.at(edge.a), complex.at(edge.b)))
                     .is_valid()) {
                throw InvariantError("bisect: an edge cannot be split");
            }
            return;
        }
        bisect(complex, work, *other);
    }
}

} // namespace

void refine(Complex& complex, Workspace& work, const LongestEdge& longest, Real max_tets) {
    // Most tets are beside a surface once there are so many: their number then grows with the
    // square of the edge length.
    constexpr std::uint32_t many = 50'000;
    for (bool is_coarse = true; is_coarse;) {
        is_coarse = false;
        Real coarsest = 1; // square of the largest ratio of an edge's length to what is allowed
        const std::uint32_t bound = complex.tet_bound();
        for (std::uint32_t t = 1; t < bound; ++t) {
            const EdgeAt edge = longest_edge(complex, t);
            const Real limit = longest(complex.positions_of(Tet{t}));
            const Real square = squared_distance(complex.at(edge.a), complex.at(edge.b));
            if (square > limit * limit) {
                coarsest = std::max(coarsest, square / (limit * limit));
                bisect(complex, work, t);
                is_coarse = true;
            }
        }
        const Real needed =
            std::max(bound > many ? bound * coarsest : 0, Real(complex.tet_bound()));
        if (needed > max_tets) {
            throw InputError({.what = "the first complex has too many tets",
                              .where = "initial_complex, edge_length",
                              .value = "about " + dsc::to_text(std::round(needed)) +
                                       " tets, each of some 200 bytes",
                              .allowed = "at most " + dsc::to_text(max_tets) +
                                         " tets (`max_tets`): longer edges"});
        }
        work.rewiring.changed.clear();
    }
}

} // namespace dsc3::initial

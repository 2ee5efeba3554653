// SPDX-License-Identifier: MIT
#include "geometric_flows/curve_solver.h"

#include "geometric_flows/curve_network.h"
#include "geometric_flows/kept_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace dsc::curve_solver_test {
namespace {

// Vertices at arbitrary positions: the solver uses only edges and junctions.
class Network {
public:
    std::uint32_t vertex(bool is_junction) {
        network.positions.emplace_back();
        network.is_junction.push_back(is_junction ? 1 : 0);
        return static_cast<std::uint32_t>(network.positions.size() - 1);
    }
    void edge(std::uint32_t from, std::uint32_t to) {
        const bool is_turned = std::bernoulli_distribution(0.5)(lot);
        network.edges.push_back({.from = is_turned ? to : from, .to = is_turned ? from : to});
    }
    void curve(std::uint32_t from, std::uint32_t to, int between) {
        for (int i = 0; i < between; ++i) {
            const std::uint32_t next = vertex(false);
            edge(from, next);
            from = next;
        }
        edge(from, to);
    }

    CurveNetwork network;
    std::mt19937 lot;
};

// Curves between junctions: several between the same two, loops, and some without inner vertices;
// closed curves down to two vertices; and a vertex without edges. In some networks the curves are
// so long that they are divided into several shares.
CurveNetwork draw(unsigned seed) {
    Network made;
    made.lot.seed(seed);
    const auto below = [&](int n) { return std::uniform_int_distribution(0, n - 1)(made.lot); };
    const int stretch = seed % 10 == 0 ? 200 : 1;
    std::vector<std::uint32_t> junctions;
    for (int i = below(5); i > 0; --i) {
        junctions.push_back(made.vertex(true));
    }
    const int curves = junctions.empty() ? 0 : below(9);
    for (int i = 0; i < curves; ++i) {
        const auto any = [&] {
            return junctions[static_cast<std::size_t>(below(static_cast<int>(junctions.size())))];
        };
        const std::uint32_t from = any();
        const std::uint32_t to = any();
        made.curve(from, to, stretch * (from == to ? 2 + below(5) : below(6)));
    }
    for (int i = below(3); i > 0; --i) {
        const std::uint32_t start = made.vertex(false);
        made.curve(start, start, stretch * (1 + below(6)));
    }
    if (below(3) == 0) {
        (void)made.vertex(true);
    }
    std::ranges::shuffle(made.network.edges, made.lot);
    return made.network;
}

using Column = Vector2;

// The product of the full matrix with a vector, row by row.
std::vector<Column> product(const CurveNetwork& network, const std::vector<Block>& diagonal,
                            const std::vector<Block>& coupling,
                            const std::vector<Column>& columns) {
    std::vector<Column> sum;
    for (std::uint32_t v = 0; v < diagonal.size(); ++v) {
        sum.push_back(diagonal[v].of(columns[v]));
    }
    for (std::size_t e = 0; e < coupling.size(); ++e) {
        const auto [from, to] = std::pair(network.edges[e].from, network.edges[e].to);
        sum[from] += coupling[e].of(columns[to]);
        sum[to] += coupling[e].transposed().of(columns[from]);
    }
    return sum;
}

void solve(CurveSolver& solver, const CurveGraph& graph, const std::vector<Block>& diagonal,
           const std::vector<Block>& coupling, std::vector<Column>& columns,
           const InShares& in_shares, const PressureRows& rows = {}) {
    graph.for_each_share(in_shares, [&](std::size_t share) {
        solver.eliminate(share, diagonal, coupling);
        solver.reduce(share, columns);
        if (!rows.gains.empty()) {
            solver.reduce(share, columns, rows);
        }
    });
    solver.factorise_junctions(diagonal, rows);
    solver.finish(columns, in_shares, rows);
}

// Pressures that act on all vertices in arbitrary directions.
struct Pushes {
    std::vector<CurvePush> of_curves;
    std::vector<Column> columns;

    Pushes(const CurveGraph& graph, int pressures, std::mt19937& lot)
        : columns(graph.network().positions.size()) {
        std::uniform_real_distribution<double> number(-1, 1);
        std::uniform_int_distribution<int> place(-1, pressures - 1);
        for (const NetworkCurve& curve : graph.curves()) {
            of_curves.push_back({.left = place(lot), .right = place(lot)});
            const auto any = [&] { return Column{number(lot), number(lot)}; };
            for (std::size_t k = curve.begin; k < curve.end; ++k) {
                columns[graph.places()[k].vertex] = any();
            }
            if (curve.is_loop) {
                columns[curve.from] = any();
            } else {
                of_curves.back().at_from = any();
                of_curves.back().at_to = any();
            }
        }
    }
    // Calls `visit(pressure, sign, vertex, push)` for each vertex that a pressure acts on.
    template <class Visit>
    void for_each(const CurveGraph& graph, const Visit& visit) const {
        for (std::size_t c = 0; c < of_curves.size(); ++c) {
            const NetworkCurve& curve = graph.curves()[c];
            for (const auto& [place, sign] :
                 {std::pair(of_curves[c].left, 1.0), std::pair(of_curves[c].right, -1.0)}) {
                for (std::size_t k = curve.begin; k < curve.end && place >= 0; ++k) {
                    const std::uint32_t v = graph.places()[k].vertex;
                    visit(static_cast<std::size_t>(place), sign, v, columns[v]);
                }
                if (place >= 0 && curve.is_loop) {
                    visit(static_cast<std::size_t>(place), sign, curve.from, columns[curve.from]);
                } else if (place >= 0) {
                    visit(static_cast<std::size_t>(place), sign, curve.from, of_curves[c].at_from);
                    visit(static_cast<std::size_t>(place), sign, curve.to, of_curves[c].at_to);
                }
            }
        }
    }
};

TEST(CurveSolver, SolvesNetworksOfEveryShape) {
    CurveGraph graph; // graph and solver are reused for one network after the other
    CurveSolver solver;
    std::size_t max_shares = 0;
    const InShares backwards = [&](std::size_t shares, const auto& task) {
        max_shares = std::max(max_shares, shares);
        for (std::size_t share = shares; share > 0; --share) {
            task(share - 1);
        }
    };
    for (unsigned seed = 0; seed < 300; ++seed) {
        const CurveNetwork network = draw(seed);
        const std::size_t n = network.positions.size();
        std::mt19937 lot(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        const auto block = [&] {
            return Block{number(lot), number(lot), number(lot), number(lot)};
        };
        std::vector<Block> diagonal(n, Block{0.1, 0, 0, 0.1});
        std::vector<Block> coupling;
        for (const CurveEdge& edge : network.edges) { // (a b) (a b)^T, which is semidefinite
            const Block a = block();
            const Block b = block();
            diagonal[edge.from] += a * a.transposed();
            diagonal[edge.to] += b * b.transposed();
            coupling.emplace_back(a * b.transposed());
        }
        graph.begin(network);
        solver.begin(graph);
        for (int round = 0; round < 2; ++round) { // the second reuses arrays
            std::vector<Column> columns;
            for (std::size_t v = 0; v < n; ++v) {
                columns.push_back({number(lot), number(lot)});
            }
            const std::vector<Column> wanted = columns;
            solve(solver, graph, diagonal, coupling, columns, backwards);
            const std::vector<Column> found = product(network, diagonal, coupling, columns);
            for (std::uint32_t v = 0; v < n; ++v) {
                EXPECT_LT(norm(found[v] - wanted[v]), 1e-10)
                    << "seed " << seed << ", vertex " << v << " of " << n;
            }
            // Three unknown pressures are recovered from the areas that they produce.
            Pushes pushes(graph, 3, lot);
            const std::array<double, 3> given{number(lot), number(lot), number(lot)};
            std::vector<Column> pushed = wanted;
            pushes.for_each(graph,
                            [&](std::size_t place, double sign, std::uint32_t v,
                                const Column& push) { pushed[v] += sign * given[place] * push; });
            solve(solver, graph, diagonal, coupling, pushed, backwards);
            std::array<double, 3> gains{};
            pushes.for_each(
                graph, [&](std::size_t place, double sign, std::uint32_t v, const Column& push) {
                    gains[place] += sign * dot(push, pushed[v]);
                });
            std::array<double, 3> pressures{};
            columns = wanted;
            solve(solver, graph, diagonal, coupling, columns, backwards,
                  {.pushes = pushes.of_curves,
                   .columns = pushes.columns,
                   .gains = gains,
                   .pressures = pressures});
            for (std::uint32_t v = 0; v < n; ++v) {
                EXPECT_LT(norm(columns[v] - pushed[v]), 1e-4 * (1 + norm(pushed[v])))
                    << "seed " << seed << ", vertex " << v << " of " << n << " under pressure";
            }
        }
    }
    EXPECT_GT(max_shares, 2U);
}

TEST(CurveSolver, HoldsAClosedCurveWithoutASolutionAlone) {
    Network made;
    for (int i = 0; i < 2; ++i) {
        const std::uint32_t start = made.vertex(false);
        made.curve(start, start, 3);
    }
    std::vector<Block> diagonal(8, Block{3, 0, 0, 3});
    const std::vector<Block> coupling(8, Block{-1, 0, 0, -1});
    diagonal[5] = {};
    CurveGraph graph;
    graph.begin(made.network);
    CurveSolver solver;
    solver.begin(graph);
    std::vector<Column> columns(8, Column{1, 1});
    solve(solver, graph, diagonal, coupling, columns, one_by_one);
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_NEAR(columns[v].x, 1, 1e-12);
        EXPECT_TRUE(std::isnan(columns[v + 4].x));
    }
}

// Closed curves, enough for several shares, whose areas differ from the required ones.
TEST(AreaKeeper, ShiftsToTheSameBitsInAnyOrderOfShares) {
    constexpr std::uint32_t discs = 8;
    constexpr std::uint32_t sides = 150;
    CurveNetwork network;
    std::vector<KeptArea> kept;
    for (std::uint32_t disc = 0; disc < discs; ++disc) {
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            network.positions.push_back({disc + 0.4 * std::cos(angle), 0.3 * std::sin(angle)});
            network.edges.push_back({.from = disc * sides + i,
                                     .to = disc * sides + (i + 1) % sides,
                                     .left = static_cast<Phase>(disc + 1),
                                     .right = exterior_phase});
        }
        kept.push_back({.phase = static_cast<Phase>(disc + 1), .area = 0.4});
    }
    network.freedom.resize(network.positions.size());
    network.is_junction.resize(network.positions.size(), 0);
    std::size_t max_shares = 0;
    const InShares backwards = [&](std::size_t shares, const auto& task) {
        max_shares = shares;
        for (std::size_t share = shares; share > 0; --share) {
            task(share - 1);
        }
    };
    CurveGraph graph;
    graph.begin(network);
    AreaKeeper keeper;
    keeper.begin(graph, kept);
    std::array<std::vector<Column>, 2> found;
    for (std::size_t i = 0; i < 2; ++i) {
        found[i].assign(network.positions.size(), {});
        const InShares& in_shares = i == 0 ? one_by_one : backwards;
        (void)keeper.look(network.positions, found[i], in_shares);
        keeper.shift(found[i], in_shares);
        EXPECT_NE(found[i].front(), Column{});
    }
    EXPECT_GT(max_shares, 2U);
    EXPECT_EQ(found[0], found[1]);
}

} // namespace
} // namespace dsc::curve_solver_test

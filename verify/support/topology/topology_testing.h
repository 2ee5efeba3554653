// SPDX-License-Identifier: MIT
// Small complexes in which the topology may change, and the surroundings of their vertices.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/validate.h"
#include "topology/change.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace dsc::test {

using PhaseAt = std::function<Phase(const Point<double>&)>;

/// No phase: such cells are left out.
inline constexpr Phase nothing = 99;
/// Cells of this phase are cut along one diagonal, and all others along both.
inline constexpr Phase film = 77;

/// A complex of the cells between rows of points.
inline Complex<double> cells_of(const std::vector<std::vector<Point<double>>>& rows,
                                const PhaseAt& phase_at) {
    std::vector<Point<double>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
    const auto width = static_cast<std::uint32_t>(rows[0].size());
    for (const auto& row : rows) {
        points.insert(points.end(), row.begin(), row.end());
    }
    for (std::uint32_t y = 0; y + 1 < rows.size(); ++y) {
        for (std::uint32_t x = 0; x + 1 < width; ++x) {
            const std::uint32_t low = y * width + x;
            const std::array<std::uint32_t, 4> around{low, low + 1, low + width + 1, low + width};
            Point<double> centre(0, 0);
            for (const std::uint32_t k : around) {
                centre += points[k] / 4;
            }
            if (phase_at(centre) == nothing) {
                continue;
            }
            if (phase_at(centre) == film) {
                triangles.push_back({around[0], around[1], around[2]});
                triangles.push_back({around[0], around[2], around[3]});
                phases.insert(phases.end(), 2, film);
                continue;
            }
            const auto middle = static_cast<std::uint32_t>(points.size());
            points.push_back(centre);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t next = around[(k + 1) % 4];
                triangles.push_back({around[k], next, middle});
                phases.push_back(phase_at((points[around[k]] + points[next] + centre) / 3));
            }
        }
    }
    return make_complex<double>(points, triangles, phases);
}

/// The same with columns at these x and rows at these y.
inline Complex<double> grid(const std::vector<double>& xs, const std::vector<double>& ys,
                            const PhaseAt& phase_at) {
    std::vector<std::vector<Point<double>>> rows;
    for (const double y : ys) {
        auto& row = rows.emplace_back();
        for (const double x : xs) {
            row.emplace_back(x, y);
        }
    }
    return cells_of(rows, phase_at);
}

inline TopologyOptions<double> changing() {
    TopologyOptions<double> options;
    options.rule = Topology::change;
    return options;
}

/// Changes the topology with all vertices as candidates and without motion, at an edge length of 1.
inline std::vector<Event> change(Complex<double>& complex,
                                 const TopologyOptions<double>& options = changing()) {
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> interface;
    auto& places = places_of(complex);
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        places[v] = {p.x(), p.y()};
        candidates.push_back({.vertex = v.id, .is_sharp = true, .is_junction = true});
        interface.push_back(v.id);
    }
    std::vector<Event> events;
    change_topology<double>({.complex = complex,
                             .options = options,
                             .edge_length = 1,
                             .time = 0,
                             .events = events,
                             .interface = interface},
                            candidates);
    EXPECT_EQ(validate(complex).problem, "");
    return events;
}

/// The phases about a vertex.
struct Meeting {
    std::vector<Phase> phases; ///< counter-clockwise; on the domain boundary from edge to edge
    bool is_on_boundary = false;
};

inline Meeting meeting_at(const Complex<double>& complex, Vertex v) {
    Meeting meeting;
    for_each_corner(complex, v, [&](Corner c) {
        meeting.is_on_boundary = meeting.is_on_boundary || is_border(complex.twin(prev(c)));
        if (meeting.phases.empty() || meeting.phases.back() != complex.phase_at(c)) {
            meeting.phases.push_back(complex.phase_at(c));
        }
    });
    if (!meeting.is_on_boundary && meeting.phases.size() > 1 &&
        meeting.phases.front() == meeting.phases.back()) {
        meeting.phases.pop_back();
    }
    return meeting;
}

/// The places where a curve ends on the domain boundary, and those where three meet inside.
struct Ends {
    std::vector<Point<double>> on_boundary;
    std::vector<Point<double>> inside;
    std::size_t crowded = 0; ///< number of vertices where more curves meet
};

inline Ends ends_of(const Complex<double>& complex) {
    Ends ends;
    for (const Vertex v : vertices(complex)) {
        const Meeting meeting = meeting_at(complex, v);
        const std::size_t stable = meeting.is_on_boundary ? 2 : 3;
        ends.crowded += meeting.phases.size() > stable ? 1U : 0U;
        if (meeting.phases.size() == stable) {
            (meeting.is_on_boundary ? ends.on_boundary : ends.inside)
                .push_back(complex.position(v));
        }
    }
    return ends;
}

} // namespace dsc::test

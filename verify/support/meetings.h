// SPDX-License-Identifier: MIT
// Where phases meet in a complex: which about a vertex, and at which vertices three or more.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"

#include <vector>

namespace dsc::test {

/// The phases about a vertex.
struct Meeting {
    std::vector<Phase> phases; ///< counter-clockwise; on the wall from side to side
    bool is_on_wall = false;
};

inline Meeting meeting_at(const Complex<double>& complex, Vertex v) {
    Meeting meeting;
    for_each_corner(complex, v, [&](Corner c) {
        meeting.is_on_wall = meeting.is_on_wall || is_border(complex.twin(prev(c)));
        if (meeting.phases.empty() || meeting.phases.back() != complex.phase_at(c)) {
            meeting.phases.push_back(complex.phase_at(c));
        }
    });
    if (!meeting.is_on_wall && meeting.phases.size() > 1 &&
        meeting.phases.front() == meeting.phases.back()) {
        meeting.phases.pop_back();
    }
    return meeting;
}

/// The places where a curve ends on the wall, and those where three meet inside.
struct Ends {
    std::vector<Point<double>> on_wall;
    std::vector<Point<double>> inside;
    std::size_t crowded = 0; ///< vertices with more than these
};

inline Ends ends_of(const Complex<double>& complex) {
    Ends ends;
    for (const Vertex v : vertices(complex)) {
        const Meeting meeting = meeting_at(complex, v);
        const std::size_t stable = meeting.is_on_wall ? 2 : 3;
        ends.crowded += meeting.phases.size() > stable ? 1U : 0U;
        if (meeting.phases.size() == stable) {
            (meeting.is_on_wall ? ends.on_wall : ends.inside).push_back(complex.position(v));
        }
    }
    return ends;
}

} // namespace dsc::test

// SPDX-License-Identifier: MIT
// The vertices at which three phases or more meet, and the angles between them. Where surface
// energies are equal, three interfaces meet at 120 degrees (C. Herring, "Surface tension as a
// motivation for sintering", 1951).
#pragma once

#include "dsc/complex/complex.h"

#include <vector>

namespace dsc::scenes {

struct Junction {
    Vertex vertex;
    std::uint32_t sectors = 0; ///< interface edges at the vertex, and so the sectors between them
    double min_deg = 0;        ///< of the angles of its sectors
    double max_deg = 0;
};

/// The vertices inside the domain with three interface edges or more, in rising order. Each curve
/// leaves its junction along the parabola through the junction and the next two vertices of the
/// curve, in its chord length: on a curve of radius R with edges of length h, the error of an angle
/// is of the order of (h / R)^3, against h / R of the first edge's own direction. A curve of one
/// edge is taken to be straight. O(triangles).
template <class Real>
[[nodiscard]] std::vector<Junction> measure_junctions(const Complex<Real>& complex);

struct JunctionFigures {
    std::uint64_t count = 0;
    std::uint64_t crossings = 0; ///< of these, with four sectors or more
    /// The largest difference of an angle from 120 degrees, at junctions with three sectors. NaN
    /// without such a junction.
    double worst_deviation_deg = 0;
};

/// The figures of all junctions. O(junctions).
[[nodiscard]] JunctionFigures summarise(const std::vector<Junction>& junctions);

} // namespace dsc::scenes

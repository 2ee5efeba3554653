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
    std::uint32_t sectors = 0; ///< number of interface edges, and of sectors, at the vertex
    double min_deg = 0;        ///< smallest and largest angle of its sectors
    double max_deg = 0;
};

/// The vertices inside the domain with three or more interface edges, in ascending order. The
/// direction of a curve at its junction is that of the parabola through the junction and the next
/// two vertices, parametrised by chord length: on a curve of radius R with edges of length h, the
/// error of an angle is O((h / R)^3); with the direction of the first edge it would be O(h / R). A
/// curve of one edge is taken as straight. O(triangles).
template <class Real>
[[nodiscard]] std::vector<Junction> measure_junctions(const Complex<Real>& complex);

struct JunctionFigures {
    std::uint64_t count = 0;
    std::uint64_t crossings = 0; ///< number of junctions with four sectors or more
    /// The largest difference of an angle from 120 degrees, at junctions with three sectors. NaN
    /// without such a junction.
    double worst_deviation_deg = 0;
};

/// The figures of all junctions. O(junctions).
[[nodiscard]] JunctionFigures summarise(const std::vector<Junction>& junctions);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// A run over time: rows of figures and counts, as comma-separated values.
#pragma once

#include "measures/measures.h"

#include <map>
#include <string>
#include <vector>

namespace dsc::scenes {

/// Figures of the mesh after a step, and counts since the previous row.
struct SeriesRow {
    int step = 0;
    double time = 0;
    std::uint64_t triangles = 0;
    std::uint64_t interface_vertices = 0;
    std::uint64_t phases = 0;    ///< number of phases with a triangle
    double interface_length = 0; ///< of all pairs of phases, with straight edges
    Figures figures;             ///< the same names in all rows
    std::map<std::string, std::uint64_t> operations;
    std::uint64_t events = 0; ///< changes of topology
    std::uint64_t unreached = 0;
    double wall_s = 0; ///< of the steps, without measuring
};

/// Measures that are cheap enough for many rows: areas, the symmetric difference if the exact shape
/// is known, worst quality and angle.
[[nodiscard]] std::vector<Measure> series_measures();

/// A line of names and one line for each row; numbers have enough digits to be read back exactly.
/// Figures that could not be measured are left empty.
[[nodiscard]] std::string series_to_csv(const std::vector<SeriesRow>& rows);

} // namespace dsc::scenes

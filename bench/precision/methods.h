// SPDX-License-Identifier: MIT
// The methods whose errors and times are measured: plain data. All except the last ones differ from
// the default in one option.
#pragma once

#include "scenes/run/strategy.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dsc::bench {

/// A key of dsc_scene's --set.
struct Setting {
    std::string key;
    std::string word{}; ///< its value; if empty, factor * h^power
    double factor = 0;
    double power = 0;
};

/// A polygon of markers without a mesh (reference/bare_markers.h).
struct BareMarkers {
    bool cubic = true;          ///< markers are inserted on a cubic; otherwise linearly
    double shortest_over_h = 0; ///< a marker is removed if an edge is shorter; 0: never
    int parts = 1;              ///< chords of each edge; 1: the edge itself
};

enum class Group : unsigned char {
    base,      ///< the default
    time,      ///< the integrator
    remeshing, ///< insertion and coarsening of the interface
    other,     ///< reading of the interface, precision, and other methods
    markers,   ///< bare markers: the lower bound
};

struct Method {
    std::string name; ///< for --method, file names and legends
    Group group = Group::base;
    std::vector<Setting> settings{};
    /// How the time step falls with the edge length. A method of first order in time needs steps
    /// that fall with the square, or its error would hide all others.
    enum class Step : unsigned char { with_length, with_square } step = Step::with_length;
    /// Factor on the flow's step, for a method that chooses its steps below this bound.
    double step_factor = 1;
    std::size_t max_lengths =
        99; ///< largest number of edge lengths, from the coarsest: for slow methods
    bool to_the_last = false;  ///< also runs the edge lengths that are too slow for most methods
    bool in_quick = true;      ///< also run by --quick
    bool reads_curves = false; ///< reads the interface as curves, not as a polygon
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::optional<BareMarkers> markers{};
};

[[nodiscard]] std::string to_string(Group group);
[[nodiscard]] const std::vector<Method>& precision_methods();

} // namespace dsc::bench

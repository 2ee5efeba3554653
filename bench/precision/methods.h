// SPDX-License-Identifier: MIT
// The methods whose errors and times are measured: plain data. All except the last ones change one
// thing in the default.
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
    std::string word{}; ///< its value; where empty, factor * h^power
    double factor = 0;
    double power = 0;
};

/// A polygon of markers without a mesh (reference/bare_markers.h).
struct BareMarkers {
    bool cubic = true;          ///< markers are inserted on a cubic; otherwise linearly
    double shortest_over_h = 0; ///< a marker goes where an edge is shorter; 0: never
    int parts = 1;              ///< chords by which an edge is read; 1: itself
};

enum class Group : unsigned char {
    base,      ///< the default, which the others change
    time,      ///< the integrator
    remeshing, ///< insertion and coarsening of the interface
    other,     ///< how it is read, precision, and other methods
    markers,   ///< bare markers: the least that is possible
};

struct Method {
    std::string name; ///< for --method, file names and legends
    Group group = Group::base;
    std::vector<Setting> settings{};
    /// How the time step shrinks with the edge length. First order in time needs steps that shrink
    /// with its square if time is not to hide everything else.
    enum class Step : unsigned char { with_length, with_square } step = Step::with_length;
    /// Factor on the flow's own step, for a method that chooses its steps below this bound.
    double step_factor = 1;
    std::size_t max_lengths = 99; ///< edge lengths at most, from the coarsest: for slow methods
    bool to_the_last = false;     ///< also the edge lengths that are too slow for most
    bool in_quick = true;         ///< also run by --quick
    bool reads_curves = false;    ///< the interface is not its polygon
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::optional<BareMarkers> markers{};
};

[[nodiscard]] std::string to_string(Group group);
[[nodiscard]] const std::vector<Method>& precision_methods();

} // namespace dsc::bench

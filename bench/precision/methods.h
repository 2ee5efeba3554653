// SPDX-License-Identifier: MIT
// The methods whose errors and times are measured: plain data. Each but the last ones varies one
// thing of the default.
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
    bool cubic = true;          ///< how markers are inserted: else linearly
    double shortest_over_h = 0; ///< a marker goes where an edge is shorter; 0: never
    int parts = 1;              ///< chords by which an edge is read; 1: itself
};

enum class Group : unsigned char {
    base,    ///< what all others vary
    time,    ///< the integrator
    upkeep,  ///< insertion and coarsening of the interface
    other,   ///< how it is read, precision, and other methods
    markers, ///< the floor
};

struct Method {
    std::string name; ///< for --method, file names and legends
    Group group = Group::base;
    std::vector<Setting> settings{};
    /// How the time step shrinks with the edge length. First order in time needs steps that shrink
    /// with its square if time is not to hide everything else.
    enum class Step : unsigned char { with_length, with_square } step = Step::with_length;
    /// Times as long as the flow's own: for a method that chooses its steps below this bound.
    double step_factor = 1;
    std::size_t most_lengths = 99; ///< so many of a flow's, from the coarsest: bounds the slow ones
    bool to_the_last = false;      ///< also the lengths that a flow keeps for few
    bool in_quick = true;          ///< also run by --quick
    bool reads_curves = false;     ///< the interface is not its polygon
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::optional<BareMarkers> markers{};
};

[[nodiscard]] std::string to_string(Group group);
[[nodiscard]] const std::vector<Method>& precision_methods();

} // namespace dsc::bench

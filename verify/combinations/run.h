// SPDX-License-Identifier: MIT
// One run of a row, from the first complex to the last.
#pragma once

#include "combinations/scene.h"
#include "shapes/outline.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dsc::combinations {

/// How a row is run; the answer depends on none of it.
struct Manner {
    std::uint32_t threads = 1;
    /// After a third of the steps, the run is archived, and read into another simulation.
    bool is_resumed = false;
    /// Without the row's interruption.
    bool is_unbroken = false;
};

/// What a complex looks like, by phase.
struct Shapes {
    std::vector<std::vector<scenes::Outline>> outlines;
    std::vector<double> areas;
};

/// What a run left.
struct Outcome {
    Shapes first;
    Shapes middle; ///< after half of the steps
    Shapes last;
    std::vector<double> times; ///< at which sub-steps began: those of a step are of one length
    std::vector<double> asked; ///< times for which a velocity was asked, each once
    std::uint64_t hash = 0;
    std::uint64_t unreached = 0;
    std::uint64_t held = 0;
    std::size_t events = 0;
    std::uint32_t threads = 0;   ///< most that were used, by a division in place
    std::uint32_t submeshes = 0; ///< of its first colour, most
    std::vector<std::string> problems;
};

/// With one thread, the mesh is validated after every step, and the edits are replayed at the end.
[[nodiscard]] Outcome run_row(const Row& row, const Scene& scene, const Manner& manner);

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
// One run of a row, from the first complex to the last.
#pragma once

#include "combinations/scene.h"
#include "shapes/outline.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dsc::combinations {

/// The manner in which a row is run; the result must not depend on it.
struct Manner {
    std::uint32_t threads = 1;
    /// After a third of the steps, the run is archived and read into another simulation.
    bool is_resumed = false;
    /// Without the row's interruption.
    bool is_unbroken = false;
};

/// The shapes of a complex, by phase.
struct Shapes {
    std::vector<std::vector<scenes::Outline>> outlines;
    std::vector<double> areas;
};

/// The results of a run.
struct Outcome {
    Shapes first;
    Shapes middle; ///< after half of the steps
    Shapes last;
    std::vector<double>
        times; ///< at which sub-steps began; the sub-steps of a step have equal length
    std::vector<double> asked; ///< times at which a velocity was evaluated, each once
    std::uint64_t hash = 0;
    std::uint64_t unreached = 0;
    std::uint64_t held = 0;
    std::size_t events = 0;
    std::uint32_t threads = 0;   ///< largest number used, by a division in place
    std::uint32_t submeshes = 0; ///< largest number of the first colour
    std::vector<std::string> problems;
};

/// With one thread, the mesh is validated after every step, and the edits are replayed at the end.
[[nodiscard]] Outcome run_row(const Row& row, const Scene& scene, const Manner& manner);

} // namespace dsc::combinations

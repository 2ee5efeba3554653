// SPDX-License-Identifier: MIT
// Meshes of a run as a series of files that ParaView and plots/mesh/frames.py can read.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/io/vtu.h"
#include "dsc/topology/events.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dsc::scenes {

class Frames {
public:
    /// An empty folder name: no frames. Creates the folder; throws InputError, before anything has
    /// run, if it is not writable.
    Frames(std::string folder, std::string name, int count, int steps, std::optional<int> half);

    /// Writes a frame if this step has one, and returns its path; otherwise returns an empty path.
    /// Throws FileError.
    template <class Real>
    std::string write(int step, double time, const Complex<Real>& complex);
    /// Writes the collection, and the events beside it if there are any.
    void finish(std::span<const Event> events) const;

private:
    [[nodiscard]] bool is_due(int step) const;

    std::string folder_;
    std::string name_;
    int count_;
    int steps_;
    std::optional<int> half_;
    std::vector<PvdEntry> entries_;
};

} // namespace dsc::scenes

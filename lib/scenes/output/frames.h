// SPDX-License-Identifier: MIT
// Meshes of a run as a series of files that ParaView and plots/frames.py can read.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/complex/complex.h"
#include "dsc/io/pictures.h"
#include "scenes/output/pictures.h"
#include "scenes/scene.h"
#include "topology/events.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dsc::scenes {

/// The steps with a frame: those of `every` and of `times`; if neither is given, about `count`
/// evenly spread ones, and the step half-way. The first and the last step also have a frame, except
/// with `times` alone.
struct FramePlan {
    std::string folder{}; ///< empty: no frames
    int count = 9;
    int every = 0;               ///< steps; 0: not by steps
    std::vector<double> times{}; ///< each time has a frame at the first step that reaches it
    Layers layers{};             ///< layers of pictures (.svg) of the frames; empty: none
};

/// Throws InputError for a time outside the run.
void check_times(const FramePlan& plan, const Setup& setup);

/// True if the step has a frame; step 0 is the start. O(times).
[[nodiscard]] bool is_frame_due(const FramePlan& plan, const Setup& setup, int step);

/// The frames of a run; the setup must outlive them.
class Frames {
public:
    /// Creates the folder. Throws InputError if the folder is not writable, and like check_times.
    Frames(FramePlan plan, std::string name, const Setup& setup);

    [[nodiscard]] bool is_due(int step) const { return is_frame_due(plan_, setup_, step); }
    /// The path of a step's frame, without the extension.
    [[nodiscard]] std::string path_of(int step) const;
    /// Adds a frame, whose .vtu the caller writes, to the collection; returns its path without the
    /// extension.
    std::string enter(int step, double time);
    /// Writes the mesh with these additional arrays, and its picture if the plan has layers.
    /// Returns the path of the mesh. Throws FileError.
    template <class Real>
    std::string write(int step, double time, const Complex<Real>& complex,
                      std::span<const VtuArray> more);
    /// Writes the collection, and a file of the events if there are any.
    void finish(std::span<const Event> events) const;

    /// Writes or reads the list of frames so far, for checkpoints.
    void archive(Archive& archive);

private:
    [[nodiscard]] std::string collection() const; ///< its path

    FramePlan plan_;
    const Setup& setup_;
    std::string name_;
    std::vector<std::pair<double, std::string>> entries_; ///< time and file name of each
};

} // namespace dsc::scenes

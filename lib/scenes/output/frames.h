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

/// Which steps have a frame: those of `every` and of `times` together; where neither is given,
/// about `count`, evenly spread, and the step half-way. With `times` alone only they have one;
/// otherwise the first and the last step do as well.
struct FramePlan {
    std::string folder{}; ///< empty: no frames
    int count = 9;
    int every = 0;               ///< steps; 0: not by steps
    std::vector<double> times{}; ///< each at the first step that reaches it
    Layers layers{};             ///< of the pictures (.svg) beside them; empty: none
};

/// Throws InputError for a time that is not within the run.
void check_times(const FramePlan& plan, const Setup& setup);

/// True if the step has a frame; step 0 is the start. O(times).
[[nodiscard]] bool is_frame_due(const FramePlan& plan, const Setup& setup, int step);

/// Of a run of a setup, which must outlive them.
class Frames {
public:
    /// Creates the folder; throws InputError, before anything has run, if it is not writable, or
    /// where check_times does.
    Frames(FramePlan plan, std::string name, const Setup& setup);

    [[nodiscard]] bool is_due(int step) const { return is_frame_due(plan_, setup_, step); }
    /// The path of a step's frame, without the ending.
    [[nodiscard]] std::string path_of(int step) const;
    /// Notes a frame, of which a .vtu is to be written; returns its path without the ending.
    std::string enter(int step, double time);
    /// Writes the mesh, with these arrays beside its own, and its picture, if it is asked for.
    /// Returns the path of the mesh. Throws FileError.
    template <class Real>
    std::string write(int step, double time, const Complex<Real>& complex,
                      std::span<const VtuArray> more);
    /// Writes the collection, and the events beside it if there are any.
    void finish(std::span<const Event> events) const;

    /// The frames so far, for a run that goes on from a checkpoint.
    void archive(Archive& archive);

private:
    [[nodiscard]] std::string collection() const; ///< its path

    FramePlan plan_;
    const Setup& setup_;
    std::string name_;
    std::vector<std::pair<double, std::string>> entries_; ///< time and file name of each
};

} // namespace dsc::scenes

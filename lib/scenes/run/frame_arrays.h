// SPDX-License-Identifier: MIT
// Additional arrays of a frame: motion of vertices, target lengths of edges, and submeshes of
// triangles.
#pragma once

#include "dsc/io/pictures.h"
#include "dsc/motion/integrator.h"
#include "dsc/parallel/partition/partition.h"

#include <vector>

namespace dsc::scenes {

/// Stores the positions of vertices before a step in an attribute of the complex, so that new
/// vertices get interpolated ones. `end_displacements` removes it. O(n).
template <class Real>
void begin_displacements(Complex<Real>& complex);
template <class Real>
void end_displacements(Complex<Real>& complex);

template <class Real>
struct FrameView {
    const dsc::Velocity<Real>* velocity = nullptr; ///< null: the velocity of the last step
    Real time = 0;                                 ///< time at which the velocity is evaluated
    Real dt = 0;                                   ///< of the last step
    Real edge_length = 0;
    bool is_uniform = true;               ///< whether all edges have that target length
    const Partition* partition = nullptr; ///< null: not divided
};

/// `velocity` and `displacement` (of the last step; 0 before the first) of each vertex; `size` (the
/// target length of its edges, the mean of its corners') and `submesh` (of the first colour; -1 in
/// none) of each triangle. O(n).
template <class Real>
[[nodiscard]] std::vector<VtuArray> frame_arrays(Complex<Real>& complex,
                                                 const FrameView<Real>& view);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// What a frame shows beside the mesh: how vertices move, how long edges ought to be, and which
// submesh a triangle lies in.
#pragma once

#include "dsc/io/pictures.h"
#include "dsc/motion/integrator.h"
#include "dsc/parallel/partition/partition.h"

#include <vector>

namespace dsc::scenes {

/// Where vertices were before a step: an attribute of the complex, so that new vertices know where
/// on their edge they would have been. To be removed by `end_displacements`. O(n).
template <class Real>
void begin_displacements(Complex<Real>& complex);
template <class Real>
void end_displacements(Complex<Real>& complex);

template <class Real>
struct FrameView {
    const dsc::Velocity<Real>* velocity = nullptr; ///< null: that of the last step
    Real time = 0;                                 ///< at which the velocity is asked for
    Real dt = 0;                                   ///< of the last step
    Real edge_length = 0;
    bool is_uniform = true;               ///< all edges are of that length
    const Partition* partition = nullptr; ///< null: not divided
};

/// `velocity` and `displacement` (of the last step; 0 before the first) of each vertex; `size` (the
/// target length of its edges, the mean of its corners') and `submesh` (of the first colour; -1 in
/// none) of each triangle. O(n).
template <class Real>
[[nodiscard]] std::vector<VtuArray> frame_arrays(Complex<Real>& complex,
                                                 const FrameView<Real>& view);

} // namespace dsc::scenes

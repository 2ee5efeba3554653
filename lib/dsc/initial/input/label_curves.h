// SPDX-License-Identifier: MIT
// The boundaries between the grains of a label image as smooth curves that meet at junctions.
//
// A boundary runs through the middles of the sides between pixels of two labels, and begins and
// ends at corners where more than two grains meet, or at a side of the image. Each point moves
// within a diamond about its original position: the diamonds of all sides of pixels are disjoint,
// so boundaries cannot meet. Within the diamonds boundaries are smoothed, and then moved sideways
// until each grain has the area of its pixels, including pixels that touched it only at a corner
// and were given to a neighbour.
#pragma once

#include "dsc/initial/input/label_regions.h"

namespace dsc::initial {

/// The curves of an image, for `initial_complex`; `given` is the image before small grains were
/// dropped. O(n log n) for n pixels.
[[nodiscard]] std::vector<Curve> curves_of(const LabelImage& image, const LabelImage& given,
                                           const Rectangle& domain);

} // namespace dsc::initial

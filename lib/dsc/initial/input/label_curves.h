// SPDX-License-Identifier: MIT
// The boundaries between the grains of a label image as smooth curves that meet at junctions.
//
// A boundary runs through the middles of the sides between pixels of two labels, and begins and
// ends at corners where more than two grains meet, or at a side of the image. Each point moves
// within a diamond about its place: the diamonds of all sides of pixels are apart, so that
// boundaries that stay in theirs cannot meet. Within the diamonds they are smoothed, and then
// moved sideways until each grain has the area of its pixels, those included that hung on it by a
// corner alone and were given to a neighbour.
#pragma once

#include "dsc/initial/input/label_regions.h"

namespace dsc::initial {

/// The curves of an image, for `initial_complex`; `given` is what it was before small grains were
/// dropped. O(n log n) for n pixels.
[[nodiscard]] std::vector<Curve> curves_of(const LabelImage& image, const LabelImage& given,
                                           const Rectangle& domain);

} // namespace dsc::initial

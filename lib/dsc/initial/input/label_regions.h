// SPDX-License-Identifier: MIT
// The grains of a label image, and the merging of small ones.
#pragma once

#include "dsc/initial/label_image.h"

#include <cstdint>
#include <vector>

namespace dsc::initial {

/// The grain of each pixel, in the order of the labels.
struct Grains {
    std::vector<std::uint32_t> of_pixel;
    std::vector<std::size_t> pixels; ///< by grain
};

[[nodiscard]] Grains grains_of(const LabelImage& image);

/// Gives grains to their neighbours that have fewer pixels than `LabelImage::min_pixels`, or are
/// smaller than `min_size`, a length. O(n) for n pixels in each of a few rounds.
void drop_small_grains(LabelImage& image, const Point<double>& pixel, double min_size,
                       InputReport& report);

} // namespace dsc::initial

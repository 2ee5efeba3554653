// SPDX-License-Identifier: MIT
// The boundaries between the grains of a label image, along the sides of its pixels.
#pragma once

#include "dsc/initial/input/label_regions.h"

#include <cstdint>
#include <vector>

namespace dsc::initial {

/// A point of a boundary: its original and its current position, in pixels from the lower left
/// corner.
struct Site {
    enum class Kind : std::uint8_t { side_of_pixels, junction, end };

    Point<double> first;
    Point<double> place;
    Kind kind = Kind::side_of_pixels;
    std::uint32_t neighbours_begin = 0;
    std::uint32_t neighbours = 0;
    bool slides_upright = false; ///< an end on the left or the right side of the image
};

/// A boundary from one end to the other; a closed one repeats its first site.
struct Boundary {
    std::vector<std::uint32_t> sites;
    std::uint32_t left = 0; ///< grains
    std::uint32_t right = 0;
    Phase left_phase = 0;
    Phase right_phase = 0;
    double first_area = 0; ///< the integral of x dy along the sides of the pixels
};

/// All boundaries of an image.
struct Boundaries {
    std::vector<Site> sites;
    std::vector<Boundary> boundaries;
};

/// Follows the sides between pixels of two labels from node to node: the corners where more than
/// two sides meet, and those at the sides of the image. O(n) for n pixels.
[[nodiscard]] Boundaries trace_boundaries(const LabelImage& image, const Grains& grains);

} // namespace dsc::initial

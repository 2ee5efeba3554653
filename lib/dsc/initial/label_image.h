// SPDX-License-Identifier: MIT
// The first complex from an image whose pixels are numbers of phases, as made by segmentation or
// electron backscatter diffraction.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <cstddef>
#include <vector>

namespace dsc {

/// Pixels of phases. Pixels of one phase that share a side belong to one grain.
struct LabelImage {
    std::size_t rows = 0;      ///< of pixels
    std::size_t columns = 0;   ///< of pixels
    std::vector<Phase> labels; ///< row by row from the top
    /// Grains of fewer pixels are merged into the neighbour with which they share the longest
    /// border.
    std::size_t min_pixels = 0;
};

/// Triangulates `domain`, over which the image is spread, with the boundaries between pixels of
/// different phases as its interface.
///
/// Boundaries are smoothed: their points move by less than half a pixel from the middles of the
/// pixels' sides, junctions by less than half a pixel from corners of pixels, and ends slide along
/// the sides of the domain. Each grain keeps the area of its pixels, to about 1e-6 of it before
/// detail finer than the mesh is left out. `Detail::thin` also merges grains smaller than 0.2 edge
/// lengths into their neighbours. `InputReport::dropped` counts merged grains.
///
/// Time and memory: O(n log n) for n pixels, and those of the complex of curves. The same image
/// gives bitwise identical results.
///
/// \throw InputError where the image has no pixels or too many, the number of labels does not fit,
/// a label is reserved, or `initial_complex` refuses the domain or the options.
template <class Real>
Complex<Real> initial_complex(const Rectangle& domain, const LabelImage& image,
                              const InitialOptions& options = {}, InputReport* report = nullptr);

} // namespace dsc

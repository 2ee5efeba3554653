// SPDX-License-Identifier: MIT
// A partition that the application supplies: a function from places to submesh numbers, one for
// each colour. It divides the plane, not the vertices, so that it stays valid while vertices are
// created, deleted and moved. Voronoi regions (thesis, section 6) are such a function.
#pragma once

#include "dsc/parallel/partition/partition.h"

#include <functional>

namespace dsc {

/// One colour: `number_of(x, y)` is below `submeshes`, always the same for the same place, and safe
/// to call from several threads. Two submeshes of one colour may touch; a colour's boundaries
/// should lie away from those of the colours before it.
struct PlaceColour {
    /// The number of the submesh that holds a place.
    std::function<std::uint32_t(double x, double y)> number_of;
    std::uint32_t submeshes = 1; ///< how many there are
};

/// Called at construction of the executor, and then every `recut` steps: gets the interface,
/// returns the colours.
template <class Real>
using PlaceFunction = std::function<std::vector<PlaceColour>(const PartitionInput<Real>& input)>;

/// Divides by the function of the application.
template <class Real>
class PlacePartitioner final : public Partitioner<Real> {
public:
    /// Calls the function every `recut` steps.
    explicit PlacePartitioner(PlaceFunction<Real> function, std::uint32_t recut = 64);
    /// All colours every `recut` steps.
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    /// Throws InputError if the function returns no colour, or one without a submesh.
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    PlaceFunction<Real> function_;
    std::uint32_t recut_;
    std::vector<PlaceColour> colours_; // regions point to these
};

/// Voronoi regions of points (thesis, section 6): the submesh of a place is the number of the
/// nearest point, the lower number in a tie. O(1) expected per look-up.
PlaceColour voronoi_colour(std::vector<Point<double>> sites);

/// The same for sites that are chosen by the interface: k-means of its vertices (Lloyd's algorithm,
/// `rounds` times, from vertices evenly spread along the list). These are the "springs" of the
/// thesis, section 6, which even out the submeshes. The second colour's sites lie in the middle
/// between neighbouring sites of the first.
template <class Real>
std::vector<PlaceColour> voronoi_colours(const PartitionInput<Real>& input, std::uint32_t submeshes,
                                         int rounds = 8);

} // namespace dsc

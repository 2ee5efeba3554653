// SPDX-License-Identifier: MIT
// Submeshes by a function of the position: one of the application, or Voronoi regions (thesis,
// section 6). The function divides the plane, not the vertices, so that it stays valid while
// vertices are created, deleted and moved.
#pragma once

#include "dsc/parallel/partition/partition.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace dsc {

/// One colour: `number_of(x, y)` is below `submeshes`, always the same for the same point, and safe
/// to call from several threads. Two submeshes of one colour may touch; a colour's boundaries
/// should lie away from those of the colours before it.
struct PlaceColour {
    /// The number of the submesh that contains a point.
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

} // namespace dsc

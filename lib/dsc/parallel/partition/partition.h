// SPDX-License-Identifier: MIT
// The interface for submeshing (thesis, section 6): the way in which the mesh is divided is one
// object, which an application can replace. A partition has colours (thesis, section 6.1); the
// regions of one colour are disjoint and run at the same time; what the boundaries of one colour
// kept from being done is handed to the next, and what all of them left is done serially.
#pragma once

#include "dsc/complex/submesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace dsc {

/// The submeshes of one colour. Their regions must be disjoint, and together cover the plane.
struct Colour {
    std::vector<Region> regions; ///< disjoint

    /// The region that holds a vertex at (x, y); tries `hint` first. regions.size() if there is
    /// none. O(regions), O(1) if the hint is right. A place function that the regions share is
    /// called once.
    [[nodiscard]] std::size_t locate(std::uint32_t vertex, double x, double y,
                                     std::size_t hint = 0) const {
        const Region* asked = nullptr; // the last region whose place function was called...
        std::uint32_t number = 0;      // ...and what it returned
        const auto owns = [&](const Region& region) {
            if (region.kind != Region::Kind::places) {
                return region.owns(vertex, x, y);
            }
            if (asked == nullptr || asked->place != region.place ||
                asked->context != region.context) {
                asked = &region;
                number = region.place(region.context, x, y);
            }
            return number == region.label;
        };
        if (hint < regions.size() && owns(regions[hint])) {
            return hint;
        }
        // Usually the regions are in the order of their numbers.
        if (asked != nullptr && number < regions.size() && owns(regions[number])) {
            return number;
        }
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (owns(regions[i])) {
                return i;
            }
        }
        return regions.size();
    }
};

/// All colours, in the order in which they run.
struct Partition {
    std::vector<Colour> colours; ///< at least one
};

/// When to divide anew.
enum class Recut : std::uint8_t {
    none,
    later, ///< the colours after the first; the interface lists of the submeshes stay
    all,
};

/// What a partitioner may base its decision on. All of it is the same for any number of threads.
struct PartitionStatus {
    std::uint64_t step = 0;             ///< steps done so far; 0: there is no partition yet
    std::uint64_t steps_since_all = 0;  ///< steps since the first colour was cut
    std::size_t interface_vertices = 0; ///< now
};

/// What a partitioner divides.
template <class Real>
struct PartitionInput {
    const Complex<Real>& complex;             ///< between two steps
    std::span<const std::uint32_t> interface; ///< roughly in the order of the curve
    std::span<const float> work; ///< of each of them in the previous steps, in any unit
    double edge_length;          ///< the target
};

/// A way to divide. Called by the executor only between steps, by one thread.
template <class Real>
class Partitioner {
public:
    virtual ~Partitioner() = default;
    Partitioner() = default;
    Partitioner(const Partitioner&) = delete;
    Partitioner& operator=(const Partitioner&) = delete;
    Partitioner(Partitioner&&) = delete;
    Partitioner& operator=(Partitioner&&) = delete;

    /// Whether the partition in force is to be replaced before the next step.
    [[nodiscard]] virtual Recut is_due(const PartitionStatus& status) const = 0;
    /// Divides; regions may point to what the partitioner holds. Must not depend on threads.
    virtual void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) = 0;
    /// What it remembers from one division to the next (base/archive.h); nothing by default.
    virtual void archive(Archive& /*archive*/) {}
};

} // namespace dsc

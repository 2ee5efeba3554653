// SPDX-License-Identifier: MIT
// Submeshing (thesis, section 6): the object that divides the mesh, which an application can
// replace; and the library's own division into cells. A partition has colours (thesis, section
// 6.1); the regions of one colour are disjoint and run at the same time; what the boundaries of one
// colour prevent is deferred to the next, and what all colours defer is done serially.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/submesh.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// The submeshes of one colour, which run at the same time. Their regions must be disjoint, and
/// together cover the plane.
struct Colour {
    std::vector<Region> regions; ///< disjoint

    /// The region that holds a vertex at (x, y); tries `hint` first. regions.size() if there is
    /// none. O(regions), O(1) if the hint is right.
    [[nodiscard]] std::size_t locate(std::uint32_t vertex, double x, double y,
                                     std::size_t hint = 0) const {
        const auto owns = [&](const Region& region) { return region.owns(vertex, x, y); };
        if (hint < regions.size() && owns(regions[hint])) {
            return hint;
        }
        return static_cast<std::size_t>(std::ranges::find_if(regions, owns) - regions.begin());
    }
};

/// All colours, in the order in which they run.
struct Partition {
    std::vector<Colour> colours; ///< at least one
};

/// Which colours to divide again.
enum class Recut : std::uint8_t {
    none,
    later, ///< the colours after the first; the interface lists of the submeshes stay
    all,
};

/// The data on which a partitioner may base its decisions, the same for any number of threads.
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
    std::span<const float> work; ///< work of each vertex in the previous steps, in any unit
    double edge_length;          ///< the target
};

/// A way to divide. Called by the executor only between steps, by one thread.
template <class Real>
class Partitioner : public Unmovable {
public:
    virtual ~Partitioner() = default;

    /// Whether the current partition must be replaced before the next step.
    [[nodiscard]] virtual Recut is_due(const PartitionStatus& status) const = 0;
    /// Divides; regions may refer to data of the partitioner. Must not depend on threads.
    virtual void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) = 0;
    /// Archives the state that it keeps between divisions (base/archive.h); nothing by default.
    virtual void archive(Archive& /*archive*/) {}
};

/// Throws InputError for a region that an application's function or a list of labels defines, which
/// cannot be archived. Boxes of any frame can.
void archive(Archive& archive, Region& region);
void archive(Archive& archive, Colour& colour);
void archive(Archive& archive, Partition& partition);
inline void archive(Archive& archive, PartitionStatus& status) {
    std::uint64_t vertices = status.interface_vertices;
    archive(status.step, status.steps_since_all, vertices);
    status.interface_vertices = static_cast<std::size_t>(vertices);
}

// --- cells ---------------------------------------------------------------------------------------
// Cells follow the interface: the plane is halved repeatedly, each time where there are few
// interface vertices, until each cell has its share of them. Vertices near the cuts go to cells of
// a second colour, which is cut in the same way for these vertices alone, so that its cuts run
// where the first colour left no work; vertices near the cuts of both colours go to a third. The
// work is at the interface, and so are the cells, whereas slabs over the whole mesh are mostly
// empty.

/// Options of cells.
struct CellOptions {
    /// Cells of the first colour; 0: as many as pay off, by the length of the interface. Fewer if
    /// they would be too small.
    std::uint32_t submeshes = 0;
    std::uint32_t min_vertices = 20; ///< smaller cells are not worth their boundaries
    double min_width = 6;            ///< in edge lengths
    double band = 4;          ///< in edge lengths: vertices nearer to a cut go to the second colour
    std::uint32_t recut = 32; ///< steps between two divisions of the first colour
    std::uint32_t recut_later = 16; ///< and of the later ones
};

/// A point with work.
struct Site {
    double x; ///< in units of the domain
    double y;
    float weight; ///< its share of the work, in any unit
};

/// Cells of equal shares of the interface's work.
template <class Real>
class CellPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError if an option is out of range.
    explicit CellPartitioner(const CellOptions& options);
    /// The first colour every `recut` steps, the later ones every `recut_later`.
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;

private:
    CellOptions options_;
    std::vector<Site> sites_;
};

} // namespace dsc

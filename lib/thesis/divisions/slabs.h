// SPDX-License-Identifier: MIT
// The slabbing method (thesis, sections 6.3 and 8.5) in place: a slab is an interval of positions
// along a direction; nothing is copied. Red slabs run first, then black ones shifted by half a
// slab; the first and the last black slab form one submesh.
#pragma once

#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"

#include <span>
#include <utility>
#include <vector>

namespace dsc {

/// The measure by which the cuts between slabs are chosen.
enum class Slabbing : std::uint8_t {
    fixed,    ///< equal widths (thesis, section 6.3)
    counting, ///< equal numbers of triangles (the same section), sampled in a large mesh
    active,   ///< equal shares of the work in the last steps
};

/// How slabs are cut.
struct SlabOptions {
    Slabbing slabbing = Slabbing::counting; ///< how the cuts are chosen
    std::uint32_t submeshes = 8; ///< number of red slabs; independent of the number of threads
    /// The slabs are cut across this direction, in degrees from the x axis; follow_shape: across
    /// the direction in which the interface extends farthest.
    double degrees = 0;
    bool follow_shape = false; ///< cuts across the direction of the shape instead of `degrees`
    /// In edge lengths. Thinner slabs would be locked completely; fewer slabs are used instead.
    double min_width = 8;
    std::uint32_t recut = 64; ///< steps between two choices of the cuts
};

/// Cuts along a direction: slab i is [cuts[i], cuts[i + 1]); the outer cuts are infinite.
struct Cuts {
    std::vector<double> red;   ///< of the first colour
    std::vector<double> black; ///< in the middle of the red slabs, by the same measure
};

/// Cuts such that each slab holds the same share of the weight, none thinner than `min_width`.
/// Reorders the positions, each a pair of place and weight. O(n log n).
Cuts cuts_of_equal_share(std::vector<std::pair<double, float>>& positions, std::uint32_t slabs,
                         double min_width);

/// Cuts of equal width over [low, high].
Cuts cuts_of_equal_width(double low, double high, std::uint32_t slabs, double min_width);

/// The colour of slabs along the normal: slab i is [cuts[i], cuts[i + 1]), and the outer cuts are
/// infinite. `round`: the first and the last form one submesh.
Colour slab_colour(std::span<const double> cuts, double normal_x, double normal_y, bool round);

/// Slabs of two colours.
template <class Real>
class SlabPartitioner final : public Partitioner<Real> {
public:
    /// Throws InputError if an option is out of range.
    explicit SlabPartitioner(const SlabOptions& options);
    /// Both colours every `recut` steps.
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override;
    void divide(const PartitionInput<Real>& input, Recut recut, Partition& partition) override;
    void archive(Archive& archive) override { archive(extent_of_, low_, high_, corners_); }

private:
    void find_extent(const Complex<Real>& complex, const Point<double>& normal);

    SlabOptions options_;
    Point<double> extent_of_ = Point<double>::Zero(); // the normal that these belong to
    double low_ = 0;
    double high_ = 0;
    std::vector<Point<double>> corners_; // of the domain's hull; of `follow_shape` alone
};

/// Vertical slabs of equal width: `Parallel{.division = &fixed_division}`.
extern const Division fixed_division;
/// Vertical slabs of equal numbers of triangles.
extern const Division counting_division;
/// Vertical slabs of equal work.
extern const Division active_division;

} // namespace dsc

// SPDX-License-Identifier: MIT
// The slabbing method [6.3, 8.5] in place: a slab is an interval of positions, nothing is copied.
// Red slabs, then black ones shifted by half a slab, whose first and last form one submesh.
#pragma once

#include "dsc/complex/submesh.h"

#include <span>
#include <string_view>
#include <vector>

namespace dsc {

/// How the cuts between slabs are chosen.
enum class Slabbing : std::uint8_t {
    fixed,    ///< equal widths [6.3]
    counting, ///< equal numbers of triangles, counted anew every `SlabOptions::recount` steps [6.3]
    active,   ///< equal numbers of interface vertices, each step
};

[[nodiscard]] constexpr std::string_view to_string(Slabbing slabbing) {
    switch (slabbing) {
    case Slabbing::fixed: return "fixed";
    case Slabbing::counting: return "counting";
    case Slabbing::active: return "active";
    }
    return "unknown";
}

struct SlabOptions {
    Slabbing slabbing = Slabbing::counting;
    std::uint32_t submeshes = 8; ///< how many red slabs; independent of the number of threads
    std::uint32_t threads = 1;
    double normal_x = 1; ///< the slabs are cut across this direction (unit length)
    double normal_y = 0;
    double least_width =
        8; ///< in edge lengths; thinner slabs would be locked altogether: fewer then
    std::uint32_t recount = 64; ///< steps between two counts of the triangles
};

/// The cuts of one colouring: red slab i is [cuts[i], cuts[i + 1]); the outer cuts are infinite.
/// Black cuts lie in the middle (by the same measure) of the red slabs.
struct Cuts {
    std::vector<double> red;
    std::vector<double> black;

    [[nodiscard]] std::size_t red_count() const { return red.size() - 1; }
    [[nodiscard]] std::size_t black_count() const { return black.size() - 1; }
};

/// Cuts such that each slab holds the same share of `positions` (along the normal), none thinner
/// than `least_width`; reorders `positions`. O(n log n).
Cuts cuts_of_equal_share(std::vector<double>& positions, std::uint32_t slabs, double least_width);

/// Cuts of equal width over [low, high].
Cuts cuts_of_equal_width(double low, double high, std::uint32_t slabs, double least_width);

/// The slab that holds position s. O(log slabs).
std::size_t slab_of(std::span<const double> cuts, double s);

/// The region of slab i between these cuts.
Region slab_region(std::span<const double> cuts, std::size_t i, double normal_x, double normal_y);

} // namespace dsc

// SPDX-License-Identifier: MIT
// Random small valid complexes for the tests, with all cases that operations must handle. The same
// seed gives the same complex on every machine.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "dsc/complex/complex.h"

#include <cstdint>
#include <vector>

namespace dsc::test {

/// A sequence of random numbers that is the same everywhere, unlike the distributions of <random>.
/// S. Vigna's splitmix64.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits();
    /// 0 to `bound` - 1.
    std::uint32_t below(std::uint32_t bound);
    /// [0, 1).
    double unit();
    bool chance(double probability) { return unit() < probability; }

private:
    std::uint64_t state_;
};

enum class PhasePattern : std::uint8_t {
    exterior,  ///< only the exterior phase
    interior,  ///< one other phase: the whole domain boundary is interface
    clustered, ///< patches, as in a simulation
    salt,      ///< a random phase for each triangle: junctions everywhere
};
inline constexpr std::array phase_pattern_names{
    Named{PhasePattern::exterior, "exterior"},
    Named{PhasePattern::interior, "interior"},
    Named{PhasePattern::clustered, "clustered"},
    Named{PhasePattern::salt, "salt"},
};

struct RandomComplexOptions {
    std::uint32_t points = 20;
    /// Coordinates are integers in [0, grid): many collinear and cocircular points, and midpoints
    /// that are exact even in float. 0: real numbers in [0, 1).
    std::uint32_t grid = 0;
    /// With a grid: shifts it so far from the origin that there is no number between its points.
    /// Midpoints are then rounded to grid points, and operations that would be legal may invert
    /// triangles.
    bool at_resolution = false;
    PhasePattern pattern = PhasePattern::clustered;
    std::uint32_t phases = 3;
    double holes = 0.1; ///< fraction of the triangles whose removal is tried
    std::uint32_t scramble =
        60;              ///< random flips, splits and collapses: high and low degrees, free ids
    double locked = 0.1; ///< fraction of locked vertices
};

/// A random triangulation of a convex domain, with holes and random edits. Always valid; some ids
/// may be free, and some vertices may have no triangles.
template <class Real>
Complex<Real> random_complex(std::uint64_t seed, const RandomComplexOptions& options);

/// Options drawn at random: every pattern, grids and real numbers, 3 to `max_points` points.
RandomComplexOptions random_options(std::uint64_t seed, std::uint32_t max_points = 30);

/// Owners of vertices: 1 if the submesh owns the vertex, otherwise 0; by id, `vertex_bound()`
/// entries. The submesh is one side of a line, a disc, or a random set of most vertices.
template <class Real>
std::vector<std::uint32_t> random_labels(std::uint64_t seed, const Complex<Real>& complex);

} // namespace dsc::test

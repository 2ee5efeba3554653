// SPDX-License-Identifier: MIT
// Grains, which are the components of phases, and how fast they grow. Where interfaces move by
// their curvature and meet in threes at 120 degrees, the growth of a grain depends only on how many
// sides it has: dA/dt = M pi / 3 (n - 6), with the multiplier M of the curvature (J. von Neumann,
// "Metal interfaces", 1952; W. W. Mullins, "Two-dimensional motion of idealized grain boundaries",
// 1956). In a grain with holes, each hole adds six, as the curve around it turns the other way.
#pragma once

#include "dsc/complex/complex.h"

#include <span>
#include <vector>

namespace dsc::scenes {

struct Grain {
    Phase phase = exterior_phase;
    double area = 0;            ///< domain units^2
    Point<double> centre{0, 0}; ///< of its area
    std::uint32_t sides = 0;    ///< how often the neighbour changes along its outlines
    std::uint32_t holes = 0;
    bool touches_border = false; ///< then the law above does not hold for it

    friend bool operator==(const Grain&, const Grain&) = default;
};

/// The grains of all phases, in the order of the smallest triangle of each. O(triangles).
template <class Real>
[[nodiscard]] std::vector<Grain> measure_grains(const Complex<Real>& complex);

struct GrainStatistics {
    std::uint64_t count = 0;
    double mean_area = 0; ///< domain units^2; 0 without a grain
    /// At position n: how many grains have n sides. Those that touch the border are left out.
    std::vector<std::uint64_t> with_sides = {};
};

/// The statistics of all grains. O(grains).
[[nodiscard]] GrainStatistics summarise(std::span<const Grain> grains);

/// The law of von Neumann and Mullins: domain units^2 per unit of time. `multiplier`: the speed of
/// an interface over its curvature.
[[nodiscard]] double growth_by_sides(const Grain& grain, double multiplier = 1);

struct GrainGrowth {
    Grain grain;         ///< as it was before
    double rate = 0;     ///< measured: domain units^2 per unit of time
    double expected = 0; ///< by the law of von Neumann and Mullins
    /// The difference, relative to the expected rate; with six sides, where that is 0, to the rate
    /// with seven.
    double error_rel = 0;
};

struct GrowthOptions {
    double duration = 0;   ///< between the two moments; above 0
    double multiplier = 1; ///< speed of an interface over its curvature; above 0
};

/// The growth of the grains that exist at both moments, touch the border at neither and have the
/// same sides and holes at both, in the order of `before`. A grain is recognised by its phase; of
/// several in one phase, the two whose centres are nearest to each other are the same. O(sum of the
/// squares of the numbers of grains in a phase). Throws InputError for options out of range.
[[nodiscard]] std::vector<GrainGrowth> measure_growth(std::span<const Grain> before,
                                                      std::span<const Grain> after,
                                                      const GrowthOptions& options);

struct GrowthFigures {
    std::uint64_t count = 0;
    double median_error_rel = 0;      ///< NaN without a grain, like the next two
    double nine_tenths_error_rel = 0; ///< nine tenths of the grains have at most this
    double worst_error_rel = 0;
};

/// The errors of all grains. O(grains log grains).
[[nodiscard]] GrowthFigures summarise(std::span<const GrainGrowth> growth);

} // namespace dsc::scenes

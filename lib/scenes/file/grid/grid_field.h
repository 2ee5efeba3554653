// SPDX-License-Identifier: MIT
// A velocity field given on a regular grid, at one time or several: measured winds, the result of
// another program.
#pragma once

#include "flows/velocity.h"

#include "dsc/base/types.h"
#include "dsc/initial/initial_complex.h"

#include <memory>

namespace dsc::scenes {

/// Between the points of the grid. Both are continuous; the derivatives of `cubic` are too.
enum class GridInterpolation : std::uint8_t {
    linear, ///< bilinear: second order
    cubic,  ///< bicubic, by the four nearest in each direction (Catmull and Rom): third order
};

inline constexpr std::array grid_interpolation_names{
    Named{GridInterpolation::linear, "linear"},
    Named{GridInterpolation::cubic, "cubic"},
};

/// The values on the grid: for each time, for each row from low to high y, for each column from low
/// to high x.
struct GridValues {
    Rectangle box{};         ///< its corners are points of the grid
    std::size_t columns = 0; ///< 2 or more, as the next
    std::size_t rows = 0;
    std::vector<double> times{0};            ///< ascending; one: the field is steady
    std::vector<Point<double>> velocities{}; ///< times * rows * columns
};

/// A Velocity. Linear in time; before the first and after the last time, and outside the box, the
/// nearest value counts. O(1) for each position, and O(log times) for each batch. Copies share the
/// values, and may be called from several threads.
class GridField {
public:
    /// Throws InputError, naming `where`, for a grid whose parts do not fit together.
    GridField(GridValues values, GridInterpolation interpolation, const std::string& where);

    void operator()(std::span<const Point<double>> positions, double time,
                    std::span<Point<double>> velocities) const;

private:
    std::shared_ptr<const GridValues> values_;
    GridInterpolation interpolation_;
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "scenes/file/grid/grid_field.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc::scenes {

namespace {

/// The four points around a place in one direction, and their weights; of `linear`, two count.
struct GridStencil {
    std::array<std::size_t, 4> at{};
    std::array<double, 4> weight{};
};

GridStencil grid_stencil(double place, std::size_t count, GridInterpolation interpolation) {
    // Written so that NaN becomes the first point; the caller sees to it that it stays NaN.
    const double last = static_cast<double>(count - 1);
    const double inside = place > 0 ? std::min(place, last) : 0.0;
    const auto cell = std::min(static_cast<std::size_t>(inside), count - 2);
    const double s = inside - static_cast<double>(cell);
    GridStencil stencil;
    stencil.at = {cell > 0 ? cell - 1 : 0, cell, cell + 1, std::min(cell + 2, count - 1)};
    if (interpolation == GridInterpolation::linear) {
        stencil.weight = {0, 1 - s, s, 0};
    } else {
        // Catmull and Rom, "A class of local interpolating splines" (1974).
        stencil.weight = {0.5 * s * (s * (2 - s) - 1), 0.5 * (s * s * (3 * s - 5) + 2),
                          0.5 * s * (s * (4 - 3 * s) + 1), 0.5 * s * s * (s - 1)};
    }
    return stencil;
}

/// Two times and how far between them.
struct GridMoment {
    std::size_t before;
    std::size_t after;
    double fraction;
};

GridMoment grid_moment(const std::vector<double>& times, double time) {
    const auto next = std::ranges::upper_bound(times, time);
    if (next == times.begin()) {
        return {0, 0, 0};
    }
    const auto before = static_cast<std::size_t>(next - times.begin()) - 1;
    if (next == times.end()) {
        return {before, before, 0};
    }
    return {before, before + 1, (time - times[before]) / (*next - times[before])};
}

Point<double> on_grid(const GridValues& grid, std::size_t moment, const GridStencil& x,
                      const GridStencil& y) {
    Point<double> sum(0, 0);
    for (std::size_t j = 0; j < 4; ++j) {
        const std::size_t row = (moment * grid.rows + y.at[j]) * grid.columns;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += y.weight[j] * x.weight[i] * grid.velocities[row + x.at[i]];
        }
    }
    return sum;
}

} // namespace

GridField::GridField(GridValues values, GridInterpolation interpolation, const std::string& where)
    : interpolation_(interpolation) {
    const auto refuse = [&](const std::string& what, std::size_t value,
                            const std::string& allowed) {
        throw InputError(
            {.what = what, .where = where, .value = std::to_string(value), .allowed = allowed});
    };
    if (values.columns < 2 || values.rows < 2) {
        refuse("grid too small", std::min(values.columns, values.rows),
               "2 points each way, or more");
    }
    if (values.times.empty() || !std::ranges::is_sorted(values.times, std::ranges::less_equal{})) {
        refuse("times out of order", values.times.size(), "ascending times");
    }
    const std::size_t points = values.times.size() * values.rows * values.columns;
    if (values.velocities.size() != points) {
        refuse("number of values", values.velocities.size(),
               std::to_string(points) + ": times * rows * columns");
    }
    if (!((values.box.high - values.box.low).minCoeff() > 0)) {
        refuse("box without area", 0, "low below and to the left of high");
    }
    values_ = std::make_shared<const GridValues>(std::move(values));
}

void GridField::operator()(std::span<const Point<double>> positions, double time,
                           std::span<Point<double>> velocities) const {
    const GridValues& grid = *values_;
    const GridMoment moment = grid_moment(grid.times, time);
    const Point<double> scale(
        static_cast<double>(grid.columns - 1) / (grid.box.high.x() - grid.box.low.x()),
        static_cast<double>(grid.rows - 1) / (grid.box.high.y() - grid.box.low.y()));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Point<double> place = (positions[i] - grid.box.low).cwiseProduct(scale);
        const GridStencil x = grid_stencil(place.x(), grid.columns, interpolation_);
        const GridStencil y = grid_stencil(place.y(), grid.rows, interpolation_);
        Point<double> velocity = on_grid(grid, moment.before, x, y);
        if (moment.after != moment.before) {
            velocity += moment.fraction * (on_grid(grid, moment.after, x, y) - velocity);
        }
        // A position that is NaN has no velocity.
        velocities[i] = place.allFinite() ? velocity : Point<double>(place * NAN);
    }
}

} // namespace dsc::scenes

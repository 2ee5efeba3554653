// SPDX-License-Identifier: MIT
#include "thesis/divisions/site_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dsc {

namespace {

constexpr double infinitely_far = std::numeric_limits<double>::infinity();

/// Positions in the grid, and squared distances, are accurate to a few units of rounding of their
/// own size; a margin of a thousand times that costs nothing.
constexpr double rounding = 1e-12;

/// This many sites are searched faster than a cell is found.
constexpr std::size_t few = 8;

bool is_finite(const Point<double>& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }

} // namespace

SiteGrid::SiteGrid(std::vector<Point<double>> sites) : sites_(std::move(sites)) {
    Point<double> low(infinitely_far, infinitely_far);
    Point<double> high(-infinitely_far, -infinitely_far);
    for (const auto& site : sites_) {
        if (is_finite(site)) {
            low = low.cwiseMin(site);
            high = high.cwiseMax(site);
        }
    }
    const Point<double> extent = high - low;
    const auto count = static_cast<double>(sites_.size());
    // Sites along a line get a row of cells, not a square in which all but the diagonal is empty.
    const double width =
        std::max(std::sqrt(extent.x()) * std::sqrt(extent.y() / count), extent.maxCoeff() / count);
    // A single cell if the extent is zero, or too large or too small to divide by.
    if (width > std::numeric_limits<double>::min() && std::isfinite(extent.sum())) {
        low_ = low;
        width_ = width;
        columns_ = static_cast<std::int64_t>(extent.x() / width) + 1;
        rows_ = static_cast<std::int64_t>(extent.y() / width) + 1;
    }
    // Sites are counted first, then filled in; within a cell they are in the order of their
    // numbers.
    first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const auto& site : sites_) {
        if (is_finite(site)) {
            ++first_[cell_of(site) + 1];
        }
    }
    for (std::size_t cell = 1; cell < first_.size(); ++cell) {
        first_[cell] += first_[cell - 1];
    }
    members_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
        if (is_finite(sites_[i])) {
            members_[next[cell_of(sites_[i])]++] = static_cast<std::uint32_t>(i);
        }
    }
}

std::size_t SiteGrid::cell_of(const Point<double>& site) const {
    const auto within = [this](double offset, std::int64_t cells) {
        return static_cast<std::int64_t>(
            std::clamp(offset / width_, 0.0, static_cast<double>(cells - 1)));
    };
    return static_cast<std::size_t>(within(site.y() - low_.y(), rows_) * columns_ +
                                    within(site.x() - low_.x(), columns_));
}

void SiteGrid::search_cell(std::int64_t column, std::int64_t row, const Point<double>& from,
                           Best& best) const {
    const auto cell = static_cast<std::size_t>(row * columns_ + column);
    for (std::uint32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
        const std::uint32_t site = members_[k];
        const double squared = (sites_[site] - from).squaredNorm();
        if (squared < best.squared || (squared == best.squared && site < best.site)) {
            best = {site, squared};
        }
    }
}

// The smallest squared distance from a place to anything in the cells not yet searched; the place
// is in units of cells. Infinite if all cells have been seen.
double SiteGrid::squared_way_out(const Block& seen, double column, double row) const {
    const auto columns = static_cast<double>(columns_);
    const auto rows = static_cast<double>(rows_);
    const double slack = rounding * (std::abs(column) + std::abs(row) + columns + rows);
    const auto square = [&](double cells) {
        const double length = std::max(cells - slack, 0.0) * width_;
        return length * length;
    };
    // For a place outside the grid, the distance to the grid is added.
    const double beside_grid = square(std::max(-column, column - columns));
    const double above_grid = square(std::max(-row, row - rows));
    double smallest = infinitely_far;
    const auto look_at = [&](bool is_open, double cells, double aside) {
        if (is_open) {
            smallest = std::min(smallest, square(cells) + aside);
        }
    };
    look_at(seen.left > 0, column - static_cast<double>(seen.left), above_grid);
    look_at(seen.right + 1 < columns_, static_cast<double>(seen.right + 1) - column, above_grid);
    look_at(seen.bottom > 0, row - static_cast<double>(seen.bottom), beside_grid);
    look_at(seen.top + 1 < rows_, static_cast<double>(seen.top + 1) - row, beside_grid);
    return smallest * (1 - rounding);
}

std::uint32_t SiteGrid::nearest(double x, double y) const {
    const Point<double> from(x, y);
    Best best{0, infinitely_far};
    const double column = (x - low_.x()) / width_;
    const double row = (y - low_.y()) / width_;
    if (sites_.size() <= few || !std::isfinite(column) || !std::isfinite(row)) {
        for (std::uint32_t i = 0; i < sites_.size(); ++i) {
            const double squared = (sites_[i] - from).squaredNorm();
            if (squared < best.squared) {
                best = {i, squared};
            }
        }
        return best.site;
    }
    const auto cell = [](double place, std::int64_t cells) {
        return static_cast<std::int64_t>(std::clamp(place, 0.0, static_cast<double>(cells - 1)));
    };
    const std::int64_t i = cell(column, columns_);
    const std::int64_t j = cell(row, rows_);
    Block seen{i, i, j, j};
    search_cell(i, j, from, best);
    // Searches frames of cells around it, until nothing nearer can lie outside.
    for (std::int64_t r = 1; !(squared_way_out(seen, column, row) > best.squared); ++r) {
        const Block before = seen;
        seen = {std::max<std::int64_t>(i - r, 0), std::min(i + r, columns_ - 1),
                std::max<std::int64_t>(j - r, 0), std::min(j + r, rows_ - 1)};
        if (seen.left == before.left && seen.right == before.right &&
            seen.bottom == before.bottom && seen.top == before.top) {
            break; // that was the whole grid
        }
        for (std::int64_t b = seen.bottom; b <= seen.top; ++b) {
            for (std::int64_t a = seen.left; a <= seen.right; ++a) {
                if (b >= before.bottom && b <= before.top && a == before.left) {
                    a = before.right; // skip the cells searched already
                } else {
                    search_cell(a, b, from, best);
                }
            }
        }
    }
    return best.site;
}

} // namespace dsc

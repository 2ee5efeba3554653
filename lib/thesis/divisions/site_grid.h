// SPDX-License-Identifier: MIT
// The nearest of many points, found with a uniform grid: Voronoi regions need it once for each
// vertex of each star.
#pragma once

#include "dsc/base/types.h"

#include <cstdint>
#include <vector>

namespace dsc {

/// Points in a grid of about one point per cell. Reading is thread-safe.
class SiteGrid {
public:
    /// O(points).
    explicit SiteGrid(std::vector<Point<double>> sites);

    /// The number of the point nearest to (x, y) by the distance as computed in floating point, the
    /// lower number in a tie: exactly the result of a search through all points. 0 if no distance
    /// is finite. O(1) expected if the points are spread evenly and (x, y) lies among them,
    /// O(points) at worst.
    [[nodiscard]] std::uint32_t nearest(double x, double y) const;

    [[nodiscard]] const std::vector<Point<double>>& sites() const { return sites_; }

private:
    struct Best {
        std::uint32_t site;
        double squared;
    };
    struct Block { // of cells, both ends included
        std::int64_t left, right, bottom, top;
    };

    [[nodiscard]] std::size_t cell_of(const Point<double>& site) const;
    void search_cell(std::int64_t column, std::int64_t row, const Point<double>& from,
                     Best& best) const;
    [[nodiscard]] double squared_way_out(const Block& seen, double column, double row) const;

    std::vector<Point<double>> sites_;
    Point<double> low_ = Point<double>::Zero();
    double width_ = 1; ///< of a cell
    std::int64_t columns_ = 1;
    std::int64_t rows_ = 1;
    std::vector<std::uint32_t> first_; ///< by cell, into members_
    std::vector<std::uint32_t> members_;
};

} // namespace dsc

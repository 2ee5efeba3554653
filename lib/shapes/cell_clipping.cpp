// SPDX-License-Identifier: MIT
#include "shapes/cell_clipping.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc::scenes {

namespace {

// Sites in a uniform grid of about one site to a cell of the grid.
class SiteBuckets {
public:
    SiteBuckets(const Rectangle& domain, std::span<const Point<double>> sites) : low_(domain.low) {
        const Point<double> size = domain.high - domain.low;
        const auto count = static_cast<double>(sites.size());
        // At most about one grid cell to a site, however long and thin the domain is.
        width_ = std::max(std::sqrt(size.x() / count * size.y()), size.maxCoeff() / count);
        columns_ = 1 + static_cast<std::int64_t>(size.x() / width_);
        rows_ = 1 + static_cast<std::int64_t>(size.y() / width_);
        first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
        for (const Point<double>& site : sites) {
            ++first_[bucket(column_of(site), row_of(site)) + 1];
        }
        for (std::size_t k = 1; k < first_.size(); ++k) {
            first_[k] += first_[k - 1];
        }
        members_.resize(sites.size());
        std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
        for (std::uint32_t i = 0; i < sites.size(); ++i) {
            members_[place[bucket(column_of(sites[i]), row_of(sites[i]))]++] = i;
        }
    }

    [[nodiscard]] double width() const { return width_; }

    // Visits the sites in the ring of buckets at this distance; false if there are no such buckets.
    template <class Visit>
    bool visit_ring(const Point<double>& from, std::int64_t ring, Visit visit) const {
        const std::int64_t column = column_of(from);
        const std::int64_t row = row_of(from);
        bool any = false;
        for (std::int64_t y = std::max<std::int64_t>(row - ring, 0);
             y <= std::min(row + ring, rows_ - 1); ++y) {
            // Only the two ends of the rows between the first and the last one.
            const bool whole = y == row - ring || y == row + ring;
            for (std::int64_t x = column - ring; x <= column + ring;
                 x += whole || ring == 0 ? 1 : 2 * ring) {
                if (x < 0 || x >= columns_) {
                    continue;
                }
                any = true;
                for (std::uint32_t k = first_[bucket(x, y)]; k < first_[bucket(x, y) + 1]; ++k) {
                    visit(members_[k]);
                }
            }
        }
        return any;
    }

private:
    [[nodiscard]] std::int64_t column_of(const Point<double>& p) const {
        return std::min(static_cast<std::int64_t>((p.x() - low_.x()) / width_), columns_ - 1);
    }
    [[nodiscard]] std::int64_t row_of(const Point<double>& p) const {
        return std::min(static_cast<std::int64_t>((p.y() - low_.y()) / width_), rows_ - 1);
    }
    [[nodiscard]] std::size_t bucket(std::int64_t column, std::int64_t row) const {
        return static_cast<std::size_t>(row * columns_ + column);
    }

    Point<double> low_;
    double width_ = 1;
    std::int64_t columns_ = 1;
    std::int64_t rows_ = 1;
    std::vector<std::uint32_t> first_; // by bucket, into members_
    std::vector<std::uint32_t> members_;
};

// Cuts away the part that is nearer to another site. Returns whether there was such a part.
bool clip(ClippedCell& cell, const Point<double>& to_other, std::uint32_t other,
          ClippedCell& scratch) {
    const double half = to_other.squaredNorm() / 2;
    const auto excess = [&](const Point<double>& p) { return to_other.dot(p) - half; };
    if (std::none_of(cell.corners.begin(), cell.corners.end(),
                     [&](const auto& p) { return excess(p) > 0; })) {
        return false;
    }
    scratch.corners.clear();
    scratch.beyond.clear();
    const std::size_t n = cell.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Point<double>& p = cell.corners[k];
        const Point<double>& q = cell.corners[k + 1 < n ? k + 1 : 0];
        const double at_p = excess(p);
        const double at_q = excess(q);
        if (at_p <= 0) {
            scratch.corners.push_back(p);
            scratch.beyond.push_back(cell.beyond[k]);
        }
        if ((at_p <= 0) != (at_q <= 0)) {
            scratch.corners.emplace_back(p + at_p / (at_p - at_q) * (q - p));
            scratch.beyond.push_back(at_p <= 0 ? other : cell.beyond[k]);
        }
    }
    std::swap(cell, scratch);
    return true;
}

double squared_radius(const ClippedCell& cell) {
    double radius = 0;
    for (const Point<double>& p : cell.corners) {
        radius = std::max(radius, p.squaredNorm());
    }
    return radius;
}

std::string site_name(std::size_t site) { return "site " + std::to_string(site); }

void check_sites(const Rectangle& domain, std::span<const Point<double>> sites) {
    const Point<double> size = domain.high - domain.low;
    if (!size.allFinite() || !(size.minCoeff() > 0) || !std::isfinite(size.prod())) {
        throw InputError({.what = "the rectangle is empty or out of range",
                          .where = "domain",
                          .value = to_text(domain.low) + " to " + to_text(domain.high),
                          .allowed = "low below high in x and y, and an area that is finite"});
    }
    require(sites.size() < bottom_side, "number of sites", static_cast<double>(sites.size()),
            "fewer than " + to_text(bottom_side));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Point<double>& s = sites[i];
        const bool inside =
            (s.array() >= domain.low.array()).all() && (s.array() <= domain.high.array()).all();
        if (!inside) { // a NaN is not inside either
            throw InputError(
                {.what = "the site is not in the domain",
                 .where = site_name(i),
                 .value = to_text(s),
                 .allowed = "points in " + to_text(domain.low) + " to " + to_text(domain.high)});
        }
    }
}

} // namespace

Point<double> centroid(std::span<const Point<double>> corners) {
    double area = 0;
    Point<double> moment = Point<double>::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        // Relative to the first corner, so that an offset of the coordinates costs no digits.
        const Point<double> p = corners[k] - corners[0];
        const Point<double> q = corners[k + 1 < corners.size() ? k + 1 : 0] - corners[0];
        const double cross = p.x() * q.y() - p.y() * q.x();
        area += cross;
        moment += cross * (p + q);
    }
    return corners[0] + moment / (3 * area);
}

std::vector<ClippedCell> clip_cells(const Rectangle& domain, std::span<const Point<double>> sites) {
    check_sites(domain, sites);
    std::vector<ClippedCell> cells;
    if (sites.empty()) {
        return cells;
    }
    cells.reserve(sites.size());
    const SiteBuckets buckets(domain, sites);
    ClippedCell scratch;
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const Point<double> low = domain.low - sites[i];
        const Point<double> high = domain.high - sites[i];
        ClippedCell cell{{low, {high.x(), low.y()}, high, {low.x(), high.y()}},
                         {bottom_side, right_side, top_side, left_side}};
        double reach = 4 * squared_radius(cell); // a site farther than two radii cuts nothing
        const auto visit = [&](std::uint32_t j) {
            const Point<double> to_other = sites[j] - sites[i];
            const double squared = to_other.squaredNorm();
            if (j == i || squared > reach) {
                return;
            }
            const bool apart = squared > 0;
            if (apart && clip(cell, to_other, j, scratch)) {
                reach = 4 * squared_radius(cell);
            }
            if (!apart || cell.corners.size() < 3) {
                throw InputError({.what = "two sites coincide or nearly do",
                                  .where = site_name(std::min(i, j)),
                                  .value = to_text(sites[i]) + ", as " + site_name(std::max(i, j)),
                                  .allowed = "sites that are apart"});
            }
        };
        // Sites beyond ring r are farther away than r times the width of a bucket.
        for (std::int64_t ring = 0; buckets.visit_ring(sites[i], ring, visit); ++ring) {
            const double seen = static_cast<double>(ring) * buckets.width();
            if (seen * seen > reach) {
                break;
            }
        }
        cells.push_back(std::move(cell));
        scratch = {};
    }
    return cells;
}

} // namespace dsc::scenes

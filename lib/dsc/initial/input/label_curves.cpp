// SPDX-License-Identifier: MIT
#include "dsc/initial/input/label_curves.h"

#include "dsc/geometry/points.h"
#include "dsc/initial/input/label_tracing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dsc::initial {

namespace {

/// The half diagonal of the diamond in which a point may move, in pixels; at 0.5 diamonds touch.
constexpr double half_diamond = 0.45;
/// Smoothing (G. Taubin, "A signal processing approach to fair surface design", 1995): points move
/// to the middle of their neighbours, and then back from it by a little more, so that only waves
/// shorter than about thirty points vanish, and corners and circles do not shrink.
constexpr int smoothing_steps = 60;
constexpr double shrinking = 0.5;
constexpr double swelling = -1 / (1 / shrinking - 0.02);
/// Two arms of a junction with a smaller angle between them are moved back to their original
/// positions.
constexpr double min_angle = 20 * std::numbers::pi / 180;
/// Rounds of area correction; each leaves about a tenth of the error.
constexpr int area_rounds = 12;
/// Areas need no correction below this, in pixels.
constexpr double enough_area = 1e-6;

class Smoothing {
public:
    /// `owed`: the area by which each grain is to grow, in pixels.
    Smoothing(std::vector<Site>& sites, const std::vector<Boundary>& boundaries, double right_side,
              std::vector<double> owed)
        : sites_(sites), boundaries_(boundaries), right_side_(right_side), owed_(std::move(owed)),
          grains_(owed_.size()) {
        for (const Boundary& boundary : boundaries) {
            for (std::size_t i = 1; i < boundary.sites.size(); ++i) {
                ++sites_[boundary.sites[i - 1]].neighbours;
                ++sites_[boundary.sites[i]].neighbours;
            }
        }
        std::uint32_t total = 0;
        for (Site& site : sites_) {
            site.neighbours_begin = total;
            total += std::exchange(site.neighbours, 0);
        }
        neighbours_.resize(total);
        for (const Boundary& boundary : boundaries) {
            for (std::size_t i = 1; i < boundary.sites.size(); ++i) {
                join(boundary.sites[i - 1], boundary.sites[i]);
                join(boundary.sites[i], boundary.sites[i - 1]);
            }
        }
    }

    void run() {
        for (int step = 0; step < smoothing_steps; ++step) {
            smooth(shrinking);
            smooth(swelling);
        }
        open_junctions();
        for (int round = 0; round < area_rounds && correct_areas(); ++round) {
        }
        open_junctions();
    }

private:
    void join(std::uint32_t one, std::uint32_t other) {
        neighbours_[sites_[one].neighbours_begin + sites_[one].neighbours++] = other;
    }

    // Moves a site as close to `place` as its diamond and its side of the image allow.
    static void move(Site& site, Point<double> place) {
        if (site.kind == Site::Kind::end) {
            const int held = site.slides_upright ? 0 : 1;
            place[held] = site.first[held];
        }
        const Point<double> way = place - site.first;
        const double length = way.cwiseAbs().sum();
        site.place = length > half_diamond
                         ? Point<double>(site.first + way * (half_diamond / length))
                         : place;
    }

    // Moves each site by a share of the way to the middle of its neighbours.
    void smooth(double share) {
        std::vector<Point<double>> targets(sites_.size());
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            const Site& site = sites_[i];
            Point<double> sum(0, 0);
            for (std::uint32_t k = 0; k < site.neighbours; ++k) {
                sum += sites_[neighbours_[site.neighbours_begin + k]].place;
            }
            targets[i] = site.place + share * (sum / site.neighbours - site.place);
        }
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            move(sites_[i], targets[i]);
        }
    }

    // Whether arms leave a junction in the same order as at the start, and no two in nearly the
    // same direction.
    [[nodiscard]] bool is_open(const Site& site) const {
        std::vector<std::array<double, 2>> arms;
        for (std::uint32_t k = 0; k < site.neighbours; ++k) {
            const Site& arm = sites_[neighbours_[site.neighbours_begin + k]];
            const Point<double> first = arm.first - site.first;
            const Point<double> now = arm.place - site.place;
            arms.push_back({std::atan2(first.y(), first.x()), std::atan2(now.y(), now.x())});
        }
        std::ranges::sort(arms);
        double turn = 0;
        for (std::uint32_t k = 0; k < site.neighbours; ++k) {
            double angle = arms[(k + 1) % site.neighbours][1] - arms[k][1];
            angle += angle < 0 ? 2 * std::numbers::pi : 0;
            if (angle < min_angle) {
                return false;
            }
            turn += angle;
        }
        return turn < 3 * std::numbers::pi; // once around
    }

    // Moves junctions with too small angles, and the sites beside them, back to their original
    // positions.
    void open_junctions() {
        constexpr int max_rounds = 60; // each halves the distance to the original position
        for (int round = 0; round < max_rounds; ++round) {
            bool any = false;
            for (Site& site : sites_) {
                if (site.kind != Site::Kind::junction || is_open(site)) {
                    continue;
                }
                any = true;
                site.place = midpoint(site.place, site.first);
                for (std::uint32_t k = 0; k < site.neighbours; ++k) {
                    Site& arm = sites_[neighbours_[site.neighbours_begin + k]];
                    arm.place = midpoint(arm.place, arm.first);
                }
            }
            if (!any) {
                return;
            }
        }
    }

    // The area on the left of a boundary minus that of the pixels. The sides of the image belong to
    // the outlines of grains: along the right one, x is not 0.
    [[nodiscard]] double area_gained(const Boundary& boundary) const {
        double area = -boundary.first_area;
        for (std::size_t i = 1; i < boundary.sites.size(); ++i) {
            const Point<double>& a = sites_[boundary.sites[i - 1]].place;
            const Point<double>& b = sites_[boundary.sites[i]].place;
            area += (a.x() + b.x()) / 2 * (b.y() - a.y());
        }
        const auto slid = [&](std::uint32_t id) {
            const Site& site = sites_[id];
            const bool is_on_right = site.kind == Site::Kind::end && site.first.x() == right_side_;
            return is_on_right ? right_side_ * (site.place.y() - site.first.y()) : 0;
        };
        return area + slid(boundary.sites.front()) - slid(boundary.sites.back());
    }

    // Moves boundaries sideways so that each grain gets its area: the area that crosses a boundary
    // is its length times the difference of two numbers, one for the grain on each side. The
    // numbers solve Poisson's equation on the graph of the grains, by conjugate gradients. Returns
    // whether there was anything to correct.
    bool correct_areas() {
        std::vector<double> missing = owed_;
        std::vector<double> length;
        for (const Boundary& boundary : boundaries_) {
            const double gained = area_gained(boundary);
            missing[boundary.left] -= gained;
            missing[boundary.right] += gained;
            length.push_back(static_cast<double>(boundary.sites.size()));
        }
        if (std::ranges::none_of(missing, [](double m) { return std::abs(m) > enough_area; })) {
            return false;
        }
        const std::vector<double> numbers = solve(missing, length);
        for (std::size_t k = 0; k < boundaries_.size(); ++k) {
            const Boundary& boundary = boundaries_[k];
            shift(boundary, length[k] * (numbers[boundary.left] - numbers[boundary.right]));
        }
        return true;
    }

    // The equation has a solution only if the residual has no sum. Its sum is not 0 but rounding,
    // so conjugate gradients stop well above rounding: beyond it the numbers would grow for ever.
    [[nodiscard]] std::vector<double> solve(std::vector<double> residual,
                                            const std::vector<double>& length) const {
        constexpr double enough = 1e-3; // of the residual that is left for the next round
        const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
            double sum = 0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                sum += a[i] * b[i];
            }
            return sum;
        };
        std::vector<double> diagonal(grains_, 0);
        for (std::size_t k = 0; k < boundaries_.size(); ++k) {
            diagonal[boundaries_[k].left] += length[k];
            diagonal[boundaries_[k].right] += length[k];
        }
        const auto divided = [&](const std::vector<double>& a) {
            std::vector<double> quotient(a.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                quotient[i] = diagonal[i] > 0 ? a[i] / diagonal[i] : 0;
            }
            return quotient;
        };
        std::vector<double> numbers(grains_, 0);
        std::vector<double> direction = divided(residual);
        double size = dot(residual, direction);
        const double smallest = enough * enough * size;
        for (std::size_t step = 0; step < 2 * grains_ && size > smallest; ++step) {
            std::vector<double> image(grains_, 0);
            for (std::size_t k = 0; k < boundaries_.size(); ++k) {
                const Boundary& boundary = boundaries_[k];
                const double flow =
                    length[k] * (direction[boundary.left] - direction[boundary.right]);
                image[boundary.left] += flow;
                image[boundary.right] -= flow;
            }
            const double curvature = dot(direction, image);
            if (!(curvature > 0)) { // only rounding remains
                break;
            }
            const double share = size / curvature;
            for (std::size_t i = 0; i < grains_; ++i) {
                numbers[i] += share * direction[i];
                residual[i] -= share * image[i];
            }
            const std::vector<double> next = divided(residual);
            const double before = std::exchange(size, dot(residual, next));
            for (std::size_t i = 0; i < grains_; ++i) {
                direction[i] = next[i] + size / before * direction[i];
            }
        }
        return numbers;
    }

    // Moves a boundary to its right, less beside its ends, so that the grain on its left gains this
    // area.
    void shift(const Boundary& boundary, double area) {
        const std::vector<std::uint32_t>& ids = boundary.sites;
        const std::size_t count = ids.size();
        const bool is_closed = sites_[ids.front()].kind == Site::Kind::side_of_pixels;
        std::vector<Point<double>> way(count, Point<double>(0, 0)); // by which area grows most
        double growth = 0;
        for (std::size_t i = is_closed ? 0 : 1; i + 1 < count; ++i) {
            const Point<double>& before = sites_[ids[i == 0 ? count - 2 : i - 1]].place;
            const Point<double> along = sites_[ids[i + 1]].place - before;
            const auto from_end = static_cast<double>(std::min(i, count - 1 - i));
            const double share = is_closed ? 1 : std::min(1.0, from_end / 3);
            way[i] = share * Point<double>(along.y(), -along.x()) / 2;
            growth += way[i].squaredNorm() / share;
        }
        if (growth > 0) {
            for (std::size_t i = 0; i < count; ++i) {
                Site& site = sites_[ids[i]];
                if (site.kind == Site::Kind::side_of_pixels && (i + 1 < count || !is_closed)) {
                    move(site, site.place + way[i] * (area / growth));
                }
            }
        }
    }

    std::vector<Site>& sites_;
    const std::vector<Boundary>& boundaries_;
    double right_side_;
    std::vector<double> owed_; // by grain
    std::size_t grains_;
    std::vector<std::uint32_t> neighbours_;
};

// A grain that touched pixels only at a corner, and lost them, is owed their area.
std::vector<double> owed_areas(const LabelImage& image, const Grains& grains,
                               const LabelImage& given) {
    std::vector<double> owed(grains.pixels.size(), 0);
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        if (image.labels[i] == given.labels[i]) {
            continue;
        }
        const std::size_t row = i / image.columns;
        const std::size_t column = i % image.columns;
        for (std::size_t k = 0; k < 9; ++k) {
            const std::size_t r = row + k / 3 - 1; // beyond all rows if it is above the first
            const std::size_t c = column + k % 3 - 1;
            if (r < image.rows && c < image.columns &&
                image.labels[r * image.columns + c] == given.labels[i]) {
                owed[grains.of_pixel[r * image.columns + c]] += 1;
                owed[grains.of_pixel[i]] -= 1;
                break;
            }
        }
    }
    return owed;
}

} // namespace

std::vector<Curve> curves_of(const LabelImage& image, const LabelImage& given,
                             const Rectangle& domain) {
    const Grains grains = grains_of(image);
    Boundaries found = trace_boundaries(image, grains);
    const Point<double> size(static_cast<double>(image.columns), static_cast<double>(image.rows));
    Smoothing(found.sites, found.boundaries, size.x(), owed_areas(image, grains, given)).run();
    const Point<double> pixel = (domain.high - domain.low).cwiseQuotient(size);
    std::vector<Curve> curves;
    for (const Boundary& boundary : found.boundaries) {
        Curve& curve = curves.emplace_back();
        curve.left = boundary.left_phase;
        curve.right = boundary.right_phase;
        for (const std::uint32_t id : boundary.sites) {
            const Site& site = found.sites[id];
            Point<double> p = domain.low + site.place.cwiseProduct(pixel);
            if (site.kind == Site::Kind::end) { // exactly on its side
                const int axis = site.slides_upright ? 0 : 1;
                p[axis] = site.first[axis] == 0 ? domain.low[axis] : domain.high[axis];
            }
            curve.points.push_back(p);
        }
    }
    return curves;
}

} // namespace dsc::initial

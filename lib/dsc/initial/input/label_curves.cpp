// SPDX-License-Identifier: MIT
#include "dsc/initial/input/label_curves.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::initial {

namespace {

/// The half diagonal of the diamond in which a point may move, in pixels; at 0.5 diamonds touch.
constexpr double half_diamond = 0.45;
/// Smoothing (G. Taubin, "A signal processing approach to fair surface design", 1995): points move
/// to the middle of their neighbours, and then back from it by a little more, so that only waves
/// shorter than about thirty points vanish, and corners and circles are not drawn in.
constexpr int smoothing_steps = 60;
constexpr double shrinking = 0.5;
constexpr double swelling = -1 / (1 / shrinking - 0.02);
/// Two arms of a junction that are closer to each other in direction than this are drawn back.
constexpr double least_angle = 20 * std::numbers::pi / 180;
/// Rounds of making areas right; each leaves about a tenth of the error.
constexpr int area_rounds = 12;

/// A point of a boundary: where it began, and where it is, in pixels from the lower left corner.
struct Site {
    enum class Kind : std::uint8_t { side_of_pixels, junction, end };

    Point<double> first;
    Point<double> place;
    Kind kind = Kind::side_of_pixels;
    std::uint32_t neighbours_begin = 0;
    std::uint32_t neighbours = 0;
    bool slides_upright = false; ///< an end, along the left or the right side of the image
};

/// A boundary from one end to the other; a closed one repeats its first site.
struct Boundary {
    std::vector<std::uint32_t> sites;
    std::uint32_t left = 0; ///< grains
    std::uint32_t right = 0;
    Phase left_phase = 0;
    Phase right_phase = 0;
    double first_area = 0; ///< the integral of x dy along the sides of the pixels
};

// Directions are counted counter-clockwise from that of x.
constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

constexpr int opposite(int way) { return (way + 2) % 4; }

class Tracing {
public:
    Tracing(const LabelImage& image, const Grains& grains)
        : image_(image), grains_(grains), columns_(static_cast<int>(image.columns)),
          rows_(static_cast<int>(image.rows)),
          done_((image.columns + 1) * (image.rows + 1) * 2, 0) {}

    void run() {
        const std::size_t corners = (image_.columns + 1) * (image_.rows + 1);
        node_at_.assign(corners, no_id);
        for (int y = 0; y <= rows_; ++y) {
            for (int x = 0; x <= columns_; ++x) {
                if (is_node(x, y)) {
                    for (int way = 0; way < 4; ++way) {
                        follow(x, y, way);
                    }
                }
            }
        }
        for (int y = 0; y <= rows_; ++y) {
            for (int x = 0; x <= columns_; ++x) {
                follow(x, y, 0); // a closed boundary has sides that are level
            }
        }
    }

    std::vector<Site> sites;
    std::vector<Boundary> boundaries;

private:
    // Of the pixel above and to the right of a corner.
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(rows_ - 1 - y) * image_.columns +
               static_cast<std::size_t>(x);
    }
    // The pixels on the left and on the right of a way from a corner; none if it leads outside or
    // along the side of the image.
    [[nodiscard]] std::optional<std::array<std::size_t, 2>> beside(int x, int y, int way) const {
        // From the corner to the pixels around it, counter-clockwise from the upper right one.
        constexpr std::array<std::array<int, 2>, 4> around{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        std::array<std::size_t, 2> found{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& [dx, dy] = around[(static_cast<std::size_t>(way) + 3 * i) % 4];
            if (x + dx < 0 || x + dx >= columns_ || y + dy < 0 || y + dy >= rows_) {
                return std::nullopt;
            }
            found[i] = pixel(x + dx, y + dy);
        }
        return found;
    }
    [[nodiscard]] bool leads(int x, int y, int way) const {
        const auto pixels = beside(x, y, way);
        return pixels && image_.labels[(*pixels)[0]] != image_.labels[(*pixels)[1]];
    }
    [[nodiscard]] bool is_node(int x, int y) const {
        int arms = 0;
        for (int way = 0; way < 4; ++way) {
            arms += leads(x, y, way) ? 1 : 0;
        }
        return arms != 0 && arms != 2;
    }
    // The way on from a corner that is no node, for one who comes by the way that leads to it.
    [[nodiscard]] int next_way(int x, int y, int way) const {
        for (int other = 0; other < 4; ++other) {
            if (other != opposite(way) && leads(x, y, other)) {
                return other;
            }
        }
        return opposite(way);
    }
    [[nodiscard]] std::uint8_t& done(int x, int y, int way) {
        const int left = way == 2 ? x - 1 : x;
        const int low = way == 3 ? y - 1 : y;
        const auto corner =
            static_cast<std::size_t>(low) * (image_.columns + 1) + static_cast<std::size_t>(left);
        return done_[2 * corner + static_cast<std::size_t>(way % 2)];
    }

    std::uint32_t node(int x, int y) {
        std::uint32_t& id = node_at_[static_cast<std::size_t>(y) * (image_.columns + 1) +
                                     static_cast<std::size_t>(x)];
        if (id == no_id) {
            const bool is_upright = x == 0 || x == columns_;
            const bool is_end = is_upright || y == 0 || y == rows_;
            id = add({x, y}, is_end ? Site::Kind::end : Site::Kind::junction);
            sites[id].slides_upright = is_upright;
        }
        return id;
    }
    std::uint32_t add(const Point<double>& place, Site::Kind kind) {
        sites.push_back({.first = place, .place = place, .kind = kind});
        return static_cast<std::uint32_t>(sites.size() - 1);
    }

    void follow(int x, int y, int way) {
        if (!leads(x, y, way) || done(x, y, way) != 0) {
            return;
        }
        Boundary& boundary = boundaries.emplace_back();
        const auto pixels = *beside(x, y, way);
        boundary.left = grains_.of_pixel[pixels[0]];
        boundary.right = grains_.of_pixel[pixels[1]];
        boundary.left_phase = image_.labels[pixels[0]];
        boundary.right_phase = image_.labels[pixels[1]];
        if (is_node(x, y)) {
            boundary.sites.push_back(node(x, y));
        }
        while (done(x, y, way) == 0) {
            done(x, y, way) = 1;
            const auto& [dx, dy] = ways[static_cast<std::size_t>(way)];
            boundary.first_area += x * dy;
            boundary.sites.push_back(add({x + 0.5 * dx, y + 0.5 * dy}, Site::Kind::side_of_pixels));
            x += dx;
            y += dy;
            if (is_node(x, y)) {
                boundary.sites.push_back(node(x, y));
                return;
            }
            way = next_way(x, y, way);
        }
        boundary.sites.push_back(boundary.sites.front());
    }

    const LabelImage& image_;
    const Grains& grains_;
    int columns_;
    int rows_;
    std::vector<std::uint8_t> done_;     // by corner: the sides to its right, and above it
    std::vector<std::uint32_t> node_at_; // by corner
};

class Smoothing {
public:
    Smoothing(std::vector<Site>& sites, const std::vector<Boundary>& boundaries, double right_side,
              std::size_t grains)
        : sites_(sites), boundaries_(boundaries), right_side_(right_side), grains_(grains) {
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
        for (int round = 0; round < area_rounds; ++round) {
            correct_areas();
        }
        open_junctions();
    }

private:
    void join(std::uint32_t one, std::uint32_t other) {
        neighbours_[sites_[one].neighbours_begin + sites_[one].neighbours++] = other;
    }

    // As near to `place` as the site may be.
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

    // Arms leave a junction in the same order as at the start, and no two in about one direction.
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
            if (angle < least_angle) {
                return false;
            }
            turn += angle;
        }
        return turn < 3 * std::numbers::pi; // once around
    }

    // Draws junctions that are not open, and the sites beside them, back to where they began.
    void open_junctions() {
        constexpr int most_rounds = 60; // halves what is far from its beginning in each
        for (int round = 0; round < most_rounds; ++round) {
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

    // By how much the area on the left of a boundary is larger than that of the pixels. The sides
    // of the image belong to the outlines of grains: along the right one, x is not 0.
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

    // Moves boundaries sideways so that each grain gets its area: what crosses a boundary is its
    // length times the difference of two numbers of the grains on both sides. The numbers solve
    // Poisson's equation on the graph of the grains, by conjugate gradients.
    void correct_areas() {
        std::vector<double> missing(grains_, 0);
        std::vector<double> length;
        for (const Boundary& boundary : boundaries_) {
            const double gained = area_gained(boundary);
            missing[boundary.left] -= gained;
            missing[boundary.right] += gained;
            length.push_back(static_cast<double>(boundary.sites.size()));
        }
        const std::vector<double> numbers = solve(missing, length);
        for (std::size_t k = 0; k < boundaries_.size(); ++k) {
            const Boundary& boundary = boundaries_[k];
            shift(boundary, length[k] * (numbers[boundary.left] - numbers[boundary.right]));
        }
    }

    [[nodiscard]] std::vector<double> solve(std::vector<double> residual,
                                            const std::vector<double>& length) const {
        constexpr double enough = 1e-10;
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
        const double least = enough * enough * size;
        for (std::size_t step = 0; step < 2 * grains_ && size > least; ++step) {
            std::vector<double> image(grains_, 0);
            for (std::size_t k = 0; k < boundaries_.size(); ++k) {
                const Boundary& boundary = boundaries_[k];
                const double flow =
                    length[k] * (direction[boundary.left] - direction[boundary.right]);
                image[boundary.left] += flow;
                image[boundary.right] -= flow;
            }
            const double curvature = dot(direction, image);
            if (!(curvature > 0)) { // nothing is left but rounding
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

    // Moves a boundary to its right, less beside its ends, so that its left gains this area.
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
    std::size_t grains_;
    std::vector<std::uint32_t> neighbours_;
};

} // namespace

std::vector<Curve> curves_of(const LabelImage& image, const Rectangle& domain) {
    const Grains grains = grains_of(image);
    Tracing tracing(image, grains);
    tracing.run();
    const Point<double> size(static_cast<double>(image.columns), static_cast<double>(image.rows));
    Smoothing(tracing.sites, tracing.boundaries, size.x(), grains.pixels.size()).run();
    const Point<double> pixel = (domain.high - domain.low).cwiseQuotient(size);
    std::vector<Curve> curves;
    for (const Boundary& boundary : tracing.boundaries) {
        Curve& curve = curves.emplace_back();
        curve.left = boundary.left_phase;
        curve.right = boundary.right_phase;
        for (const std::uint32_t id : boundary.sites) {
            const Site& site = tracing.sites[id];
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

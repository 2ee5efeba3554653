// SPDX-License-Identifier: MIT
// A sweep over vertical strips. The abscissae of all vertices bound the strips; within one, the
// edges are ordered, and the gap between neighbours is a trapezoid that belongs to the region given
// by its parity (or winding number). Edges cross within a strip exactly if their orders at its two
// sides differ, so no crossing has to be searched for, and none can be missed or invented: an
// edge's ordinate at an abscissa is computed once and used by both strips that meet there. A
// crossing that rounding misplaces causes an error of the product of two rounding errors. (The
// decomposition is that of the slab method: F. P. Preparata, M. I. Shamos, "Computational
// geometry", 1985, section 2.2.)
#include "measures/symmetric_difference.h"

#include "measures/compensated_sum.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace dsc::scenes {

namespace {

/// Crossings are ignored in strips narrower than this fraction of the extent: their effect is of
/// the size of rounding errors, and a nearly vertical edge may have very many.
constexpr double thin_strip = 0x1p-50;

/// An edge from left to right, in coordinates scaled to unit size. `step` is the change of its
/// region's winding number for a path that crosses the edge upwards.
struct Edge {
    double x0, y0, x1, y1;
    int region;
    int step;

    [[nodiscard]] double ordinate(double x) const {
        return x >= x1 ? y1 : y0 + ((x - x0) / (x1 - x0)) * (y1 - y0);
    }
};

/// An edge in the current strip with its ordinates at the two sides of the strip.
struct Active {
    double left, right;
    Edge edge;
};

bool below(const Active& s, const Active& t) {
    return s.left < t.left || (s.left == t.left && s.right < t.right);
}

/// The map to coordinates in which no area can underflow. It preserves differences exactly: the
/// offset is subtracted only if that is exact (Sterbenz), and the scale is a power of two.
struct Frame {
    Point<double> offset{0.0, 0.0};
    int exponent = 0;

    [[nodiscard]] Point<double> scaled(const Point<double>& p) const {
        return {std::ldexp(p.x() - offset.x(), -exponent),
                std::ldexp(p.y() - offset.y(), -exponent)};
    }
};

double offset(double low, double high) {
    const double centre = 0.5 * low + 0.5 * high;
    return std::abs(centre) > high - low ? centre : 0.0;
}

Frame frame_of(const Region& first, const Region& second) {
    const Eigen::AlignedBox2d box = box_around(first.outlines, second.outlines, "overlap_areas");
    Frame frame;
    const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    if (extent > 0.0 && std::isfinite(extent)) {
        frame.offset = {offset(box.min().x(), box.max().x()), offset(box.min().y(), box.max().y())};
        std::frexp(extent, &frame.exponent);
    }
    return frame;
}

void append_edges(const Region& region, int number, const Frame& frame, std::vector<Edge>& edges) {
    for (const Outline& outline : region.outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double> a = frame.scaled(outline[i]);
            const Point<double> b = frame.scaled(outline[i + 1 == outline.size() ? 0 : i + 1]);
            if (a.x() < b.x()) {
                edges.push_back({a.x(), a.y(), b.x(), b.y(), number, 1});
            } else if (b.x() < a.x()) {
                edges.push_back({b.x(), b.y(), a.x(), a.y(), number, -1});
            }
        }
    }
}

class Sweep {
public:
    Sweep(FillRule first, FillRule second) : rules_{first, second} {}

    void run(const std::vector<Edge>& edges) {
        std::vector<double> abscissae;
        abscissae.reserve(2 * edges.size());
        for (const Edge& edge : edges) {
            abscissae.push_back(edge.x0);
            abscissae.push_back(edge.x1);
        }
        std::sort(abscissae.begin(), abscissae.end());
        abscissae.erase(std::unique(abscissae.begin(), abscissae.end()), abscissae.end());
        std::size_t next = 0;
        for (std::size_t i = 0; i + 1 < abscissae.size(); ++i) {
            const double x0 = abscissae[i];
            const double x1 = abscissae[i + 1];
            std::erase_if(active_, [x0](const Active& a) { return a.edge.x1 <= x0; });
            for (Active& a : active_) {
                a.left = a.right;
                a.right = a.edge.ordinate(x1);
            }
            for (; next < edges.size() && edges[next].x0 == x0; ++next) {
                active_.push_back({edges[next].y0, edges[next].ordinate(x1), edges[next]});
            }
            std::sort(active_.begin(), active_.end(), below);
            add_strip(x1 - x0);
        }
    }

    [[nodiscard]] OverlapAreas areas(int exponent) const {
        return {std::ldexp(areas_[1].value(), 2 * exponent),
                std::ldexp(areas_[2].value(), 2 * exponent),
                std::ldexp(areas_[3].value(), 2 * exponent)};
    }

private:
    using Winding = std::array<int, 2>;

    /// A part of the strip's width in which the order of a group does not change.
    struct Slice {
        double part;
        double lowest, highest;
    };

    void enter(Winding& winding, const Edge& edge) const {
        winding[static_cast<std::size_t>(edge.region)] += edge.step;
    }

    [[nodiscard]] bool inside(const Winding& winding, std::size_t region) const {
        return rules_[region] == FillRule::nonzero ? winding[region] != 0
                                                   : winding[region] % 2 != 0;
    }

    void add(const Winding& winding, double area) {
        const std::size_t where = (inside(winding, 0) ? 1U : 0U) + (inside(winding, 1) ? 2U : 0U);
        areas_[where].add(area);
    }

    void add_strip(double width) {
        bool crossed = false;
        for (std::size_t i = 1; i < active_.size(); ++i) {
            crossed = crossed || active_[i].right < active_[i - 1].right;
        }
        if (crossed && width > thin_strip) {
            add_crossed_strip(width);
            return;
        }
        if (crossed) {
            std::sort(active_.begin(), active_.end(), [](const Active& s, const Active& t) {
                return s.left + s.right < t.left + t.right;
            });
        }
        Winding winding{0, 0};
        for (std::size_t i = 1; i < active_.size(); ++i) {
            enter(winding, active_[i - 1].edge);
            add(winding, 0.5 * width *
                             ((active_[i].left - active_[i - 1].left) +
                              (active_[i].right - active_[i - 1].right)));
        }
    }

    /// Divides the edges into the smallest groups whose edges cross only within the group.
    void add_crossed_strip(double width) {
        lowest_right_.resize(active_.size());
        double lowest = std::numeric_limits<double>::infinity();
        for (std::size_t i = active_.size(); i-- > 0;) {
            lowest = std::min(lowest, active_[i].right);
            lowest_right_[i] = lowest;
        }
        Winding winding{0, 0};
        double top = 0.0;
        for (std::size_t begin = 0; begin < active_.size();) {
            std::size_t end = begin + 1;
            double highest = active_[begin].right;
            while (end < active_.size() && lowest_right_[end] < highest) {
                highest = std::max(highest, active_[end].right);
                ++end;
            }
            const Slice mean = add_group(begin, end, width, winding);
            if (begin > 0) {
                add(winding, width * std::max(0.0, mean.lowest - top));
            }
            top = mean.highest;
            for (; begin < end; ++begin) {
                enter(winding, active_[begin].edge);
            }
        }
    }

    /// Adds the areas between the edges of a group, with the given winding numbers below it, and
    /// returns the mean ordinates of its lower and its upper envelope.
    Slice add_group(std::size_t begin, std::size_t end, double width, const Winding& outside) {
        if (end - begin == 1) {
            const double middle = 0.5 * (active_[begin].left + active_[begin].right);
            return {1.0, middle, middle};
        }
        cuts_.assign({0.0, 1.0});
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t j = i + 1; j < end; ++j) {
                const double before = active_[j].left - active_[i].left;
                const double after = active_[i].right - active_[j].right;
                if (after > 0.0 && before > 0.0) {
                    cuts_.push_back(before / (before + after));
                }
            }
        }
        std::sort(cuts_.begin(), cuts_.end());
        Slice mean{1.0, 0.0, 0.0};
        for (std::size_t k = 0; k + 1 < cuts_.size(); ++k) {
            if (cuts_[k] < cuts_[k + 1]) {
                const Slice slice = add_slice(begin, end, cuts_[k], cuts_[k + 1], width, outside);
                mean.lowest += slice.part * slice.lowest;
                mean.highest += slice.part * slice.highest;
            }
        }
        return mean;
    }

    Slice add_slice(std::size_t begin, std::size_t end, double from, double to, double width,
                    const Winding& outside) {
        const double middle = 0.5 * (from + to);
        slice_.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const Active& a = active_[i];
            slice_.push_back({a.left + middle * (a.right - a.left), i});
        }
        std::sort(slice_.begin(), slice_.end(), [](const Crossed& s, const Crossed& t) {
            return s.ordinate < t.ordinate || (s.ordinate == t.ordinate && s.index < t.index);
        });
        Winding winding = outside;
        for (std::size_t k = 0; k + 1 < slice_.size(); ++k) {
            enter(winding, active_[slice_[k].index].edge);
            add(winding, width * (to - from) * (slice_[k + 1].ordinate - slice_[k].ordinate));
        }
        return {to - from, slice_.front().ordinate, slice_.back().ordinate};
    }

    struct Crossed {
        double ordinate;
        std::size_t index;
    };

    std::array<FillRule, 2> rules_;
    std::array<CompensatedSum, 4> areas_; ///< by membership: none, first, second, both
    std::vector<Active> active_;
    std::vector<double> lowest_right_;
    std::vector<double> cuts_;
    std::vector<Crossed> slice_;
};

} // namespace

OverlapAreas overlap_areas(const Region& first, const Region& second) {
    const Frame frame = frame_of(first, second);
    std::vector<Edge> edges;
    append_edges(first, 0, frame, edges);
    append_edges(second, 1, frame, edges);
    std::sort(edges.begin(), edges.end(), [](const Edge& s, const Edge& t) { return s.x0 < t.x0; });
    Sweep sweep(first.rule, second.rule);
    sweep.run(edges);
    return sweep.areas(frame.exponent);
}

double symmetric_difference(std::span<const Outline> first, std::span<const Outline> second) {
    return overlap_areas({first}, {second}).symmetric_difference();
}

double symmetric_difference(const Outline& first, const Outline& second) {
    return symmetric_difference(std::span(&first, 1), std::span(&second, 1));
}

} // namespace dsc::scenes

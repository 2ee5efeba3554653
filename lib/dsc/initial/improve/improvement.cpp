// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/improvement.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/triangle.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/initial/improve/relaxation.h"
#include "dsc/initial/rounding.h"
#include "dsc/quality/measures.h"
#include "dsc/sizes/rule.h"

#include <algorithm>
#include <limits>
#include <string>

namespace dsc::initial {

namespace {

// Calls `round`, which returns the number of its changes, until there are none.
template <class Real, class Round>
void in_rounds(Complex<Real>& complex, int rounds, Round round) {
    for (int i = 0; i < rounds && round() > 0; ++i) {
    }
    for (auto& record : complex.vertices) {
        record.slot = unsettled;
    }
}

// --- near the interface --------------------------------------------------------------------------

constexpr int layers = 4; // rings of edges about the interface that always belong to the zone
// An edge shorter than this share of the target is not one of the lattice, whose shortest edges
// belong to the half triangles at the sides.
constexpr double fine_below = 0.48;

template <class Real>
bool is_fine(const Complex<Real>& complex, std::uint32_t vertex, double length) {
    double shortest = std::numeric_limits<double>::infinity();
    const Point<Real> centre = complex.position(Vertex{vertex});
    for (const Vertex w : link_vertices(complex, Vertex{vertex})) {
        const Point<Real> incident_edge = complex.position(w) - centre;
        shortest = std::min(shortest, incident_edge.template cast<double>().norm());
    }
    return shortest < fine_below * length;
}

// --- where edges grow ----------------------------------------------------------------------------

// A triangle is broken up if the radius of its circle over the mean target of its corners is larger
// than this (0.58 for an equilateral triangle with such edges). The new edges are between once and
// twice this length.
constexpr double largest_radius = 0.75;
// Sides of the domain are split from this length on, over the mean target of their ends.
constexpr double longest_side = 1.4;
// Shorter sides are not split for a circle's centre that comes too close to them.
constexpr double shortest_side = 0.8;
// A vertex all of whose incident edges are shorter than this, over its target, is removed...
constexpr double crowded = 0.95;
// ...if edges are not longer than this afterwards, and triangles no worse.
constexpr double longest_after = 1.5;
constexpr double quality_after = 0.5;

template <class Real>
class SizeRefinement {
public:
    SizeRefinement(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length,
                   Protection protection)
        : complex_(complex), rule_(sizes, edge_length), field_(size_field(complex)),
          edge_length_(static_cast<double>(edge_length)), protection_(protection) {}

    void run() {
        queue_ = ids_of(triangles(complex_));
        for (std::size_t i = 0; i < queue_.size(); ++i) {
            look_at(queue_[i]);
        }
    }

private:
    [[nodiscard]] double target(std::uint32_t v) const {
        return static_cast<double>(field_[Vertex{v}].length);
    }
    [[nodiscard]] Point<double> at(std::uint32_t v) const { return position_of(complex_, v); }

    void look_at(std::uint32_t triangle) {
        if (!complex_.is_alive(Triangle{triangle})) {
            return;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (split_side(corner_of(triangle, i), longest_side)) {
                return; // the parts are in the queue
            }
        }
        const auto& v = complex_.triangles[triangle].v;
        const Point<double> centre = circumcentre<double>(at(v[0]), at(v[1]), at(v[2]));
        const double allowed = largest_radius * (target(v[0]) + target(v[1]) + target(v[2])) / 3;
        if (!((centre - at(v[0])).norm() > allowed)) {
            return;
        }
        const BreakUp result = break_up(complex_, triangle, protection_, stack_);
        if (result.vertex != no_id) {
            add_vertex(result.vertex);
        } else if (result.in_the_way != no_id && split_side(result.in_the_way, shortest_side) &&
                   complex_.is_alive(Triangle{triangle})) {
            queue_.push_back(triangle);
        }
    }

    // Splits the edge opposite to the corner if it is a side of the domain that is longer than that
    // share of the target. Sides of other phases than the exterior one belong to the interface, and
    // are split only beside parts of it that are finer than the edge length.
    bool split_side(Corner corner, double share) {
        if (!is_border(complex_.twin(corner))) {
            return false;
        }
        const std::uint32_t a = complex_.vertex(next(corner));
        const std::uint32_t b = complex_.vertex(prev(corner));
        const double wanted = (target(a) + target(b)) / 2;
        if ((complex_.phase_at(corner) != exterior_phase && !(wanted < edge_length_)) ||
            !((at(a) - at(b)).norm() > share * wanted)) {
            return false;
        }
        const Point<Real> middle = narrowed<Real>(midpoint<double>(at(a), at(b)));
        add_vertex(insert_point(complex_, {WalkEnd::Kind::edge, corner}, middle, stack_));
        return true;
    }

    // Gives a new vertex the target that its star implies, and queues the star's triangles.
    void add_vertex(std::uint32_t v) {
        if (gather(complex_, Region{}, v, star_)) {
            field_[Vertex{v}] = rule_.at(star_, field_.data(), Real(0));
        }
        for (const Triangle t : star_triangles(complex_, Vertex{v})) {
            queue_.push_back(t.id);
        }
    }

    Complex<Real>& complex_;
    SizeRule<Real> rule_;
    SizeField<Real>& field_;
    double edge_length_;
    Protection protection_;
    std::vector<std::uint32_t> queue_; ///< triangles to be examined, in order
    std::vector<Corner> stack_;
    Star<Real> star_;
};

// Collapses vertices in places with more vertices than the targets require. Returns their number.
template <class Real>
std::size_t remove_crowded(Complex<Real>& complex, std::span<const std::uint32_t> zone) {
    const SizeField<Real>& field = size_field(complex);
    std::vector<Corner> stack;
    Star<Real> star;
    std::size_t removed = 0;
    for (const std::uint32_t v : zone) {
        if (!complex.is_alive(Vertex{v}) || !gather(complex, Region{}, v, star) ||
            !star.one_phase || !star.closed || star.size < 4) {
            continue;
        }
        const auto target = static_cast<double>(field[Vertex{v}].length);
        if (!(std::sqrt(static_cast<double>(examine(star).longest)) < crowded * target)) {
            continue;
        }
        const CollapseChoice best = best_collapse(star, longest_after * target);
        if (best.quality > quality_after &&
            collapse_along(complex, star, best.incident_edge, stack)) {
            ++removed;
        }
    }
    return removed;
}

} // namespace

template <class Real>
std::vector<std::uint32_t> find_zone(Complex<Real>& complex,
                                     std::span<const std::uint32_t> interface_vertices,
                                     double edge_length) {
    std::vector<std::uint32_t> found(interface_vertices.begin(), interface_vertices.end());
    for (const std::uint32_t v : found) {
        complex.vertices[v].stamp = 1;
    }
    std::size_t layer_end = found.size();
    int layer = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i == layer_end) {
            ++layer;
            layer_end = found.size();
        }
        const std::uint32_t v = found[i];
        if (layer >= layers && !is_fine(complex, v, edge_length)) {
            continue;
        }
        for (const Vertex w : link_vertices(complex, Vertex{v})) {
            if (complex.vertices[w.id].stamp == 0) {
                complex.vertices[w.id].stamp = 1;
                found.push_back(w.id);
            }
        }
    }
    for (const std::uint32_t v : found) {
        complex.vertices[v].stamp = 0;
    }
    std::erase_if(found, [&](std::uint32_t v) { return complex.vertices[v].slot == settled; });
    return found;
}

template <class Real>
void improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
             double edge_length, int rounds, Protection protection) {
    const auto round = [&] {
        const auto zone = find_zone(complex, interface_vertices, edge_length);
        // Smooths after every change, because the next change is judged by the current triangles.
        std::size_t changes = smooth(complex, zone);
        changes += thin_out(complex, zone, edge_length);
        changes += smooth(complex, zone);
        changes += refine(complex, zone, protection);
        return changes + split_long(complex, zone, edge_length);
    };
    in_rounds(complex, rounds, round);
    if (rounds > 0 && halve_needles(complex, interface_vertices, edge_length) > 0) {
        in_rounds(complex, rounds, round);
    }
}

template <class Real>
void grade(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length, int rounds,
           Protection protection) {
    SizeOptions<Real> bounded = sizes;
    if (bounded.longest == 0) {
        bounded.longest = std::max(extent_of(complex), edge_length);
    }
    measure_sizes(complex, bounded, edge_length, Real(0));
    SizeRefinement<Real>(complex, bounded, edge_length, protection).run();
    in_rounds(complex, rounds, [&] {
        const std::vector<std::uint32_t> zone = ids_of(vertices(complex));
        std::size_t changes = smooth(complex, zone);
        changes += remove_crowded(complex, zone);
        return changes + refine(complex, zone, protection);
    });
    const std::string name = size_field(complex).name(); // outlives the attribute
    complex.attributes.remove(name);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::vector<std::uint32_t> find_zone(Complex<Real>&, std::span<const std::uint32_t>,  \
                                                  double);                                         \
    template void improve(Complex<Real>&, std::span<const std::uint32_t>, double, int,             \
                          Protection);                                                             \
    template void grade(Complex<Real>&, const SizeOptions<Real>&, Real, int, Protection);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::initial

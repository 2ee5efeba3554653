// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/grading.h"

#include "dsc/complex/ranges.h"
#include "dsc/initial/build/delaunay.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/initial/build/zone.h"
#include "dsc/initial/improve/refinement.h"
#include "dsc/initial/improve/relaxation.h"
#include "dsc/quality/ring_quality.h"
#include "dsc/sizes/measure.h"

#include <algorithm>
#include <string>

namespace dsc::initial {

namespace {

// The radius of the circle about a triangle that is broken up, over the mean target of its corners;
// of an equilateral triangle with such edges it is 0.58. The edges that result are between this and
// twice this.
constexpr double largest_radius = 0.75;
// Sides of the domain that are split, over the mean target of their ends.
constexpr double longest_side = 1.4;
// Sides shorter than that are not split for a centre that comes too near to them.
constexpr double shortest_side = 0.8;
// A vertex all of whose spokes are shorter than this, over its target, is removed...
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
          protection_(protection) {}

    std::size_t run() {
        for (const Triangle t : triangles(complex_)) {
            queue_.push_back(t.id);
        }
        for (std::size_t i = 0; i < queue_.size(); ++i) {
            look_at(queue_[i]);
        }
        return inserted_;
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
            take(result.vertex);
        } else if (result.in_the_way != no_id && split_side(result.in_the_way, shortest_side) &&
                   complex_.is_alive(Triangle{triangle})) {
            queue_.push_back(triangle);
        }
    }

    // Splits the edge opposite to the corner if it is a side of the domain in the exterior phase,
    // and longer than that share of the target.
    bool split_side(Corner corner, double share) {
        if (!is_border(complex_.twin(corner)) || complex_.phase_at(corner) != exterior_phase) {
            return false;
        }
        const std::uint32_t a = complex_.vertex(next(corner));
        const std::uint32_t b = complex_.vertex(prev(corner));
        if (!((at(a) - at(b)).norm() > share * (target(a) + target(b)) / 2)) {
            return false;
        }
        const Point<Real> middle = narrowed<Real>(midpoint<double>(at(a), at(b)));
        take(insert_point(complex_, Location{Place::edge, corner}, middle, stack_));
        return true;
    }

    // A new vertex gets its target from its star, whose triangles are looked at.
    void take(std::uint32_t v) {
        ++inserted_;
        if (gather(complex_, Region{}, v, ring_)) {
            lengths_.take(ring_, [this](std::uint32_t u) { return field_[Vertex{u}].length; });
            if (rule_.needs_distance()) {
                distances_.take(ring_,
                                [this](std::uint32_t u) { return field_[Vertex{u}].distance; });
            }
            field_[Vertex{v}] = rule_.at(ring_, lengths_, distances_, Real(0));
        }
        for (const Triangle t : star_triangles(complex_, Vertex{v})) {
            queue_.push_back(t.id);
        }
    }

    Complex<Real>& complex_;
    SizeRule<Real> rule_;
    SizeField<Real>& field_;
    Protection protection_;
    std::vector<std::uint32_t> queue_; ///< triangles to be looked at, in order
    std::vector<Corner> stack_;
    Ring<Real> ring_;
    LinkValues<Real> lengths_;
    LinkValues<Real> distances_;
    std::size_t inserted_ = 0;
};

// Collapses vertices where there are more of them than the targets call for. Returns their number.
template <class Real>
std::size_t remove_crowded(Complex<Real>& complex, std::span<const std::uint32_t> zone) {
    const SizeField<Real>& field = size_field(complex);
    std::vector<Corner> stack;
    Ring<Real> ring;
    std::size_t removed = 0;
    for (const std::uint32_t v : zone) {
        if (!complex.is_alive(Vertex{v}) || !gather(complex, Region{}, v, ring) ||
            !ring.one_phase || !ring.closed || ring.size < 4) {
            continue;
        }
        const auto target = static_cast<double>(field[Vertex{v}].length);
        if (!(std::sqrt(static_cast<double>(examine(ring).longest)) < crowded * target)) {
            continue;
        }
        const CollapseChoice best = best_collapse(ring, longest_after * target);
        if (best.spoke != no_id && best.quality > quality_after &&
            collapse_along(complex, ring, best.spoke)) {
            legalise_star(complex, ring.link[best.spoke], stack);
            ++removed;
        }
    }
    return removed;
}

template <class Real>
std::vector<std::uint32_t> all_vertices(const Complex<Real>& complex) {
    std::vector<std::uint32_t> list;
    list.reserve(complex.vertex_count());
    for (const Vertex v : vertices(complex)) {
        list.push_back(v.id);
    }
    return list;
}

} // namespace

template <class Real>
Grading grade(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length, int rounds,
              Protection protection) {
    SizeOptions<Real> bounded = sizes;
    if (bounded.longest == 0) {
        bounded.longest = std::max(extent_of(complex), edge_length);
    }
    measure_sizes(complex, bounded, edge_length, Real(0));
    Grading done;
    done.insertions = SizeRefinement<Real>(complex, bounded, edge_length, protection).run();
    bool busy = true;
    while (done.rounds < rounds && busy) {
        ++done.rounds;
        const std::vector<std::uint32_t> zone = all_vertices(complex);
        const std::size_t moves = smooth(complex, zone);
        const std::size_t collapses = remove_crowded(complex, zone);
        const std::size_t insertions = refine(complex, zone, protection);
        done.moves += moves;
        done.collapses += collapses;
        done.insertions += insertions;
        busy = moves + collapses + insertions > 0;
    }
    for (auto& record : complex.vertices) {
        record.slot = unsettled;
    }
    const std::string name = size_field(complex).name(); // outlives the attribute
    complex.attributes.remove(name);
    return done;
}

template Grading grade(Complex<double>&, const SizeOptions<double>&, double, int, Protection);
template Grading grade(Complex<float>&, const SizeOptions<float>&, float, int, Protection);

} // namespace dsc::initial

// SPDX-License-Identifier: MIT
#include "thesis/operations/triangle_collapse.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <string>

namespace dsc {

namespace {

using Three = std::array<bool, 3>;

// The outcome of a collapse, before anything is changed. `heir`: the index in the triangle of the
// vertex that remains.
template <class Real>
struct CollapsePlan {
    Verdict verdict = Verdict::legal;
    std::uint32_t heir = 0;
    Point<Real> place = {};
};

template <class Real>
class Planner {
public:
    Planner(const Complex<Real>& complex, const Region& region, Triangle triangle,
            const TriangleCollapseOptions<Real>& options)
        : complex_(complex), region_(region), options_(options), t_(triangle.id),
          v_(complex.triangles[triangle.id].v) {}

    CollapsePlan<Real> plan() {
        // Vertices of other submeshes are refused before their stars are read: another thread may
        // be rewriting these.
        const auto is_owned = [&](std::uint32_t v) { return owns(complex_, region_, v); };
        if (!std::ranges::all_of(v_, is_owned)) {
            return {Verdict::on_submesh_boundary};
        }
        Three on_boundary{};
        Three on_interface{};
        Three locked{};
        Three corners{};
        bool owned = true;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const StarSummary summary = inspect(complex_, region_, v_[i]);
            on_boundary[i] = summary.on_boundary;
            on_interface[i] = summary.interface_edges > 0;
            owned = owned && summary.owned;
            locked[i] = complex_.is_locked(Vertex{v_[i]});
            corners[i] = complex_.is_feature(Vertex{v_[i]});
        }
        if (!pin(on_boundary)) {
            return {Verdict::on_boundary};
        }
        if (!owned) {
            return {Verdict::on_submesh_boundary};
        }
        if (options_.interface == InterfaceRule::keep && !pin(on_interface)) {
            return {Verdict::on_interface};
        }
        if (!pin(locked)) {
            return {Verdict::locked};
        }
        const CollapsePlan<Real> plan = choose(on_interface, corners);
        if (!owns_place(region_, plan.place)) {
            return {Verdict::on_submesh_boundary};
        }
        if (changes_topology()) {
            return {Verdict::changes_topology};
        }
        return stays_positive(plan.place) ? plan : CollapsePlan<Real>{Verdict::inverts};
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Pins the named vertices, which must stay where they are. False if that contradicts the place
    // asked for, or vertices pinned before.
    bool pin(const Three& named) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (!named[i]) {
                continue;
            }
            if ((pinned_ < 3 && pinned_ != i) || (options_.place && *options_.place != at(v_[i]))) {
                return false;
            }
            pinned_ = i;
        }
        return true;
    }

    [[nodiscard]] CollapsePlan<Real> choose(const Three& on_interface, const Three& corners) const {
        const auto smallest = static_cast<std::uint32_t>(std::ranges::min_element(v_) - v_.begin());
        // Summed in the order of the ids: the bits do not depend on where the triangle begins.
        auto sorted = v_;
        std::ranges::sort(sorted);
        const Point<Real> sum = at(sorted[0]) + at(sorted[1]) + at(sorted[2]);
        CollapsePlan<Real> plan{Verdict::legal, smallest, sum / static_cast<Real>(3)};
        const auto only = [](const Three& of) { return std::ranges::count(of, true) == 1; };
        const auto index = [](const Three& of) {
            return static_cast<std::uint32_t>(std::ranges::find(of, true) - of.begin());
        };
        const std::uint32_t preferred = pinned_ < 3          ? pinned_
                                        : only(on_interface) ? index(on_interface)
                                        : only(corners)      ? index(corners)
                                                             : 3;
        if (preferred < 3) {
            plan.heir = preferred;
            plan.place = at(v_[preferred]);
        }
        if (options_.place) {
            plan.place = *options_.place;
        }
        return plan;
    }

    // Beside the third vertex, the ends of an edge of the triangle may have one neighbour in
    // common: the apex beyond that edge. There is one exception: if the third vertex lies inside
    // and has degree three, all three are joined to the apex beyond. With any other common
    // neighbour, two edges would become one although other simplices lie between them. That is the
    // link condition of T. K. Dey et al., "Topology preserving edge contraction" (1999), for both
    // edge collapses. At most one of the three vertices is on the domain boundary here, so that
    // there is an apex beyond each edge.
    [[nodiscard]] bool changes_topology() const {
        std::array<std::uint32_t, 3> apex{};
        for (std::uint32_t i = 0; i < 3; ++i) {
            apex[i] = complex_.vertex(complex_.twin(corner_of(t_, i)));
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t j = (i + 1) % 3;
            const std::uint32_t k = (i + 2) % 3;
            bool elsewhere = false;
            const auto inspect_neighbour = [&](std::uint32_t w) {
                const bool expected =
                    std::ranges::count(v_, w) > 0 || w == apex[i] || (w == apex[j] && w == apex[k]);
                elsewhere = elsewhere || (!expected && is_adjacent(v_[k], w));
            };
            turn(complex_, v_[j], [&](Corner c) {
                inspect_neighbour(complex_.vertex(next(c)));
                inspect_neighbour(complex_.vertex(prev(c)));
            });
            if (elsewhere) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] bool is_adjacent(std::uint32_t v, std::uint32_t w) const {
        bool found = false;
        turn(complex_, v, [&](Corner c) {
            found = found || complex_.vertex(next(c)) == w || complex_.vertex(prev(c)) == w;
        });
        return found;
    }

    [[nodiscard]] bool stays_positive(const Point<Real>& place) const {
        bool positive = true;
        const auto vanishes = [&](std::uint32_t w) { return std::ranges::count(v_, w) > 0; };
        for (const std::uint32_t v : v_) {
            turn(complex_, v, [&](Corner c) {
                const std::uint32_t p = complex_.vertex(next(c));
                const std::uint32_t q = complex_.vertex(prev(c));
                positive = positive && (vanishes(p) || vanishes(q) ||
                                        orientation<Real>(place, at(p), at(q)) > 0);
            });
        }
        return positive;
    }

    const Complex<Real>& complex_;
    const Region& region_;
    const TriangleCollapseOptions<Real>& options_;
    std::uint32_t t_;
    std::array<std::uint32_t, 3> v_;
    std::uint32_t pinned_ = 3; // none
};

template <class Real>
CollapsePlan<Real> plan_collapse(const Complex<Real>& complex, const Region& region,
                                 Triangle triangle, const TriangleCollapseOptions<Real>& options) {
    if (options.place && !options.place->allFinite()) {
        throw InputError({.what = "the place of the new vertex is not finite",
                          .where = "triangle_collapse",
                          .value = to_text(*options.place),
                          .allowed = "finite coordinates"});
    }
    if (!complex.is_alive(triangle)) {
        return {Verdict::not_a_simplex};
    }
    return Planner<Real>(complex, region, triangle, options).plan();
}

} // namespace

template <class Real>
Verdict triangle_collapse_guard(const Complex<Real>& complex, Triangle triangle,
                                const TriangleCollapseOptions<Real>& options,
                                const Region& region) {
    return plan_collapse(complex, region, triangle, options).verdict;
}

template <class Real>
TriangleCollapseResult detail::triangle_collapse(const Submesh<Real>& submesh, Triangle triangle,
                                                 const TriangleCollapseOptions<Real>& options) {
    Complex<Real>& complex = submesh.complex;
    const CollapsePlan<Real> plan = plan_collapse(complex, submesh.region, triangle, options);
    if (plan.verdict != Verdict::legal) {
        return {plan.verdict, {}};
    }
    const Corner at_heir = corner_of(triangle.id, plan.heir);
    const std::uint32_t heir = complex.vertex(at_heir);
    // The edges from the heir to the vertices at next and prev, as corners outside the triangle.
    Corner to_next = complex.twin(prev(at_heir));
    Corner to_prev = complex.twin(next(at_heir));
    // A vertex of degree three is collapsed first. At the second collapse it would have only two
    // triangles, both with the same three vertices, and an edge of the heir would lose its data.
    if (complex.vertex(to_prev) == complex.vertex(complex.twin(at_heir))) {
        std::swap(to_next, to_prev);
    }
    for (const Corner c : {to_next, to_prev}) {
        const auto end =
            complex.vertex(next(c)) == heir ? rewire::Vanishing::prev : rewire::Vanishing::next;
        rewire::collapse(complex, *submesh.log, c, end, *submesh.pool);
    }
    if (const auto before = complex.position(Vertex{heir}); before != plan.place) {
        rewire::move(complex, *submesh.log, heir, plan.place.x(), plan.place.y(),
                     MoveReason::coarsening);
    }
    rethrow_failure(submesh);
    return {Verdict::legal, Vertex{heir}};
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Verdict triangle_collapse_guard(const Complex<Real>&, Triangle,                       \
                                             const TriangleCollapseOptions<Real>&, const Region&); \
    template TriangleCollapseResult detail::triangle_collapse(                                     \
        const Submesh<Real>&, Triangle, const TriangleCollapseOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

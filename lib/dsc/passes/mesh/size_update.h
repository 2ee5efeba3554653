// SPDX-License-Identifier: MIT
// Keeps the targets of edges up to date as the mesh update visits stars: a changed target is
// stored, and the neighbours that it affects are visited in the next pass. A change thus spreads by
// one star per pass, as far as it affects targets. Flips and smoothing nearby may change a target
// without a visit; the slow sweep of `Simulation` finds such targets. Only owned stars are read and
// written: the result does not depend on the threads.
#pragma once

#include "dsc/complex/ranges.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/mesh/star.h"
#include "dsc/passes/work.h"
#include "dsc/sizes/rule.h"

#include <cmath>

namespace dsc {

/// Puts the vertices where targets change into the active set, once each. O(their number).
template <class Real>
void activate_resized(Work<Real>& work) {
    for (const std::uint32_t v : work.resized) {
        work.activate(v);
    }
    work.resized.clear();
}

template <class Real>
class SizeUpdate {
public:
    explicit SizeUpdate(Work<Real>& work)
        : work_(work), rule_(work.options.sizes, work.options.edge_length),
          field_(work.options.sizes.is_uniform() ? nullptr : &size_field(work.complex)) {}

    [[nodiscard]] bool is_uniform() const { return field_ == nullptr; }

    /// Updates and returns the target at the centre of an owned star. O(degree); O(1) if all edges
    /// are of one length.
    Real follow(const Star<Real>& star) {
        return is_uniform() ? work_.options.edge_length : follow_star(star);
    }

    /// The target at a vertex, as stored.
    [[nodiscard]] Real at(std::uint32_t v) const {
        return is_uniform() ? work_.options.edge_length : (*field_)[Vertex{v}].length;
    }

    /// Call after removing the centre: its link is visited again in the next pass, because this
    /// pass may have visited it already. Coarsening thus continues until no vertex needs to be
    /// removed.
    void look_again(const Star<Real>& star) {
        if (!is_uniform()) {
            work_.resized.insert(work_.resized.end(), star.link.begin(),
                                 star.link.begin() + star.link_size());
        }
    }

private:
    // Out of line, so that the update of uniform meshes stays small.
    [[gnu::noinline]] Real follow_star(const Star<Real>& star) {
        VertexSize<Real>& stored = (*field_)[Vertex{star.vertex}];
        if (rule_.is_finest(star) && stored.length == work_.options.edge_length) {
            return stored.length; // the usual case
        }
        const auto& data = field_->data();
        if (rule_.stays(star, data, stored.length, work_.time)) {
            return stored.length;
        }
        const VertexSize<Real> now = rule_.at(star, data, work_.time);
        const Real change = rule_.slack() * std::min(now.length, stored.length);
        const bool is_nearer = std::abs(now.distance - stored.distance) > change;
        // A target below all its neighbours', without an interface nearby, is stale: the interface
        // has moved on. Raise it at once; the slack applies only to targets that something still
        // supports.
        const bool is_left_over =
            now.length > stored.length &&
            std::none_of(star.link.begin(), star.link.begin() + star.link_size(),
                         [&](std::uint32_t v) { return at(v) < stored.length; });
        if (is_nearer || is_left_over || std::abs(now.length - stored.length) > change) {
            const VertexSize<Real> old = stored;
            stored = now;
            tell_neighbours(star, old.length, now.length, is_nearer && rule_.needs_distance());
        }
        return stored.length;
    }

    void tell_neighbours(const Star<Real>& star, Real old, Real now, bool all) {
        for (std::uint32_t i = 0; i < star.link_size(); ++i) {
            const Real rise = rule_.slope() * std::sqrt(star.squared_edge(i));
            const Real theirs = at(star.link[i]);
            // The neighbour's target falls with this one...
            const bool falls = theirs > (now + rise) * (1 + rule_.slack());
            // ...or the old one limited it, along the edge or at less than 60 degrees to it, up to
            // the slack.
            const bool rises = now > old && theirs * (1 + rule_.slack()) > old + Real(0.5) * rise;
            if (all || falls || rises) {
                work_.resized.push_back(star.link[i]);
            }
        }
    }

    Work<Real>& work_;
    SizeRule<Real> rule_;
    SizeField<Real>* field_;
};

/// The vertices whose incident edges are too long or too short for the targets of `size_field`:
/// those that the mesh update has to visit first. Ascending. O(n).
template <class Real>
std::vector<std::uint32_t> out_of_size(Complex<Real>& complex, const Options<Real>& options) {
    const SizeField<Real>* field = options.sizes.is_uniform() ? nullptr : &size_field(complex);
    std::vector<std::uint32_t> found;
    Star<Real> star;
    for (const Vertex v : vertices(complex)) {
        if (gather(complex, Region{}, v.id, star)) {
            const Real length = field != nullptr ? (*field)[v].length : options.edge_length;
            if (is_out_of_size(examine(star), star_limits(options, star.phase[0], length))) {
                found.push_back(v.id);
            }
        }
    }
    return found;
}

} // namespace dsc

// SPDX-License-Identifier: MIT
// The target length of edges, kept at each vertex: an attribute of the complex, so that it follows
// splits, renumbering and copies. The rule says what it should be at a vertex, given its star.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/ring.h"
#include "dsc/sizes/options.h"
#include "dsc/sizes/wavefront.h"

#include <algorithm>

namespace dsc {

/// What is known at a vertex. New ones that are on no edge know nothing.
template <class Real>
struct VertexSize {
    Real length = std::numeric_limits<Real>::infinity();   ///< target of edges
    Real distance = std::numeric_limits<Real>::infinity(); ///< to the interface; kept if needed
};

template <class Real>
void archive(Archive& archive, VertexSize<Real>& size) {
    archive(size.length, size.distance);
}

/// The attribute that holds the targets.
template <class Real>
using SizeField = VertexAttribute<VertexSize<Real>>;

/// The attribute, created if there is none yet.
template <class Real>
SizeField<Real>& size_field(Complex<Real>& complex);

/// Whether the centre of a star is on the interface (or on a side of the domain that belongs to
/// it). O(1).
template <class Real>
bool is_on_interface(const Ring<Real>& ring) {
    return !ring.one_phase || (!ring.closed && ring.phase[0] != exterior_phase);
}

/// What the target should be. Thread-safe if the functions of the application are.
template <class Real>
class SizeRule {
public:
    /// Refers to the options.
    SizeRule(const SizeOptions<Real>& options, Real edge_length)
        : options_(options), edge_length_(edge_length),
          slope_(static_cast<Real>(options.growth) - 1),
          slack_(std::min(Real(0.1), Real(0.3) * slope_)) {}

    /// By how much a target grows over a length of 1.
    [[nodiscard]] Real slope() const { return slope_; }
    /// Changes of less than this share of the target are not followed. Two neighbours that hold
    /// each other down rise by the slope times the edge between them, which is longer than the 0.3
    /// above times their target: they are not held up.
    [[nodiscard]] Real slack() const { return slack_; }
    /// Whether the distance to the interface has to be kept.
    [[nodiscard]] bool needs_distance() const { return bool(options_.by_distance); }

    /// The target at the centre without regard to its neighbours. O(degree).
    [[nodiscard]] Real own(const Ring<Real>& ring, Real distance, Real time) const {
        if (is_finest(ring)) {
            return edge_length_;
        }
        Real least =
            options_.longest > 0 ? options_.longest : std::numeric_limits<Real>::infinity();
        for (std::uint32_t i = 0; options_.by_place && i < ring.size; ++i) {
            if (i == 0 || ring.phase[i] != ring.phase[i - 1]) {
                least = std::min(
                    least, at_least(options_.by_place({ring.x0, ring.y0}, time, ring.phase[i])));
            }
        }
        if (options_.on_interface && is_on_interface(ring)) {
            least = std::min(least, on_interface({ring.x0, ring.y0}, time));
        }
        if (needs_distance()) {
            least = std::min(least, at_least(options_.by_distance(distance)));
        }
        return least;
    }

    /// The target of the interface's own edges at a place; only where there is one.
    [[nodiscard]] Real on_interface(const Point<Real>& place, Real time) const {
        return at_least(options_.on_interface(place, time));
    }

    /// Whether all that matters at the centre is that it is on the interface. O(1).
    [[nodiscard]] bool is_finest(const Ring<Real>& ring) const {
        return !options_.by_place && !options_.on_interface && is_on_interface(ring);
    }

    /// The same with regard to its neighbours. `distances` is read only if it is needed. O(degree).
    [[nodiscard]] VertexSize<Real> at(const Ring<Real>& ring, const LinkValues<Real>& lengths,
                                      const LinkValues<Real>& distances, Real time) const {
        Real distance = 0;
        if (needs_distance() && !is_on_interface(ring)) {
            distance = least_over_link(ring, Real(1), distances);
        }
        const Real least = own(ring, distance, time);
        return {std::min(least, least_over_link(ring, slope_, lengths)), distance};
    }

private:
    [[nodiscard]] Real at_least(Real length) const {
        return length > edge_length_ ? length : edge_length_; // also for NaN
    }

    const SizeOptions<Real>& options_;
    Real edge_length_;
    Real slope_;
    Real slack_;
};

} // namespace dsc

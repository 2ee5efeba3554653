// SPDX-License-Identifier: MIT
// The centred difference (thesis, section 9.4): an integrator of second order that needs one
// evaluation of the velocity, because it stores the last step of each vertex.
#pragma once

#include "dsc/motion/integrator.h"

#include <algorithm>
#include <memory>

namespace dsc {

/// An error of the past, even rounding, enters the next step multiplied by the square of the ratio
/// of the two steps. Steps may become this many times longer before the past is discarded: two
/// digits of it are lost by then.
inline constexpr double max_growth = 10;

/// A turn of the velocity by more than 60 degrees from one step to the next counts as a jump, as at
/// the tip where two growing discs have met: there a step based on the last one would lead to the
/// other side of the tip, and the next step back. Such a turn is no jump if the last step was
/// shorter than this fraction of each edge at the vertex: a flow that reverses comes to rest in
/// between, and without its past the centred difference would lose its symmetry in time.
inline constexpr double longest_at_rest = 0.1;

/// The last step of a vertex.
template <class Real>
struct Past {
    Point<Real> way = Point<Real>::Zero(); ///< to its last target
    Real dt = 0; ///< the duration of that step; 0: the vertex has no past yet
    /// An upper bound of the ratio of that step's duration to the shortest since the vertex had no
    /// past.
    Real growth = 1;

    /// `growth` at the end of a step of this length.
    [[nodiscard]] Real growth_after(Real next_dt) const {
        return std::max(growth * (next_dt / dt), Real(1));
    }
    /// Whether the next step, of this duration, may use this one.
    [[nodiscard]] bool serves(Real next_dt) const {
        return dt > 0 && growth_after(next_dt) <= static_cast<Real>(max_growth);
    }
    /// Whether this velocity is at more than 60 degrees to that step.
    [[nodiscard]] bool is_crossed_by(const Point<Real>& velocity) const {
        return way.dot(velocity) < Real(0.5) * way.norm() * velocity.norm();
    }
};

template <class Real>
void archive(Archive& archive, Past<Real>& past) {
    archive(past.way, past.dt, past.growth);
}

/// The attribute "thesis.past" of the complex, created if there is none yet. A new vertex has no
/// past.
template <class Real>
VertexAttribute<Past<Real>>& past_of(Complex<Real>& complex);

/// The integrator, for `Options::custom_integrator`. Vertices without a past, whose steps have
/// become more than `max_growth` times longer since, or whose velocity jumps, take a midpoint step.
/// Unstable for any step in flows that smooth the interface. Returns the same object each time:
/// replacing options does not make a simulation forget the past.
template <class Real>
[[nodiscard]] std::shared_ptr<const CustomIntegrator<Real>> centred_difference();

} // namespace dsc

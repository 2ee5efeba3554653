// SPDX-License-Identifier: MIT
// Vertices that are ahead of the time of the simulation. What happens within a sub-step is found at
// its end, and a stage may put a vertex where it will be a little later, or was a little earlier:
// where two fronts meet. Such a vertex then moves for the rest of the next sub-step alone.
#pragma once

#include "dsc/complex/complex.h"

namespace dsc {

/// How far a vertex is ahead of the simulation. A type of its own, because numbers count as data of
/// the application and are written to files.
template <class Real>
struct TimeAhead {
    Real time = 0;  ///< by which it is ahead; below 0: late
    Real share = 1; ///< of the last sub-step, for which it moved
    Real speed = 0; ///< of the fronts that met there, along their normals; 0: none
};

/// Archives how far a vertex is ahead.
template <class Real>
void archive(Archive& archive, TimeAhead<Real>& ahead) {
    archive(ahead.time, ahead.share, ahead.speed);
}

/// The name of the attribute of vertices.
inline constexpr const char* time_ahead_name = "dsc.time_ahead";

/// The attribute of the vertices; null if there is none, as no vertex is ever ahead then. O(1).
template <class Real>
[[nodiscard]] VertexAttribute<TimeAhead<Real>>* find_times_ahead(Complex<Real>& complex) {
    return complex.attributes.contains(time_ahead_name)
               ? &complex.attributes.template get<Vertex, TimeAhead<Real>>(time_ahead_name)
               : nullptr;
}

/// The attribute of the vertices, created if there is none yet: a new vertex between two is ahead
/// as the edge is there. O(1), or O(n) for a new one.
template <class Real>
[[nodiscard]] VertexAttribute<TimeAhead<Real>>& times_ahead_of(Complex<Real>& complex) {
    if (auto* const there = find_times_ahead(complex)) {
        return *there;
    }
    return complex.attributes.template add<Vertex>(
        time_ahead_name, TimeAhead<Real>{},
        [](const TimeAhead<Real>& one, const TimeAhead<Real>& other, double fraction) {
            const auto at = static_cast<Real>(fraction);
            return TimeAhead<Real>{.time = (1 - at) * one.time + at * other.time,
                                   .share = (1 - at) * one.share + at * other.share};
        });
}

} // namespace dsc

// SPDX-License-Identifier: MIT
// Growth and shrinkage along the normal by the principle of Huygens: the interface at a later time
// is the envelope of circles about all of its points. A feature that is convex in the direction of
// motion opens into an arc; two sheets that run into each other continue to meet in a sharp notch.
//
// Velocities along normals alone achieve neither: an arc starts from one point, and vertices
// inserted there later do not lie on it. So a pass (growth_features.h) puts a fan of vertices at
// the feature, each with its own direction, and the flow moves each along its ray: a characteristic
// of the eikonal equation (J. A. Sethian, "Curvature and the evolution of fronts", 1985).
#pragma once

#include "dsc/motion/interface_flow.h"

#include <vector>

namespace dsc {

/// The speed at which one phase grows into another, in lengths per time; negative if it shrinks.
struct GrowthSpeed {
    Phase growing = 1; ///< the phase that gains area where `speed` is positive
    Phase into = 0;    ///< the phase that loses it
    double speed = 0;  ///< along the normal
};

/// A factor of all speeds, by place and time. Called from several threads at once.
template <class Real>
using GrowthFactor = std::function<Real(const Point<Real>& place, Real time)>;

/// Speeds by pairs of phases, and the treatment of features.
template <class Real>
struct GrowthOptions {
    std::vector<GrowthSpeed> speeds; ///< interfaces between other phases stay
    GrowthFactor<Real> factor = {};  ///< none: 1

    double open_degrees = 30; ///< features that turn by more open into a fan...
    double fan_degrees = 25;  ///< ...whose edges turn by at most this much
    /// Sheets that run into each other and turn by more than this meet in a notch, which is a
    /// feature from then on...
    double notch_degrees = 40;
    double smooth_degrees = 15; ///< ...until it turns by less than this
    /// A notch moves by at most this times the speed: a very sharp one would outrun its mesh. The
    /// tip of what grows is no faster than its sheets.
    double max_notch = 4;
};

/// Throws InputError if a value is not finite or out of range, a pair of phases is named twice or
/// has twice the same phase.
template <class Real>
void check_growth(const GrowthOptions<Real>& options);

/// The speed with which an interface moves from its left phase to its right one; 0 for pairs that
/// the options do not name. O(pairs).
template <class Real>
[[nodiscard]] Real growth_speed(const GrowthOptions<Real>& options, Phase left, Phase right,
                                const Point<Real>& place, Real time);

/// The state of a vertex of a fan.
enum class FanState : std::uint8_t {
    none,     ///< in no fan
    opening,  ///< moving from beside the feature to its ray
    inserted, ///< new between two vertices of a fan, not on the arc yet
    open,     ///< on its ray
    closing,  ///< moving to where the sheets will meet again
};

/// The ray of a vertex of a fan.
template <class Real>
struct FanRay {
    Point<Real> source = Point<Real>::Zero(); ///< the feature
    /// Unit vector from the left phase to the right; `closing`: the velocity.
    Point<Real> direction = Point<Real>::Zero();
    float start = 0;    ///< distance of the vertex along its ray when the feature opened
    float to_first = 0; ///< angle from its ray to the first one along the curve, in radians
    float to_last = 0;  ///< to the last one
    FanState state = FanState::none; ///< the stage of its movement
};

template <class Real>
void archive(Archive& archive, FanRay<Real>& ray) {
    archive(ray.source, ray.direction, ray.start, ray.to_first, ray.to_last);
    archive.choice(ray.state, 5);
}

/// Whether both rays start from one feature.
template <class Real>
[[nodiscard]] bool belong_together(const FanRay<Real>& a, const FanRay<Real>& b) {
    return a.state != FanState::none && b.state != FanState::none && a.source == b.source;
}

/// The rays of a complex, by vertex; null if it has none.
template <class Real>
[[nodiscard]] VertexAttribute<FanRay<Real>>* fan_rays(Complex<Real>& complex);
template <class Real>
[[nodiscard]] const VertexAttribute<FanRay<Real>>* fan_rays(const Complex<Real>& complex);

/// Adds the rays if there are none yet. O(vertices).
template <class Real>
VertexAttribute<FanRay<Real>>& add_fan_rays(Complex<Real>& complex);

/// The tangent at the end c of a sheet that comes from a and b: that of their circle, or of the
/// chord where the sheet turns too much at b. Unit vector; zero if b and c coincide. Second order.
template <class Real>
[[nodiscard]] Point<Real> end_tangent(const Point<Real>& a, const Point<Real>& b,
                                      const Point<Real>& c);

/// The flow, for a simulation whose algorithm is `growth_algorithm`, whose passes open features. A
/// step throws InputError if the complex lacks the rays that this algorithm adds. A junction moves
/// as closely as it can with all sheets that meet there; on the domain boundary it slides with
/// them. Second order in the edge length; first order beside opened features where the speed
/// depends on the place, since the rays of a fan bend there and are given up early. O(1) for a
/// vertex, O(arms) for a junction. Throws InputError if an option is out of range. Safe to call
/// from several threads.
template <class Real>
[[nodiscard]] InterfaceFlow<Real> growth(const GrowthOptions<Real>& options);

} // namespace dsc

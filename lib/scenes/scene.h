// SPDX-License-Identifier: MIT
// A scene (thesis, section 9): a shape, a flow, and the shape that an exact method would have at
// any time.
#pragma once

#include "dsc/initial/label_image.h"
#include "dsc/motion/interpolation.h"
#include "flows/velocity.h"
#include "fluid/options.h"
#include "geometric_flows/curvature_flow.h"
#include "scenes/keys.h"
#include "shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes {

/// Motion by curvature.
struct CurvatureMotion {
    std::vector<PairCurvature> pairs{}; ///< those of another tension or mobility than 1
    std::vector<Phase> keeps{};         ///< phases whose areas at the start are kept
};

/// Growth along the normal, at a speed that changes its sign once.
struct Growth {
    double speed = 1;    ///< of phase 1 into the exterior
    double turns_at = 0; ///< the time at which it begins to shrink at that speed
};

/// A small wave on a level or around a circle, whose height over time is known.
struct SmallWave {
    bool is_on_circle = false;
    Point<double> middle{0.0, 0.0}; ///< of the circle; of a level: any point on it
    double number = 1;              ///< crests around the circle; of a level: 2 pi / wavelength
    std::function<double(double time)> exact{}; ///< its height
};

/// Motion by a fluid that fills the phases.
struct FluidMotion {
    FluidOptions options{};
    std::optional<SmallWave> wave{}; ///< that is measured against its exact height
    /// Exact distance from the left side to where the interface meets the bottom, as a function of
    /// time. Empty: none.
    std::function<double(double time)> neck{};
};

/// Edges as long as the way from them to the interface divided by their number on it, and none
/// shorter than the finest.
struct EdgesToInterface {
    double finest = 0;
    double number = 0;

    double operator()(double distance) const { return std::max(finest, distance / number); }
};

/// Edges of one length in each phase, by its number; the last holds for all that follow.
struct LengthByPhase {
    std::vector<double> lengths;

    double operator()(const Point<double>&, double, Phase phase) const {
        return lengths[std::min<std::size_t>(phase, lengths.size() - 1)];
    }
};

/// The application's interpolator of a circle that is to stay round (thesis, section 9.2): a new
/// vertex lies as far from the centre as its neighbours do on average.
struct OnCircle {
    Point<double> centre{0.5, 0.5};

    template <class Real>
    Point<Real> operator()(const CurveNeighbours<Real>& curve) const {
        const Point<Real> middle = centre.cast<Real>();
        const Point<Real> a = curve.p1 - middle;
        const Point<Real> b = curve.p2 - middle;
        const Point<Real> way = a + b;
        return middle + way * ((a.norm() + b.norm()) / 2 / way.norm());
    }
};

/// A value at the vertices of a growing circle and its inside (thesis, section 9.5): 0 at the
/// start, and on the interface rising to 1. New vertices get theirs by linear interpolation. The
/// exact field depends on the place alone: what the interface had when it was there.
struct RadialValue {
    Point<double> centre{0.5, 0.5};
    double first_radius = 0;
    double last_radius = 1;
    double speed = 1; ///< at which the radius grows
    double power = 1; ///< of the rise with the radius

    [[nodiscard]] double at_radius(double radius) const {
        const double share = (radius - first_radius) / (last_radius - first_radius);
        return std::pow(std::max(share, 0.0), power);
    }
    [[nodiscard]] double exact(const Point<double>& p) const {
        return at_radius((p - centre).norm());
    }
    [[nodiscard]] double on_interface(double time) const {
        return at_radius(first_radius + speed * time);
    }
};

/// A scene with its parameters filled in.
struct Setup {
    Rectangle domain{};
    std::vector<Outline> outlines{};
    std::vector<Phase> phases{};      ///< of the outlines, in their order; empty: each of phase 1
    std::vector<dsc::Curve> curves{}; ///< in place of outlines: where several phases meet
    std::shared_ptr<const LabelImage> labels{}; ///< in place of both
    bool clamped = false;            ///< where curves end on the domain's sides, they stay
    std::optional<Phase> measured{}; ///< the one whose shape is measured; none: all but 0
    Flow flow{};
    std::vector<Phase>
        advected{}; ///< phases whose inside moves with the flow, not for the reference
    std::optional<CurvatureMotion> curvature{}; ///< replaces `flow`; not for the reference
    std::optional<Growth> growth{};             ///< the same
    std::optional<FluidMotion> fluid{};         ///< the same, in double alone
    SizeOptions<double> sizes{}; ///< targets of edges; unless edges are all of one length
    std::vector<PhaseThresholds> thresholds{}; ///< by phase; of all others those of the library
    std::optional<OnCircle> insertion{};       ///< replaces that of the parameters
    std::optional<RadialValue> value{};        ///< kept at the vertices; not by the reference
    double dt = 0;
    int steps = 0;                  ///< in total
    std::optional<int> half_step{}; ///< the step at which a reversing flow is farthest out
    /// What errors are measured against: the first outlines moved rigidly, or the smooth shape of
    /// the scene. Empty if it is unknown; at times when it is unknown, a shape whose area is NaN.
    std::function<ExactShape(double time)> exact{};

    /// The interface moves by where it is itself, rather than by a given velocity.
    [[nodiscard]] bool sees_interface() const { return curvature || growth || fluid; }
};

struct Scene {
    std::string name;
    std::string description;
    std::string section; ///< the section of the thesis that it comes from
    Parameters defaults{};
    std::function<Setup(const Parameters&)> prepare{};
    std::vector<std::string> keys = common_keys(); ///< the keys that --set accepts
    bool counts_steps_each_way = false; ///< the key `steps`; otherwise it counts them all
};

} // namespace dsc::scenes

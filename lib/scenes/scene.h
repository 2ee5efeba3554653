// SPDX-License-Identifier: MIT
// A scene (thesis, section 9): a shape, a flow, and the exact shape at any time.
#pragma once

#include "dsc/initial/label_image.h"
#include "dsc/motion/interpolation.h"
#include "flows/growing_discs.h"
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
    std::vector<PairCurvature> pairs{}; ///< pairs with a tension or mobility other than 1
    std::vector<Phase> keeps{};         ///< phases with constant area
};

/// Growth along the normal, at a speed that changes its sign once.
struct Growth {
    double speed = 1;    ///< of phase 1 into the exterior
    double turns_at = 0; ///< time from which on the phase shrinks at that speed
    std::shared_ptr<const GrowingDiscs> discs{}; ///< grow instead of phase 1, each from its start
};

/// A small wave on a level or around a circle, whose height over time is known.
struct SmallWave {
    bool is_on_circle = false;
    Point<double> middle{0.0, 0.0}; ///< centre of the circle; of a level: any point on it
    double number = 1;              ///< crests around the circle; of a level: 2 pi / wavelength
    std::function<double(double time)> exact{}; ///< its height
};

/// Motion by a fluid that fills the phases.
struct FluidMotion {
    FluidOptions options{};
    std::optional<SmallWave> wave{}; ///< with a known exact height
    /// The exact distance from the left side to the end of the interface on the bottom, as a
    /// function of time. Empty: unknown.
    std::function<double(double time)> neck{};
};

/// Edge lengths such that a given number of edges leads to the interface: the distance divided by
/// this number, but at least the finest length.
struct EdgesToInterface {
    double finest = 0;
    double number = 0;

    double operator()(double distance) const { return std::max(finest, distance / number); }
};

/// One edge length for each phase, by its number; the last one also applies to all larger numbers.
struct LengthByPhase {
    std::vector<double> lengths;

    double operator()(const Point<double>&, double, Phase phase) const {
        return lengths[std::min<std::size_t>(phase, lengths.size() - 1)];
    }
};

/// An application's interpolator that keeps a circle round (thesis, section 9.2): the distance of a
/// new vertex from the centre is the mean of those of its neighbours.
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
/// start, and rising to 1 on the interface. New vertices get values by linear interpolation. The
/// exact field depends only on the position: the value of the interface when it was there.
struct RadialValue {
    Point<double> centre{0.5, 0.5};
    double first_radius = 0;
    double last_radius = 1;
    double speed = 1; ///< at which the radius grows
    double power = 1; ///< exponent of the rise with the radius

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
    Rectangle domain{};               ///< or the box around it
    std::optional<Polygon> polygon{}; ///< the domain, if it is no rectangle
    std::vector<Outline> outlines{};
    std::vector<Phase> phases{}; ///< phases of the outlines, in their order; empty: all are phase 1
    std::vector<dsc::Curve> curves{};           ///< instead of outlines, if several phases meet
    std::shared_ptr<const LabelImage> labels{}; ///< instead of outlines and curves
    bool clamped = false;            ///< whether ends of curves on the domain's sides stay
    std::optional<Phase> measured{}; ///< the phase whose shape is measured; empty: all but 0
    Flow flow{};
    std::vector<Phase> advected{}; ///< phases whose inside is advected; not for the reference
    std::optional<CurvatureMotion> curvature{}; ///< replaces `flow`; not for the reference
    std::optional<Growth> growth{};             ///< the same
    std::optional<FluidMotion> fluid{};         ///< the same, only in double
    SizeOptions<double> sizes{};                ///< target lengths of edges, if not uniform
    std::vector<PhaseThresholds> thresholds{};  ///< by phase; all others use the library's defaults
    std::optional<OnCircle> insertion{};        ///< replaces that of the parameters
    std::optional<RadialValue> value{};         ///< stored at the vertices; not for the reference
    double dt = 0;
    int steps = 0;                  ///< in total
    std::optional<int> half_step{}; ///< the step at which the flow turns back
    /// The exact shape, against which errors are measured: the first outlines moved rigidly, or the
    /// smooth shape of the scene. Empty if it is unknown; at times when it is unknown, the area of
    /// the result is NaN.
    std::function<ExactShape(double time)> exact{};

    /// Whether the motion depends on the interface itself rather than on a given velocity.
    [[nodiscard]] bool sees_interface() const { return curvature || growth || fluid; }
};

struct Scene {
    std::string name;
    std::string description;
    std::string section; ///< the section of the thesis
    Parameters defaults{};
    std::function<Setup(const Parameters&)> prepare{};
    std::vector<std::string> keys = common_keys(); ///< the keys that --set accepts
    bool counts_steps_each_way =
        false; ///< whether the key `steps` counts the steps each way, or all
};

} // namespace dsc::scenes

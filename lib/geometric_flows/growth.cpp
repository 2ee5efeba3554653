// SPDX-License-Identifier: MIT
#include "geometric_flows/growth.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"

#include <cmath>
#include <numbers>
#include <string>

namespace dsc {

namespace {

const char* const rays_name = "dsc.growth";

std::string pair_name(const GrowthSpeed& pair) {
    return std::to_string(pair.growing) + " into " + std::to_string(pair.into);
}

// A new vertex between two rays of the same feature gets a ray between them; any other new vertex
// belongs to no fan.
template <class Real>
FanRay<Real> ray_between(const FanRay<Real>& a, const FanRay<Real>& b, double /*fraction*/) {
    FanRay<Real> ray;
    const Point<Real> sum = a.direction + b.direction;
    if (belong_together(a, b) && a.state != FanState::closing && b.state != FanState::closing &&
        sum.norm() > 0) {
        ray = {a.source,
               sum.normalized(),
               0,
               (a.to_first + b.to_first) / 2,
               (a.to_last + b.to_last) / 2,
               FanState::inserted};
    }
    return ray;
}

template <class Real>
Point<Real> right_of(const Point<Real>& tangent) {
    return {tangent.y(), -tangent.x()};
}

// The rays, which `growth_algorithm` has added.
template <class Real>
const VertexAttribute<FanRay<Real>>& rays_of(const Complex<Real>& complex) {
    const auto* const rays = fan_rays(complex);
    if (rays == nullptr) {
        throw InputError({.what = "growth needs an executor made with growth_algorithm",
                          .where = "growth",
                          .value = "an executor of another algorithm",
                          .allowed = "make_executor(..., growth_algorithm(complex, options)); in "
                                     "Python, dsc.Simulation(mesh, flow, ...)"});
    }
    return *rays;
}

// The growth of one interface at one time.
template <class Real>
class Front {
public:
    Front(const GrowthOptions<Real>& options, const InterfaceView<Real>& view, Real time)
        : options_(options), view_(view), time_(time), rays_(rays_of(view.complex)),
          straight_(static_cast<Real>(std::sin(options.smooth_degrees * std::numbers::pi / 180))) {}

    [[nodiscard]] Point<Real> velocity(std::size_t i) const {
        if (view_.is_junction(i)) {
            return of_junction(i);
        }
        const Real speed = speed_at(i, view_.left[i], view_.right[i]);
        if (speed == 0) {
            return Point<Real>::Zero();
        }
        if (const FanRay<Real>* ray = ray_of(i)) {
            return ray->state == FanState::closing ? ray->direction
                                                   : Point<Real>(speed * ray->direction);
        }
        return view_.is_feature(i) ? of_feature(i, speed) : speed * normal(view_, i);
    }

private:
    [[nodiscard]] Real speed_at(std::size_t i, Phase left, Phase right) const {
        return growth_speed(options_, left, right, view_.positions[i], time_);
    }
    [[nodiscard]] const FanRay<Real>* ray_of(std::size_t i) const {
        const FanRay<Real>& ray = rays_[view_.vertices[i]];
        return ray.state == FanState::none ? nullptr : &ray;
    }

    // The tangent of the sheet that reaches i from its neighbour.
    [[nodiscard]] Point<Real> tangent_to(std::size_t i, std::uint32_t neighbour) const {
        const Point<Real>& at = view_.positions[i];
        const Point<Real>& before = view_.positions[neighbour];
        if (view_.is_junction(neighbour) || view_.is_feature(neighbour)) {
            return end_tangent<Real>(before, before, at);
        }
        const bool is_on = view_.next[neighbour] == i;
        const std::uint32_t beyond = is_on ? view_.previous[neighbour] : view_.next[neighbour];
        return end_tangent<Real>(view_.positions[beyond], before, at);
    }

    // The velocity of the point where two sheets meet that move by `speed` along n and m: the
    // intersection of their offsets.
    [[nodiscard]] Point<Real> of_notch(const Point<Real>& n, const Point<Real>& m,
                                       Real speed) const {
        const Point<Real> sum = n + m;
        const Real size = sum.norm(); // twice the cosine of half the turn
        const Real max = static_cast<Real>(options_.max_notch);
        if (size * max > 2) {
            return (2 * speed / (size * size)) * sum;
        }
        return size > 0 ? Point<Real>((speed * max / size) * sum) : Point<Real>(speed * n);
    }

    [[nodiscard]] Point<Real> of_feature(std::size_t i, Real speed) const {
        const Point<Real> in = tangent_to(i, view_.previous[i]);
        const Point<Real> out = -tangent_to(i, view_.next[i]);
        // Sheets that move apart open an arc between them, for which the pass makes a fan.
        return cross<Real>(in, out) * speed > 0 ? Point<Real>(speed * normal(view_, i))
                                                : of_notch(right_of(in), right_of(out), speed);
    }

    // The least-squares velocity v with v.n = speed for the normal n of each sheet; along the
    // domain boundary for a vertex there.
    [[nodiscard]] Point<Real> of_junction(std::size_t i) const {
        Point<Real> x = Point<Real>::Zero(); // the rows of the normal equations
        Point<Real> y = Point<Real>::Zero();
        Point<Real> right = Point<Real>::Zero();
        Point<Real> boundary = Point<Real>::Zero();
        Point<Real> inwards = Point<Real>::Zero(); // of the domain
        Point<Real> sheet = Point<Real>::Zero();
        Point<Real> seam = Point<Real>::Zero(); // its normal
        int sheets = 0;                         // that move
        Real fastest = 0;
        for (const InterfaceArm& arm : arms_of(view_, i)) {
            const Point<Real> along = -tangent_to(i, arm.neighbour);
            if (arm.left == border_phase || arm.right == border_phase) {
                boundary = along;
                inwards = arm.left == border_phase ? right_of<Real>(along)
                                                   : Point<Real>(-right_of<Real>(along));
                continue;
            }
            const Point<Real> n = right_of<Real>(along);
            const Real speed = speed_at(i, arm.left, arm.right);
            if (speed == 0 && is_seam(i, arm)) {
                seam = n;
                continue;
            }
            x += n.x() * n;
            y += n.y() * n;
            right += speed * n;
            fastest = std::max(fastest, std::abs(speed));
            if (speed != 0) {
                sheet = along;
                ++sheets;
            }
        }
        // The fronts say where a seam goes on; its own direction counts only where they are one
        // line.
        if (!(cross<Real>(x, y) > straight_ * straight_)) {
            x += seam.x() * seam;
            y += seam.y() * seam;
        }
        Point<Real> velocity = Point<Real>::Zero();
        if (view_.is_on_boundary(i)) {
            // The domain boundary may belong to the exterior on one side, where it is no part of
            // the interface: the pass of movement keeps the vertex on it in any case.
            const Real across = boundary.x() * x.dot(boundary) + boundary.y() * y.dot(boundary);
            velocity = across > 0 ? Point<Real>(boundary.dot(right) / across * boundary) : right;
            // Within a sub-step the next vertex may be on the other side of the domain boundary:
            // the end moves on, and does not turn round.
            if (sheets == 1 && sheet.dot(inwards) < 0 && sheet.dot(velocity) < 0) {
                velocity = -velocity;
            }
        } else if (const Real determinant = cross<Real>(x, y);
                   determinant > straight_ * straight_) {
            velocity = {cross<Real>(right, Point<Real>(x.y(), y.y())) / determinant,
                        cross<Real>(Point<Real>(x.x(), y.x()), right) / determinant};
        } else {
            velocity = right; // a single sheet, or a straight line
        }
        const Real size = velocity.norm();
        const Real max = size > fastest ? fastest * notch_of(i, velocity / size) : fastest;
        return size > max ? Point<Real>(max / size * velocity) : velocity;
    }

    // Whether a sheet lies between two phases whose fronts have met at the junction.
    [[nodiscard]] bool is_seam(std::size_t i, const InterfaceArm& seam) const {
        const auto has_front = [&](Phase phase) {
            return std::ranges::any_of(arms_of(view_, i), [&](const InterfaceArm& arm) {
                return arm.left != border_phase && arm.right != border_phase &&
                       (arm.left == phase || arm.right == phase) &&
                       speed_at(i, arm.left, arm.right) != 0;
            });
        };
        return has_front(seam.left) && has_front(seam.right);
    }

    // How many times faster than its sheets a junction may move in this direction. Where all moving
    // sheets trail behind it, it is the tip of what grows, which spreads as an arc: no faster than
    // they, although their offsets intersect farther on. A sheet that leans forward at an angle
    // allows 1 / sin of it, so that nothing jumps between the two.
    [[nodiscard]] Real notch_of(std::size_t i, const Point<Real>& direction) const {
        Real forward = 0; // the cosine for the sheet that leans forward most
        for (const InterfaceArm& arm : arms_of(view_, i)) {
            if (arm.left != border_phase && arm.right != border_phase &&
                speed_at(i, arm.left, arm.right) != 0) {
                forward = std::max(forward, -tangent_to(i, arm.neighbour).dot(direction));
            }
        }
        const Real sine = std::sqrt(std::max(1 - forward * forward, Real(0)));
        const Real max = static_cast<Real>(options_.max_notch);
        return sine * max > 1 ? 1 / sine : max;
    }

    const GrowthOptions<Real>& options_;
    const InterfaceView<Real>& view_;
    Real time_;
    const VertexAttribute<FanRay<Real>>& rays_;
    Real straight_; // sheets that make a smaller angle (its sine) have no intersection
};

} // namespace

template <class Real>
void check_growth(const GrowthOptions<Real>& options) {
    for (std::size_t i = 0; i < options.speeds.size(); ++i) {
        const GrowthSpeed& pair = options.speeds[i];
        if (pair.growing == pair.into || pair.growing == border_phase ||
            pair.into == border_phase) {
            throw InputError({.what = "not a pair of phases",
                              .where = "growth.speeds",
                              .value = pair_name(pair),
                              .allowed = "two different phases of the complex"});
        }
        require(std::isfinite(pair.speed), ("growth.speeds: " + pair_name(pair)).c_str(),
                pair.speed, "a finite speed");
        for (std::size_t k = 0; k < i; ++k) {
            const GrowthSpeed& other = options.speeds[k];
            if (std::minmax(pair.growing, pair.into) == std::minmax(other.growing, other.into)) {
                throw InputError({.what = "two speeds for one pair of phases",
                                  .where = "growth.speeds",
                                  .value = pair_name(pair),
                                  .allowed = "each pair once"});
            }
        }
    }
    require(options.open_degrees >= 1 && options.open_degrees <= 180, "growth.open_degrees",
            options.open_degrees, "1 to 180 degrees");
    require(options.fan_degrees >= 1 && options.fan_degrees < options.open_degrees,
            "growth.fan_degrees", options.fan_degrees,
            "1 degree or more, less than growth.open_degrees, or fans open without end");
    require(options.smooth_degrees > 0 && options.smooth_degrees < options.open_degrees,
            "growth.smooth_degrees", options.smooth_degrees,
            "more than 0, less than growth.open_degrees");
    require(options.notch_degrees > options.smooth_degrees && options.notch_degrees <= 180,
            "growth.notch_degrees", options.notch_degrees,
            "more than growth.smooth_degrees, up to 180 degrees");
    require(options.max_notch >= 1 && std::isfinite(options.max_notch), "growth.max_notch",
            options.max_notch, "1 or more");
}

template <class Real>
Real growth_speed(const GrowthOptions<Real>& options, Phase left, Phase right,
                  const Point<Real>& place, Real time) {
    for (const GrowthSpeed& pair : options.speeds) {
        const bool grows = pair.growing == left && pair.into == right;
        if (grows || (pair.growing == right && pair.into == left)) {
            const auto speed = static_cast<Real>(grows ? pair.speed : -pair.speed);
            return options.factor && speed != 0 ? speed * options.factor(place, time) : speed;
        }
    }
    return 0;
}

template <class Real>
VertexAttribute<FanRay<Real>>* fan_rays(Complex<Real>& complex) {
    return complex.attributes.contains(rays_name)
               ? &complex.attributes.template get<Vertex, FanRay<Real>>(rays_name)
               : nullptr;
}

template <class Real>
const VertexAttribute<FanRay<Real>>* fan_rays(const Complex<Real>& complex) {
    return complex.attributes.contains(rays_name)
               ? &complex.attributes.template get<Vertex, FanRay<Real>>(rays_name)
               : nullptr;
}

template <class Real>
VertexAttribute<FanRay<Real>>& add_fan_rays(Complex<Real>& complex) {
    auto* const there = fan_rays(complex);
    return there != nullptr ? *there
                            : complex.attributes.template add<Vertex>(rays_name, FanRay<Real>{},
                                                                      &ray_between<Real>);
}

template <class Real>
Point<Real> end_tangent(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    constexpr Real straight_enough = Real(0.82); // cosine of 35 degrees: where the sheet turns by
                                                 // more, b is a feature
    const Point<Real> chord = c - b;
    const Real length = chord.norm();
    if (!(length > 0)) {
        return Point<Real>::Zero();
    }
    // The tangent makes the angle with the chord under which the chord is seen from a.
    Point<Real> turn(1, 0);
    if (turns_less<Real>(a, b, c, straight_enough)) {
        const Point<Real> near = b - a;
        const Point<Real> far = c - a;
        turn = Point<Real>(near.dot(far), cross<Real>(near, far)).normalized();
    }
    return Point<Real>(turn.x() * chord.x() - turn.y() * chord.y(),
                       turn.y() * chord.x() + turn.x() * chord.y()) /
           length;
}

template <class Real>
InterfaceFlow<Real> growth(const GrowthOptions<Real>& options) {
    check_growth(options);
    return [options](const InterfaceView<Real>& view, std::size_t begin, std::size_t end, Real time,
                     std::span<Point<Real>> velocities) {
        const Front<Real> front(options, view, time);
        for (std::size_t i = begin; i < end; ++i) {
            velocities[i] = front.velocity(i);
        }
    };
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void check_growth(const GrowthOptions<Real>&);                                        \
    template Real growth_speed(const GrowthOptions<Real>&, Phase, Phase, const Point<Real>&,       \
                               Real);                                                              \
    template VertexAttribute<FanRay<Real>>* fan_rays(Complex<Real>&);                              \
    template const VertexAttribute<FanRay<Real>>* fan_rays(const Complex<Real>&);                  \
    template VertexAttribute<FanRay<Real>>& add_fan_rays(Complex<Real>&);                          \
    template Point<Real> end_tangent(const Point<Real>&, const Point<Real>&, const Point<Real>&);  \
    template InterfaceFlow<Real> growth(const GrowthOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

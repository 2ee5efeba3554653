// SPDX-License-Identifier: MIT
#include "flows/sine_cosine.h"
#include "scenes/space/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dsc::scenes::space {

namespace {

using dsc3::Point;
using std::numbers::pi;
using Positions = std::span<const Point>;
using Velocities = std::span<Point>;

double ball_volume(double radius) { return 4.0 / 3 * pi * std::pow(radius, 3); }

// A ball that ends as a ball. Unless their number is given, steps have the duration h.
Setup ball_setup(const Parameters& p, double duration, const Point& first, double first_radius,
                 const Point& last, double last_radius) {
    Setup setup;
    setup.shapes = {{dsc3::ball(first, first_radius), 1}};
    setup.steps = p.steps > 0 ? p.steps : static_cast<int>(std::ceil(duration / p.h - 1e-9));
    setup.dt = duration / setup.steps;
    setup.last = dsc3::ball(last, last_radius);
    setup.volume_last = ball_volume(last_radius);
    return setup;
}

Setup translation(const Parameters& p) {
    const Point velocity(0.4, 0.4, 0.4);
    const Point first(0.3, 0.3, 0.3);
    Setup setup = ball_setup(p, 1, first, 0.15, first + velocity, 0.15);
    setup.velocity = [velocity](Positions positions, double, Velocities velocities) {
        std::fill_n(velocities.begin(), positions.size(), velocity);
    };
    return setup;
}

Setup rotation(const Parameters& p) {
    const Point first(0.5, 0.7, 0.5);
    Setup setup = ball_setup(p, 1, first, 0.15, first, 0.15);
    setup.velocity = [](Positions positions, double, Velocities velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double x = positions[i].x() - 0.5;
            const double y = positions[i].y() - 0.5;
            velocities[i] = {-2 * pi * y, 2 * pi * x, 0};
        }
    };
    return setup;
}

// S. T. Zalesak's disc (1979) in three dimensions: a ball with a slot, which turns about an axis.
// The slot's edges are rounded by the first complex, which has no feature lines.
struct SlottedBall {
    Point centre{0.5, 0.75, 0.5};
    double radius = 0.15;
    double half_width = 0.025;
    double top = 0.1; // height of the slot's end above the centre

    [[nodiscard]] double distance(const Point& p) const {
        const Point r = p - centre;
        const double slot = std::max(std::abs(r.x()) - half_width, r.y() - top);
        return std::max(r.norm() - radius, -slot);
    }
    // The cross-sections of the slot integrated over x by Simpson's rule.
    [[nodiscard]] double volume() const {
        constexpr int n = 64;
        double slot = 0;
        for (int i = 0; i <= n; ++i) {
            const double x = half_width * i / n;
            const double square = radius * radius - x * x;
            const double section = square * (pi / 2 + std::asin(top / std::sqrt(square))) +
                                   top * std::sqrt(square - top * top);
            slot += section * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2);
        }
        return ball_volume(radius) - 2 * slot * half_width / (3 * n);
    }
};

Setup slotted(const Parameters& p) {
    const SlottedBall shape;
    Setup setup = rotation(p);
    setup.last = [shape](const Point& place) { return shape.distance(place); };
    setup.shapes = {{setup.last, 1}};
    setup.volume_last = shape.volume();
    return setup;
}

// D. Enright et al., "A hybrid particle level set method for improved interface capturing" (2002);
// the field is that of R. J. LeVeque (1996).
Setup enright(const Parameters& p) {
    const Point first(0.35, 0.35, 0.35);
    const double period = p.period;
    Setup setup = ball_setup(p, period, first, 0.15, first, 0.15);
    if (setup.steps % 2 == 0) {
        setup.half_step = setup.steps / 2;
    }
    setup.velocity = [period](Positions positions, double time, Velocities velocities) {
        const double factor = std::cos(pi * time / period);
        constexpr std::size_t block = 64;
        std::array<Point, block> sine;
        std::array<Point, block> cosine;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const std::size_t k = i % block;
            if (k == 0) {
                const std::size_t count = std::min(block, positions.size() - i);
                sine_cosine_pi(positions[i].data(), 3 * count, sine[0].data(), cosine[0].data());
            }
            const Point& s = sine[k];
            const Point d = 2 * s.cwiseProduct(cosine[k]);
            velocities[i] = {2 * factor * s.x() * s.x() * d.y() * d.z(),
                             -factor * d.x() * s.y() * s.y() * d.z(),
                             -factor * d.x() * d.y() * s.z() * s.z()};
        }
    };
    return setup;
}

Setup growing(const Parameters& p) {
    const Point middle(0.5, 0.5, 0.5);
    Setup setup = ball_setup(p, 1, middle, 0.1, middle, 0.3);
    setup.velocity = [middle](Positions positions, double, Velocities velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = 0.2 * (positions[i] - middle).normalized();
        }
    };
    return setup;
}

} // namespace

const std::vector<Scene>& catalogue() {
    const Parameters defaults{.h = 1.0 / 32};
    Parameters returning = defaults;
    returning.period = 3;
    static const std::vector<Scene> scenes{
        {"translation-3d", "a ball is advected along", "3D", defaults, translation},
        {"rotation-3d", "a ball turns about an axis", "3D", defaults, rotation},
        {"slotted-sphere", "a ball with a slot turns about an axis", "3D", defaults, slotted},
        {"enright",
         "a ball becomes a film and comes back",
         "3D",
         returning,
         enright,
         {"h", "steps", "period", "integrator"}},
        {"growing-sphere", "a ball grows along its normals", "3D", defaults, growing},
    };
    return scenes;
}

const Scene* find_scene(const std::string& name) {
    const auto& scenes = catalogue();
    const auto at = std::find_if(scenes.begin(), scenes.end(),
                                 [&](const Scene& scene) { return scene.name == name; });
    return at == scenes.end() ? nullptr : &*at;
}

} // namespace dsc::scenes::space

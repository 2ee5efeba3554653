// SPDX-License-Identifier: MIT
// Random shapes and random flows for the tests of the whole method: the same seed gives the same
// scene on every machine.
#pragma once

#include "support/environment.h"

#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/motion/integrator.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace dsc::test {

/// The distributions of <random> differ between standard libraries; its engines do not.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    /// Draws these bytes first, two at a time, and continues as Dice(0): for fuzzers.
    explicit Dice(std::span<const std::uint8_t> loaded) : loaded_(loaded), engine_(0) {}
    double in(double low, double high) {
        return low + (high - low) * (static_cast<double>(draw() >> 11U) * 0x1p-53);
    }
    int in(int low, int high) {
        return low + static_cast<int>(draw() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// The order of two draws in the arguments of a call would depend on the compiler.
    Point<double> point(double low, double high) {
        const double y = in(low, high);
        const double x = in(low, high);
        return {x, y};
    }
    bool chance(double probability) { return in(0.0, 1.0) < probability; }
    /// One of the values of an enum.
    template <class Enum, std::size_t n>
    Enum one_of(const EnumTable<Enum, n>& table) {
        return table[draw() % n].value;
    }

private:
    std::uint64_t draw() {
        if (loaded_.size() < 2) {
            return engine_();
        }
        const std::uint64_t two = loaded_[0] | static_cast<std::uint64_t>(loaded_[1]) << 8U;
        loaded_ = loaded_.subspan(2);
        return two * 0x0001000100010001U; // four times, as callers use any of the bits
    }

    std::span<const std::uint8_t> loaded_;
    std::mt19937_64 engine_;
};

inline std::vector<Point<double>> circle_points(const Point<double>& centre, double radius, int n) {
    std::vector<Point<double>> points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        points.emplace_back(centre + radius * Point<double>(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// The unit square with a disc of phase 1 in it.
template <class Real>
Complex<Real> disc_complex(double h, const Point<double>& centre = {0.5, 0.5},
                           double radius = 0.25) {
    const int n = static_cast<int>(std::ceil(2 * std::numbers::pi * radius / h));
    const std::vector<Shape> shapes{{circle_points(centre, radius, n), 1}};
    return initial_complex<Real>({}, shapes, {.edge_length = h});
}

/// Stars with one to seven irregular arms, separated in the cells of a grid; some with a hole of
/// another phase.
template <class Real>
Complex<Real> random_shapes(Dice& dice, double h) {
    const int cells = h < 0.035 ? dice.in(1, 3) : dice.in(1, 2);
    const double cell = 1.0 / cells;
    std::vector<Shape> shapes;
    for (int i = 0; i < cells * cells; ++i) {
        if (!shapes.empty() && dice.chance(0.3)) {
            continue;
        }
        const Point<double> centre((i % cells + 0.5) * cell, (i / cells + 0.5) * cell);
        const double radius = dice.in(0.25, 0.4) * cell;
        const double depth = dice.in(0.0, 0.35);
        const int arms = dice.in(1, 7);
        const double turn = dice.in(0.0, 6.0);
        std::vector<Point<double>> points =
            circle_points({0, 0}, 1, std::max(8, static_cast<int>(6 * radius / h)));
        for (auto& p : points) {
            const double angle = std::atan2(p.y(), p.x());
            p = centre + radius * (1 - depth * (0.5 + 0.5 * std::sin(arms * angle + turn))) * p;
        }
        const auto phase = static_cast<Phase>(dice.in(1, 3));
        shapes.push_back({points, phase});
        if (dice.chance(0.3) && radius > 5 * h) {
            const int n = std::max(8, static_cast<int>(2 * radius / h));
            shapes.push_back({circle_points(centre, 0.3 * radius, n),
                              dice.chance(0.5) ? exterior_phase : phase + 1});
        }
    }
    return initial_complex<Real>({}, shapes, {.edge_length = h});
}

struct Site {
    double x, y;
    Phase phase;
};

/// No shapes, but each triangle has the phase of the site that is nearest to its middle.
template <class Real>
Complex<Real> complex_of_sites(double h, std::span<const Site> sites) {
    auto complex = initial_complex<Real>({}, {}, {.edge_length = h});
    for (const Triangle t : triangles(complex)) {
        Point<double> middle = Point<double>::Zero();
        for (const Vertex v : complex.vertices_of(t)) {
            middle += complex.position(v).template cast<double>() / 3;
        }
        const auto squared_distance = [x = middle.x(), y = middle.y()](const Site& site) {
            return (site.x - x) * (site.x - x) + (site.y - y) * (site.y - y);
        };
        complex.set_phase(t, std::ranges::min_element(sites, {}, squared_distance)->phase);
    }
    return complex;
}

/// Random phases of the triangles: junctions, pinched vertices, phases at the domain boundary. With
/// few patches, phases form large pieces.
template <class Real>
Complex<Real> random_patches(Dice& dice, double h, int patches) {
    std::vector<Site> sites;
    for (int i = 0; i < patches; ++i) {
        const Point<double> at = dice.point(0, 1);
        sites.push_back({at.x(), at.y(), static_cast<Phase>(dice.in(0, 3))});
    }
    return complex_of_sites<Real>(h, sites);
}

/// As many phases as grains, from 1 on.
inline Complex<double> random_grains(int count, double h, std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Site> sites;
    for (int i = 0; i < count; ++i) {
        const double x = dice.in(0.0, 1.0);
        sites.push_back({x, dice.in(0.0, 1.0), static_cast<Phase>(i + 1)});
    }
    return complex_of_sites<double>(h, sites);
}

/// Irregularities of a flow, which the library need not follow accurately but must survive.
enum class Wildness : std::uint8_t {
    none,
    not_a_number, ///< in a disc
    infinite,     ///< in a disc
    absurd,       ///< a speed of 1e300 in a disc
    torn,         ///< opposite velocities on the two sides of a line
    sink,         ///< everything to one point
    noise,        ///< neighbours are independent of each other
};

inline constexpr std::array wildness_names{
    Named{Wildness::none, "none"},         Named{Wildness::not_a_number, "not_a_number"},
    Named{Wildness::infinite, "infinite"}, Named{Wildness::absurd, "absurd"},
    Named{Wildness::torn, "torn"},         Named{Wildness::sink, "sink"},
    Named{Wildness::noise, "noise"},
};

/// A sum of waves: of a stream function, and of a small potential, that change with time.
class RandomFlow {
public:
    RandomFlow(Dice& dice, double speed, Wildness wildness)
        : speed_(speed), wildness_(wildness), centre_(dice.point(0.1, 0.9)) {
        for (int i = 0; i < 5; ++i) {
            const Point<double> number = dice.point(-9, 9);
            const Point<double> along = number / (1 + number.norm());
            waves_.push_back({number.x(), number.y(), along.x(), along.y(), dice.in(0.0, 6.0),
                              dice.in(-6.0, 6.0), dice.chance(0.7) ? 0.0 : dice.in(-0.5, 0.5)});
        }
    }

    template <class Real>
    [[nodiscard]] dsc::Velocity<Real> velocity() const {
        return [flow = *this](std::span<const Point<Real>> positions, Real time,
                              std::span<Point<Real>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] =
                    flow.at(positions[i].template cast<double>(), static_cast<double>(time))
                        .template cast<Real>();
            }
        };
    }

private:
    struct Wave {
        double number_x;
        double number_y;
        double along_x;
        double along_y;
        double phase;
        double frequency;
        double potential; ///< its share of the wave
    };

    // Scalars are used, because under the sanitizers, without optimisation, Eigen's vectors would
    // take longer here than the whole library.
    [[nodiscard]] Point<double> at(const Point<double>& p, double time) const {
        const double p_x = p.x();
        const double p_y = p.y();
        double x = 0;
        double y = 0;
        for (const Wave& wave : waves_) {
            const double value = std::cos(wave.number_x * p_x + wave.number_y * p_y + wave.phase +
                                          wave.frequency * time);
            x += value * (wave.potential * wave.along_x - wave.along_y);
            y += value * (wave.potential * wave.along_y + wave.along_x);
        }
        const Point<double> sum(x * speed_, y * speed_);
        const auto inside = [&] { return (p - centre_).norm() < 0.2; };
        switch (wildness_) {
        case Wildness::none: break;
        case Wildness::not_a_number:
            return inside() ? constant(std::numeric_limits<double>::quiet_NaN()) : sum;
        case Wildness::infinite:
            return inside() ? constant(std::numeric_limits<double>::infinity()) : sum;
        case Wildness::absurd: return inside() ? constant(1e300) : sum;
        case Wildness::torn: return p.x() + p.y() < 1 ? sum : Point<double>(-sum);
        case Wildness::sink: return speed_ * (centre_ - p) / ((centre_ - p).norm() + 1e-9);
        case Wildness::noise: {
            const double angle = 1e5 * std::sin(1e4 * p.x() + 2e4 * p.y());
            return speed_ * Point<double>(std::cos(angle), std::sin(angle));
        }
        }
        return sum;
    }

    static Point<double> constant(double value) { return {value, 0.0}; }

    double speed_;
    Wildness wildness_;
    Point<double> centre_;
    std::vector<Wave> waves_;
};

/// For each vertex id: 1 if the vertex belongs to an interface edge, as derived from the phases.
template <class Real>
std::vector<std::uint8_t> on_interface(const Complex<Real>& complex) {
    std::vector<std::uint8_t> on(complex.vertex_bound(), 0);
    for (const Triangle t : triangles(complex)) {
        for (const Edge e : complex.edges_of(t)) {
            if (is_interface(complex, e)) {
                for (const Vertex v : complex.vertices_of(e)) {
                    on[v.id] = 1;
                }
            }
        }
    }
    return on;
}

/// The first error in a list of interface vertices, in which each must occur once; empty if it is
/// correct.
template <class Real>
std::string interface_fault(const Complex<Real>& complex, const std::vector<std::uint32_t>& list) {
    auto on = on_interface(complex);
    for (const std::uint32_t v : list) {
        if (v >= on.size() || on[v] == 0) {
            return "vertex " + std::to_string(v) + " is listed twice or not on the interface";
        }
        on[v] = 0;
    }
    for (std::size_t v = 0; v < on.size(); ++v) {
        if (on[v] != 0) {
            return "vertex " + std::to_string(v) + " of the interface is not listed";
        }
    }
    return {};
}

/// The number of steps of a test of threads: under the thread sanitizer, races show in the first
/// steps that divide the mesh, hand over vertices and divide it again.
inline int steps_or_fewer(int steps) { return are_asked_for("few") ? std::min(steps, 5) : steps; }

} // namespace dsc::test

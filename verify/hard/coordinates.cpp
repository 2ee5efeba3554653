// SPDX-License-Identifier: MIT
// Coordinates far from the origin, scenes of any size, and the limits of the scalar.
#include "scene.h"
#include "watch.h"

#include "dsc/base/error.h"
#include "flows/exact.h"
#include "flows/velocity.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"
#include "replay/mesh_hash.h"
#include "shapes/shapes.h"
#include "support/frame_testing.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::hard {

namespace {

using scenes::Outline;

constexpr int offset_steps = 150;

// A circle that moves to the right, and one that rotates, in the unit square times `size` plus
// `offset`.
struct Place {
    double size = 1;
    double offset = 0;
    double h = 0.02; ///< in units of `size`

    [[nodiscard]] Point<double> at(double x, double y) const {
        return {offset + size * x, offset + size * y};
    }
    [[nodiscard]] Rectangle domain() const { return {at(0, 0), at(1, 1)}; }
    [[nodiscard]] std::vector<Outline> outlines() const {
        // The circle is made at unit size and then placed, so that all cases have the same circle
        // up to rounding.
        return mapped(std::vector<Outline>{scenes::circle({0.35, 0.5}, 0.2, h)},
                      [this](const Point<double>& p) { return at(p.x(), p.y()); });
    }
};

enum class Motion { translation, rotation };

scenes::Velocity velocity_of(Motion motion, const Place& place) {
    // The velocity: 0.3 of the domain, or a quarter turn, per unit of time.
    if (motion == Motion::translation) {
        return scenes::Translation{{0.3 * place.size, 0}};
    }
    return scenes::Rotation{place.at(0.5, 0.5), std::numbers::pi / 2};
}

std::vector<Outline> exact_of(Motion motion, const Place& place) {
    const auto outlines = place.outlines();
    if (motion == Motion::translation) {
        return scenes::translated_shape(outlines, {0.3 * place.size, 0}).outlines;
    }
    return scenes::rotated_shape(outlines, place.at(0.5, 0.5), std::numbers::pi / 2).outlines;
}

// The final interface in coordinates of the unit square, from a run without or with a frame.
template <class Real>
std::vector<Outline> run_at(const Place& place, Motion motion, bool with_frame, HardResult& result,
                            std::uint64_t* hash = nullptr) {
    const auto velocity = velocity_of(motion, place);
    constexpr double dt = 1.0 / offset_steps;
    const Frame frame =
        with_frame ? choose_frame(place.domain().low, place.domain().high) : Frame{};
    auto scene = scene_of<Real>(frame, place.domain(), place.outlines(), place.h * place.size);
    Watch<Real> watch(scene.complex, scene.options, {.domain = scene.domain, .thorough_every = 10},
                      result);
    watch.run(test::velocity_in<Real>(frame, velocity), 0, dt, offset_steps);
    if (hash != nullptr) {
        *hash = mesh_hash(scene.complex);
    }
    // The difference is exact for coordinates far from the origin; the division by the size rounds
    // once.
    return mapped(scenes::interface_outlines(scene.complex), [&](const Point<double>& unit) {
        if (with_frame) {
            const Point<double> shift = frame.origin - place.at(0, 0);
            return Point<double>((unit * frame.unit + shift) / place.size);
        }
        return Point<double>((unit - place.at(0, 0)) / place.size);
    });
}

double error_of(const std::vector<Outline>& outlines, Motion motion, double h = 0.02) {
    const auto exact = exact_of(motion, {.h = h});
    return scenes::symmetric_difference(outlines, exact) / scenes::signed_area(exact);
}

// The shape error from rounding the coordinates once: at most that of moving the whole outline by
// half a step of the scalar in x and in y.
double rounding_cost(const std::vector<Outline>& outlines, double offset, double epsilon) {
    return scenes::perimeter(outlines) * 0.5 * epsilon * std::abs(offset) * std::numbers::sqrt2 /
           scenes::signed_area(outlines);
}

HardResult offset_case(double offset, bool with_frame) {
    HardResult result;
    result.asked = "a circle translated and turned, " + text(offset) +
                   " from the origin at h = 0.02" +
                   (with_frame ? ", in the coordinates of a frame" : "");
    const Place there{.offset = offset};
    double worst_share = 0;
    const double once =
        rounding_cost(Place{}.outlines(), offset, std::numeric_limits<double>::epsilon());
    for (const Motion motion : {Motion::translation, Motion::rotation}) {
        HardResult plain;
        const double at_origin = error_of(run_at<double>({}, motion, false, plain), motion);
        const double far = error_of(run_at<double>(there, motion, with_frame, result), motion);
        // Without a frame each step rounds again, perhaps in the same direction each time.
        const double allowed = at_origin + 1e-13 + (with_frame ? 3 : 2 * (offset_steps + 1)) * once;
        note_error(result, far, allowed);
        worst_share = std::max(worst_share, (far - at_origin) / once);
    }
    result.happened = "the offset adds " + text(worst_share) +
                      " times what rounding the coordinates once costs (" + text(once) + ")";
    expect_sound(result, Targets::reachable);
    return result;
}

HardResult size_case(double size) {
    HardResult result;
    result.asked = "the same scene at a size of " + text(size) + ", in the coordinates of a frame";
    for (const Motion motion : {Motion::translation, Motion::rotation}) {
        HardResult plain;
        const double at_one =
            error_of(run_at<double>({.h = 0.05}, motion, false, plain), motion, 0.05);
        const double here =
            error_of(run_at<double>({.size = size, .h = 0.05}, motion, true, result), motion, 0.05);
        note_error(result, here, at_one + 1e-12);
    }
    result.happened = "as at unit size";
    expect_sound(result, Targets::reachable);
    return result;
}

// Scaling by a power of two must not change anything.
HardResult power_case(int exponent, bool with_frame) {
    HardResult result;
    result.asked = "the same scene times 2^" + std::to_string(exponent) +
                   (with_frame ? ", in the coordinates of a frame" : ", as it is");
    bool same = true;
    for (const Motion motion : {Motion::translation, Motion::rotation}) {
        HardResult plain;
        std::uint64_t one = 0;
        std::uint64_t scaled = 0;
        const auto at_one = run_at<double>({.h = 0.05}, motion, false, plain, &one);
        const Place place{.size = std::ldexp(1.0, exponent), .h = 0.05};
        const auto here = run_at<double>(place, motion, with_frame, result, &scaled);
        same = same && here == at_one && (!with_frame || scaled == one);
        result.error = error_of(here, motion, 0.05);
    }
    expect(result, same, "not the bits of the run at unit size");
    result.happened = same ? "the same bits as at unit size" : "other bits than at unit size";
    expect_sound(result, Targets::reachable);
    return result;
}

HardResult bare_size_case(double size) {
    HardResult result;
    result.asked = "a scene of size " + text(size) + " without a frame";
    const Place place{.size = size, .h = 0.05};
    auto scene = scene_of<double>(place.domain(), place.outlines(), place.h * place.size);
    try {
        const Simulation<double> simulation(scene.complex, scene.options);
        result.failures.emplace_back("no InputError");
    } catch (const InputError& error) {
        result.error_message = error.what();
        expect(result, error.allowed().find("choose_frame") != std::string::npos,
               "the error does not name the way out: " + result.error_message);
    }
    result.happened = "refused by a typed error that names the way out";
    return result;
}

// At this offset, float cannot even represent a mesh with such edges.
HardResult float_mapped_case() {
    HardResult result;
    result.asked = "float at an offset of 1e5, h = 0.02, in the coordinates of a frame";
    const Place there{.offset = 1e5};
    constexpr auto epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());
    // A bound of the sum of all steps' rounding errors, for coordinates up to 1.
    const double allowed = 2 * (offset_steps + 1) * rounding_cost(Place{}.outlines(), 1.0, epsilon);
    for (const Motion motion : {Motion::translation, Motion::rotation}) {
        note_error(result, error_of(run_at<float>(there, motion, true, result), motion), allowed);
    }
    result.happened = "as at the origin: only the roundings of the steps in float remain";
    expect_sound(result, Targets::reachable);
    return result;
}

} // namespace

void append_coordinates(std::vector<HardCase>& cases) {
    for (const int power : {3, 6, 9, 12}) {
        const double offset = std::pow(10.0, power);
        const std::string name = "offset-1e" + std::to_string(power);
        cases.push_back({name, [offset] { return offset_case(offset, false); }});
        cases.push_back({name + "-mapped", [offset] { return offset_case(offset, true); }});
    }
    for (const int power : {-150, -75, -30, 30, 75, 150}) {
        cases.push_back({"size-1e" + std::to_string(power) + "-mapped",
                         [power] { return size_case(std::pow(10.0, power)); }});
    }
    for (const int power : {-498, 498}) {
        cases.push_back({"size-2^" + std::to_string(power) + "-mapped",
                         [power] { return power_case(power, true); }});
    }
    for (const int power : {-150, 150}) {
        cases.push_back(
            {"size-2^" + std::to_string(power), [power] { return power_case(power, false); }});
    }
    for (const int power : {-75, 75}) {
        cases.push_back({"size-1e" + std::to_string(power),
                         [power] { return bare_size_case(std::pow(10.0, power)); }});
    }
    cases.push_back({"float-offset-1e5-mapped", float_mapped_case});
}

} // namespace dsc::hard

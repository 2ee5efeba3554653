// SPDX-License-Identifier: MIT
// The polygon of markers: its parts, and its errors in the single vortex, a floor for methods that
// track the interface by edges.
#include "reference/algorithm/bare_markers.h"

#include "flows/exact.h"
#include "measures/symmetric_difference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::bare_markers_test {
namespace {

using reference::InterfacePoint;
using reference::MarkerOptions;
using reference::Markers;

constexpr double period = 8;
const Point<double> centre(0.5, 0.75);
constexpr double radius = 0.15;

const scenes::Outline& exact_half() {
    static const scenes::Outline outline =
        scenes::advected_shape(scenes::circle_curve(centre, radius),
                               scenes::steady(scenes::Swirl{1.0, period}), period / 2)
            .outlines.front();
    return outline;
}

struct Errors {
    double area_loss = 0; ///< over the first polygon's area
    double last = 0;      ///< symmetric difference, absolute
    double half = 0;
};

// The errors half-way and at the end, with 8 / L steps.
Errors errors_of(double length, const MarkerOptions& options, int parts = 1) {
    Markers markers = scenes::circle(centre, radius, length);
    const double first_area = scenes::signed_area(markers);
    const int steps = static_cast<int>(std::lround(period / length));
    const double dt = period / steps;
    Errors errors;
    for (int step = 1; step <= steps; ++step) {
        reference::move_markers(markers, scenes::Swirl{1.0, period}, (step - 1) * dt, dt);
        reference::space_markers(markers, options);
        if (2 * step == steps) {
            errors.half = scenes::symmetric_difference(reference::read_as_cubic(markers, parts),
                                                       exact_half());
        }
    }
    errors.area_loss = 1 - scenes::signed_area(markers) / first_area;
    errors.last =
        scenes::symmetric_difference(reference::read_as_cubic(markers, parts),
                                     scenes::exact_circle(centre, radius).outlines.front());
    return errors;
}

// The figures of reference/published/marker_floor.json were computed by an independent program.
// With removal of markers, results depend on every single decision, so they only agree to a tenth.
TEST(BareMarkers, ReproduceTheFloor) {
    struct Row {
        InterfacePoint insertion;
        double length, area_loss, last, half;
    };
    const InterfacePoint linear = &reference::linear_point;
    const InterfacePoint cubic = MarkerOptions{}.insertion;
    for (const Row& row :
         {Row{linear, 1.0 / 32, 2.3e-2, 2.2e-3, 0}, Row{linear, 1.0 / 64, 6.0e-3, 5.7e-4, 0},
          Row{linear, 1.0 / 128, 1.6e-3, 1.5e-4, 0}, Row{cubic, 1.0 / 32, -3.6e-3, 2.4e-4, 1.06e-3},
          Row{cubic, 1.0 / 64, -1.2e-3, 5.3e-5, 2.6e-4},
          Row{cubic, 1.0 / 128, -1.4e-4, 2.2e-5, 7.1e-5}}) {
        SCOPED_TRACE(row.length);
        const Errors errors = errors_of(
            row.length,
            {.longest = row.length, .shortest = 0.3 * row.length, .insertion = row.insertion});
        EXPECT_NEAR(errors.area_loss, row.area_loss, 0.1 * std::abs(row.area_loss));
        EXPECT_NEAR(errors.last, row.last, 0.1 * row.last);
        if (row.half > 0) { // published for the cubic alone
            EXPECT_NEAR(errors.half, row.half, 0.1 * row.half);
        }
    }
}

TEST(BareMarkers, NeverRemovedTheyAreReadAtFourthOrder) {
    const auto at = [](double length, int parts) {
        return errors_of(length, {.longest = length}, parts);
    };
    EXPECT_NEAR(at(1.0 / 128, 1).last, 3.1e-6, 0.1 * 3.1e-6);
    const double coarse = at(1.0 / 128, 16).last;
    EXPECT_NEAR(coarse, 1.3e-6, 0.1 * 1.3e-6);
    const double fine = at(1.0 / 256, 16).last;
    EXPECT_NEAR(fine, 4.8e-8, 0.1 * 4.8e-8);
    EXPECT_GT(std::log2(coarse / fine), 3.8);
}

} // namespace
} // namespace dsc::bare_markers_test

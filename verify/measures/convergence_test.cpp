// SPDX-License-Identifier: MIT
// The order of an error over several sizes.
#include "dsc/base/error.h"
#include "measures/convergence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dsc::scenes::convergence_test {
namespace {

TEST(Order, OfAPowerIsItsExponent) {
    const std::array sizes{0.02, 0.005, 0.01, 0.04};
    std::array<double, 4> errors{};
    std::transform(sizes.begin(), sizes.end(), errors.begin(),
                   [](double h) { return 1e-200 * std::pow(h, 2.5); });
    const Order order = fit_order(sizes, errors);
    EXPECT_NEAR(order.order, 2.5, 1e-12);
    EXPECT_NEAR(order.smallest, 2.5, 1e-12);
    EXPECT_NEAR(order.spread(), 0.0, 1e-11);
}

TEST(Order, IsTheLeastSquaresLine) {
    const std::array sizes{1.0, 2.0, 4.0, 8.0};
    const std::array errors{1.0, 2.0, 16.0, 32.0};
    const Order order = fit_order(sizes, errors);
    EXPECT_NEAR(order.order, 1.8, 1e-12); // (1.5 * 2.5 + 0.5 * 1.5) * 2 / 5
    EXPECT_NEAR(order.smallest, 1.0, 1e-12);
    EXPECT_NEAR(order.largest, 3.0, 1e-12);
}

TEST(Order, RefusesWhatHasNone) {
    using Values = std::vector<double>;
    EXPECT_THROW((void)fit_order(Values{1}, Values{1}), InputError);
    EXPECT_THROW((void)fit_order(Values{}, Values{}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, 2}, Values{1}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, 2}, Values{1, 0}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, -2}, Values{1, 1}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, 2}, Values{1, NAN}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, INFINITY}, Values{1, 2}), InputError);
    EXPECT_THROW((void)fit_order(Values{1, 2, 1}, Values{1, 2, 3}), InputError);
    EXPECT_EQ(fit_order(Values{1, 2}, Values{1, 2}).order, 1.0);
}

} // namespace

} // namespace dsc::scenes::convergence_test

// SPDX-License-Identifier: MIT
// Sums whose rounding error does not grow with their length: the measures add up to a hundred
// thousand slivers of very different size. T. Ogita, S. M. Rump, S. Oishi, "Accurate sum and dot
// product" (2005), algorithms Sum2 and Dot2.
#pragma once

#include <cmath>

namespace dsc::scenes {

/// A running sum, as accurate as if it were computed in twice the working precision.
class CompensatedSum {
public:
    void add(double term) {
        const double total = sum_ + term;
        const double shadow = total - sum_;
        error_ += (sum_ - (total - shadow)) + (term - shadow);
        sum_ = total;
    }

    /// Adds a product together with its rounding error.
    void add_product(double left, double right) {
        const double product = left * right;
        error_ += std::fma(left, right, -product);
        add(product);
    }

    [[nodiscard]] double value() const { return sum_ + error_; }

private:
    double sum_ = 0.0;
    double error_ = 0.0;
};

} // namespace dsc::scenes

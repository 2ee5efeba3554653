// SPDX-License-Identifier: MIT
// How fast an error falls with a size: error = C size^order.
#pragma once

#include <span>

namespace dsc::scenes {

struct Order {
    double order = 0.0;    ///< slope of the least-squares line through log(error) over log(size)
    double smallest = 0.0; ///< of the orders between neighbouring sizes
    double largest = 0.0;

    /// How much the order itself varies with the sizes considered.
    [[nodiscard]] double spread() const { return largest - smallest; }
};

/// The order of convergence, from one error for each size; sizes come in any order. A statement
/// about convergence should have four or more. Throws InputError unless there are as many errors as
/// sizes, at least two, all of them finite and above 0, and no size twice.
[[nodiscard]] Order fit_order(std::span<const double> sizes, std::span<const double> errors);

} // namespace dsc::scenes

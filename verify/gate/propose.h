// SPDX-License-Identifier: MIT
// Limits, measured: how far figures spread when the interface is taken in different orders, none of
// which is right. For a person to look at and to commit; the gate itself never writes limits.
#pragma once

#include "suite.h"

#include <vector>

namespace dsc::gate {

/// Of one check, over all orders; of a comparison, over all pairs of them.
struct Band {
    const Case* of = nullptr;
    std::shared_ptr<const Check> check;
    double median = 0;
    double least = 0;
    double most = 0;
    Limit limit{}; ///< as it is proposed
};

/// Measures the limits that the cases have of their own and those that they lack; a case that has
/// none gets all that can be made of any scene, from `orders` orders: its own and shuffled ones.
/// What is required stays as it is. Throws InvariantError for a run that gives up or has a figure
/// that is no number.
[[nodiscard]] std::vector<Band> propose(const Cases& cases, int orders, int jobs);

} // namespace dsc::gate

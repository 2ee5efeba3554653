// SPDX-License-Identifier: MIT
// Measured limits: the spread of figures when the interface is visited in different orders, all
// equally valid. They must be reviewed and committed; the gate itself never writes limits.
#pragma once

#include "suite.h"

#include <vector>

namespace dsc::gate {

/// The spread of one check over all orders; for a comparison, over all pairs of orders.
struct Band {
    const Case* of = nullptr;
    std::shared_ptr<const Check> check;
    double median = 0;
    double min = 0;
    double max = 0;
    Limit limit{}; ///< the proposed limit
};

/// A limit to be measured, and its case, which must outlive it.
struct Wanted {
    const Case* of = nullptr;
    Held held;
};

/// The cases' own limits and the missing ones; a case without limits gets all that are possible for
/// its scene. Each is measured in `orders` orders: the scene's own and shuffled ones.
[[nodiscard]] std::vector<Wanted> limits_to_measure(const Cases& cases, int orders);

/// Measures them. What a limit stores is measured as well: the median figure, or the sum of the
/// histograms, over all orders. Limits of the rule "required" are not changed. Throws
/// InvariantError for a run that gives up or has a figure that is not a number.
[[nodiscard]] std::vector<Band> propose(const std::vector<Wanted>& limits, int jobs);

} // namespace dsc::gate

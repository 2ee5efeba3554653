// SPDX-License-Identifier: MIT
// Limits of a scene, measured: how far its figures spread when the interface is taken in different
// orders, none of which is right. For a person to look at and to commit; the gate itself never
// writes limits.
#pragma once

#include "runs.h"

#include <string>
#include <vector>

namespace dsc::gate {

/// Of one check, over all orders; of a comparison, over all pairs of them.
struct Band {
    std::string check;
    double median = 0;
    double least = 0;
    double most = 0;
    double limit = 0;
    bool at_least = false;
    int orders = 0;
    std::string note{}; ///< where the limit comes from

    [[nodiscard]] double spread() const { return most - least; }
    /// Of the limit to the median: what a run has room for. NaN where the median is 0.
    [[nodiscard]] double ratio() const;
};

/// Runs the scene as it is and in `orders` - 1 shuffled orders. Throws InvariantError for a run
/// that gives up or has a figure that is no number.
[[nodiscard]] std::vector<Band> propose(const scenes::SceneFile& file, int orders);

/// A limits file of this scene.
[[nodiscard]] std::string to_limits(const std::string& scene, const std::vector<Band>& bands);

} // namespace dsc::gate

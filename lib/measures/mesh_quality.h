// SPDX-License-Identifier: MIT
// The quality of the triangles of a mesh.
#pragma once

#include "dsc/algorithm/simulation.h"

#include <cstdint>
#include <vector>

namespace dsc::scenes {

struct MeshQuality {
    double min_quality = 1; ///< equation 4
    double min_angle_deg = 60;
    double median_angle_deg = 60; ///< of the triangles' smallest angles
    std::uint64_t inverted =
        0; ///< triangles that are not strictly positive, by the exact predicate
};

/// The quality of all triangles. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_quality(const Complex<Real>& complex);

/// Only `min_quality` and `inverted`, without the angles. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_worst(const Complex<Real>& complex);

/// The worst triangle over all checks of a run, without visiting the whole mesh: only triangles
/// changed by steps since the last check are examined.
template <class Real>
class QualityWatch {
public:
    /// The simulation must outlive the watch and have no other one. The first check visits all
    /// triangles.
    explicit QualityWatch(Simulation<Real>& simulation) : simulation_(simulation) {}

    /// Makes the next check visit all triangles: for changes of the mesh outside steps.
    void forget() { is_known_ = false; }
    /// Checks the mesh: `min_quality` is the minimum over all checks so far, `inverted` the number
    /// now. O(poor stars and edits other than moves); O(n) for the first check.
    [[nodiscard]] MeshQuality look();

private:
    Simulation<Real>& simulation_;
    bool is_known_ = false; ///< whether all triangles that no step has changed are known
    std::vector<std::uint32_t> inverted_; ///< triangles
    double min_quality_ = 1;
};

} // namespace dsc::scenes

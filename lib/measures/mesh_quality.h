// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are.
#pragma once

#include "dsc/algorithm/simulation.h"

#include <cstdint>
#include <vector>

namespace dsc::scenes {

struct MeshQuality {
    double min_quality = 1; ///< equation 4
    double min_angle_deg = 60;
    double median_angle_deg = 60; ///< of the triangles' smallest angles
    std::uint64_t inverted = 0;   ///< not strictly positive, by the exact predicate
};

/// The quality of all triangles. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_quality(const Complex<Real>& complex);

/// The same with `min_quality` and `inverted` only. O(n).
template <class Real>
[[nodiscard]] MeshQuality measure_worst(const Complex<Real>& complex);

/// The worst triangle of all moments at which it looks, without a look at the whole mesh: a
/// triangle that no step has touched since the last look is what it was then.
template <class Real>
class QualityWatch {
public:
    /// The simulation must outlive it and have no other. The first look is at all triangles.
    explicit QualityWatch(Simulation<Real>& simulation) : simulation_(simulation) {}

    /// The next look is at all triangles: something other than a step has changed the mesh.
    void forget() { is_known_ = false; }
    /// `min_quality` is the least at any look so far, `inverted` is the number now. O(poor stars
    /// and edits of steps other than moves), O(n) for the first one.
    [[nodiscard]] MeshQuality look();

private:
    Simulation<Real>& simulation_;
    bool is_known_ = false;               ///< all triangles but those that steps have touched
    std::vector<std::uint32_t> inverted_; ///< triangles
    double min_quality_ = 1;
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// How good the triangles of a mesh are.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"

#include <span>
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
/// triangle that no edit has touched since the last look is what it was then. It has to be told all
/// edits:
///
///     simulation.add_listener([&](std::span<const Edit> edits) { watch.note(edits); });
template <class Real>
class QualityWatch {
public:
    /// The complex must outlive it. The first look is at all triangles.
    explicit QualityWatch(const Complex<Real>& complex) : complex_(complex) {}

    /// Notes what has to be looked at. O(edits).
    void note(std::span<const Edit> edits);
    /// The next look is at all triangles: the mesh became another without edits.
    void forget() { is_known_ = false; }
    /// `min_quality` is the least at any look so far, `inverted` is the number now. O(stars that
    /// edits have touched), O(n) for the first one.
    [[nodiscard]] MeshQuality look();

private:
    void look_at(Triangle t);
    void look_at(Vertex v, Ring<Real>& ring); // at its star

    const Complex<Real>& complex_;
    bool is_known_ = false;              ///< all triangles but those of `touched_`
    std::vector<std::uint32_t> touched_; ///< vertices, with duplicates
    std::vector<std::uint32_t> visited_; ///< by vertex: the last look at its star
    std::uint32_t looks_ = 0;
    std::vector<std::uint32_t> inverted_; ///< triangles
    double min_quality_ = 1;
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// Whether the triangles of phases that are carried along stay what they were (thesis, section 9.1):
// every operation on one of them is counted, and their vertices and edges are compared with those
// at the start.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/complex/complex.h"

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace dsc::scenes {

/// What has become of the triangles of carried phases.
struct CarriedFigures {
    std::uint64_t triangles = 0;  ///< at the start
    std::uint64_t operations = 0; ///< that changed a triangle of them, or removed it; so far
    /// That are no longer there with the same three vertices, and new ones; the most after any
    /// step.
    std::uint64_t triangles_changed = 0;
    double edge_change = 0; ///< largest change of an edge's length so far, relative to the first
};

/// Adds attributes to the complex, which it refers to; the mesh is not touched, and triangles are
/// known again after a renumbering.
template <class Real>
class CarriedWatch {
public:
    CarriedWatch(Complex<Real>& complex, std::vector<Phase> phases);

    /// To be called after each step. O(mesh).
    const CarriedFigures& look();
    /// What has been counted so far; to be called after the complex has been read. Throws
    /// FileError.
    void archive(Archive& archive);

private:
    struct Known {
        std::array<std::uint32_t, 3> v; ///< counter-clockwise, from the smallest
        std::array<double, 3> lengths;  ///< from each to the next
    };
    [[nodiscard]] bool is_inside(Triangle t) const;
    [[nodiscard]] Known known(Triangle t) const;

    Complex<Real>& complex_;
    std::vector<Phase> phases_;
    std::shared_ptr<std::atomic<std::uint64_t>> operations_;
    std::vector<Known> first_; ///< by number of the triangle, less 1
    CarriedFigures figures_;
};

} // namespace dsc::scenes

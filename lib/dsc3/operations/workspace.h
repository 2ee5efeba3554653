// SPDX-License-Identifier: MIT
// Scratch arrays of the operations, which avoid allocation in a step, and counts of the operations.
#pragma once

#include "dsc3/complex/rewire.h"
#include "dsc3/complex/star.h"
#include "dsc3/quality/star_quality.h"
#include "dsc3/queries/interface_star.h"

#include <array>
#include <cstdint>

namespace dsc3 {

/// How often each operation was done.
struct OperationCounts {
    std::uint64_t splits = 0;              ///< of edges inside a phase
    std::uint64_t collapses = 0;           ///< of edges inside a phase
    std::uint64_t edge_removals = 0;       ///< with those that follow from a reassigned sliver
    std::uint64_t face_flips = 0;          ///< two tets become three
    std::uint64_t smoothings = 0;          ///< vertices that were moved for quality
    std::uint64_t interface_splits = 0;    ///< of edges of the interface
    std::uint64_t interface_collapses = 0; ///< of edges of the interface
    std::uint64_t interface_flips = 0;     ///< of edges of the interface
    std::uint64_t reassigned = 0;          ///< flat tets on the interface that changed phase

    OperationCounts& operator+=(const OperationCounts& other);
    /// The operations that make tets: all but smoothing, and reassignments, because the edge
    /// removal that follows each is counted.
    [[nodiscard]] std::uint64_t rewirings() const {
        return splits + collapses + edge_removals + face_flips + interface_splits +
               interface_collapses + interface_flips;
    }
};

/// Edges with more tets are not removed: the work grows with the cube of their number.
inline constexpr std::uint32_t polygon_limit = 9;

/// Of one thread: no cache line is also another thread's.
struct alignas(64) Workspace {
    Rewiring rewiring;
    Star star;
    Star other;
    InterfaceStar interface_star;
    InterfaceStar other_interface_star;
    Ring ring;
    StarQuality quality;
    /// The best triangulations of the pieces of a polygon; see edge_removal.cpp.
    std::array<std::array<Real, polygon_limit + 1>, polygon_limit + 1> polygon_quality{};
    std::array<std::array<std::uint32_t, polygon_limit + 1>, polygon_limit + 1> polygon_apex{};
    OperationCounts counts;
    std::uint64_t treated = 0;          ///< tets that mesh repair tried to improve
    std::uint64_t treated_together = 0; ///< of these, by several submeshes at the same time
};

/// The quality of a tet.
[[nodiscard]] Real quality_of(const Complex& complex, std::uint32_t tet);

/// Whether a vertex is on the interface, but on no single sheet: on a curve or at a point. `star`
/// of the workspace is kept. O(degree^2).
[[nodiscard]] bool is_off_sheets(const Complex& complex, Workspace& work, std::uint32_t v);

/// Whether all tets around an edge have the same phase. O(size).
[[nodiscard]] bool has_one_phase(const Complex& complex, const Ring& ring);

/// Whether an edge exists and is on the interface. `ring` is then the tets around it. O(degree).
[[nodiscard]] bool is_on_interface(const Complex& complex, const EdgeAt& edge, Ring& ring);

/// The smallest quality of the tets around an edge. O(size).
[[nodiscard]] Real worst_quality(const Complex& complex, const Ring& ring);

} // namespace dsc3

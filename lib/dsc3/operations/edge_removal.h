// SPDX-License-Identifier: MIT
// Edge removal inside a phase: the tets around an edge are replaced by those over the best
// triangulation of its link. 3-2 and 4-4 flips are the cases of three and four tets. The
// triangulation is that of G. T. Klincsek, "Minimal triangulations of polygonal domains" (1980); J.
// R. Shewchuk, "Two discrete optimization algorithms for the topological improvement of tetrahedral
// meshes" (2002). The 2-3 flip of a face is the inverse of the 3-2 flip.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Whether removing the edge would raise the worst quality of the tets around it by this factor. Of
/// edges on the domain boundary, those within a side may be removed.
/// `work` then holds the triangulation. O(n^3) for n tets.
[[nodiscard]] Verdict edge_removal_guard(const Complex& complex, Workspace& work,
                                         const EdgeAt& edge, Real gain = 1.0001);

/// Removes the edge if that is legal.
Verdict edge_removal(Complex& complex, Workspace& work, const EdgeAt& edge, Real gain = 1.0001);

/// Replaces the two tets at the face opposite to `corner` by three around a new edge, if that is
/// legal and raises the worst quality. O(1).
Verdict face_flip(Complex& complex, Workspace& work, Corner corner);

// --- for other operations that fill a polygon ----------------------------------------------------

/// The worst quality of the tets that join the best triangulation of the polygon to a and b;
/// `floor` or less if none is better. `work` then holds the triangulation.
[[nodiscard]] Real best_triangulation(const Complex& complex, Workspace& work, std::uint32_t a,
                                      std::uint32_t b, std::span<const std::uint32_t> polygon,
                                      Real floor);

/// Appends the tets over the triangulation in `work` to the tets to be made.
void append_triangulation(Workspace& work, std::uint32_t a, std::uint32_t b,
                          std::span<const std::uint32_t> polygon, Phase phase);

} // namespace dsc3

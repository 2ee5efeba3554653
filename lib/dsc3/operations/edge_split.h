// SPDX-License-Identifier: MIT
// Edge split: a new vertex on an edge, which cuts all tets around it in two.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Splits the edge at a point strictly between its ends; the new vertex is on the interface or on
/// sides of the domain, exactly, if the edge is. Returns the vertex; an invalid one, with nothing
/// changed, if the edge has too many tets or a tet would be inverted. O(tets around the edge).
[[nodiscard]] Vertex edge_split(Complex& complex, Workspace& work, const EdgeAt& edge, Point place);

/// Splits an edge inside a phase at the place that is best for the new tets, if their worst quality
/// is at least `gain` times that of the tets around the edge. O(tets around the edge).
Verdict improving_split(Complex& complex, Workspace& work, const EdgeAt& edge, Real gain);

/// Moves a vertex to a point, along the sides on which it is, or a half, a quarter or an eighth of
/// the way, so that all tets of its star stay above the quality `floor`. Returns whether it
/// arrived. O(degree).
bool nudge(Complex& complex, Workspace& work, Vertex vertex, const Point& place, Real floor);

} // namespace dsc3

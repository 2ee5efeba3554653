// SPDX-License-Identifier: MIT
// The mesh updates of algorithm 5.1: coarsening and refinement of the interface; coarsening,
// refinement, optimization and smoothing of the phases. Each sweeps over all simplices of its kind,
// as the thesis does.
#pragma once

#include "reference/algorithm/interpolators.h"
#include "reference/complex/complex.h"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace dsc::reference {

/// The thresholds of the passes. Lengths are in units of the target edge length h, areas in units
/// of the area sqrt(3)/4 h^2 of an equilateral triangle of that edge length.
struct PassOptions {
    double edge_length = 0.02; ///< h, in the unit of the coordinates
    /// h for a phase and a point, if it differs from `edge_length`, which still applies to the
    /// interface.
    std::function<double(Phase, const Point<double>&)> phase_edge_length;

    double interface_collapse = 0.5;   ///< interface edges shorter than this may be collapsed, in h
    double interface_deviation = 0.02; ///< ... if the curve moves less than this, in h
    double interface_split = 1.5;      ///< interface edges longer than this are split, in h
    InterfacePoint interface_point;    ///< position of the new vertex; empty: the midpoint

    double small_area = 0.25;        ///< triangles below this are coarsened
    double large_area = 2.5;         ///< triangles above this are refined
    double poor_quality = 0.25;      ///< triangles below this (equation 4) may be collapsed
    double smoothing_quality = 0.65; ///< stars below this (equation 4) are smoothed
    double flip_slack = 1e-9;        ///< accepted violation of the Delaunay condition
    int flip_sweeps = 3;             ///< sweeps in one pass: a flip may make its neighbours worse
};

/// Numbers of legal operations.
struct PassCounts {
    std::size_t flips = 0;
    std::size_t splits = 0;
    std::size_t collapses = 0;
    std::size_t subdivisions = 0;
    std::size_t retriangulations = 0;
    std::size_t smoothed = 0;
};

/// Phases(K): the triangles of each phase. A sweep over all triangles.
using Phases = std::map<Phase, std::vector<TriangleKey>>;
Phases phases(const Complex& K);

/// EdgeCollapse of short edges of the interface I.
void interface_coarsening(Complex& K, const SimplexSet& I, const PassOptions& options,
                          PassCounts& counts);
/// EdgeSplit of long edges of the interface I. Edges that no longer exist are skipped; edges made
/// by a collapse are too short to be split.
void interface_refinement(Complex& K, const SimplexSet& I, const PassOptions& options,
                          PassCounts& counts);
/// LocalRetriangulation of the small triangles of phase p, EdgeCollapse at the poor ones.
void phase_coarsening(Complex& K, const Phases::value_type& p, const PassOptions& options,
                      PassCounts& counts);
/// LoopSubdivision of the large triangles of phase p, EdgeSplit where the interface forbids that.
void phase_refinement(Complex& K, const Phases::value_type& p, const PassOptions& options,
                      PassCounts& counts);
/// EdgeFlip where the Delaunay condition fails, in all phases.
void optimization(Complex& K, const PassOptions& options, PassCounts& counts);
/// LaplacianSmoothing where the star is poor, in all phases.
void smoothing(Complex& K, const PassOptions& options, PassCounts& counts);

} // namespace dsc::reference

// SPDX-License-Identifier: MIT
// Algorithms 5.1 and 5.2 of the thesis line by line: a mesh update is a measure, a selection
// strategy and an operation. An application builds its own in the same way. The candidates are the
// simplices of the active set, so the cost of a pass is proportional to what changed, and it runs
// in submeshes unchanged.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "thesis/algorithm/selection.h"

namespace dsc {

/// Algorithm 5.2: applies an operation to the selected simplices. `quality` and `operation` are
/// arbitrary functions; the worst simplex has the smallest quality.
template <class Real, class Simplex>
struct MeshUpdateLine {
    std::string name;                                             ///< of the pass
    std::function<double(const Complex<Real>&, Simplex)> quality; ///< small values are bad
    SelectionStrategy<Simplex> select; ///< chooses among the candidates, and orders them
    /// Applies the operation; its verdict says whether anything changed.
    std::function<Verdict(Work<Real>&, Simplex)> operation;
};

/// The pass that runs algorithm 5.2. Simplex is Vertex, Edge or Triangle. O(active log active).
template <class Real, class Simplex>
Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Simplex> line);

/// The thresholds at which the lines of algorithm 5.1 act. Areas are relative to that of an
/// equilateral triangle of the target edge length, qualities are those of equation 4.
struct ThesisThresholds {
    double small_area = 0.25;      ///< below: LocalRetriangulation
    double large_area = 2.5;       ///< above: LoopSubdivision
    double smooth_quality = 0.65;  ///< stars below: LaplacianSmoothing
    bool smooth_interface = false; ///< InterfaceSmoothing of line 8
};

/// Algorithm 5.1 with the operations of chapter 7. Lines 6 to 8 (the interface) run before anything
/// moves; the last pass is the default mesh update, which handles what the operations of the thesis
/// refuse: triangles at the interface can be neither subdivided nor retriangulated (thesis, section
/// 6.5).
template <class Real>
Algorithm<Real> thesis_algorithm(const Options<Real>& options,
                                 const ThesisThresholds& thresholds = {});

} // namespace dsc

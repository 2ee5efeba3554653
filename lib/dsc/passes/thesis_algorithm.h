// SPDX-License-Identifier: MIT
// Algorithms 5.1 and 5.2 line by line: a mesh update is a measure, a selection strategy and an
// operation. An application puts its own together the same way; the candidates are the simplices of
// the active set, so that a pass costs what changed and runs in submeshes as it is.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/passes/algorithm.h"
#include "dsc/quality/selection.h"

namespace dsc {

/// Algorithm 5.2: Op on the selected simplices. `quality` and `operation` may be anything; worst is
/// the smallest quality.
template <class Real, class Simplex>
struct MeshUpdateLine {
    std::string name;
    std::function<double(const Complex<Real>&, Simplex)> quality;
    SelectionStrategy<Simplex> select;
    std::function<Verdict(Work<Real>&, Simplex)> operation;
};

/// The pass that runs it. Simplex is Vertex, Edge or Triangle. O(active log active).
template <class Real, class Simplex>
Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Simplex> line);

/// When the lines of algorithm 5.1 act, relative to the area of an equilateral triangle of the
/// target edge length, and to quality of equation 4.
struct ThesisThresholds {
    double small_area = 0.25;      ///< below: LocalRetriangulation
    double large_area = 2.5;       ///< above: LoopSubdivision
    double smooth_quality = 0.65;  ///< stars below: LaplacianSmoothing
    bool smooth_interface = false; ///< InterfaceSmoothing of line 8
};

/// Algorithm 5.1 with the operations of section 7. Lines 6 to 8 (the interface) run before anything
/// moves; the last pass is the default mesh update, which takes what the printed operations refuse:
/// triangles at the interface can be neither subdivided nor retriangulated [6.5].
template <class Real>
Algorithm<Real> thesis_algorithm(const Options<Real>& options,
                                 const ThesisThresholds& thresholds = {});

} // namespace dsc

// SPDX-License-Identifier: MIT
// A measure is a named function of the state of a run at one time. A run has a list of measures,
// and each value is stored in its result under the measure's name: to add a measure, add an entry
// to the list.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"
#include "measures/figures.h"
#include "measures/mesh_quality.h"
#include "shapes/outline.h"

#include <functional>
#include <span>

namespace dsc::scenes {

/// The mesh in the precision of the run.
using MeshView = std::variant<const Complex<double>*, const Complex<float>*>;

/// The input of a measure. Lengths and areas are in units of the domain.
struct Moment {
    MeshView mesh;
    std::span<const Outline> outlines; ///< the interface, read as chords or cubics
    std::span<const Outline> polygons; ///< the interface with straight edges
    const ExactShape* exact = nullptr; ///< null: only measures that do not need it are run
    double area_exact_first = 0;       ///< of the first exact shape
    const Figures* figures = nullptr;  ///< the results of the measures before this one
    MeshQuality quality = {};          ///< quality of the mesh, if a measure needs it
};

enum class Needs : std::uint8_t {
    outlines,
    exact_shape, ///< the outlines and the exact shape; without one the value is NaN
    mesh,
};

struct Measure {
    std::string name; ///< name of its value; results at the end and half-way append _last and _half
    std::string unit; ///< "1" if it has none
    std::string description; ///< in a few words
    Needs needs = Needs::outlines;
    std::function<Value(const Moment&)> function;
};

/// The measures of a run by default.
[[nodiscard]] const std::vector<Measure>& default_measures();

/// The value of each measure, in their order. `moment.figures` and `quality` need not be set.
/// Passes on exceptions of the measures.
[[nodiscard]] Figures measure(const std::vector<Measure>& measures, Moment moment);

} // namespace dsc::scenes

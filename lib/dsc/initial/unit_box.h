// SPDX-License-Identifier: MIT
// An initial complex in the unit coordinates of a map, from a scene in world coordinates; and a
// copy of a complex in world coordinates, to be written or measured.
#pragma once

#include "dsc/geometry/unit_map.h"
#include "dsc/initial/initial_complex.h"

namespace dsc {

/// The same rectangle, shape or curve in unit coordinates.
[[nodiscard]] Rectangle to_unit(const UnitMap& map, const Rectangle& world);
[[nodiscard]] Shape to_unit(const UnitMap& map, const Shape& world);
[[nodiscard]] Curve to_unit(const UnitMap& map, const Curve& world);

/// As `initial_complex`, with `domain`, `shapes` or `curves`, and the lengths and functions of
/// `options` in world coordinates and the complex in unit ones: those of the simulation's options
/// are `length_to_unit(map, ...)`. Errors name unit coordinates. O(n log n).
template <class Real>
Complex<Real> initial_complex(const UnitMap& map, const Rectangle& domain,
                              std::span<const Shape> shapes, const InitialOptions& options = {});
template <class Real>
Complex<Real> initial_complex(const UnitMap& map, const Rectangle& domain,
                              std::span<const Curve> curves, const InitialOptions& options = {});

/// A copy with every vertex where it lies in the world. O(n). Far from the origin, or in float,
/// neighbours may round to one place: the copy is made for files and measures, not for more steps.
template <class Real>
[[nodiscard]] Complex<Real> to_world(const UnitMap& map, Complex<Real> complex);

extern template Complex<double> initial_complex(const UnitMap&, const Rectangle&,
                                                std::span<const Shape>, const InitialOptions&);
extern template Complex<float> initial_complex(const UnitMap&, const Rectangle&,
                                               std::span<const Shape>, const InitialOptions&);
extern template Complex<double> initial_complex(const UnitMap&, const Rectangle&,
                                                std::span<const Curve>, const InitialOptions&);
extern template Complex<float> initial_complex(const UnitMap&, const Rectangle&,
                                               std::span<const Curve>, const InitialOptions&);
extern template Complex<double> to_world(const UnitMap&, Complex<double>);
extern template Complex<float> to_world(const UnitMap&, Complex<float>);

} // namespace dsc

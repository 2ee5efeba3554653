// SPDX-License-Identifier: MIT
// The phases of a mesh as GeoJSON (RFC 7946), for programs that draw, cut or measure polygons; and
// for scene files, which read it back (file/outlines).
#pragma once

#include "dsc/complex/complex.h"

#include <string>

namespace dsc::scenes {

/// A FeatureCollection with a Polygon for each component of each phase but the exterior: first the
/// ring around it, counter-clockwise, then those around its holes, clockwise. Each ring begins and
/// ends at the same position; coordinates are those of the domain, with the digits that read back
/// the same. Properties: `phase`, and `area` in squared units of the domain. Components come in the
/// order of their smallest triangle. O(n).
template <class Real>
[[nodiscard]] std::string outlines_to_geojson(const Complex<Real>& complex);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// The value of a scene at the vertices of its mesh (thesis, section 9.5): an attribute of the
// complex that the scene sets on the interface and the library interpolates elsewhere.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <span>

namespace dsc::scenes {

/// Keeps a reference to the complex, to which it adds the attribute "value".
template <class Real>
class KeptValue {
public:
    KeptValue(Complex<Real>& complex, const RadialValue& value);

    /// Sets interface vertices to their values at the end of a step. To be called before the step,
    /// so that inserted vertices are interpolated from values at one time. Steps should not be
    /// longer than a sub-step. O(interface).
    void set_interface(std::span<const std::uint32_t> interface, double time);

    /// The largest error of the piecewise linear field in phase 1, at the vertices, midpoints of
    /// edges and centroids of its triangles. O(mesh).
    [[nodiscard]] double largest_error() const;

private:
    Complex<Real>& complex_;
    RadialValue value_;
    VertexAttribute<double>& at_;
};

} // namespace dsc::scenes

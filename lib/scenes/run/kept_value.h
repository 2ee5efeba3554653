// SPDX-License-Identifier: MIT
// The value of a scene at the vertices of its mesh (thesis, section 9.5): an attribute of the
// complex that the scene sets on the interface and the library interpolates elsewhere.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <span>

namespace dsc::scenes {

/// Refers to the complex, to which it adds the attribute "value".
template <class Real>
class KeptValue {
public:
    KeptValue(Complex<Real>& complex, const RadialValue& value);

    /// What interface vertices will have at the end of a step: to be called before it, so that
    /// vertices which it inserts beside them are interpolated from values of one time. Steps should
    /// be no longer than a sub-step. O(their number).
    void set_interface(std::span<const std::uint32_t> interface, double time);

    /// Of the field that is linear in each triangle of phase 1, at its vertices, the midpoints of
    /// its edges and its centroid. O(mesh).
    [[nodiscard]] double largest_error() const;

private:
    Complex<Real>& complex_;
    RadialValue value_;
    VertexAttribute<double>& at_;
};

} // namespace dsc::scenes

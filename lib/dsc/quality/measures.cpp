// SPDX-License-Identifier: MIT
#include "dsc/quality/measures.h"

namespace dsc {

template <class Real>
Real length(const Complex<Real>& complex, Edge e) {
    const auto v = complex.vertices_of(e);
    return distance(complex.position(v[0]), complex.position(v[1]));
}

template <class Real>
Real squared_length(const Complex<Real>& complex, Edge e) {
    const auto v = complex.vertices_of(e);
    return squared_distance(complex.position(v[0]), complex.position(v[1]));
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Real length(const Complex<Real>&, Edge);                                              \
    template Real squared_length(const Complex<Real>&, Edge);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

// The measures of a triangle are those of its three points.
#define DSC_TRIANGLE_MEASURE(measure)                                                              \
    template <class Real>                                                                          \
    Real measure(const Complex<Real>& complex, Triangle t) {                                       \
        const auto v = complex.vertices_of(t);                                                     \
        return measure(complex.position(v[0]), complex.position(v[1]), complex.position(v[2]));    \
    }                                                                                              \
    template double measure(const Complex<double>&, Triangle);                                     \
    template float measure(const Complex<float>&, Triangle);
DSC_TRIANGLE_MEASURE(area)
DSC_TRIANGLE_MEASURE(quality)
DSC_TRIANGLE_MEASURE(min_angle_deg)
#undef DSC_TRIANGLE_MEASURE

} // namespace dsc

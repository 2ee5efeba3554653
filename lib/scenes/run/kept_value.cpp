// SPDX-License-Identifier: MIT
#include "scenes/run/kept_value.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

template <class Real>
KeptValue<Real>::KeptValue(Complex<Real>& complex, const RadialValue& value)
    : complex_(complex), value_(value),
      at_(complex.attributes.template add<Vertex, double>("value")) {
    at_.set_field(true, OnInterface::advected);
}

template <class Real>
void KeptValue<Real>::set_interface(std::span<const std::uint32_t> interface, double time) {
    const double now = value_.on_interface(time);
    for (const std::uint32_t v : interface) {
        at_[Vertex{v}] = now;
    }
}

template <class Real>
double KeptValue<Real>::largest_error() const {
    double worst = 0;
    for (const Triangle t : triangles(complex_)) {
        if (complex_.phase(t) == exterior_phase) {
            continue;
        }
        const auto v = complex_.vertices_of(t);
        const auto look_at = [&](double a, double b, double c) {
            const Point<double> place = a * complex_.position(v[0]).template cast<double>() +
                                        b * complex_.position(v[1]).template cast<double>() +
                                        c * complex_.position(v[2]).template cast<double>();
            const double value = a * at_[v[0]] + b * at_[v[1]] + c * at_[v[2]];
            worst = std::max(worst, std::abs(value - value_.exact(place)));
        };
        for (const auto& [a, b] : {std::pair{1.0, 0.0},
                                   {0.0, 1.0},
                                   {0.5, 0.5},
                                   {0.5, 0.0},
                                   {0.0, 0.5},
                                   {0.0, 0.0},
                                   {1.0 / 3, 1.0 / 3}}) {
            look_at(a, b, 1 - a - b);
        }
    }
    return worst;
}

template class KeptValue<double>;
template class KeptValue<float>;

} // namespace dsc::scenes

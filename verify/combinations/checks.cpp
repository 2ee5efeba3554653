// SPDX-License-Identifier: MIT
#include "combinations/checks.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace dsc::combinations {

template <class Real>
std::string field_fault(const Complex<Real>& complex) {
    const auto& field = complex.attributes.template get<Vertex, double>("place");
    double worst = 0;
    for (const Vertex v : vertices(complex)) {
        worst = std::max(worst, std::abs(field[v] - linear_field(complex.position(v))));
    }
    if (worst < (std::is_same_v<Real, double> ? 1e-9 : 1e-4)) {
        return {};
    }
    return "the field is off by " + std::to_string(worst);
}

template std::string field_fault(const Complex<double>&);
template std::string field_fault(const Complex<float>&);

} // namespace dsc::combinations

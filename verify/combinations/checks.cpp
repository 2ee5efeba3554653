// SPDX-License-Identifier: MIT
#include "combinations/checks.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>
#include <sstream>
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

std::string account_fault(const test::ChangingReport& report, bool is_given_back) {
    double taken = 0;
    bool is_one_way = true;
    for (const Event& event : report.events) {
        const Event& first = report.events.front();
        taken += event.area;
        is_one_way = is_one_way && event.taken[0] == event.taken[1] && event.lost == first.lost &&
                     event.taken == first.taken;
    }
    const double told = report.area.given_back + report.area.owed;
    const double due = is_given_back ? taken : 0;
    const double rounding = 1e-9 * taken;
    if (told <= due + rounding && (!is_one_way || told >= due - rounding)) {
        return {};
    }
    std::ostringstream words;
    words << report.area.given_back << " is given back and " << report.area.owed << " owed of "
          << due;
    return words.str();
}

template std::string field_fault(const Complex<double>&);
template std::string field_fault(const Complex<float>&);

} // namespace dsc::combinations

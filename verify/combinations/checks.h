// SPDX-License-Identifier: MIT
// Invariants of every run in any scene; each function returns a fault as a sentence, or an empty
// text.
#pragma once

#include "support/topology/changing.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace dsc::combinations {

/// A field that is linear in the position, so it is exact wherever a vertex is made or moved.
template <class Real>
[[nodiscard]] double linear_field(const Point<Real>& p) {
    return static_cast<double>(p.x()) + 2 * static_cast<double>(p.y());
}

/// Adds a vertex attribute with the values of that field.
template <class Real>
void add_field(Complex<Real>& complex) {
    auto& field = complex.attributes.template add<Vertex, double>("place", 0.0);
    field.set_field(true);
    for (const Vertex v : vertices(complex)) {
        field[v] = linear_field(complex.position(v));
    }
}

/// Checks that the attribute still has these values.
template <class Real>
[[nodiscard]] std::string field_fault(const Complex<Real>& complex) {
    const auto& field = complex.attributes.template get<Vertex, double>("place");
    double worst = 0;
    for (const Vertex v : vertices(complex)) {
        worst = std::max(worst, std::abs(field[v] - linear_field(complex.position(v))));
    }
    const bool is_exact = worst < (std::is_same_v<Real, double> ? 1e-9 : 1e-4);
    return is_exact ? "" : "the field is off by " + std::to_string(worst);
}

/// Checks that areas taken by the events of a step are given back or owed, if the options ask for
/// it. Only opposite areas between the same two phases may cancel.
[[nodiscard]] inline std::string account_fault(const test::ChangingReport& report,
                                               bool is_given_back) {
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

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
// What holds in every run, whatever its scene; each fault in a sentence, or empty.
#pragma once

#include "support/topology/changing.h"

#include "dsc/complex/complex.h"

#include <string>

namespace dsc::combinations {

/// Linear in the place, and so exact wherever a vertex is made or moved.
template <class Real>
[[nodiscard]] double linear_field(const Point<Real>& p) {
    return static_cast<double>(p.x()) + 2 * static_cast<double>(p.y());
}

/// Whether the attribute "place" is that field.
template <class Real>
[[nodiscard]] std::string field_fault(const Complex<Real>& complex);

/// What the events of a step took is given back or owed, if that is asked for. Only areas that go
/// to and fro between the same two phases are set off against each other.
[[nodiscard]] std::string account_fault(const test::ChangingReport& report, bool is_given_back);

} // namespace dsc::combinations

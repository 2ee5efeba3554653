// SPDX-License-Identifier: MIT
// A length by place and time, given by a formula in x, y and t.
#pragma once

#include "scenes/file/formula/formula_flow.h"

#include <string>

namespace dsc::scenes {

/// For radii, and the targets of `SizeOptions`. Safe to call from several threads at once;
/// O(formula).
class FormulaLength {
public:
    /// `where` says whose formula it is, for errors. Throws InputError for one that cannot be
    /// understood.
    FormulaLength(std::string formula, FormulaParameters parameters, const std::string& where)
        : flow_({.u = std::move(formula),
                 .v = "0",
                 .parameters = std::move(parameters),
                 .where_u = where,
                 .where_v = where}) {}

    double operator()(const Point<double>& place, double time) const {
        Point<double> length;
        flow_({&place, 1}, time, {&length, 1});
        return length.x();
    }
    double operator()(const Point<double>& place, double time, Phase) const {
        return (*this)(place, time);
    }

    [[nodiscard]] bool changes_in_time() const { return flow_.uses_time(); }

private:
    FormulaFlow flow_;
};

} // namespace dsc::scenes

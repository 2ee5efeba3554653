// SPDX-License-Identifier: MIT
// A velocity field given by two formulas in x, y and t.
//
// The formulas are compiled once, into a list of operations on rows of positions: a row of numbers
// is read, computed and written at a time, so that the processor's vector units are at work and a
// formula costs less than twice as much as the same field written in C++ (an interpreter that takes
// one position after the other: 70 times as much). Rows stay in the first-level cache.
// Whatever depends on the time alone is computed once for each batch.
#pragma once

#include "flows/velocity.h"
#include "scenes/file/formula/parser.h"

#include <memory>

namespace dsc::scenes {

struct FormulaProgram;

/// The two components of a velocity: formulas, and where each comes from, for errors.
struct FormulaTexts {
    std::string u; ///< along x
    std::string v; ///< along y
    FormulaParameters parameters{};
    std::string where_u = "u";
    std::string where_v = "v";
};

/// A Velocity. The result for a position depends neither on the batch nor on the thread; calls from
/// several threads at once are safe, and nothing is allocated. Sines and cosines are those of
/// `sine_cosine_pi`, with an error below 1e-15 + 3e-16 |argument|; where a formula has no value the
/// result is NaN or infinite.
class FormulaFlow {
public:
    /// Throws InputError for a formula that cannot be understood, or one with too many operations.
    explicit FormulaFlow(FormulaTexts texts);

    void operator()(std::span<const Point<double>> positions, double time,
                    std::span<Point<double>> velocities) const;

    /// Whether the time occurs in either formula.
    [[nodiscard]] bool uses_time() const;

    [[nodiscard]] const FormulaTexts& texts() const { return *texts_; }

private:
    std::shared_ptr<const FormulaTexts> texts_;
    std::shared_ptr<const FormulaProgram> program_;
};

} // namespace dsc::scenes

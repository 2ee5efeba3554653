// SPDX-License-Identifier: MIT
// A velocity field given by two formulas in x, y and t.
//
// The formulas are read once. Each operation is then computed on a row of positions with vector
// instructions, so a formula takes at most four times as long as the same field in C++ (muParser
// 2.3.3, which evaluates one position at a time, takes 70 to 95 times as long). Operations that
// depend only on the time are computed once for each batch.
#pragma once

#include "flows/velocity.h"
#include "scenes/file/formula/graph.h"

#include <memory>

namespace dsc::scenes {

inline constexpr std::size_t longest_formula = 4096; ///< characters
inline constexpr int deepest_formula = 64;           ///< levels of nested parentheses
/// Largest number of operations of the two formulas together.
inline constexpr std::size_t max_formula_nodes = 512;

/// Whether a parameter may have this name: letters, digits and _, with a letter first, and not the
/// name of a variable or a function.
[[nodiscard]] bool is_parameter_name(std::string_view name);

/// The formulas of the two components of a velocity, and their places in the file for errors.
struct FormulaTexts {
    std::string u; ///< along x
    std::string v; ///< along y
    FormulaParameters parameters{};
    std::string where_u = "u";
    std::string where_v = "v";
};

/// A Velocity. The result for a position depends neither on the batch nor on the thread; calls from
/// several threads at once are safe, and nothing is allocated. Sines and cosines are those of
/// `sine_cosine_pi`, with an error below 1e-15 + 3e-16 |argument|; where a formula is undefined the
/// result is NaN or infinite.
class FormulaFlow {
public:
    /// Throws InputError for a formula that cannot be understood, or one with too many operations.
    explicit FormulaFlow(const FormulaTexts& texts);

    void operator()(std::span<const Point<double>> positions, double time,
                    std::span<Point<double>> velocities) const;

    /// Whether either formula depends on the time.
    [[nodiscard]] bool uses_time() const;

private:
    struct Program {
        FormulaGraph graph;
        FormulaNodeId u;
        FormulaNodeId v;
    };

    std::shared_ptr<const Program> program_;
};

/// The three components of a velocity in space, by formulas in x, y, z and t.
struct SpaceFormulaTexts {
    std::array<std::string, 3> components;
    FormulaParameters parameters{};
    std::array<std::string, 3> where{"u", "v", "w"};
};

/// The same as `FormulaFlow`, in three dimensions.
class SpaceFormulaFlow {
public:
    explicit SpaceFormulaFlow(const SpaceFormulaTexts& texts);

    void operator()(std::span<const Eigen::Vector3d> positions, double time,
                    std::span<Eigen::Vector3d> velocities) const;

private:
    struct Program {
        FormulaGraph graph{3};
        std::array<FormulaNodeId, 3> components{};
    };

    std::shared_ptr<const Program> program_;
};

} // namespace dsc::scenes

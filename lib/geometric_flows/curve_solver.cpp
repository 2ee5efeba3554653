// SPDX-License-Identifier: MIT
#include "geometric_flows/curve_solver.h"

#include "geometric_flows/curve_network.h"

#include <algorithm>
#include <limits>

namespace dsc {

namespace {

/// NaN unless the block, which is symmetric, is positive definite.
Block inverse_of(const Block& block) {
    const double determinant = block.xx * block.yy - block.xy * block.yx;
    if (!(block.xx > 0 && determinant > 0)) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none, none};
    }
    const double scale = 1 / determinant;
    return {block.yy * scale, -block.xy * scale, -block.yx * scale, block.xx * scale};
}

/// Regularisation: in the matrix each area responds to its own pressure more strongly than it
/// really does, by this share of its response, along curves and through junctions alike. No pivot
/// is then zero, even if only junctions surround a phase, or the areas of some phases always have
/// the same sum. A shift afterwards corrects the areas.
constexpr double softness = 1e-8;

} // namespace

void CurveSolver::begin(const CurveGraph& graph) {
    graph_ = &graph;
    factors_.resize(graph.places().size());
    to_from_.resize(graph.places().size());
    rests_.resize(graph.curves().size());
    left_.resize(graph.junctions().vertices.size());
}

// --- elimination ---------------------------------------------------------------------------------

void CurveSolver::eliminate_curve(std::size_t curve, std::span<const Block> diagonal,
                                  std::span<const Block> coupling) {
    const NetworkCurve& of = graph_->curves()[curve];
    const auto block_of = [&](const CurveSide& side) {
        return side.is_first ? coupling[side.edge] : coupling[side.edge].transposed();
    };
    Remainder rest;
    rest.to_last = block_of(of.last);
    if (of.begin == of.end) {
        rest.across = rest.to_last.transposed();
        rests_[curve] = rest;
        return;
    }
    for (std::size_t k = of.begin; k < of.end; ++k) {
        const CurvePlace& place = graph_->places()[k];
        Factor& factor = factors_[k];
        factor.to_before = block_of(place.before);
        Block own = diagonal[place.vertex];
        if (k == of.begin) {
            factor.to_first = factor.to_before;
        } else {
            const Factor& before = factors_[k - 1];
            const Block along = factor.to_before * before.inverse;
            own += -(along * factor.to_before.transposed());
            factor.to_first = -(along * before.to_first);
        }
        factor.inverse = inverse_of(own);
        rest.at_first += -(factor.to_first.transposed() * (factor.inverse * factor.to_first));
    }
    const Factor& last = factors_[of.end - 1];
    const Block along = rest.to_last.transposed() * last.inverse;
    rest.at_last = -(along * rest.to_last);
    rest.across = -(along * last.to_first);
    if (of.is_loop) {
        Block left = diagonal[of.from];
        for (const Block& more :
             {rest.at_first, rest.at_last, rest.across, rest.across.transposed()}) {
            left += more;
        }
        rest.cut_inverse = inverse_of(left);
    }
    rests_[curve] = rest;
}

void CurveSolver::eliminate(std::size_t share, std::span<const Block> diagonal,
                            std::span<const Block> coupling) {
    for (auto [curve, end] = graph_->curves_of(share); curve < end; ++curve) {
        eliminate_curve(curve, diagonal, coupling);
    }
}

void CurveSolver::factorise_junctions(std::span<const Block> diagonal, const PressureRows& rows) {
    const CurvePart junctions = graph_->junctions();
    const std::size_t size = 2 * junctions.vertices.size() + rows.gains.size();
    if (size == 0) {
        return;
    }
    entries_.clear();
    for (std::size_t i = 0; i < junctions.vertices.size(); ++i) {
        left_[i] = diagonal[junctions.vertices[i]];
    }
    for (std::size_t c = 0; c < graph_->between_junctions().size(); ++c) {
        const std::uint32_t from = graph_->number(graph_->curves()[c].from);
        const std::uint32_t to = graph_->number(graph_->curves()[c].to);
        const Remainder& rest = rests_[c];
        left_[from] += rest.at_first;
        left_[to] += rest.at_last;
        if (from == to) {
            left_[from] += rest.across;
            left_[from] += rest.across.transposed();
        } else {
            add_block(to, from, rest.across);
        }
    }
    for (std::size_t k = 0; k < left_.size(); ++k) {
        const int i = 2 * static_cast<int>(k);
        entries_.emplace_back(i, i, left_[k].xx);
        entries_.emplace_back(i + 1, i, left_[k].yx);
        entries_.emplace_back(i + 1, i + 1, left_[k].yy);
    }
    add_pressures(rows);
    (void)junction_solver_.factorise(static_cast<Eigen::Index>(size), entries_);
}

// In the lower half of the matrix.
void CurveSolver::add_block(std::uint32_t row, std::uint32_t column, const Block& block) {
    const bool is_lower = row > column;
    const Block lower = is_lower ? block : block.transposed();
    const int i = 2 * static_cast<int>(std::max(row, column));
    const int j = 2 * static_cast<int>(std::min(row, column));
    entries_.emplace_back(i, j, lower.xx);
    entries_.emplace_back(i, j + 1, lower.xy);
    entries_.emplace_back(i + 1, j, lower.yx);
    entries_.emplace_back(i + 1, j + 1, lower.yy);
}

// Below the junctions S y = B p and B^T y + C p = gains, symmetric for -p: the rows B^T and -C. The
// matrix is quasidefinite, so that its factors exist in any order (Vanderbei, SIAM J. Optim. 5,
// 1995).
void CurveSolver::add_pressures(const PressureRows& rows) {
    yielding_.assign(rows.gains.size(), 0.0);
    const int first = 2 * static_cast<int>(left_.size());
    const auto add_anchor = [&](int place, std::uint32_t anchor, const Vector2& push) {
        const std::uint32_t number = graph_->number(anchor);
        if (place >= 0 && number != no_id) {
            const int column = 2 * static_cast<int>(number);
            entries_.emplace_back(first + place, column, push.x);
            entries_.emplace_back(first + place, column + 1, push.y);
            yielding_[static_cast<std::size_t>(place)] +=
                softness * dot(push, push) / (left_[number].xx + left_[number].yy);
        }
    };
    for (std::size_t c = 0; c < graph_->curves().size() && !rows.gains.empty(); ++c) {
        const NetworkCurve& curve = graph_->curves()[c];
        const CurvePush& push = rows.pushes[c];
        if (push.left == push.right) {
            continue;
        }
        for (const int place : {push.left, push.right}) {
            const double sign = place == push.left ? 1 : -1;
            add_anchor(place, curve.from, sign * push.at_from);
            add_anchor(place, curve.to, sign * push.at_to);
            if (place >= 0) {
                yielding_[static_cast<std::size_t>(place)] += (1 + softness) * rests_[c].yielding;
            }
        }
        if (push.left >= 0 && push.right >= 0) {
            entries_.emplace_back(first + std::max(push.left, push.right),
                                  first + std::min(push.left, push.right), rests_[c].yielding);
        }
    }
    for (std::size_t k = 0; k < yielding_.size(); ++k) {
        const int i = first + static_cast<int>(k);
        entries_.emplace_back(i, i, yielding_[k] > 0 ? -yielding_[k] : -1.0);
    }
}

// --- solution ------------------------------------------------------------------------------------

void CurveSolver::reduce(std::size_t share, std::span<Vector2> columns) {
    for (auto [c, end] = graph_->curves_of(share); c < end; ++c) {
        const NetworkCurve& curve = graph_->curves()[c];
        Vector2 before; // the column before, by the inverse there
        for (std::size_t k = curve.begin; k < curve.end; ++k) {
            const Factor& factor = factors_[k];
            Vector2& own = columns[graph_->places()[k].vertex];
            if (k != curve.begin) {
                own -= factor.to_before.of(before);
            }
            before = factor.inverse.of(own);
            to_from_[k] = factor.to_first.transposed().of(before);
        }
        if (curve.is_loop) {
            gather(c, columns);
            columns[curve.from] = rests_[c].cut_inverse.of(columns[curve.from]);
        }
    }
}

void CurveSolver::reduce(std::size_t share, std::span<const Vector2> columns,
                         const PressureRows& rows) {
    for (auto [c, end] = graph_->curves_of(share); c < end; ++c) {
        const NetworkCurve& curve = graph_->curves()[c];
        CurvePush& push = rows.pushes[c];
        Remainder& rest = rests_[c];
        rest.yielding = 0;
        rest.gained = 0;
        if (push.left == push.right || curve.begin == curve.end) {
            continue;
        }
        Vector2 before;
        for (std::size_t k = curve.begin; k < curve.end; ++k) {
            const Factor& factor = factors_[k];
            const std::uint32_t v = graph_->places()[k].vertex;
            Vector2& own = rows.columns[v];
            if (k != curve.begin) {
                own -= factor.to_before.of(before);
            }
            before = factor.inverse.of(own);
            push.at_from -= factor.to_first.transposed().of(before);
            rest.yielding += dot(own, before);
            rest.gained += dot(columns[v], before);
        }
        push.at_to -= rest.to_last.transposed().of(before);
        if (curve.is_loop) {
            const Vector2 own = rows.columns[curve.from] + push.at_from + push.at_to;
            rows.columns[curve.from] = rest.cut_inverse.of(own);
            rest.yielding += dot(own, rows.columns[curve.from]);
            rest.gained += dot(own, columns[curve.from]);
        }
    }
}

// The forward substitution at the anchors of a curve.
void CurveSolver::gather(std::size_t curve, std::span<Vector2> columns) const {
    const NetworkCurve& of = graph_->curves()[curve];
    if (of.begin == of.end) {
        return;
    }
    for (std::size_t k = of.begin; k < of.end; ++k) {
        columns[of.from] -= to_from_[k];
    }
    const Vector2& last = columns[graph_->places()[of.end - 1].vertex];
    columns[of.to] -= rests_[curve].to_last.transposed().of(factors_[of.end - 1].inverse.of(last));
}

void CurveSolver::finish(std::span<Vector2> columns, const InShares& in_shares,
                         const PressureRows& rows) {
    for (std::size_t c = 0; c < graph_->between_junctions().size(); ++c) {
        gather(c, columns);
    }
    solve_junctions(columns, rows);
    const auto pressure = [&](int place) {
        return place < 0 ? 0.0 : rows.pressures[static_cast<std::size_t>(place)];
    };
    graph_->for_each_curve(in_shares, [&](std::size_t c) {
        const NetworkCurve& curve = graph_->curves()[c];
        double push = 0;
        if (!rows.gains.empty() && rows.pushes[c].left != rows.pushes[c].right) {
            push = pressure(rows.pushes[c].left) - pressure(rows.pushes[c].right);
        }
        const auto add_push = [&](std::uint32_t v) {
            if (push != 0) {
                columns[v] += push * rows.columns[v];
            }
        };
        if (curve.is_loop) {
            add_push(curve.from);
        }
        Vector2 after = rests_[c].to_last.of(columns[curve.to]);
        for (std::size_t k = curve.end; k > curve.begin; --k) {
            const Factor& factor = factors_[k - 1];
            const std::uint32_t v = graph_->places()[k - 1].vertex;
            add_push(v);
            Vector2& own = columns[v];
            own = factor.inverse.of(own - after - factor.to_first.of(columns[curve.from]));
            after = factor.to_before.transposed().of(own);
        }
    });
}

void CurveSolver::solve_junctions(std::span<Vector2> columns, const PressureRows& rows) const {
    const std::span<const std::uint32_t> junctions = graph_->junctions().vertices;
    const std::size_t first = 2 * junctions.size();
    if (first + rows.gains.size() == 0) {
        return;
    }
    Eigen::VectorXd sides(static_cast<Eigen::Index>(first + rows.gains.size()));
    for (std::size_t k = 0; k < junctions.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(2 * k);
        sides[i] = columns[junctions[k]].x;
        sides[i + 1] = columns[junctions[k]].y;
    }
    const std::span<double> gains(sides.data() + first, rows.gains.size());
    std::ranges::copy(rows.gains, gains.begin());
    for (std::size_t c = 0; c < graph_->curves().size() && !gains.empty(); ++c) {
        const auto [left, right, from, to] = rows.pushes[c];
        if (left >= 0) {
            gains[static_cast<std::size_t>(left)] -= rests_[c].gained;
        }
        if (right >= 0) {
            gains[static_cast<std::size_t>(right)] += rests_[c].gained;
        }
    }
    if (junction_solver_.is_solvable()) {
        sides = junction_solver_.solve(sides);
    } else {
        sides.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t k = 0; k < junctions.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(2 * k);
        columns[junctions[k]] = {sides[i], sides[i + 1]};
    }
    for (std::size_t k = 0; k < rows.pressures.size(); ++k) {
        rows.pressures[k] = -sides[static_cast<Eigen::Index>(first + k)];
    }
}

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "geometric_flows/curve_solver.h"

#include "geometric_flows/curve_network.h"

#include <algorithm>
#include <limits>

namespace dsc {

namespace {

/// More shares than most machines have cores: curves, and with them shares, differ in length.
constexpr std::size_t most_shares = 8;
/// Vertices of a share at least: about ten microseconds of work.
constexpr std::size_t least_of_a_share = 256;

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

} // namespace

void CurveSolver::begin(const CurveNetwork& network, const InShares& in_shares) {
    network_ = &network;
    in_shares_ = &in_shares;
    for (auto* list : {&junctions_, &arms_, &vertices_, &edges_}) {
        list->clear();
    }
    curves_.clear();
    places_.clear();
    ends_.clear();
    find_sides();
    find_curves();
    to_from_.resize(places_.size());
    left_.resize(junctions_.size());
}

// --- the curves ----------------------------------------------------------------------------------

// A vertex that has not just two edges counts as a junction.
void CurveSolver::find_sides() {
    const std::size_t n = network_->positions.size();
    degree_.assign(n, 0);
    edges_at_.assign(n, {no_id, no_id});
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        for (const std::uint32_t v : {network_->edges[e].from, network_->edges[e].to}) {
            if (degree_[v] < 2) {
                edges_at_[v][degree_[v]] = e;
            }
            ++degree_[v];
        }
    }
    number_.assign(n, no_id);
    for (std::uint32_t v = 0; v < n; ++v) {
        if (network_->is_junction[v] != 0 || degree_[v] != 2) {
            number_[v] = static_cast<std::uint32_t>(junctions_.size());
            junctions_.push_back(v);
        }
    }
}

void CurveSolver::find_curves() {
    places_.reserve(number_.size() - junctions_.size());
    end_share(); // where the first one begins
    is_taken_.assign(network_->edges.size(), 0);
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        const CurveEdge& edge = network_->edges[e];
        const bool starts = number_[edge.from] != no_id;
        const bool ends = number_[edge.to] != no_id;
        if (starts || ends) {
            arms_.push_back(e);
        }
        if (starts && ends) {
            is_taken_[e] = 1;
        } else if ((starts || ends) && is_taken_[e] == 0) {
            follow(starts ? edge.from : edge.to, e);
        }
    }
    first_loop_ = curves_.size();
    for (std::uint32_t e = 0; e < network_->edges.size(); ++e) {
        if (is_taken_[e] == 0) {
            follow(network_->edges[e].from, e);
        }
    }
    if (ends_.back().curves < curves_.size()) {
        end_share();
    }
}

std::uint32_t CurveSolver::far_end(std::uint32_t edge, std::uint32_t vertex) const {
    const CurveEdge& e = network_->edges[edge];
    return e.from == vertex ? e.to : e.from;
}

// Along the curve that leaves the anchor by this edge, to its other anchor. The curve ends its
// share if that has vertices enough.
void CurveSolver::follow(std::uint32_t anchor, std::uint32_t edge) {
    Curve curve{.begin = places_.size(),
                .end = 0,
                .from = anchor,
                .to = anchor,
                .last = {},
                .is_loop = number_[anchor] == no_id};
    if (curve.is_loop) {
        vertices_.push_back(anchor);
    }
    std::uint32_t v = far_end(edge, anchor);
    for (; number_[v] == no_id && v != anchor; v = far_end(edge, v)) {
        is_taken_[edge] = 1;
        places_.push_back({.vertex = v, .before = {edge, network_->edges[edge].from == v}});
        vertices_.push_back(v);
        edges_.push_back(edge);
        edge = edges_at_[v][edges_at_[v][0] == edge ? 1 : 0];
    }
    is_taken_[edge] = 1;
    edges_.push_back(edge);
    curve.end = places_.size();
    curve.to = v;
    curve.last = {edge, network_->edges[edge].from == places_.back().vertex};
    curves_.push_back(curve);
    const std::size_t enough =
        std::max(least_of_a_share, (number_.size() - junctions_.size()) / most_shares + 1);
    if (vertices_.size() - ends_.back().vertices >= enough) {
        end_share();
    }
}

std::span<CurveSolver::Curve> CurveSolver::curves_of(std::size_t share) {
    return {curves_.data() + ends_[share].curves, curves_.data() + ends_[share + 1].curves};
}

CurvePart CurveSolver::part(std::size_t share) const {
    const ShareEnd& begin = ends_[share];
    const ShareEnd& end = ends_[share + 1];
    return {{vertices_.data() + begin.vertices, vertices_.data() + end.vertices},
            {edges_.data() + begin.edges, edges_.data() + end.edges},
            false};
}

// --- elimination ---------------------------------------------------------------------------------

void CurveSolver::eliminate(Curve& curve, std::span<const Block> diagonal,
                            std::span<const Block> coupling) {
    const auto block_of = [&](const Side& side) {
        return side.is_first ? coupling[side.edge] : coupling[side.edge].transposed();
    };
    Remainder rest;
    for (std::size_t k = curve.begin; k < curve.end; ++k) {
        Place& place = places_[k];
        place.to_before = block_of(place.before);
        Block own = diagonal[place.vertex];
        if (k == curve.begin) {
            place.to_first = place.to_before;
        } else {
            const Place& before = places_[k - 1];
            const Block factor = place.to_before * before.inverse;
            own += -(factor * place.to_before.transposed());
            place.to_first = -(factor * before.to_first);
        }
        place.inverse = inverse_of(own);
        rest.at_first += -(place.to_first.transposed() * (place.inverse * place.to_first));
    }
    const Place& last = places_[curve.end - 1];
    curve.to_last = block_of(curve.last);
    const Block factor = curve.to_last.transposed() * last.inverse;
    rest.at_last = -(factor * curve.to_last);
    rest.across = -(factor * last.to_first);
    curve.rest = rest;
    if (curve.is_loop) {
        Block left = diagonal[curve.from];
        for (const Block& more :
             {rest.at_first, rest.at_last, rest.across, rest.across.transposed()}) {
            left += more;
        }
        curve.cut_inverse = inverse_of(left);
    }
}

void CurveSolver::eliminate(std::size_t share, std::span<const Block> diagonal,
                            std::span<const Block> coupling) {
    for (Curve& curve : curves_of(share)) {
        eliminate(curve, diagonal, coupling);
    }
}

void CurveSolver::factorise_junctions(std::span<const Block> diagonal,
                                      std::span<const Block> coupling) {
    if (junctions_.empty()) {
        return;
    }
    entries_.clear();
    for (std::size_t i = 0; i < junctions_.size(); ++i) {
        left_[i] = diagonal[junctions_[i]];
    }
    for (const Curve& curve : between_junctions()) {
        const std::uint32_t from = number_[curve.from];
        const std::uint32_t to = number_[curve.to];
        left_[from] += curve.rest.at_first;
        left_[to] += curve.rest.at_last;
        if (from == to) {
            left_[from] += curve.rest.across;
            left_[from] += curve.rest.across.transposed();
        } else {
            add_block(to, from, curve.rest.across);
        }
    }
    for (const std::uint32_t e : arms_) {
        const std::uint32_t from = number_[network_->edges[e].from];
        const std::uint32_t to = number_[network_->edges[e].to];
        if (from != no_id && to != no_id) {
            add_block(from, to, coupling[e]);
        }
    }
    for (std::size_t k = 0; k < junctions_.size(); ++k) {
        const int i = 2 * static_cast<int>(k);
        entries_.emplace_back(i, i, left_[k].xx);
        entries_.emplace_back(i + 1, i, left_[k].yx);
        entries_.emplace_back(i + 1, i + 1, left_[k].yy);
    }
    (void)junction_solver_.factorise(static_cast<Eigen::Index>(2 * junctions_.size()), entries_);
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

// --- solution ------------------------------------------------------------------------------------

void CurveSolver::reduce(std::size_t share, std::span<Point<double>> columns) {
    for (const Curve& curve : curves_of(share)) {
        Point<double> before(0, 0); // the column before, by the inverse there
        for (std::size_t k = curve.begin; k < curve.end; ++k) {
            const Place& place = places_[k];
            Point<double>& own = columns[place.vertex];
            if (k != curve.begin) {
                own -= place.to_before.of(before);
            }
            before = place.inverse.of(own);
            to_from_[k] = place.to_first.transposed().of(before);
        }
        if (curve.is_loop) {
            gather(curve, columns);
            columns[curve.from] = curve.cut_inverse.of(columns[curve.from]);
        }
    }
}

// The forward substitution at the anchors of a curve.
void CurveSolver::gather(const Curve& curve, std::span<Point<double>> columns) const {
    for (std::size_t k = curve.begin; k < curve.end; ++k) {
        columns[curve.from] -= to_from_[k];
    }
    const Place& last = places_[curve.end - 1];
    columns[curve.to] -= curve.to_last.transposed().of(last.inverse.of(columns[last.vertex]));
}

void CurveSolver::finish(std::span<Point<double>> columns) {
    for (const Curve& curve : between_junctions()) {
        gather(curve, columns);
    }
    solve_junctions(columns);
    for_each_share([&](std::size_t share) {
        for (const Curve& curve : curves_of(share)) {
            Point<double> after = curve.to_last.of(columns[curve.to]);
            for (std::size_t k = curve.end; k > curve.begin; --k) {
                const Place& place = places_[k - 1];
                Point<double>& own = columns[place.vertex];
                own = place.inverse.of(own - after - place.to_first.of(columns[curve.from]));
                after = place.to_before.transposed().of(own);
            }
        }
    });
}

void CurveSolver::solve(std::span<Point<double>> columns) {
    for_each_share([&](std::size_t share) { reduce(share, columns); });
    finish(columns);
}

void CurveSolver::solve_junctions(std::span<Point<double>> columns) const {
    if (junctions_.empty()) {
        return;
    }
    Eigen::VectorXd sides(static_cast<Eigen::Index>(2 * junctions_.size()));
    for (std::size_t k = 0; k < junctions_.size(); ++k) {
        sides.segment<2>(static_cast<Eigen::Index>(2 * k)) = columns[junctions_[k]];
    }
    if (junction_solver_.is_solvable()) {
        sides = junction_solver_.solve(sides);
    } else {
        sides.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t k = 0; k < junctions_.size(); ++k) {
        columns[junctions_[k]] = sides.segment<2>(static_cast<Eigen::Index>(2 * k));
    }
}

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "topology/give_back.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"
#include "dsc/motion/movement.h"
#include "dsc/queries/locate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace dsc {

namespace {

/// Transfers of the same two phases within this many edge lengths are netted: in a T1, much of the
/// area that one triangle takes, the next one returns.
constexpr double same_place = 4;
/// How far a vertex may move, in edge lengths: too little to close or open anything.
constexpr double farthest_move = 0.1;
/// Fewer vertices would make a bump.
constexpr std::size_t fewest_vertices = 6;
/// The search for an interface between the two phases ends after this many vertices.
constexpr std::size_t max_searched = 4096;
/// Rounds in which the pressure is computed: each leaves a small part of the remaining area, until
/// that is rounding.
constexpr int max_pressures = 30;

/// The area that one phase owes another at one place.
struct Debt {
    Point<double> place;
    Triangle near; ///< where the search begins
    double area;   ///< area owed to the first phase of the pair; negative: to the second
};

/// An interface vertex with two interface edges, both between the two phases.
struct Bend {
    std::uint32_t vertex;
    std::uint32_t before; ///< neighbours along the curve, with the phase that must gain on the left
    std::uint32_t after;
    Point<double> first; ///< its position at the start
    double weight = 1;   ///< of its movement
};

template <class Real>
class GiveBack {
public:
    explicit GiveBack(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex),
          farthest_(farthest_move * static_cast<double>(work.edge_length)) {}

    AreaAccount run() {
        AreaAccount account;
        for (const auto& [phases, debts] : collect_debts()) {
            for (const Debt& debt : debts) {
                const double left = repay(phases, debt);
                account.given_back += std::abs(debt.area) - std::abs(left);
                account.owed += std::abs(left);
            }
        }
        return account;
    }

private:
    using Pair = std::pair<Phase, Phase>;

    // The net debts, in the order of the phases.
    std::map<Pair, std::vector<Debt>> collect_debts() {
        std::map<Pair, std::vector<Debt>> debts;
        const double near = same_place * static_cast<double>(work_.edge_length);
        for (const Transfer& transfer : std::exchange(work_.transfers, {})) {
            const bool in_order = transfer.from < transfer.to;
            const double area = in_order ? transfer.area : -transfer.area;
            auto& list = debts[in_order ? Pair{transfer.from, transfer.to}
                                        : Pair{transfer.to, transfer.from}];
            const auto known = std::ranges::find_if(list, [&](const Debt& debt) {
                return (debt.place - transfer.place).norm() < near;
            });
            if (known != list.end()) {
                known->area += area;
            } else {
                list.push_back({transfer.place, transfer.near, area});
            }
        }
        return debts;
    }

    // Repays a debt by moving the interface; returns what remains of it.
    double repay(const Pair& phases, const Debt& debt) {
        const Phase gains = debt.area > 0 ? phases.first : phases.second;
        const Phase loses = debt.area > 0 ? phases.second : phases.first;
        double left = std::abs(debt.area);
        if (left == 0 || !find_bends(debt, gains, loses, left)) {
            return left;
        }
        for (int round = 0; round < max_pressures; ++round) {
            const double before = std::abs(left);
            left -= move_by(left);
            if (left == 0 || std::abs(left) > 0.9 * before) {
                break;
            }
        }
        return left;
    }

    // --- where ----------------------------------------------------------------------------------
    bool find_bends(const Debt& debt, Phase gains, Phase loses, double area) {
        bends_.clear();
        const Location start = locate<Real>(complex_, debt.place.cast<Real>(), debt.near);
        if (start.kind == Location::Kind::outside) {
            return false;
        }
        std::vector<std::uint32_t> layer;
        std::unordered_set<std::uint32_t> seen;
        for (const Vertex v : complex_.vertices_of(start.triangle)) {
            layer.push_back(v.id);
            seen.insert(v.id);
        }
        double room = 0; // area that the vertices can sweep
        while (!layer.empty() && seen.size() < max_searched &&
               (bends_.size() < fewest_vertices || room < area)) {
            std::vector<std::uint32_t> next_layer;
            for (const std::uint32_t v : layer) {
                if (add_bend(Vertex{v}, gains, loses)) {
                    // One third of the largest sweep, because the weights fall towards the ends.
                    room += farthest_ * gradient(bends_.back()).norm() / 3;
                }
                for_each_corner(complex_, Vertex{v}, [&](Corner c) {
                    for (const Corner end : {next(c), prev(c)}) {
                        const std::uint32_t w = complex_.vertex(end);
                        if (seen.insert(w).second) {
                            next_layer.push_back(w);
                        }
                    }
                });
            }
            layer = std::move(next_layer);
        }
        weigh(debt.place);
        return !bends_.empty();
    }

    bool add_bend(Vertex v, Phase gains, Phase loses) {
        constexpr std::uint32_t fixed = vertex_locked | vertex_feature;
        if ((complex_.vertices[v.id].flags & fixed) != 0) {
            return false;
        }
        Bend bend{v.id, no_id, no_id, position(v.id)};
        int edges = 0;
        bool is_inside = true;
        for_each_corner(complex_, v, [&](Corner c) {
            // The half-edge that leaves the vertex, with the triangle of the corner on its left.
            const Corner edge = prev(c);
            const Corner across = complex_.twin(edge);
            is_inside = is_inside && !is_border(across) && !is_border(complex_.twin(next(c)));
            const Phase left = complex_.phase_at(c);
            const Phase right = complex_.phase_at(across);
            if (left == right) {
                return;
            }
            ++edges;
            if (left == gains && right == loses) {
                bend.after = complex_.vertex(next(c));
            } else if (left == loses && right == gains) {
                bend.before = complex_.vertex(next(c));
            }
        });
        if (!is_inside || edges != 2 || bend.before == no_id || bend.after == no_id) {
            return false;
        }
        bends_.push_back(bend);
        return true;
    }

    // Sorts vertices nearest first, with weights that fall to 0 beyond the farthest, so that the
    // curve stays smooth.
    void weigh(const Point<double>& place) {
        const auto squared = [&](const Bend& bend) { return (bend.first - place).squaredNorm(); };
        std::ranges::sort(bends_, {}, [&](const Bend& bend) {
            return std::tuple(squared(bend), bend.first.x(), bend.first.y());
        });
        const double farthest = bends_.empty() ? 0 : squared(bends_.back());
        for (Bend& bend : bends_) {
            // A single vertex may lie exactly at the place.
            bend.weight = farthest > 0 ? 1 - squared(bend) / (1.2 * farthest) : 1;
        }
    }

    // --- by how much ----------------------------------------------------------------------------
    [[nodiscard]] Point<double> position(std::uint32_t v) const {
        return complex_.position(Vertex{v}).template cast<double>();
    }

    // The gradient of the area on the left of the curve: half of the chord between the neighbours,
    // turned clockwise. The area is linear in the position of a single vertex.
    [[nodiscard]] Point<double> gradient(const Bend& bend) const {
        const Point<double> chord = position(bend.after) - position(bend.before);
        return Point<double>(chord.y(), -chord.x()) / 2;
    }

    // The displacement along the normal per unit of pressure: equal everywhere except for the
    // weight, and small at a sharp tip.
    [[nodiscard]] Point<double> way(const Bend& bend) const {
        const Point<double> at = position(bend.vertex);
        const double length =
            ((position(bend.after) - at).norm() + (at - position(bend.before)).norm()) / 2;
        return gradient(bend) * (bend.weight / length);
    }

    // Moves all vertices; returns the area gained.
    double move_by(double area) {
        double per_pressure = 0;
        for (const Bend& bend : bends_) {
            per_pressure += gradient(bend).dot(way(bend));
        }
        if (!(per_pressure > 0)) {
            return 0; // no room: all weights are 0, or the curve turns back at once
        }
        const double pressure = area / per_pressure;
        double gained = 0;
        for (const Bend& bend : bends_) {
            gained += move(bend, pressure * way(bend));
        }
        return gained;
    }

    double move(const Bend& bend, const Point<double>& step) {
        const Point<double> before = position(bend.vertex);
        Point<double> whole = before + step - bend.first;
        if (const double length = whole.norm(); length > farthest_) {
            whole *= farthest_ / length;
        }
        const Point<Real> target = (bend.first + whole).template cast<Real>();
        if (!gather(complex_, Region{}, bend.vertex, star_)) {
            return 0;
        }
        if (move_vertex(submesh_, star_, target.x(), target.y(), MoveReason::giving_back) ==
            MoveOutcome::blocked) {
            return 0;
        }
        return gradient(bend).dot(position(bend.vertex) - before);
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    double farthest_;
    std::vector<Bend> bends_;
    Star<Real> star_;
};

} // namespace

template <class Real>
AreaAccount give_back(TopologyWork<Real>& work) {
    return work.transfers.empty() ? AreaAccount{} : GiveBack<Real>(work).run();
}

template AreaAccount give_back(TopologyWork<double>&);
template AreaAccount give_back(TopologyWork<float>&);

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "geometric_flows/kept_areas.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <numeric>

namespace dsc {

namespace {

/// The place of the phase in the list, which is sorted by phase, or -1.
int place_in(std::span<const KeptArea> kept, Phase phase) {
    const auto found = std::ranges::lower_bound(kept, phase, {}, &KeptArea::phase);
    return found == kept.end() || found->phase != phase ? -1
                                                        : static_cast<int>(found - kept.begin());
}

/// Those of the phases whose areas can be kept. A phase that is absent or locked has none that
/// could change; where all phases are kept, the last one follows from the others.
std::vector<KeptArea> changeable(const CurveNetwork& network, std::span<const KeptArea> kept) {
    std::vector<std::uint8_t> is_there(kept.size(), 0);
    bool are_all_kept = true;
    const auto note = [&](Phase phase) {
        const int place = place_in(kept, phase);
        if (place >= 0) {
            is_there[static_cast<std::size_t>(place)] = 1;
        }
        are_all_kept = are_all_kept && place >= 0;
    };
    const auto can_move = [&](std::uint32_t i) {
        return network.freedom[i].xx + network.freedom[i].yy > 0;
    };
    for (const CurveEdge& edge : network.edges) {
        if (edge.forces.drag > 0 && (can_move(edge.from) || can_move(edge.to))) {
            note(edge.left);
            note(edge.right);
        }
    }
    std::vector<KeptArea> list;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (is_there[k] != 0) {
            list.push_back(kept[k]);
        }
    }
    if (are_all_kept && !list.empty()) {
        list.pop_back();
    }
    return list;
}

/// Written out: the compiler warns of Eigen's own.
double dot(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

void add_to(std::span<Point<double>> sum, std::span<const Point<double>> more, double factor = 1) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += factor * more[i];
    }
}

} // namespace

// --- once for each network -----------------------------------------------------------------------

void AreaKeeper::begin(const CurveNetwork& network, std::span<const KeptArea> kept) {
    network_ = &network;
    kept_ = changeable(network, kept);
    pressures_ = Vector::Zero(static_cast<Eigen::Index>(kept_.size()));
    if (!kept_.empty()) {
        find_sides();
    }
}

void AreaKeeper::find_sides() {
    const auto ordered = [](const Sides& sides) {
        return sides.left < sides.right ? sides : Sides{sides.right, sides.left};
    };
    sides_.clear();
    pairs_.clear();
    for (const CurveEdge& edge : network_->edges) {
        sides_.push_back({place_in(kept_, edge.left), place_in(kept_, edge.right)});
        if (pairs_.empty() || pairs_.back() != ordered(sides_.back())) { // along a curve they stay
            pairs_.push_back(ordered(sides_.back()));
        }
    }
    std::ranges::sort(pairs_);
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    pair_of_.clear();
    curve_of_.assign(network_->positions.size(), no_id);
    arms_.clear();
    for (std::uint32_t e = 0; e < sides_.size(); ++e) {
        const auto place = std::ranges::lower_bound(pairs_, ordered(sides_[e])) - pairs_.begin();
        pair_of_.push_back(static_cast<std::uint32_t>(place));
        for (const std::uint32_t v : {network_->edges[e].from, network_->edges[e].to}) {
            if (network_->is_junction[v] != 0) {
                arms_.emplace_back(v, e);
            } else {
                curve_of_[v] = e;
            }
        }
    }
    std::ranges::sort(arms_);
}

// --- areas and their derivatives -----------------------------------------------------------------

// Relative to a vertex, so that an offset of all costs no digits.
void AreaKeeper::find_missing(std::span<const Point<double>> positions,
                              std::span<const Point<double>> displacements) {
    missing_.resize(static_cast<Eigen::Index>(kept_.size()));
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        missing_[static_cast<Eigen::Index>(k)] = kept_[k].area;
    }
    const Point<double> origin = positions[0] + displacements[0];
    const auto at = [&](std::uint32_t v) {
        return Point<double>(positions[v] + displacements[v] - origin);
    };
    for (std::size_t e = 0; e < sides_.size(); ++e) {
        const CurveEdge& edge = network_->edges[e];
        const double part = cross<double>(at(edge.from), at(edge.to)) / 2;
        if (sides_[e].left >= 0) {
            missing_[sides_[e].left] -= part;
        }
        if (sides_[e].right >= 0) {
            missing_[sides_[e].right] += part;
        }
    }
}

// What pressures do without tension: vertices move along the gradients of the areas, as far as they
// are free to, and the less the more drag they have. False if the pressures cannot be found.
bool AreaKeeper::prepare(std::span<const Point<double>> positions,
                         std::span<const Point<double>> displacements) {
    moves_.resize(positions.size()); // first the places
    for (std::size_t v = 0; v < positions.size(); ++v) {
        moves_[v] = positions[v] + displacements[v];
    }
    lump_drag(*network_, moves_, drag_);
    normals_.resize(sides_.size());
    across_.assign(positions.size(), Point<double>(0, 0));
    for (std::size_t e = 0; e < sides_.size(); ++e) {
        const CurveEdge& edge = network_->edges[e];
        const Point<double> way = moves_[edge.to] - moves_[edge.from];
        normals_[e] = Point<double>(way.y(), -way.x()) / 2;
        for (const std::uint32_t v : {edge.from, edge.to}) {
            if (network_->is_junction[v] == 0) {
                const bool is_turned = sides_[curve_of_[v]] != sides_[e];
                across_[v] += is_turned ? Point<double>(-normals_[e]) : normals_[e];
            }
        }
    }
    sums_.assign(pairs_.size(), 0.0);
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        if (curve_of_[v] != no_id && drag_[v] > 0) {
            sums_[pair_of_[curve_of_[v]]] +=
                across_[v].dot(network_->freedom[v].of(across_[v])) / drag_[v];
        }
    }
    entries_.clear();
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const auto [low, high] = pairs_[k];
        if (low >= 0) {
            entries_.emplace_back(low, low, sums_[k]);
            entries_.emplace_back(high, low, -sums_[k]);
        }
        if (high >= 0) {
            entries_.emplace_back(high, high, sums_[k]);
        }
    }
    add_junctions();
    return solver_.factorise(static_cast<Eigen::Index>(kept_.size()), entries_);
}

// Where the edges of a vertex lie between different phases, each is paired with each.
void AreaKeeper::add_junctions() {
    for (std::size_t i = 0; i < arms_.size(); ++i) {
        const auto [v, e] = arms_[i];
        if (!(drag_[v] > 0)) {
            continue;
        }
        const Point<double> move = network_->freedom[v].of(normals_[e]) / drag_[v];
        const auto add = [&](int row, int column, double value) {
            if (row >= column && column >= 0) { // the solver reads the lower half
                entries_.emplace_back(row, column, value);
            }
        };
        std::size_t k = i;
        while (k > 0 && arms_[k - 1].first == v) {
            --k;
        }
        for (; k < arms_.size() && arms_[k].first == v; ++k) {
            const std::uint32_t f = arms_[k].second;
            const double value = normals_[f].dot(move);
            add(sides_[f].left, sides_[e].left, value);
            add(sides_[f].left, sides_[e].right, -value);
            add(sides_[f].right, sides_[e].left, -value);
            add(sides_[f].right, sides_[e].right, value);
        }
    }
}

// The forces of pressures on the vertices.
void AreaKeeper::push(const Vector& pressures, std::span<Point<double>> forces) const {
    std::ranges::fill(forces, Point<double>(0, 0));
    const auto in = [&](int place) { return place >= 0 ? pressures[place] : 0.0; };
    for (std::size_t e = 0; e < sides_.size(); ++e) {
        const Point<double> force = (in(sides_[e].left) - in(sides_[e].right)) * normals_[e];
        forces[network_->edges[e].from] += force;
        forces[network_->edges[e].to] += force;
    }
}

// By how much the areas grow, to first order.
AreaKeeper::Vector AreaKeeper::gained_by(std::span<const Point<double>> displacements) const {
    Vector gain = Vector::Zero(static_cast<Eigen::Index>(kept_.size()));
    for (std::size_t e = 0; e < sides_.size(); ++e) {
        const CurveEdge& edge = network_->edges[e];
        const double part = normals_[e].dot(displacements[edge.from] + displacements[edge.to]);
        if (sides_[e].left >= 0) {
            gain[sides_[e].left] += part;
        }
        if (sides_[e].right >= 0) {
            gain[sides_[e].right] -= part;
        }
    }
    return gain;
}

// --- pressures -----------------------------------------------------------------------------------

// Pressures during a step of the system that give the areas what is missing: conjugate gradients,
// preconditioned by what pressures do without tension, and from those of the step before.
void AreaKeeper::press(CurveSystem& system, std::span<Point<double>> displacements) {
    constexpr int most_rounds = 30;
    constexpr double tolerance = 1e-8; // what remains is left to a shift
    const double all = dot(missing_, missing_);
    const double enough = tolerance * tolerance * all;
    total_.assign(displacements.size(), Point<double>(0, 0));
    Vector left = missing_;
    if (dot(pressures_, pressures_) > 0) {
        push(pressures_, total_);
        system.respond(total_);
        left -= gained_by(total_);
    }
    Vector preconditioned = solver_.solve(left);
    Vector direction = preconditioned;
    double size = dot(left, preconditioned);
    for (int round = 0; round < most_rounds && dot(left, left) > enough; ++round) {
        push(direction, moves_);
        system.respond(moves_);
        const Vector gain = gained_by(moves_);
        const double slope = dot(direction, gain);
        if (!(slope > 0)) {
            break;
        }
        add_to(total_, moves_, size / slope);
        pressures_ += (size / slope) * direction;
        left -= (size / slope) * gain;
        preconditioned = solver_.solve(left);
        const double next = dot(left, preconditioned);
        direction = preconditioned + (next / size) * direction;
        size = next;
    }
    // Rounding errors alone would be left over by targets that contradict each other.
    if (dot(left, left) <= all) {
        add_to(displacements, total_);
    } else {
        pressures_.setZero();
    }
}

// Without tension, by the shortest way.
void AreaKeeper::shift(std::span<Point<double>> displacements) {
    push(solver_.solve(missing_), moves_);
    for (std::size_t i = 0; i < moves_.size(); ++i) {
        if (drag_[i] > 0) {
            displacements[i] += network_->freedom[i].of(moves_[i]) / drag_[i];
        }
    }
}

void AreaKeeper::keep(std::span<const Point<double>> positions,
                      std::span<Point<double>> displacements, CurveSystem* system) {
    // Area is quadratic in the displacement: a shift leaves about its square.
    constexpr int shifts = 3;
    if (kept_.empty() || !prepare(positions, displacements)) {
        return;
    }
    if (system != nullptr) {
        find_missing(positions, displacements);
        press(*system, displacements);
    }
    for (int done = 0; done < shifts; ++done) {
        find_missing(positions, displacements);
        shift(displacements);
    }
}

} // namespace dsc

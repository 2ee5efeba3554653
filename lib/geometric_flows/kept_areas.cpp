// SPDX-License-Identifier: MIT
#include "geometric_flows/kept_areas.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

namespace {

/// The index of the phase in the list, which is sorted by phase, or -1.
int place_in(std::span<const KeptArea> kept, Phase phase) {
    const auto found = std::ranges::lower_bound(kept, phase, {}, &KeptArea::phase);
    return found == kept.end() || found->phase != phase ? -1
                                                        : static_cast<int>(found - kept.begin());
}

/// Calls `visit(k, a, b)` for each edge from a to b of a curve, from its first anchor to its last
/// one; the place of b is k.
template <class Visit>
void for_each_edge(const CurveGraph& graph, const NetworkCurve& curve, const Visit& visit) {
    std::uint32_t before = curve.from;
    for (std::size_t k = curve.begin; k < curve.end; ++k) {
        const std::uint32_t v = graph.places()[k].vertex;
        visit(k, before, v);
        before = v;
    }
    visit(curve.end, before, curve.to);
}

/// The phases on the left and on the right of a curve.
std::array<Phase, 2> phases_beside(const CurveGraph& graph, const NetworkCurve& curve) {
    const CurveEdge& last = graph.network().edges[curve.last.edge];
    return curve.last.is_first ? std::array{last.left, last.right}
                               : std::array{last.right, last.left};
}

/// The phases whose areas can be kept. The area of a phase that is absent or locked cannot change;
/// if all phases are kept, the last area follows from the others.
std::vector<KeptArea> changeable(const CurveGraph& graph, std::span<const KeptArea> kept) {
    const CurveNetwork& network = graph.network();
    const auto can_move = [&](std::uint32_t i) {
        return network.freedom[i].xx + network.freedom[i].yy > 0;
    };
    std::vector<std::uint8_t> is_there(kept.size(), 0);
    bool are_all_kept = true;
    for (const NetworkCurve& curve : graph.curves()) {
        bool moves = false;
        for_each_edge(graph, curve, [&](std::size_t, std::uint32_t a, std::uint32_t b) {
            moves = moves || can_move(a) || can_move(b);
        });
        if (!moves || !(network.edges[curve.last.edge].forces.drag > 0)) {
            continue;
        }
        for (const Phase phase : phases_beside(graph, curve)) {
            const int place = place_in(kept, phase);
            if (place >= 0) {
                is_there[static_cast<std::size_t>(place)] = 1;
            }
            are_all_kept = are_all_kept && place >= 0;
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

} // namespace

// --- once for each network -----------------------------------------------------------------------

void AreaKeeper::begin(const CurveGraph& graph, std::span<const KeptArea> kept) {
    graph_ = &graph;
    origin_ = graph.network().positions.empty() ? Vector2{} : graph.network().positions[0];
    kept_.clear();
    if (!kept.empty()) {
        kept_ = changeable(graph, kept);
    }
    if (kept_.empty()) {
        return;
    }
    const std::size_t curves = graph.curves().size();
    pushes_.resize(curves);
    strands_.resize(curves);
    arms_.clear();
    for (std::uint32_t c = 0; c < curves; ++c) {
        const NetworkCurve& curve = graph.curves()[c];
        const auto [left, right] = phases_beside(graph, curve);
        pushes_[c] = {.left = place_in(kept_, left), .right = place_in(kept_, right)};
        if (!curve.is_loop) {
            arms_.push_back({curve.from, c, false});
            arms_.push_back({curve.to, c, true});
        }
    }
    std::ranges::sort(arms_);
    const std::size_t n = graph.network().positions.size();
    columns_.resize(n);
    drag_.resize(n);
    places_.resize(n);
    missing_.resize(kept_.size());
    pressures_.resize(kept_.size());
}

// --- areas and their derivatives -----------------------------------------------------------------

// An edge pushes each of its ends by half of its length along the normal to its right, as far as
// they are free to move, and each has half of its drag, which only shifts need.
void AreaKeeper::push(std::size_t curve, std::span<const Vector2> places, bool with_drag) {
    const NetworkCurve& of = graph_->curves()[curve];
    const CurveNetwork& network = graph_->network();
    const double drag = network.edges[of.last.edge].forces.drag;
    CurvePush push = pushes_[curve];
    Strand strand = strands_[curve];
    strand.yielding = 0;
    const auto set = [&](std::uint32_t v, const Vector2& normal, double halves) {
        const Vector2 column = network.freedom[v].of(normal);
        columns_[v] = column;
        if (with_drag) {
            drag_[v] = halves;
            strand.yielding += halves > 0 ? dot(column, column) / halves : 0.0;
        }
    };
    Vector2 before;
    double half_before = 0;
    for_each_edge(*graph_, of, [&](std::size_t k, std::uint32_t a, std::uint32_t b) {
        const Vector2 way = places[b] - places[a];
        const Vector2 normal = Vector2{way.y, -way.x} / 2;
        const double half = with_drag ? drag * norm(normal) : 0.0;
        if (k == of.begin) {
            push.at_from = normal;
            strand.half_at_from = half;
        } else {
            set(a, before + normal, half_before + half);
        }
        before = normal;
        half_before = half;
    });
    push.at_to = before;
    strand.half_at_to = half_before;
    if (of.is_loop) {
        set(of.from, push.at_from + push.at_to, strand.half_at_from + strand.half_at_to);
        push.at_from = push.at_to = Vector2{};
    } else {
        push.at_from = network.freedom[of.from].of(push.at_from);
        push.at_to = network.freedom[of.to].of(push.at_to);
    }
    pushes_[curve] = push;
    strands_[curve] = strand;
}

// Coordinates are relative to the initial position of a vertex, so that an offset of all
// coordinates costs no digits. The vertex's current position cannot be used, because another thread
// may be moving it.
double AreaKeeper::area_of(std::size_t curve, std::span<const Vector2> places) const {
    double doubled = 0;
    for_each_edge(*graph_, graph_->curves()[curve],
                  [&](std::size_t, std::uint32_t a, std::uint32_t b) {
                      doubled += cross(places[a] - origin_, places[b] - origin_);
                  });
    return doubled / 2;
}

void AreaKeeper::find_missing() {
    std::ranges::transform(kept_, missing_.begin(), &KeptArea::area);
    for (std::size_t c = 0; c < strands_.size(); ++c) {
        if (pushes_[c].left >= 0) {
            missing_[static_cast<std::size_t>(pushes_[c].left)] -= strands_[c].area;
        }
        if (pushes_[c].right >= 0) {
            missing_[static_cast<std::size_t>(pushes_[c].right)] += strands_[c].area;
        }
    }
}

PressureRows AreaKeeper::rows(std::span<const Vector2> positions, const InShares& in_shares) {
    if (kept_.empty()) {
        return {};
    }
    graph_->for_each_curve(in_shares, [&](std::size_t c) {
        push(c, positions, false);
        strands_[c].area = area_of(c, positions);
    });
    find_missing();
    return {.pushes = pushes_, .columns = columns_, .gains = missing_, .pressures = pressures_};
}

bool AreaKeeper::look(std::span<const Vector2> positions, std::span<const Vector2> displacements,
                      const InShares& in_shares) {
    if (kept_.empty()) {
        return true;
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
        places_[v] = positions[v] + displacements[v];
    }
    graph_->for_each_curve(in_shares, [&](std::size_t c) {
        push(c, places_, true);
        strands_[c].area = area_of(c, places_);
        strands_[c].second = 0;
        for_each_edge(
            *graph_, graph_->curves()[c], [&](std::size_t, std::uint32_t a, std::uint32_t b) {
                strands_[c].second += std::abs(cross(displacements[a], displacements[b])) / 2;
            });
    });
    find_missing();
    constexpr double rounding = 1e-6;
    pressures_.assign(kept_.size(), 0.0); // first used as scratch: bounds on the missing areas
    for (std::size_t c = 0; c < strands_.size(); ++c) {
        for (const int place : {pushes_[c].left, pushes_[c].right}) {
            if (place >= 0) {
                pressures_[static_cast<std::size_t>(place)] += strands_[c].second;
            }
        }
    }
    bool holds = true;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        holds = holds && std::abs(missing_[k]) <= pressures_[k] + rounding * kept_[k].area;
    }
    return holds;
}

// --- the remaining error
// ---------------------------------------------------------------------------

// Factorises the response to pressures without tension: vertices move along the gradients of the
// areas, as far as they are free to, and less with more drag. Curves that meet at a junction move
// it together. False if there is no solution.
bool AreaKeeper::prepare() {
    entries_.clear();
    const auto add = [&](int row, int column, double value) {
        if (row >= column && column >= 0) { // the solver reads the lower half
            entries_.emplace_back(row, column, value);
        }
    };
    const auto add_pair = [&](const CurvePush& one, const CurvePush& other, double value) {
        add(one.left, other.left, value);
        add(one.left, other.right, -value);
        add(one.right, other.left, -value);
        add(one.right, other.right, value);
    };
    for (std::size_t c = 0; c < strands_.size(); ++c) {
        add_pair(pushes_[c], pushes_[c], strands_[c].yielding);
    }
    for_each_junction([&](std::span<const Arm> arms, double drag) {
        for (const Arm& one : arms) {
            for (const Arm& other : arms) {
                add_pair(pushes_[one.curve], pushes_[other.curve],
                         dot(push_of(one), push_of(other)) / drag);
            }
        }
    });
    return solver_.factorise(static_cast<Eigen::Index>(kept_.size()), entries_);
}

template <class Visit>
void AreaKeeper::for_each_junction(const Visit& visit) const {
    const auto same = [](const Arm& one, const Arm& other) {
        return one.junction == other.junction;
    };
    for (auto first = arms_.begin(); first != arms_.end();) {
        double drag = 0;
        auto last = first;
        for (; last != arms_.end() && same(*first, *last); ++last) {
            const Strand& strand = strands_[last->curve];
            drag += last->is_last ? strand.half_at_to : strand.half_at_from;
        }
        if (drag > 0) {
            visit(std::span<const Arm>(first, last), drag);
        }
        first = last;
    }
}

const Vector2& AreaKeeper::push_of(const Arm& arm) const {
    return arm.is_last ? pushes_[arm.curve].at_to : pushes_[arm.curve].at_from;
}

double AreaKeeper::pressure_on(std::size_t curve) const {
    const auto at = [&](int place) {
        return place >= 0 ? pressures_[static_cast<std::size_t>(place)] : 0.0;
    };
    return at(pushes_[curve].left) - at(pushes_[curve].right);
}

void AreaKeeper::shift(std::span<Vector2> displacements, const InShares& in_shares) {
    // Area is quadratic in the displacement: a shift leaves about its square.
    constexpr int shifts = 3;
    if (kept_.empty() || !prepare()) {
        return;
    }
    const auto move = [&](std::uint32_t v, const Vector2& push, double drag) {
        if (drag > 0) {
            displacements[v] += push / drag;
            places_[v] += push / drag;
        }
    };
    const auto shift_curve = [&](std::size_t c) {
        const NetworkCurve& curve = graph_->curves()[c];
        const double pressure = pressure_on(c);
        for (std::size_t k = curve.begin; k < curve.end; ++k) {
            const std::uint32_t v = graph_->places()[k].vertex;
            move(v, pressure * columns_[v], drag_[v]);
        }
        if (curve.is_loop) {
            move(curve.from, pressure * columns_[curve.from], drag_[curve.from]);
        }
    };
    for (int done = 0; done < shifts; ++done) {
        Eigen::Map<Eigen::VectorXd>(pressures_.data(), std::ssize(pressures_)) =
            solver_.solve(Eigen::Map<const Eigen::VectorXd>(missing_.data(), std::ssize(missing_)));
        for_each_junction([&](std::span<const Arm> arms, double drag) {
            for (const Arm& arm : arms) {
                move(arm.junction, pressure_on(arm.curve) * push_of(arm), drag);
            }
        });
        graph_->for_each_curve(in_shares, [&](std::size_t c) {
            shift_curve(c);
            strands_[c].area = area_of(c, places_);
        });
        find_missing();
    }
}

} // namespace dsc

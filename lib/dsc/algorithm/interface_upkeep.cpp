// SPDX-License-Identifier: MIT
#include "dsc/algorithm/interface_upkeep.h"

#include "dsc/algorithm/wall.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/quality/ring_quality.h"

#include <cmath>
#include <numbers>
#include <random>

namespace dsc {

namespace {

// The interface spokes of a ring; more than two make a junction.
struct Spokes {
    std::uint32_t count = 0;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

bool is_interface_pair(Phase before, Phase after) {
    if (before == after) {
        return false;
    }
    if (before == border_phase) {
        return after != exterior_phase;
    }
    return after != border_phase || before != exterior_phase;
}

template <class Real>
Spokes interface_spokes(const Ring<Real>& ring) {
    Spokes spokes;
    for (std::uint32_t i = 0; i < ring.link_size(); ++i) {
        if (is_interface_pair(ring.phase_before(i), ring.phase_after(i))) {
            (spokes.count == 0 ? spokes.first : spokes.second) = i;
            ++spokes.count;
        }
    }
    return spokes;
}

template <class Real>
Point<Real> link_point(const Ring<Real>& ring, std::uint32_t i) {
    return {ring.link_x(i), ring.link_y(i)};
}

// Whether the polyline turns by less than the corner angle at `at`.
template <class Real>
bool is_smooth(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to, Real cosine) {
    const Point<Real> in = at - from;
    const Point<Real> out = to - at;
    const Real dot = in.dot(out);
    return dot > cosine * std::sqrt(in.squaredNorm() * out.squaredNorm());
}

template <class Real>
class Upkeep {
public:
    explicit Upkeep(Work<Real>& work)
        : work_(work), complex_(work.complex), length_(work.options.edge_length),
          longest_squared_(square(work.options.interface.longest)),
          shortest_squared_(square(work.options.interface.shortest)),
          deviation_squared_(square(work.options.interface.deviation)),
          corner_cosine_(static_cast<Real>(
              std::cos(work.options.interface.corner_degrees * std::numbers::pi / 180))),
          // A poor triangle for the time being is better than none that can move.
          wall_{longest_squared_, shortest_squared_, Real(0.05)} {}

    void run() {
        auto& kept = work_.interface_next;
        kept.clear();
        for (const std::uint32_t v : work_.interface) {
            visit(v);
        }
        std::swap(work_.interface, kept);
    }

private:
    Real square(double relative) const {
        const Real value = static_cast<Real>(relative) * length_;
        return value * value;
    }

    void visit(std::uint32_t v) {
        if (!complex_.is_alive(Vertex{v})) {
            return;
        }
        Ring<Real>& ring = work_.ring;
        const bool gathered = gather(complex_, work_.submesh.region, v, ring);
        if (gathered && !ring.owned) {
            // The triangles of this star are of two submeshes, so that nobody rewrites them, and
            // nothing moves during upkeep: whether there is anything to do can be seen from here.
            const Spokes spokes = interface_spokes(ring);
            if (should_collapse(ring, spokes) || long_spoke(ring) != no_id ||
                wants_wall_upkeep(ring)) {
                work_.put_off_interface.push_back(v);
            }
            work_.interface_next.push_back(v);
            return;
        }
        if (!gathered) {
            work_.interface_next.push_back(v);
            return;
        }
        const Spokes spokes = interface_spokes(ring);
        if (spokes.count == 0) {
            return;
        }
        if (should_collapse(ring, spokes) && try_collapse(ring, spokes)) {
            return;
        }
        if (wants_wall_upkeep(ring) && keep_wall(v, ring)) {
            return;
        }
        refine(v, ring, spokes);
    }

    // --- the interface along the domain boundary ----------------------------------------------
    bool wants_wall_upkeep(const Ring<Real>& ring) const {
        return !ring.closed &&
               (should_collapse_on_wall(ring, wall_) ||
                (ring.phase[0] != exterior_phase && should_split_wall(ring, wall_)));
    }

    // True if the ring is stale, and what is to be kept in the list was put there.
    bool keep_wall(std::uint32_t v, const Ring<Real>& ring) {
        if (should_collapse_on_wall(ring, wall_) && collapse_on_wall(work_, ring, wall_)) {
            ++work_.counts.interface_collapses;
            return true;
        }
        if (ring.phase[0] == exterior_phase || !should_split_wall(ring, wall_)) {
            return false;
        }
        const SplitResult result = split_wall(work_, ring);
        if (result.verdict == Verdict::out_of_ids ||
            result.verdict == Verdict::on_submesh_boundary) {
            work_.put_off_interface.push_back(v);
        }
        if (result.verdict != Verdict::legal) {
            return false;
        }
        ++work_.counts.interface_splits;
        work_.interface_next.push_back(v);
        work_.interface_next.push_back(result.vertex.id);
        return true;
    }

    bool should_collapse(const Ring<Real>& ring, const Spokes& spokes) const {
        if (spokes.count != 2 || !ring.closed) {
            return false;
        }
        const Point<Real> p(ring.x0, ring.y0);
        const Point<Real> a = link_point(ring, spokes.first);
        const Point<Real> b = link_point(ring, spokes.second);
        if (std::min((a - p).squaredNorm(), (b - p).squaredNorm()) >= shortest_squared_) {
            return false;
        }
        const Point<Real> chord = b - a;
        const Real chord_squared = chord.squaredNorm();
        const Point<Real> offset = p - a;
        const Real area = chord.x() * offset.y() - chord.y() * offset.x();
        return chord_squared < longest_squared_ &&
               area * area < deviation_squared_ * chord_squared &&
               is_smooth(a, p, b, corner_cosine_);
    }

    // The interface edge that is to be split: too long, and leaving the centre with the larger
    // phase on its left, so that each edge is seen from one of its ends only. no_id: there is none.
    std::uint32_t long_spoke(const Ring<Real>& ring) const {
        for (std::uint32_t i = 0; i < ring.link_size(); ++i) {
            const Phase before = ring.phase_before(i);
            const Phase after = ring.phase_after(i);
            if (before != border_phase && after != border_phase && after > before &&
                (link_point(ring, i) - Point<Real>(ring.x0, ring.y0)).squaredNorm() >
                    longest_squared_) {
                return i;
            }
        }
        return no_id;
    }

    bool try_collapse(Ring<Real>& ring, const Spokes& spokes) {
        const Point<Real> p(ring.x0, ring.y0);
        const Real to_a = (link_point(ring, spokes.first) - p).squaredNorm();
        const Real to_b = (link_point(ring, spokes.second) - p).squaredNorm();
        const std::uint32_t nearer = to_a < to_b ? spokes.first : spokes.second;
        const std::uint32_t farther = to_a < to_b ? spokes.second : spokes.first;
        for (const std::uint32_t i : {nearer, farther}) {
            if (edge_collapse(complex_, work_.submesh, prev(ring.corner[i]),
                              rewire::Vanishing::next) == Verdict::legal) {
                ++work_.counts.interface_collapses;
                for (std::uint32_t j = 0; j < ring.size; ++j) {
                    work_.activate(ring.link[j]);
                }
                return true;
            }
        }
        return false;
    }

    // Splits one edge at most: then the ring is stale; a junction's other edges wait for the next
    // step.
    void refine(std::uint32_t v, Ring<Real>& ring, const Spokes& spokes) {
        newest_ = no_id;
        if (const std::uint32_t i = long_spoke(ring); i != no_id && !split(v, ring, spokes, i)) {
            work_.put_off_interface.push_back(v);
        }
        work_.interface_next.push_back(v);
        if (newest_ != no_id) {
            work_.interface_next.push_back(newest_);
        }
    }

    bool split(std::uint32_t v, const Ring<Real>& ring, const Spokes& spokes, std::uint32_t i) {
        CurveNeighbours<Real> curve;
        curve.p1 = {ring.x0, ring.y0};
        curve.p2 = link_point(ring, i);
        if (spokes.count == 2 && ring.closed) {
            curve.p0 = link_point(ring, spokes.first == i ? spokes.second : spokes.first);
            curve.has_first = is_smooth<Real>(curve.p0, curve.p1, curve.p2, corner_cosine_);
        }
        Ring<Real>& beyond = work_.other_ring;
        const bool gathered = gather(complex_, work_.submesh.region, ring.link[i], beyond);
        if (!beyond.owned) {
            return false;
        }
        if (gathered) {
            const Spokes next_spokes = interface_spokes(beyond);
            if (next_spokes.count == 2 && beyond.closed) {
                const bool first_is_v = beyond.link[next_spokes.first] == v;
                curve.p3 = link_point(beyond, first_is_v ? next_spokes.second : next_spokes.first);
                curve.has_last = is_smooth<Real>(curve.p1, curve.p2, curve.p3, corner_cosine_);
            }
        }
        const auto& options = work_.options;
        Point<Real> point = options.insertion_function ? options.insertion_function(curve)
                                                       : insertion_point(options.insertion, curve);
        if (!owns_point(point)) {
            point = midpoint<Real>(curve.p1, curve.p2);
            if (!owns_point(point)) {
                return false;
            }
        }
        SplitResult result = edge_split(complex_, work_.submesh, prev(ring.corner[i]), point);
        if (result.verdict == Verdict::inverts) {
            point = midpoint<Real>(curve.p1, curve.p2);
            result = edge_split(complex_, work_.submesh, prev(ring.corner[i]), point);
        }
        if (result.verdict == Verdict::out_of_ids) {
            return false;
        }
        if (result.verdict != Verdict::legal) {
            return true;
        }
        newest_ = result.vertex.id;
        ++work_.counts.interface_splits;
        work_.activate(newest_);
        work_.activate(v);
        work_.activate(ring.link[i]);
        work_.activate(ring.link[i + 1]);
        work_.activate(ring.link[i == 0 ? ring.size - 1 : i - 1]);
        return true;
    }

    // What is made must lie where its maker works: the next colour looks for it there.
    bool owns_point(const Point<Real>& point) const {
        return owns_place(work_.submesh.region, point);
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    Real length_;
    Real longest_squared_;
    Real shortest_squared_;
    Real deviation_squared_;
    Real corner_cosine_;
    WallLimits<Real> wall_;
    std::uint32_t newest_ = no_id;
};

} // namespace

template <class Real>
void upkeep_interface(Work<Real>& work) {
    Upkeep<Real>(work).run();
}

template <class Real>
std::vector<std::uint32_t> collect_interface(const Complex<Real>& complex, std::uint64_t seed) {
    // next[v]: where the interface half-edge with the larger phase on its left leads from v.
    std::vector<std::uint32_t> list;
    std::vector<std::uint8_t> seen(complex.vertex_bound(), 0);
    const auto follow = [&](Corner c) {
        // c is opposite to the half-edge from next(c) to prev(c); go on around the larger phase.
        while (true) {
            const std::uint32_t v = complex.vertex(next(c));
            if (seen[v] != 0) {
                return;
            }
            seen[v] = 1;
            list.push_back(v);
            // The next interface edge about w = vertex(prev(c)), clockwise inside this phase.
            Corner at = prev(c);
            const Phase inside = complex.phase_at(c);
            while (true) {
                // Half-edge that leaves w in this triangle is opposite to prev(at).
                const Corner candidate = prev(at);
                const Corner across = complex.twin(candidate);
                if (complex.phase_at(across) != inside) {
                    c = candidate;
                    break;
                }
                at = prev(across);
            }
        }
    };
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        if (!complex.is_alive(Triangle{t})) {
            continue;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            const Phase inside = complex.phase_at(c);
            const Phase across = complex.phase_at(complex.twin(c));
            const bool canonical =
                across == border_phase ? inside != exterior_phase : inside > across;
            if (canonical) {
                follow(c);
                const std::uint32_t w = complex.vertex(prev(c));
                if (seen[w] == 0) {
                    seen[w] = 1;
                    list.push_back(w);
                }
            }
        }
    }
    if (seed != 0) {
        // Fisher and Yates, spelt out: std::shuffle differs between standard libraries.
        std::mt19937_64 random(seed);
        for (std::size_t i = list.size(); i > 1; --i) {
            std::swap(list[i - 1], list[random() % i]);
        }
    }
    return list;
}

template <class Real>
void order_interface(Complex<Real>& complex, std::vector<std::uint32_t>& list,
                     std::uint32_t epoch) {
    const std::uint32_t listed = epoch;
    const std::uint32_t placed = epoch + 1;
    for (const std::uint32_t v : list) {
        complex.vertices[v].stamp = listed;
    }
    std::vector<std::uint32_t> ordered;
    ordered.reserve(list.size());
    Ring<Real> ring;
    for (const std::uint32_t start : list) {
        std::uint32_t v = start;
        while (v != no_id && complex.vertices[v].stamp == listed) {
            complex.vertices[v].stamp = placed;
            ordered.push_back(v);
            std::uint32_t following = no_id;
            if (gather(complex, Region{}, v, ring)) {
                for (std::uint32_t i = 0; i < ring.link_size() && following == no_id; ++i) {
                    if (ring.is_constrained(i) && complex.vertices[ring.link[i]].stamp == listed) {
                        following = ring.link[i];
                    }
                }
            }
            v = following;
        }
    }
    list.swap(ordered);
}

template void order_interface(Complex<double>&, std::vector<std::uint32_t>&, std::uint32_t);
template void order_interface(Complex<float>&, std::vector<std::uint32_t>&, std::uint32_t);
template void upkeep_interface(Work<double>&);
template void upkeep_interface(Work<float>&);
template std::vector<std::uint32_t> collect_interface(const Complex<double>&, std::uint64_t);
template std::vector<std::uint32_t> collect_interface(const Complex<float>&, std::uint64_t);

} // namespace dsc

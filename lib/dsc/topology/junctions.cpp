// SPDX-License-Identifier: MIT
#include "dsc/topology/junctions.h"

#include "dsc/base/require.h"
#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace dsc {

namespace {

/// Two junctions closer than this times the edge length may exchange their neighbours.
constexpr double exchange_length = 0.15;
/// Length of the edge that opens between two junctions, in edge lengths; more than the above.
constexpr double opened_length = 0.25;
/// Differences of energy below this are a tie.
constexpr double tie = 1e-9;

/// The triangles of one phase about a vertex, between two interface edges.
template <class Real>
struct Sector {
    Phase phase;
    Corner first;      ///< at the vertex, in its first triangle
    std::size_t count; ///< of its triangles, counter-clockwise
    Point<Real> ray;   ///< unit direction of the interface edge that it begins with
    double angle = 0;
};

template <class Real>
class Junctions {
public:
    explicit Junctions(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(whole_submesh(work.complex)) {}

    void run(std::span<const Suspect<Real>> suspects) {
        for (const Vertex v : in_order(suspects)) {
            if (complex_.is_alive(v) && find_sectors(v, sectors_)) {
                if (sectors_.size() == 3) {
                    exchange(v);
                } else {
                    take_apart(v);
                }
            }
        }
    }

private:
    // --- what is there ------------------------------------------------------------------------
    std::vector<Vertex> in_order(std::span<const Suspect<Real>> suspects) const {
        std::vector<std::tuple<Real, Real, std::uint32_t>> found;
        for (const auto& suspect : suspects) {
            const Vertex v{suspect.vertex};
            if (suspect.is_sharp && complex_.is_alive(v)) {
                found.emplace_back(complex_.position(v).x(), complex_.position(v).y(), v.id);
            }
        }
        std::ranges::sort(found);
        std::vector<Vertex> list;
        for (const auto& one : found) {
            list.push_back(Vertex{std::get<2>(one)});
        }
        return list;
    }

    // False at the domain boundary, and where fewer than three sectors meet.
    bool find_sectors(Vertex v, std::vector<Sector<Real>>& sectors) const {
        sectors.clear();
        const Corner start = find_corner(complex_, v, [&](Corner c) {
            const Corner across = complex_.twin(prev(c));
            return is_border(across) || complex_.phase_at(across) != complex_.phase_at(c);
        });
        if (start == no_id) {
            return false;
        }
        Corner c = start;
        do {
            const Phase phase = complex_.phase_at(c);
            if (sectors.empty() || sectors.back().phase != phase) {
                sectors.push_back({phase, c, 0, ray(v, complex_.vertex(next(c))), 0});
            }
            ++sectors.back().count;
            c = corner_ccw(complex_, c);
            if (is_border(c)) {
                return false;
            }
        } while (c != start);
        if (sectors.size() < 3) {
            return false;
        }
        for (std::size_t i = 0; i < sectors.size(); ++i) {
            sectors[i].angle = angle(sectors[i].ray, sectors[(i + 1) % sectors.size()].ray);
        }
        return true;
    }

    Point<Real> ray(Vertex from, std::uint32_t to) const {
        return (complex_.position(Vertex{to}) - complex_.position(from)).normalized();
    }

    // Counter-clockwise from one direction to another, 0 to 2 pi.
    static double angle(const Point<Real>& from, const Point<Real>& to) {
        const double turn = std::atan2(static_cast<double>(from.x() * to.y() - from.y() * to.x()),
                                       static_cast<double>(from.dot(to)));
        return turn > 0 ? turn : turn + 2 * std::numbers::pi;
    }

    [[nodiscard]] bool may(Phase one, Phase other) const {
        return one == other ||
               rule_of(work_.options, work_.edge_length, one, other).rule == Topology::change;
    }
    [[nodiscard]] double energy(Phase one, Phase other) const {
        if (one == other) {
            return 0;
        }
        const double its = work_.options.energy ? work_.options.energy(one, other) : 1.0;
        require(std::isfinite(its) && its >= 0, "topology.energy", its,
                "0 or more, per length of interface");
        return its;
    }

    // How the energy changes with the way of a junction that moves into a sector, along its middle,
    // away from the neighbours `before` and `after`, which touch from then on.
    [[nodiscard]] double gain(Phase before, Phase sector, Phase after, double its_angle) const {
        return energy(before, after) -
               (energy(before, sector) + energy(sector, after)) * std::cos(its_angle / 2);
    }

    // --- exchange -----------------------------------------------------------------------------
    void exchange(Vertex v) {
        const Real shortest = static_cast<Real>(exchange_length) * work_.edge_length;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner at = sectors_[i].first; // the spoke of its ray is opposite prev
            const Corner edge = prev(at);
            const Vertex w{complex_.vertex(next(at))};
            if ((complex_.position(w) - complex_.position(v)).norm() >= shortest ||
                !find_sectors(w, others_) || others_.size() != 3) {
                continue;
            }
            if (wants_exchange(i) && merge(v, edge) && find_sectors(w, sectors_)) {
                take_apart(w);
                return;
            }
        }
    }

    // Sector i lies to the left of the edge from v to w, sector i - 1 to its right, the third one
    // beyond v; at w the two swap sides. Beyond w lies the one that is neither.
    bool wants_exchange(std::size_t i) const {
        const Sector<Real>& left = sectors_[i];
        const Sector<Real>& right = sectors_[(i + 2) % 3];
        const Sector<Real>& near = sectors_[(i + 1) % 3];
        const auto at = std::ranges::find(others_, right.phase, &Sector<Real>::phase);
        if (at == others_.end()) {
            return false;
        }
        const auto k = static_cast<std::size_t>(at - others_.begin());
        const Sector<Real>& far = others_[(k + 1) % 3];
        if (others_[(k + 2) % 3].phase != left.phase || !may(left.phase, near.phase) ||
            !may(right.phase, near.phase) || !may(left.phase, far.phase) ||
            !may(right.phase, far.phase)) {
            return false;
        }
        // Rays at v: the one between left and near, and the one between near and right; at w the
        // one between right and far, and the one between far and left.
        const double left_angle = angle(others_[(k + 2) % 3].ray, near.ray);
        const double right_angle = angle(right.ray, far.ray);
        const double as_it_is = gain(left.phase, near.phase, right.phase, near.angle) +
                                gain(right.phase, far.phase, left.phase, far.angle);
        const double exchanged = gain(far.phase, left.phase, near.phase, left_angle) +
                                 gain(near.phase, right.phase, far.phase, right_angle);
        return exchanged < as_it_is - tie;
    }

    // v vanishes into the other end.
    bool merge(Vertex v, Corner edge) {
        const auto end =
            complex_.vertex(next(edge)) == v.id ? rewire::Vanishing::next : rewire::Vanishing::prev;
        if (edge_collapse_guard(complex_, submesh_.region, edge, end, JunctionRule::may_merge) !=
            Verdict::legal) {
            return false;
        }
        rewire::collapse(complex_, *submesh_.log, edge, end, *submesh_.pool);
        return true;
    }

    // --- coming apart -------------------------------------------------------------------------
    void take_apart(Vertex v) {
        const Point<Real> place = complex_.position(v);
        // Each round takes one sector away.
        for (std::size_t round = sectors_.size(); round > 3; --round) {
            const std::size_t k = sector_to_leave();
            if (k == sectors_.size()) {
                return;
            }
            Event event{.kind = EventKind::exchange,
                        .time = work_.time,
                        .x = static_cast<double>(place.x()),
                        .y = static_cast<double>(place.y()),
                        .lost = sectors_[k].phase,
                        .taken = {sector(k, -1).phase, sector(k, 1).phase}};
            if (!leave(v, k, event.area)) {
                return;
            }
            work_.events.push_back(event);
            if (!find_sectors(v, sectors_)) {
                return;
            }
        }
    }

    const Sector<Real>& sector(std::size_t k, int offset) const {
        const auto n = static_cast<std::ptrdiff_t>(sectors_.size());
        return sectors_[static_cast<std::size_t>((static_cast<std::ptrdiff_t>(k) + offset + n) %
                                                 n)];
    }

    [[nodiscard]] double gain_of(std::size_t k) const {
        const Phase before = sector(k, -1).phase;
        const Phase phase = sectors_[k].phase;
        const Phase after = sector(k, 1).phase;
        if (!may(before, phase) || !may(phase, after)) {
            return std::numeric_limits<double>::infinity();
        }
        return gain(before, phase, after, sectors_[k].angle);
    }

    // The sector from which the junction moves away. Of four, opposite ones go together. Ties go to
    // the smaller phase, and then to the ray that points farthest to the left.
    std::size_t sector_to_leave() const {
        const auto better = [&](std::size_t one, std::size_t other, double a, double b) {
            if (std::abs(a - b) > tie) {
                return a < b;
            }
            const auto key = [&](std::size_t k) {
                return std::tuple(sectors_[k].phase, sectors_[k].ray.x(), sectors_[k].ray.y());
            };
            return key(one) < key(other);
        };
        const bool pairs = sectors_.size() == 4;
        const auto total = [&](std::size_t k) {
            return pairs ? gain_of(k) + gain_of((k + 2) % 4) : gain_of(k);
        };
        std::size_t best = 0;
        for (std::size_t k = 1; k < sectors_.size(); ++k) {
            if (pairs && k == (best + 2) % 4) {
                best = better(k, best, gain_of(k), gain_of(best)) ? k : best;
            } else {
                best = better(k, best, total(k), total(best)) ? k : best;
            }
        }
        return std::isfinite(total(best)) ? best : sectors_.size();
    }

    // Opens an edge from v into sector k: a new junction there, and a triangle on either side of
    // the edge for the neighbours.
    bool leave(Vertex v, std::size_t k, double& area) {
        const Phase before = sector(k, -1).phase;
        const Phase after = sector(k, 1).phase;
        const Phase phase = sectors_[k].phase;
        const std::uint32_t begin = complex_.vertex(next(sectors_[k].first));
        Corner first = no_id;
        if (!make_two_triangles(v, sectors_[k], first)) {
            return false;
        }
        // The spoke between the two is opposite to the corner after v in the first of them.
        const Corner spoke = next(first);
        const Point<Real> place = complex_.position(v);
        const Point<Real> way = complex_.position(Vertex{complex_.vertex(prev(first))}) - place;
        const Real length =
            std::min(static_cast<Real>(opened_length) * work_.edge_length, way.norm() / 2);
        const Point<Real> point = place + way.normalized() * length;
        if (edge_split(complex_, submesh_, spoke, point).verdict != Verdict::legal) {
            return false;
        }
        // v, the first ray's end and the new vertex; v, the new vertex and the second ray's end.
        const Corner at_first = corner_to(v, begin, phase);
        const Corner at_second = corner_ccw(complex_, at_first);
        for (const auto& [corner, taker] :
             {std::pair{at_first, before}, std::pair{at_second, after}}) {
            const Triangle t{triangle_of(corner)};
            area += static_cast<double>(doubled_area(complex_, t)) / 2;
            give(work_, t, taker);
        }
        return true;
    }

    // Flips spokes away, or splits the far edge of a single triangle, until the sector consists of
    // two triangles. `first`: the corner at v of the first.
    bool make_two_triangles(Vertex v, const Sector<Real>& sector, Corner& first) {
        const Phase phase = sector.phase;
        const std::uint32_t begin = complex_.vertex(next(sector.first));
        std::size_t count = sector.count;
        first = sector.first;
        if (count == 1) {
            const Point<Real> middle = (complex_.position(Vertex{complex_.vertex(next(first))}) +
                                        complex_.position(Vertex{complex_.vertex(prev(first))})) /
                                       Real(2);
            if (edge_split(complex_, submesh_, first, middle).verdict != Verdict::legal) {
                return false;
            }
            count = 2;
        }
        while (count > 2) {
            Corner c = corner_to(v, begin, phase);
            bool flipped = false;
            for (std::size_t i = 0; i + 1 < count && !flipped; ++i) {
                const Corner following = corner_ccw(complex_, c);
                flipped = edge_flip(complex_, submesh_, next(c)) == Verdict::legal;
                c = following;
            }
            if (!flipped) {
                return false;
            }
            --count;
        }
        first = corner_to(v, begin, phase);
        return first != no_id;
    }

    // The corner at v of the triangle that begins with the spoke to `end`.
    Corner corner_to(Vertex v, std::uint32_t end, Phase phase) const {
        return find_corner(complex_, v, [&](Corner c) {
            return complex_.vertex(next(c)) == end && complex_.phase_at(c) == phase;
        });
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh submesh_;
    std::vector<Sector<Real>> sectors_;
    std::vector<Sector<Real>> others_;
};

} // namespace

template <class Real>
void change_junctions(TopologyWork<Real>& work, std::span<const Suspect<Real>> suspects) {
    Junctions<Real>(work).run(suspects);
}

template void change_junctions(TopologyWork<double>&, std::span<const Suspect<double>>);
template void change_junctions(TopologyWork<float>&, std::span<const Suspect<float>>);

} // namespace dsc

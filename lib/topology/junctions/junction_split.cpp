// SPDX-License-Identifier: MIT
#include "topology/junctions/junction_split.h"

#include "topology/junctions/merging.h"
#include "topology/junctions/opening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace dsc {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
/// A curve lies along a side of the domain if the angle between them is below this, in radians: 20
/// degrees.
constexpr double along_boundary = 0.349;

template <class Real>
class JunctionSplit {
public:
    JunctionSplit(TopologyWork<Real>& work, Vertex v)
        : work_(work), complex_(work.complex), v_(v),
          length_(static_cast<Real>(opened_length) * work.edge_length) {}

    void run() {
        find_sectors(complex_, v_, sectors_);
        // Each round removes one sector.
        for (std::size_t left = sectors_.size();
             left > 0 && sectors_.size() > sectors_.stable() && leave_one(); --left) {
            find_sectors(complex_, v_, sectors_);
        }
    }

    void leave_film(Phase film) {
        find_sectors(complex_, v_, sectors_);
        const auto at = std::ranges::find(sectors_.list, film, &Sector<Real>::phase);
        if (sectors_.size() == 4 && !sectors_.is_on_boundary && at != sectors_.list.end()) {
            (void)leave(static_cast<std::size_t>(at - sectors_.list.begin()));
        }
    }

    // Moves the end of a curve from the corner along the domain boundary, beside sector k.
    void pass_corner(Phase lost) {
        if (is_single_in_corner()) {
            const std::size_t k = sectors_[0].phase == lost ? 0 : 1;
            if (sectors_[k].phase == lost && gain_of(k) < -energy_tie) {
                (void)leave(k);
            }
        }
    }
    void leave_along_boundary() {
        if (is_single_in_corner()) {
            const std::size_t k = sectors_[0].angle <= sectors_[1].angle ? 0 : 1;
            if (sectors_[k].angle < along_boundary && gain_of(k) < -energy_tie) {
                (void)leave(k);
            }
        }
    }

private:
    [[nodiscard]] bool is_single_in_corner() const {
        return sectors_.is_at_corner && sectors_.size() == 2;
    }

    // Removes the sector whose loss lowers the energy the most; if there is no room in it, the next
    // one.
    bool leave_one() {
        const std::size_t n = sectors_.size();
        gains_.resize(n);
        for (std::size_t k = 0; k < n; ++k) {
            gains_[k] = gain_of(k);
        }
        for (std::size_t trial = 0; trial < n; ++trial) {
            const std::size_t k = best();
            if (!(total(k) < never)) {
                return false;
            }
            const std::uint32_t size = complex_.triangle_count();
            if (leave(k)) {
                return true;
            }
            if (complex_.triangle_count() != size) {
                find_sectors_again(complex_, v_, sectors_);
            }
            gains_[k] = never;
        }
        return false;
    }

    [[nodiscard]] double gain_of(std::size_t k) const {
        const Phase phase = sectors_[k].phase;
        if (sectors_.is_beside_boundary(k)) {
            const Phase other = (k == 0 ? sectors_.after(k) : sectors_.before(k)).phase;
            return may_change(work_, phase, other)
                       ? energy_along_boundary(work_, phase, other, sectors_[k].angle)
                       : never;
        }
        const Phase before = sectors_.before(k).phase;
        const Phase after = sectors_.after(k).phase;
        if (before == after && before != phase && is_displaced(work_, before)) {
            return never; // fronts that have met do not part
        }
        return may_change(work_, before, phase) && may_change(work_, phase, after)
                   ? energy_inwards(work_, before, phase, after, sectors_[k].angle)
                   : never;
    }

    // Opposite sectors of four leave the vertex together. So do the two sectors beside the domain
    // boundary if there are three, because they are four with their mirror images.
    [[nodiscard]] std::size_t partner(std::size_t k) const {
        const std::size_t n = sectors_.size();
        if (sectors_.is_on_boundary) {
            return n == 3 ? n - 1 - k : k;
        }
        return n == 4 ? (k + 2) % 4 : k;
    }
    [[nodiscard]] double total(std::size_t k) const {
        const std::size_t other = partner(k);
        return other == k || !std::isfinite(gains_[other]) ? gains_[k] : gains_[k] + gains_[other];
    }
    [[nodiscard]] std::size_t best() const {
        std::size_t found = 0;
        for (std::size_t k = 1; k < sectors_.size(); ++k) {
            const bool is_pair = k != found && k == partner(found);
            if (is_pair ? is_better(k, gains_[k], found, gains_[found])
                        : is_better(k, total(k), found, total(found))) {
                found = k;
            }
        }
        return found;
    }
    [[nodiscard]] bool is_better(std::size_t k, double gain, std::size_t other,
                                 double its_gain) const {
        if (!std::isfinite(gain) || !std::isfinite(its_gain)) {
            return gain < its_gain;
        }
        if (std::abs(gain - its_gain) > energy_tie) {
            return gain < its_gain;
        }
        const auto key = [&](const Sector<Real>& sector) {
            return std::tuple(sector.phase, sector.ray.x(), sector.ray.y());
        };
        return key(sectors_[k]) < key(sectors_[other]);
    }

    // Removes vertices inside sector k that would keep the two junctions close together.
    void make_room(std::size_t k) {
        constexpr double poor_squared = 0.02; // squared quality that a removal may leave
        std::vector<Vertex> close;
        Corner c = sectors_[k].first;
        for (std::size_t i = 1; i < sectors_[k].count; ++i) {
            const Vertex w{complex_.vertex(prev(c))};
            if (distance<Real>(complex_.position(v_), complex_.position(w)) < 2 * length_) {
                close.push_back(w);
            }
            c = corner_ccw(complex_, c);
        }
        bool has_edited = false;
        for (const Vertex w : close) {
            has_edited = remove_inside(work_, w, static_cast<Real>(poor_squared)) || has_edited;
        }
        if (has_edited) {
            find_sectors_again(complex_, v_, sectors_);
        }
    }

    bool leave(std::size_t k) {
        make_room(k);
        const Point<Real> place = complex_.position(v_);
        Event event{.kind = EventKind::t1,
                    .time = work_.time,
                    .x = static_cast<double>(place.x()),
                    .y = static_cast<double>(place.y()),
                    .lost = sectors_[k].phase};
        const Sector<Real> sector = sectors_[k];
        if (sectors_.is_beside_boundary(k)) {
            const Phase taker = (k == 0 ? sectors_.after(k) : sectors_.before(k)).phase;
            const Corner only = open_on_boundary(complex_, v_, sector, k == 0, length_);
            if (only == no_id) {
                return false;
            }
            event.taken = {taker, taker};
            event.area = hand_over(only, taker);
        } else {
            event.taken = {sectors_.before(k).phase, sectors_.after(k).phase};
            const Corner first = open_inside(complex_, v_, sector, length_);
            if (first == no_id) {
                return false;
            }
            const Corner second = corner_ccw(complex_, first);
            event.area = hand_over(first, event.taken[0]) + hand_over(second, event.taken[1]);
        }
        event.area += std::exchange(work_.swept, 0);
        work_.events.push_back(event);
        return true;
    }

    double hand_over(Corner c, Phase taker) {
        const Triangle t{triangle_of(c)};
        give(work_, t, taker);
        return static_cast<double>(doubled_area(complex_, t)) / 2;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Vertex v_;
    Real length_;
    Sectors<Real> sectors_;
    std::vector<double> gains_; ///< change of energy per length that the junction moves
};

} // namespace

template <class Real>
void split_junction(TopologyWork<Real>& work, Vertex v) {
    JunctionSplit<Real> vertex(work, v);
    vertex.run();
    vertex.leave_along_boundary();
}

template <class Real>
void leave_film(TopologyWork<Real>& work, Vertex v, Phase film) {
    JunctionSplit<Real>(work, v).leave_film(film);
}

template <class Real>
void pass_corner(TopologyWork<Real>& work, Vertex corner, Phase lost) {
    JunctionSplit<Real> vertex(work, corner);
    vertex.run();
    vertex.pass_corner(lost);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void split_junction(TopologyWork<Real>&, Vertex);                                     \
    template void leave_film(TopologyWork<Real>&, Vertex, Phase);                                  \
    template void pass_corner(TopologyWork<Real>&, Vertex, Phase);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

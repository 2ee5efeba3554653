// SPDX-License-Identifier: MIT
#include "dsc/topology/films/remnants.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dsc {

namespace {

/// A piece with a longer outline is larger than the least area, unless its edges are very short.
constexpr int longest_outline = 24;

template <class Real>
class Remnants {
public:
    explicit Remnants(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), least_area_(least_area(work)) {}

    void run(std::span<const Suspect<Real>> suspects) {
        for (const Corner c : outlines_at(suspects)) {
            if (is_outline(complex_, c)) { // it may have vanished since
                visit(c);
            }
        }
    }

private:
    // The half-edges of outlines that leave the vertices, in the order of their places.
    std::vector<Corner> outlines_at(std::span<const Suspect<Real>> suspects) const {
        std::vector<std::tuple<Real, Real, Corner>> found;
        for (const auto& suspect : suspects) {
            const std::uint32_t v = suspect.vertex;
            if (!suspect.is_sharp || !complex_.is_alive(Vertex{v})) {
                continue;
            }
            (void)find_corner(complex_, Vertex{v}, [&](Corner at) {
                const Corner c = prev(at); // the half-edge that starts at v
                if (is_sheet(complex_, c) && may_be_small(at)) {
                    const Point<Real> place = centroid(complex_, Triangle{triangle_of(c)});
                    found.emplace_back(place.x(), place.y(), c);
                }
                return false; // all of them, in any order
            });
        }
        std::ranges::sort(found);
        std::vector<Corner> list;
        for (const auto& one : found) {
            list.push_back(std::get<2>(one));
        }
        return list;
    }

    // Whether the triangles of the phase around this one have less than the least area together. A
    // handful rules out nearly every piece, long before its outline has been walked.
    bool may_be_small(Corner at) const {
        constexpr std::size_t handful = 16;
        const Phase phase = complex_.phase_at(at);
        std::array<std::uint32_t, handful> seen{};
        std::size_t size = 0;
        Real doubled = 0;
        const auto add = [&](std::uint32_t t) {
            seen[size++] = t;
            doubled += doubled_area(complex_, Triangle{t});
        };
        add(triangle_of(at));
        for (std::size_t i = 0; i < size; ++i) {
            for (const Corner across : complex_.triangles[seen[i]].n) {
                const std::uint32_t t = triangle_of(across);
                const auto end = seen.begin() + static_cast<std::ptrdiff_t>(size);
                if (size < handful && complex_.triangles[t].phase == phase &&
                    std::find(seen.begin(), end, t) == end) {
                    add(t);
                }
            }
            if (doubled / 2 >= least_area_) {
                return false;
            }
        }
        return true;
    }

    void visit(Corner start) {
        outline_.clear();
        Real doubled = 0;
        const Point<Real> origin = complex_.position(Vertex{complex_.vertex(next(start))});
        Corner c = start;
        do {
            if (outline_.size() == longest_outline) {
                return;
            }
            outline_.push_back(c);
            const Point<Real> from = complex_.position(Vertex{complex_.vertex(next(c))}) - origin;
            const Point<Real> way = direction(complex_, c);
            doubled += cross<Real>(from, way);
            c = along_outline(complex_, c);
        } while (c != start);
        // The outline of a hole runs clockwise: what it surrounds is another phase.
        if (!(doubled > 0) || doubled / 2 >= least_area_) {
            return;
        }
        const Phase phase = complex_.phase_at(start);
        const Phase to = heir();
        // More edges than the outline has: another phase lies within.
        if (to == phase ||
            gather_piece(complex_, Triangle{triangle_of(start)}, piece_) != outline_.size() ||
            piece_.size() > most_of_piece) {
            return;
        }
        Event event{.kind = phase == exterior_phase ? EventKind::fill : EventKind::remove,
                    .time = work_.time,
                    .lost = phase,
                    .taken = {to, to}};
        for (const Triangle t : piece_) {
            const auto area = static_cast<double>(doubled_area(complex_, t)) / 2;
            const Point<Real> place = centroid(complex_, t);
            event.area += area;
            event.x += area * static_cast<double>(place.x());
            event.y += area * static_cast<double>(place.y());
            give(work_, t, to);
        }
        event.x /= event.area;
        event.y /= event.area;
        work_.events.push_back(event);
    }

    // The phase with the longest share of the outline; the smaller one of two equal ones. The
    // piece's own phase if there is none that it may vanish into.
    Phase heir() const {
        std::vector<std::pair<Phase, Real>> lengths;
        const Phase phase = complex_.phase_at(outline_.front());
        for (const Corner c : outline_) {
            const Corner across = complex_.twin(c);
            const Phase other = complex_.phase_at(across);
            if (is_border(across) ||
                rule_of(work_.options, work_.edge_length, phase, other).rule != Topology::change) {
                continue;
            }
            const auto at = std::ranges::find(lengths, other, &std::pair<Phase, Real>::first);
            auto& entry = at != lengths.end() ? *at : lengths.emplace_back(other, Real(0));
            entry.second += direction(complex_, c).norm();
        }
        Phase longest = phase;
        Real length = -1;
        std::ranges::sort(lengths);
        for (const auto& [other, its] : lengths) {
            if (its > length) {
                longest = other;
                length = its;
            }
        }
        return longest;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Real least_area_;
    std::vector<Corner> outline_;
    std::vector<Triangle> piece_;
};

} // namespace

template <class Real>
void remove_remnants(TopologyWork<Real>& work, std::span<const Suspect<Real>> suspects) {
    Remnants<Real>(work).run(suspects);
}

template void remove_remnants(TopologyWork<double>&, std::span<const Suspect<double>>);
template void remove_remnants(TopologyWork<float>&, std::span<const Suspect<float>>);

} // namespace dsc

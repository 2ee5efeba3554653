// SPDX-License-Identifier: MIT
#include "topology/junctions/sectors.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/side.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

// Whether the domain boundary turns at a vertex on it.
template <class Real>
bool turns(const Complex<Real>& complex, Vertex v) {
    std::uint32_t from = no_id;
    std::uint32_t to = no_id;
    for_each_corner(complex, v, [&](Corner c) {
        from = is_border(complex.twin(prev(c))) ? complex.vertex(next(c)) : from;
        to = complex.vertex(prev(c));
    });
    return orientation<Real>(complex.position(Vertex{from}), complex.position(v),
                             complex.position(Vertex{to})) != 0;
}

} // namespace

template <class Real>
void find_sectors(const Complex<Real>& complex, Vertex v, Sectors<Real>& sectors) {
    auto& list = sectors.list;
    list.clear();
    sectors.is_on_boundary = false;
    sectors.is_at_corner = false;
    if (complex.vertices[v.id].corner == no_id) {
        return; // of no triangle
    }
    const Point<Real> here = complex.position(v);
    const auto way = [&](std::uint32_t to) {
        return Point<Real>((complex.position(Vertex{to}) - here).normalized());
    };
    const Corner first = first_corner(complex, complex.vertices[v.id].corner);
    sectors.is_on_boundary = is_border(complex.twin(prev(first)));
    Corner start = first;
    if (!sectors.is_on_boundary) {
        start = find_corner(complex, v, [&](Corner c) { return is_outline(complex, prev(c)); });
        if (start == no_id) {
            return; // inside a phase
        }
    }
    const Corner last = circulate(complex, start, [&](Corner c) {
        const Phase phase = complex.phase_at(c);
        if (list.empty() || list.back().phase != phase) {
            list.push_back({phase, c, 0, way(complex.vertex(next(c))), 0});
        }
        ++list.back().count;
    });
    sectors.end = list.front().ray;
    if (sectors.is_on_boundary) {
        const std::uint32_t from = complex.vertex(next(first));
        const std::uint32_t to = complex.vertex(prev(last));
        sectors.end = way(to);
        sectors.is_at_corner = complex.is_boundary_feature(v) ||
                               side_at<Real>(complex.position(Vertex{from}), here,
                                             complex.position(Vertex{to}), false) == Side::feature;
    }
    for (std::size_t k = 0; k < list.size(); ++k) {
        list[k].angle =
            angle_between(list[k].ray, k + 1 < list.size() ? list[k + 1].ray : sectors.end);
    }
}

template <class Real>
void find_sectors_again(const Complex<Real>& complex, Vertex v, Sectors<Real>& sectors) {
    const Point<Real> ray = sectors[0].ray;
    find_sectors(complex, v, sectors);
    const auto start = std::ranges::find(sectors.list, ray, &Sector<Real>::ray);
    std::rotate(sectors.list.begin(), start, sectors.list.end());
}

template <class Real>
bool may_split(const Complex<Real>& complex, Vertex v, Real shortest) {
    const Point<Real> here = complex.position(v);
    const auto is_short = [&](std::uint32_t to) {
        return (complex.position(Vertex{to}) - here).squaredNorm() < shortest * shortest;
    };
    std::size_t curves = 0;
    bool is_on_boundary = false;
    bool has_short_curve = false;
    bool has_short_boundary = false;
    for_each_corner(complex, v, [&](Corner c) {
        const Corner before = complex.twin(prev(c));
        if (is_border(before)) {
            is_on_boundary = true;
            has_short_boundary = has_short_boundary || is_short(complex.vertex(next(c)));
        } else if (complex.phase_at(before) != complex.phase_at(c)) {
            ++curves;
            has_short_curve = has_short_curve || is_short(complex.vertex(next(c)));
        }
        if (is_border(complex.twin(next(c)))) {
            has_short_boundary = has_short_boundary || is_short(complex.vertex(prev(c)));
        }
    });
    if (is_on_boundary) {
        return curves > 1 || (curves == 1 && (has_short_boundary ||
                                              complex.is_boundary_feature(v) || turns(complex, v)));
    }
    return curves > 3 || (curves == 3 && has_short_curve);
}

template <class Real>
double angle_between(const Point<Real>& from, const Point<Real>& to) {
    const double turn =
        std::atan2(static_cast<double>(cross<Real>(from, to)), static_cast<double>(from.dot(to)));
    return turn > 0 ? turn : turn + 2 * std::numbers::pi;
}

template <class Real>
bool may_change(const TopologyWork<Real>& work, Phase one, Phase other) {
    return one == other ||
           rule_of(work.options, work.edge_length, one, other).rule == Topology::change;
}

template <class Real>
double energy_between(const TopologyWork<Real>& work, Phase one, Phase other) {
    if (one == other) {
        return 0;
    }
    const double its = work.options.energy ? work.options.energy(one, other) : 1.0;
    require(std::isfinite(its) && its >= 0, "topology.energy", its,
            "0 or more, per length of interface");
    return its;
}

template <class Real>
double energy_inwards(const TopologyWork<Real>& work, Phase before, Phase sector, Phase after,
                      double angle) {
    return energy_between(work, before, after) -
           (energy_between(work, before, sector) + energy_between(work, sector, after)) *
               std::cos(angle / 2);
}

template <class Real>
double energy_along_boundary(const TopologyWork<Real>& work, Phase sector, Phase neighbour,
                             double angle) {
    return -energy_between(work, sector, neighbour) * std::cos(angle);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void find_sectors(const Complex<Real>&, Vertex, Sectors<Real>&);                      \
    template void find_sectors_again(const Complex<Real>&, Vertex, Sectors<Real>&);                \
    template bool may_split(const Complex<Real>&, Vertex, Real);                                   \
    template double angle_between(const Point<Real>&, const Point<Real>&);                         \
    template bool may_change(const TopologyWork<Real>&, Phase, Phase);                             \
    template double energy_between(const TopologyWork<Real>&, Phase, Phase);                       \
    template double energy_inwards(const TopologyWork<Real>&, Phase, Phase, Phase, double);        \
    template double energy_along_boundary(const TopologyWork<Real>&, Phase, Phase, double);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "topology/fronts/squeezed.h"

#include "topology/fronts/front_curve.h"
#include "topology/fronts/front_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dsc {

namespace {

/// Below this determinant of the three fronts, with speeds of at most 1, the place where they meet
/// is uncertain.
constexpr double min_determinant = 0.05;
/// The three fronts meet no farther than this from the middle of the squeezed one, in edge lengths.
constexpr double max_way_of_ends = 1.5;
/// A front that has been squeezed out for so many sub-steps still vanishes. Of an older one the
/// fronts beside it say nothing.
constexpr double longest_overdue = 2;

// The front of the half-edge `edge`, with the film on its left, between v and q, if it vanishes
// within the coming sub-step: the place p and the time t with n.(p - x) = s t for the normal n, the
// speed s and a point x of it and of the fronts before and after it.
template <class Real>
std::optional<Sight<Real>> end_of_squeezed(const TopologyWork<Real>& work, std::uint32_t v,
                                           std::uint32_t q, Corner edge) {
    const Complex<Real>& complex = work.complex;
    const Phase film = complex.phase_at(edge);
    const Corner before = previous_along(complex, edge, [&](Corner other) {
        return complex.phase_at(other) == film && is_outline(complex, other);
    });
    const std::array edges{before, edge, along_outline(complex, edge)};
    const std::array phases{phase_beyond(complex, edges[0]), phase_beyond(complex, edges[1]),
                            phase_beyond(complex, edges[2])};
    if (phases[0] == phases[1] || phases[1] == phases[2] || phases[0] == phases[2]) {
        return {};
    }
    const Point<Real> middle =
        midpoint<Real>(complex.position(Vertex{v}), complex.position(Vertex{q}));
    std::array<Eigen::Vector3d, 3> rows;
    std::array<double, 3> right{};
    Real sum = 0;
    double fastest = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!(contact_of(work, film, phases[i]) > 0)) {
            return {};
        }
        const CurvePoint<Real> front = curve_now(work, edges[i], Real(0.5), Real(0));
        const auto speed = speed_of(work, front_point(complex, edges[i], Real(0.5)), front.normal);
        if (!speed || !(*speed > 0)) {
            return {};
        }
        sum += *speed;
        fastest = std::max(fastest, static_cast<double>(*speed));
        const Point<double> n = front.normal.template cast<double>();
        rows[i] = {n.x(), n.y(), -static_cast<double>(*speed)};
        right[i] = n.dot((front.place - middle).template cast<double>());
    }
    const std::array normals{Eigen::Vector3d(rows[1].cross(rows[2])),
                             Eigen::Vector3d(rows[2].cross(rows[0])),
                             Eigen::Vector3d(rows[0].cross(rows[1]))};
    const double determinant = rows[0].dot(normals[0]);
    if (!(std::abs(determinant) > min_determinant * fastest)) {
        return {};
    }
    const Eigen::Vector3d solution =
        (right[0] * normals[0] + right[1] * normals[1] + right[2] * normals[2]) / determinant;
    const double farthest = max_way_of_ends * static_cast<double>(work.edge_length);
    if (!(solution.z() < 1 && solution.z() > -longest_overdue) ||
        !(solution.head<2>().norm() < farthest)) {
        return {};
    }
    return Sight<Real>{.v = v,
                       .q = q,
                       .gap = (complex.position(Vertex{q}) - complex.position(Vertex{v})).norm(),
                       .film = film,
                       .one = phases[0],
                       .other = phases[2],
                       .speed_v = sum / 3,
                       .speed_q = sum / 3,
                       .is_squeezed = true,
                       .vanishing = {.place = middle + solution.head<2>().template cast<Real>(),
                                     .shares = static_cast<Real>(solution.z())}};
}

} // namespace

template <class Real>
std::optional<Sight<Real>> see_squeezed(const TopologyWork<Real>& work,
                                        const Sectors<Real>& sectors, std::uint32_t v,
                                        std::size_t k) {
    const Complex<Real>& complex = work.complex;
    const Corner first = sectors[k].first;
    const Corner last = last_of(complex, sectors[k]);
    std::optional<Sight<Real>> best;
    for (const auto& [q, edge] : {std::pair(complex.vertex(next(first)), prev(first)),
                                  {complex.vertex(prev(last)), next(last)}}) {
        if (!is_junction(complex, Vertex{q}) || complex.is_locked(Vertex{q}) ||
            is_on_boundary(complex, Vertex{q})) {
            continue;
        }
        const auto end = end_of_squeezed(work, v, q, edge);
        if (end && (!best || end->gap < best->gap)) {
            best = end;
        }
    }
    return best;
}

template <class Real>
bool is_behind_squeezed(const Complex<Real>& complex, const Sectors<Real>& sectors, std::size_t k,
                        Phase front) {
    const Sector<Real>& sector = sectors[k];
    return sectors.size() > 2 &&
           (has_phase(complex, complex.vertex(next(sector.first)), front) ||
            has_phase(complex, complex.vertex(prev(last_of(complex, sector))), front));
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::optional<Sight<Real>> see_squeezed(                                              \
        const TopologyWork<Real>&, const Sectors<Real>&, std::uint32_t, std::size_t);              \
    template bool is_behind_squeezed(const Complex<Real>&, const Sectors<Real>&, std::size_t,      \
                                     Phase);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

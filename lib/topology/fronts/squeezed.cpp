// SPDX-License-Identifier: MIT
#include "topology/fronts/squeezed.h"

#include "topology/fronts/front_curve.h"
#include "topology/fronts/front_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

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

// The half-edge between two vertices with the film on its left, if it is a sheet.
template <class Real>
Corner sheet_between(const Complex<Real>& complex, std::uint32_t v, std::uint32_t q, Phase film) {
    Corner sheet = no_id;
    const auto finds = [&](Corner c) {
        const Corner edge = complex.vertex(next(c)) == q ? prev(c) : next(c);
        const bool reaches = complex.vertex(next(c)) == q || complex.vertex(prev(c)) == q;
        sheet = reaches && complex.phase_at(c) == film && is_sheet(complex, edge) ? edge : no_id;
        return sheet != no_id;
    };
    return find_corner(complex, Vertex{v}, finds) == no_id ? no_id : sheet;
}

// The half-edge of the film's outline that ends where another begins.
template <class Real>
Corner before_on_outline(const Complex<Real>& complex, Corner edge) {
    const Corner c = find_corner(complex, Vertex{complex.vertex(next(edge))}, [&](Corner k) {
        return complex.phase_at(k) == complex.phase_at(edge) && is_outline(complex, next(k));
    });
    return c == no_id ? no_id : next(c);
}

} // namespace

// The place p and the time t with n.(p - q) = s t for the normal n, the speed s and a point q of
// each of the three fronts.
template <class Real>
std::optional<Vanishing<Real>> end_of_squeezed(const TopologyWork<Real>& work, std::uint32_t v,
                                               std::uint32_t q, Phase film) {
    const Complex<Real>& complex = work.complex;
    const Corner edge = sheet_between(complex, v, q, film);
    const Corner before = edge == no_id ? no_id : before_on_outline(complex, edge);
    if (before == no_id) {
        return {};
    }
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
        if (phases[i] == border_phase || !(contact_of(work, film, phases[i]) > 0)) {
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
    return Vanishing<Real>{.place = middle + solution.head<2>().template cast<Real>(),
                           .shares = static_cast<Real>(solution.z()),
                           .speed = sum / 3,
                           .beside = {phases[0], phases[2]}};
}

template <class Real>
std::optional<Sight<Real>> see_squeezed(const TopologyWork<Real>& work,
                                        const Sectors<Real>& sectors, std::uint32_t v,
                                        std::size_t k) {
    const Complex<Real>& complex = work.complex;
    const Sector<Real>& sector = sectors[k];
    std::optional<Sight<Real>> best;
    for (const std::uint32_t q :
         {complex.vertex(next(sector.first)), complex.vertex(prev(last_of(complex, sector)))}) {
        const Real gap = (complex.position(Vertex{q}) - complex.position(Vertex{v})).norm();
        if ((best && !(gap < best->gap)) || !is_junction(complex, Vertex{q}) ||
            complex.is_locked(Vertex{q}) || is_on_boundary(complex, Vertex{q})) {
            continue;
        }
        if (const auto end = end_of_squeezed(work, v, q, sector.phase)) {
            best = Sight<Real>{.v = v,
                               .q = q,
                               .gap = gap,
                               .film = sector.phase,
                               .one = end->beside[0],
                               .other = end->beside[1],
                               .is_squeezed = true};
        }
    }
    return best;
}

template <class Real>
bool is_behind_squeezed(const Complex<Real>& complex, const Sectors<Real>& sectors, std::size_t k,
                        Phase front) {
    const Sector<Real>& sector = sectors[k];
    const auto has_front = [&](std::uint32_t w) {
        return find_corner(complex, Vertex{w},
                           [&](Corner c) { return complex.phase_at(c) == front; }) != no_id;
    };
    return sectors.size() > 2 && (has_front(complex.vertex(next(sector.first))) ||
                                  has_front(complex.vertex(prev(last_of(complex, sector)))));
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::optional<Vanishing<Real>> end_of_squeezed(const TopologyWork<Real>&,             \
                                                            std::uint32_t, std::uint32_t, Phase);  \
    template std::optional<Sight<Real>> see_squeezed(                                              \
        const TopologyWork<Real>&, const Sectors<Real>&, std::uint32_t, std::size_t);              \
    template bool is_behind_squeezed(const Complex<Real>&, const Sectors<Real>&, std::size_t,      \
                                     Phase);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

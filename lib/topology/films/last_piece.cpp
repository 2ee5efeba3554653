// SPDX-License-Identifier: MIT
#include "topology/films/last_piece.h"

#include "dsc/complex/submesh.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "topology/fronts/front_curve.h"
#include "topology/fronts/front_point.h"
#include "topology/junctions/mending.h"
#include "topology/junctions/merging.h"

#include <Eigen/Dense>

#include <algorithm>

namespace dsc {

namespace {

constexpr std::size_t max_rounds_of_piece = 32;
/// A piece among more than three fronts still has several junctions: it closes about one vertex
/// only if its fronts reach that vertex's place within so many sub-steps.
constexpr double most_shares = 3;

template <class Real>
class LastPiece {
public:
    LastPiece(TopologyWork<Real>& work, std::span<const Triangle> piece,
              std::span<const Corner> outline, std::size_t fronts)
        : work_(work), complex_(work.complex), submesh_(work.complex), piece_(piece),
          outline_(outline), fronts_(fronts), film_(work.complex.phase(piece.front())) {}

    Closing run() {
        for (const Corner c : outline_) {
            ends_.push_back(complex_.vertex(next(c)));
            if (is_border(complex_.twin(c)) ||
                !may_change(work_, film_, phase_beyond(complex_, c))) {
                return Closing::impossible;
            }
        }
        const Point<Real> place = meeting_place();
        if (fronts_ > 3 && shares_ > static_cast<Real>(most_shares)) {
            return Closing::later;
        }
        const std::uint32_t centre = vertex_within();
        if (centre == no_id) {
            return Closing::impossible;
        }
        // Flips make all of the piece the star of the centre.
        for (std::size_t round = 0; round < max_rounds_of_piece; ++round) {
            move_towards(centre, place);
            const Corner flipped = find_corner(complex_, Vertex{centre}, [&](Corner c) {
                return is_of_film(c) && is_of_film(complex_.twin(c)) &&
                       edge_flip(submesh_, c) == Verdict::legal;
            });
            if (flipped == no_id) {
                break;
            }
        }
        std::vector<std::pair<Triangle, Phase>> gifts;
        for_each_corner(complex_, Vertex{centre}, [&](Corner c) {
            if (is_of_film(c) && is_outline(complex_, c)) {
                gifts.emplace_back(Triangle{triangle_of(c)}, phase_beyond(complex_, c));
            }
        });
        for (const auto& [t, to] : gifts) {
            give(work_, t, to);
        }
        give_rest(centre);
        mend_star(work_, Vertex{centre});
        for (const std::uint32_t v : ends_) {
            mend_star(work_, Vertex{v});
        }
        return Closing::done;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }
    [[nodiscard]] bool is_of_film(Corner c) const {
        return !is_border(c) && complex_.phase_at(c) == film_;
    }

    // What could not become the star of the centre: each triangle to the phase beyond its longest
    // sheet, from outside inwards.
    void give_rest(std::uint32_t centre) {
        std::vector<Triangle> rest;
        const auto add = [&](Triangle t) {
            if (complex_.is_alive(t) && complex_.phase(t) == film_ &&
                std::ranges::find(rest, t) == rest.end()) {
                rest.push_back(t);
            }
        };
        std::ranges::for_each(piece_, add);
        for_each_corner(complex_, Vertex{centre}, [&](Corner c) { add(Triangle{triangle_of(c)}); });
        for (bool is_given = true; is_given;) {
            is_given = false;
            for (const Triangle t : rest) {
                Corner longest = no_id;
                for (std::uint32_t k = 0; k < 3 && complex_.phase(t) == film_; ++k) {
                    const Corner c = corner_of(t.id, k);
                    if (is_sheet(complex_, c) && !is_border(complex_.twin(c)) &&
                        (longest == no_id || direction(complex_, c).squaredNorm() >
                                                 direction(complex_, longest).squaredNorm())) {
                        longest = c;
                    }
                }
                if (longest != no_id) {
                    give(work_, t, phase_beyond(complex_, longest));
                    is_given = true;
                }
            }
        }
    }

    // How far the edge of the outline goes in a sub-step; none if nobody knows.
    [[nodiscard]] std::optional<Real> speed_of_edge(Corner c) const {
        const Point<Real> way = direction(complex_, c).normalized();
        return speed_of(work_, front_point(complex_, c, Real(0.5)), Point<Real>(-way.y(), way.x()));
    }
    // The mean of those that are known.
    [[nodiscard]] Real mean_speed() const {
        Real sum = 0;
        Real length = 0;
        for (const Corner c : outline_) {
            const auto speed = is_border(complex_.twin(c)) ? std::nullopt : speed_of_edge(c);
            if (speed && *speed > 0) {
                const Real size = direction(complex_, c).norm();
                sum += size * *speed;
                length += size;
            }
        }
        return length > 0 ? sum / length : Real(0);
    }

    // The place and the time t with n.(place - p) = v t for the normal n, the speed v and a point p
    // of each edge of the outline, weighted by length, in the sense of least squares. Held a little
    // to the mean of the outline: between two parallel fronts it could be anywhere.
    [[nodiscard]] Point<Real> meeting_place() {
        constexpr double hold = 1e-4;
        Point<double> mean = Point<double>::Zero();
        double perimeter = 0;
        for (const Corner c : outline_) {
            const auto way = direction(complex_, c).template cast<double>().eval();
            const auto from = at(complex_.vertex(next(c))).template cast<double>().eval();
            mean += way.norm() * (from + way / 2);
            perimeter += way.norm();
        }
        mean /= perimeter;
        const Real speed = mean_speed();
        Eigen::Matrix3d matrix = Eigen::Vector3d(hold, hold, 0).asDiagonal();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (const Corner c : outline_) {
            const auto length = static_cast<double>(direction(complex_, c).norm());
            if (!(length > 0)) {
                continue;
            }
            const CurvePoint<Real> front = curve_now(work_, c, Real(0.5), speed);
            const Point<double> n = front.normal.template cast<double>();
            const auto own_speed =
                speed_of(work_, front_point(complex_, c, Real(0.5)), front.normal);
            const Real own = std::max(own_speed.value_or(speed), Real(0));
            const double rate = speed > 0 ? static_cast<double>(own / speed) : 1.0;
            const Eigen::Vector3d row(n.x(), n.y(), -rate);
            matrix += length / perimeter * row * row.transpose();
            right += length / perimeter * n.dot(front.place.template cast<double>() - mean) * row;
        }
        const Eigen::Vector3d solution = matrix.ldlt().solve(right);
        shares_ = speed > 0 ? static_cast<Real>(solution.z()) / speed : Real(0);
        return (mean + solution.head<2>()).template cast<Real>();
    }

    // A vertex inside the piece: the only one, or a new one on its longest inner edge. A single
    // triangle has none: that in the middle of its shortest edge, which the front beyond follows.
    std::uint32_t vertex_within() {
        for (std::size_t round = 0; round < max_rounds_of_piece; ++round) {
            std::vector<std::uint32_t> inside;
            Corner longest = no_id;
            Real max_length = 0;
            for (const Triangle t : piece_) {
                if (!complex_.is_alive(t) || complex_.phase(t) != film_) {
                    continue;
                }
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const Corner c = corner_of(t.id, k);
                    const std::uint32_t v = complex_.vertex(c);
                    if (std::ranges::find(ends_, v) == ends_.end() &&
                        std::ranges::find(inside, v) == inside.end()) {
                        inside.push_back(v);
                    }
                    const Real length = direction(complex_, c).squaredNorm();
                    if (is_of_film(complex_.twin(c)) && length > max_length) {
                        max_length = length;
                        longest = c;
                    }
                }
            }
            if (inside.size() == 1) {
                return inside.front();
            }
            if (inside.empty()) {
                if (longest == no_id) {
                    longest = *std::ranges::min_element(outline_, {}, [&](Corner c) {
                        return direction(complex_, c).squaredNorm();
                    });
                }
                const Point<Real> middle =
                    (at(complex_.vertex(next(longest))) + at(complex_.vertex(prev(longest)))) /
                    Real(2);
                const SplitResult split = edge_split(submesh_, longest, middle);
                return split.verdict == Verdict::legal ? split.vertex.id : no_id;
            }
            if (inside.size() > max_rounds_of_piece ||
                !remove_inside(work_, Vertex{inside.back()}, Real(0))) {
                return no_id;
            }
        }
        return no_id;
    }

    // All of the way, or as much of it as leaves all triangles positive.
    void move_towards(std::uint32_t v, const Point<Real>& place) {
        if (complex_.is_boundary_feature(Vertex{v})) {
            return;
        }
        const Point<Real> from = at(v);
        for (const Real share : {Real(1), Real(0.5), Real(0.25)}) {
            const Point<Real> to = from + share * (place - from);
            if (worst_height(complex_, Vertex{v}, to) > 0) {
                // In a piece of a single triangle the vertex is on a sheet.
                const double before = work_.swept;
                note_sweep(work_, Vertex{v}, Vertex{}, to);
                work_.swept = before; // the event has the area of the piece
                rewire::move(complex_, complex_.journal, v, to.x(), to.y(), MoveReason::smoothing);
                return;
            }
        }
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    std::span<const Triangle> piece_;
    std::span<const Corner> outline_;
    std::size_t fronts_; ///< the number of phases beyond the outline
    Phase film_;
    std::vector<std::uint32_t> ends_; ///< the vertices of the outline
    Real shares_ = 0;                 ///< of a sub-step until the fronts reach the meeting place
};

} // namespace

template <class Real>
Closing close_last_piece(TopologyWork<Real>& work, std::span<const Triangle> piece,
                         std::span<const Corner> outline, std::size_t fronts) {
    return LastPiece<Real>(work, piece, outline, fronts).run();
}

template Closing close_last_piece(TopologyWork<double>&, std::span<const Triangle>,
                                  std::span<const Corner>, std::size_t);
template Closing close_last_piece(TopologyWork<float>&, std::span<const Triangle>,
                                  std::span<const Corner>, std::size_t);

} // namespace dsc

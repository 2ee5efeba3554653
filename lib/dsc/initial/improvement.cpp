// SPDX-License-Identifier: MIT
#include "dsc/initial/improvement.h"

#include "dsc/initial/delaunay.h"
#include "dsc/initial/insertion.h"
#include "dsc/initial/star_quality.h"
#include "dsc/operations/edge_collapse.h"

namespace dsc::initial {

namespace {

constexpr int zone_rings = 4;         // of vertices about the interface that may change
constexpr double collapse_below = 0.6; // worst quality of a star that is tried to be collapsed
constexpr double refine_below = 0.5;   // quality of a triangle that is tried to be broken up
constexpr double search_below = 0.75;  // worst quality of a star whose centre is searched for
constexpr double least_gain = 1e-3;    // in quality, for a move
constexpr double collapse_gain = 0.02; // in quality, for a collapse
constexpr double longest_edge = 1.5;   // after a collapse, over the target

template <class Real>
class Improver {
public:
    Improver(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
             double edge_length)
        : complex_(complex), whole_(whole_submesh(complex)), interface_(interface_vertices),
          edge_length_(edge_length) {}

    Improvement run(int rounds) {
        while (done_.rounds < rounds) {
            const std::size_t before = done_.moves + done_.collapses + done_.insertions;
            ++done_.rounds;
            find_zone();
            smooth();
            collapse();
            smooth();
            refine();
            smooth();
            if (before == done_.moves + done_.collapses + done_.insertions) {
                break;
            }
        }
        return done_;
    }

private:
    // All vertices within a few edges of the interface, the interface first.
    void find_zone() {
        zone_.assign(interface_.begin(), interface_.end());
        for (const std::uint32_t v : zone_) {
            complex_.vertices[v].stamp = 1;
        }
        std::size_t first = 0;
        for (int ring = 0; ring < zone_rings; ++ring) {
            const std::size_t last = zone_.size();
            for (; first < last; ++first) {
                visit_link(complex_, zone_[first], [&](std::uint32_t w) {
                    if (complex_.vertices[w].stamp == 0) {
                        complex_.vertices[w].stamp = 1;
                        zone_.push_back(w);
                    }
                });
            }
        }
        for (const std::uint32_t v : zone_) {
            complex_.vertices[v].stamp = 0;
        }
    }

    // Gathers the star of a vertex that is free to move: not on the interface nor the boundary.
    bool gather_free(std::uint32_t v) {
        return complex_.is_alive(Vertex{v}) && gather(complex_, Region{}, v, ring_) &&
               ring_.closed && ring_.one_phase;
    }

    bool try_place(double x, double y, double& best, Point<Real>& place) {
        const Point<Real> point(static_cast<Real>(x), static_cast<Real>(y));
        const double quality = worst_quality_at(ring_, static_cast<double>(point.x()),
                                                static_cast<double>(point.y()));
        if (quality > best + least_gain && fits(ring_, point)) {
            best = quality;
            place = point;
            return true;
        }
        return false;
    }

    void smooth() {
        for (std::size_t i = interface_.size(); i < zone_.size(); ++i) {
            const std::uint32_t v = zone_[i];
            if (!gather_free(v)) {
                continue;
            }
            const double before = worst_quality(ring_);
            double best = before;
            Point<Real> place(ring_.x0, ring_.y0);
            double x = 0;
            double y = 0;
            double reach = 0;
            for (std::uint32_t k = 0; k < ring_.size; ++k) {
                x += static_cast<double>(ring_.x[k] - ring_.x0);
                y += static_cast<double>(ring_.y[k] - ring_.y0);
                reach += std::hypot(static_cast<double>(ring_.x[k] - ring_.x0),
                                    static_cast<double>(ring_.y[k] - ring_.y0));
            }
            const double n = ring_.size;
            try_place(static_cast<double>(ring_.x0) + x / n, static_cast<double>(ring_.y0) + y / n,
                      best, place);
            if (best < search_below) {
                search(reach / n, best, place);
            }
            if (best > before) {
                complex_.set_position(Vertex{v}, place);
                ++done_.moves;
                push_star(complex_, v, stack_);
                legalise(complex_, stack_);
            }
        }
    }

    // Climbs to a place where the worst triangle is as good as can be, in ever smaller steps.
    void search(double reach, double& best, Point<Real>& place) {
        constexpr std::array<std::array<double, 2>, 8> directions{
            {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
        double step = 0.25 * reach;
        for (int halving = 0; halving < 4; ++halving, step *= 0.5) {
            for (int turn = 0; turn < 4; ++turn) {
                bool moved = false;
                const Point<Real> from = place;
                for (const auto& d : directions) {
                    moved = try_place(static_cast<double>(from.x()) + step * d[0],
                                      static_cast<double>(from.y()) + step * d[1], best, place) ||
                            moved;
                }
                if (!moved) {
                    break;
                }
            }
        }
    }

    void collapse() {
        for (std::size_t i = interface_.size(); i < zone_.size(); ++i) {
            const std::uint32_t v = zone_[i];
            if (!complex_.is_alive(Vertex{v}) || !gather(complex_, Region{}, v, ring_) ||
                !ring_.one_phase) {
                continue;
            }
            const double before = worst_quality(ring_);
            if (before > collapse_below) {
                continue;
            }
            const CollapseChoice best = best_collapse(ring_, longest_edge * edge_length_);
            if (best.spoke == no_id || best.quality < before + collapse_gain) {
                continue;
            }
            // A spoke is opposite to the previous corner of the triangle that begins with it; the
            // last one of an open star to the next corner of the triangle that ends there.
            const bool last = best.spoke == ring_.size;
            const Corner corner =
                last ? next(ring_.corner[ring_.size - 1]) : prev(ring_.corner[best.spoke]);
            const auto end = last ? rewire::Vanishing::prev : rewire::Vanishing::next;
            const std::uint32_t keep = ring_.link[best.spoke];
            if (edge_collapse(complex_, whole_, corner, end) == Verdict::legal) {
                ++done_.collapses;
                push_star(complex_, keep, stack_);
                legalise(complex_, stack_);
            }
        }
    }

    void refine() {
        for (std::size_t i = 0; i < zone_.size(); ++i) {
            const std::uint32_t v = zone_[i];
            if (!complex_.is_alive(Vertex{v})) {
                continue;
            }
            bad_.clear();
            visit_star(complex_, v, [&](Corner c) {
                if (quality_of(triangle_of(c)) < refine_below) {
                    bad_.push_back(triangle_of(c));
                }
            });
            if (!bad_.empty()) {
                break_up(bad_.front());
            }
        }
    }

    double quality_of(std::uint32_t t) const {
        const auto& v = complex_.triangles[t].v;
        const auto at = [&](std::uint32_t k) {
            return complex_.position(Vertex{v[k]}).template cast<double>().eval();
        };
        const Point<double> a = at(0);
        const Point<double> b = at(1);
        const Point<double> c = at(2);
        return triangle_quality(a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
    }

    void break_up(std::uint32_t t) {
        const auto& v = complex_.triangles[t].v;
        const Point<double> a = complex_.position(Vertex{v[0]}).template cast<double>();
        const Point<double> b = complex_.position(Vertex{v[1]}).template cast<double>() - a;
        const Point<double> c = complex_.position(Vertex{v[2]}).template cast<double>() - a;
        const double d = 2 * (b.x() * c.y() - b.y() * c.x());
        const Point<double> centre =
            a + Point<double>(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                              b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                    d;
        if (!(d > 0) || !std::isfinite(centre.x()) || !std::isfinite(centre.y())) {
            return;
        }
        const Point<Real> point = centre.cast<Real>();
        const Location location = locate(complex_, t, point);
        if (location.place == Place::beyond || location.place == Place::vertex ||
            encroaches(triangle_of(location.corner), centre)) {
            return;
        }
        insert_point(complex_, location, point, stack_);
        ++done_.insertions;
    }

    // Whether the point lies in the smallest circle about a constrained edge of the triangle or of
    // those next to it: such a point would leave worse triangles there.
    bool encroaches(std::uint32_t t, const Point<double>& point) const {
        const auto& record = complex_.triangles[t];
        bool found = encroaches_own(t, point);
        for (const Corner c : record.n) {
            found = found || (!is_border(c) && encroaches_own(triangle_of(c), point));
        }
        return found;
    }

    bool encroaches_own(std::uint32_t t, const Point<double>& point) const {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            if (complex_.phase_at(c) == complex_.phase_at(complex_.twin(c))) {
                continue;
            }
            const auto a = complex_.position(Vertex{complex_.vertex(next(c))});
            const auto b = complex_.position(Vertex{complex_.vertex(prev(c))});
            if ((a.template cast<double>() - point).dot(b.template cast<double>() - point) < 0) {
                return true;
            }
        }
        return false;
    }

    Complex<Real>& complex_;
    Submesh whole_;
    std::span<const std::uint32_t> interface_;
    double edge_length_;
    Improvement done_;
    Ring<Real> ring_;
    std::vector<std::uint32_t> zone_;
    std::vector<std::uint32_t> bad_;
    std::vector<Corner> stack_;
};

} // namespace

template <class Real>
Improvement improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                    double edge_length, int rounds) {
    return Improver<Real>(complex, interface_vertices, edge_length).run(rounds);
}

template Improvement improve(Complex<double>&, std::span<const std::uint32_t>, double, int);
template Improvement improve(Complex<float>&, std::span<const std::uint32_t>, double, int);

} // namespace dsc::initial

// SPDX-License-Identifier: MIT
#include "dsc/passes/interface/list.h"

#include "dsc/complex/circulate.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/points.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

namespace dsc {

void shuffle_interface(std::vector<std::uint32_t>& list, std::uint64_t seed) {
    if (seed == 0) {
        return;
    }
    // The shuffle of Fisher and Yates, written out because std::shuffle differs between standard
    // libraries.
    std::mt19937_64 random(seed);
    for (std::size_t i = list.size(); i > 1; --i) {
        std::swap(list[i - 1], list[random() % i]);
    }
}

template <class Real>
std::vector<std::uint32_t> collect_interface(const Complex<Real>& complex) {
    // next[v]: the end of the interface half-edge that starts at v with the larger phase on its
    // left.
    std::vector<std::uint32_t> list;
    std::vector<std::uint8_t> seen(complex.vertex_bound(), 0);
    const auto follow = [&](Corner c) {
        // The corner c is opposite to the half-edge from next(c) to prev(c); the curve continues
        // around the larger phase.
        while (true) {
            const std::uint32_t v = complex.vertex(next(c));
            if (seen[v] != 0) {
                return;
            }
            seen[v] = 1;
            list.push_back(v);
            const Phase inside = complex.phase_at(c);
            c = next_along(complex, c,
                           [&](Corner at) { return complex.phase_at(complex.twin(at)) != inside; });
        }
    };
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
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
    Star<Real> star;
    for (const std::uint32_t start : list) {
        std::uint32_t v = start;
        while (v != no_id && complex.vertices[v].stamp == listed) {
            complex.vertices[v].stamp = placed;
            ordered.push_back(v);
            std::uint32_t following = no_id;
            if (gather(complex, Region{}, v, star)) {
                for (std::uint32_t i = 0; i < star.link_size() && following == no_id; ++i) {
                    if (star.is_constrained(i) && complex.vertices[star.link[i]].stamp == listed) {
                        following = star.link[i];
                    }
                }
            }
            v = following;
        }
    }
    list.swap(ordered);
}

namespace {

// Measures turns of the interface at the scale of an arc.
template <class Real>
class Turns {
public:
    Turns(const Complex<Real>& complex, Real arc) : complex_(complex), arc_(arc) {}

    // Whether the curve turns by more than the angle of this cosine, and most sharply within the
    // arc.
    bool is_feature(std::uint32_t v, Real cosine) {
        near_.clear();
        const auto ends = arc_ends(v, &near_);
        const Point<Real> at = complex_.position(Vertex{v});
        if (!ends || turns_less<Real>(ends->front(), at, ends->back(), cosine)) {
            return false;
        }
        const Real signed_turn = turn_angle<Real>(ends->front(), at, ends->back());
        const Real turn = std::abs(signed_turn);
        // At the blunt end of a strip each vertex is needed to keep the strip's width.
        constexpr Real turns_back = Real(2.6); // radians
        const Real here = turn_at(v);
        if (turn > turns_back && here * signed_turn > 0 && std::cos(here) < cosine) {
            return true;
        }
        return std::ranges::none_of(near_, [&](std::uint32_t u) {
            const auto there = arc_ends(u, nullptr);
            const Real other =
                there ? std::abs(turn_angle<Real>(there->front(), complex_.position(Vertex{u}),
                                                  there->back()))
                      : Real(0);
            return other > turn || (other == turn && u < v);
        });
    }

private:
    using Ends = std::array<Point<Real>, 2>;

    // The turn at a vertex of one curve, in the direction of `arc_ends`.
    Real turn_at(std::uint32_t v) {
        (void)gather(complex_, Region{}, v, star_);
        const IncidentEdges incident = interface_edges_of(star_);
        return turn_angle<Real>(link_point(star_, incident.first), {star_.x0, star_.y0},
                                link_point(star_, incident.second));
    }

    // The ends of the arcs on both sides of a vertex of one curve inside the domain; the vertices
    // before these ends are appended to `near`.
    std::optional<Ends> arc_ends(std::uint32_t v, std::vector<std::uint32_t>* near) {
        if (!gather(complex_, Region{}, v, star_)) {
            return std::nullopt;
        }
        const IncidentEdges incident = interface_edges_of(star_);
        if (incident.count != 2) {
            return std::nullopt;
        }
        const std::array<std::uint32_t, 2> first{star_.link[incident.first],
                                                 star_.link[incident.second]};
        return Ends{arc_end(v, first[0], near), arc_end(v, first[1], near)};
    }

    Point<Real> arc_end(std::uint32_t v, std::uint32_t next, std::vector<std::uint32_t>* near) {
        Real length = 0;
        for (std::uint32_t from = v;;) {
            const Point<Real> end = complex_.position(Vertex{next});
            length += distance<Real>(complex_.position(Vertex{from}), end);
            if (length >= arc_ || !gather(complex_, Region{}, next, star_)) {
                return end;
            }
            const IncidentEdges incident = interface_edges_of(star_);
            if (incident.count != 2 || !star_.closed || next == v) {
                return end; // a junction, a side of the domain, or a curve shorter than the arc
            }
            if (near != nullptr) {
                near->push_back(next);
            }
            const bool is_first = star_.link[incident.first] == from;
            from = std::exchange(next, star_.link[is_first ? incident.second : incident.first]);
        }
    }

    const Complex<Real>& complex_;
    Real arc_;
    Star<Real> star_;
    std::vector<std::uint32_t> near_;
};

} // namespace

template <class Real>
void mark_features(Complex<Real>& complex, const std::vector<std::uint32_t>& list, double degrees,
                   Real arc) {
    const auto cosine = static_cast<Real>(std::cos(degrees * std::numbers::pi / 180));
    Turns<Real> turns(complex, arc);
    for (const std::uint32_t v : list) {
        if (turns.is_feature(v, cosine)) {
            complex.vertices[v].flags |= vertex_feature;
        }
    }
}

template <class Real>
bool is_advected(const Complex<Real>& complex, std::span<const Phase> phases, Vertex vertex) {
    const Corner first = complex.vertices[vertex.id].corner;
    if (phases.empty() || first == no_id ||
        std::ranges::find(phases, complex.phase_at(first)) == phases.end()) {
        return false;
    }
    const Phase phase = complex.phase_at(first);
    bool is_inside = true;
    for_each_corner(complex, vertex, [&](Corner c) {
        is_inside = is_inside && complex.phase_at(c) == phase &&
                    !is_border(complex.twin(prev(c))) && !is_border(complex.twin(next(c)));
    });
    return is_inside;
}

template <class Real>
std::vector<std::uint32_t> collect_moved(const Complex<Real>& complex,
                                         const Options<Real>& options) {
    std::vector<std::uint32_t> list = collect_interface(complex);
    if (!options.advected_phases.empty()) {
        std::ranges::copy_if(ids_of(vertices(complex)), std::back_inserter(list), [&](auto v) {
            return is_advected<Real>(complex, options.advected_phases, Vertex{v});
        });
    }
    shuffle_interface(list, options.shuffle_seed);
    return list;
}

template <class Real>
bool is_moved(const Complex<Real>& complex, const Options<Real>& options, Vertex vertex) {
    return complex.is_alive(vertex) && complex.vertices[vertex.id].corner != no_id &&
           (is_interface(complex, vertex) ||
            is_advected<Real>(complex, options.advected_phases, vertex));
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::vector<std::uint32_t> collect_interface(const Complex<Real>&);                   \
    template void order_interface(Complex<Real>&, std::vector<std::uint32_t>&, std::uint32_t);     \
    template void mark_features(Complex<Real>&, const std::vector<std::uint32_t>&, double, Real);  \
    template bool is_advected(const Complex<Real>&, std::span<const Phase>, Vertex);               \
    template std::vector<std::uint32_t> collect_moved(const Complex<Real>&, const Options<Real>&); \
    template bool is_moved(const Complex<Real>&, const Options<Real>&, Vertex);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

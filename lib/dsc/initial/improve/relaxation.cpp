// SPDX-License-Identifier: MIT
#include "dsc/initial/improve/relaxation.h"

#include "dsc/initial/build/insertion.h"
#include "dsc/initial/build/star_quality.h"
#include "dsc/initial/rounding.h"

#include <array>
#include <cmath>
#include <vector>

namespace dsc::initial {

namespace {

constexpr double good_star = 0.9;      // worst quality of a star that is left alone
constexpr double search_below = 0.75;  // worst quality of a star whose centre is searched for
constexpr double min_gain = 5e-3;      // in quality, for a move
constexpr double collapse_below = 0.6; // worst quality of a star that may be collapsed
constexpr double collapse_gain = 0.02; // in quality, for a collapse
constexpr double longest_edge = 1.4;   // after a collapse, over the target

/// The freedom of a vertex: anywhere, along one axis, or none.
enum class Freedom : std::uint8_t { none, horizontal, vertical, full };

template <class Real>
Freedom freedom_of(const Complex<Real>& complex, const Star<Real>& star) {
    if (!star.one_phase || complex.is_boundary_feature(Vertex{star.vertex})) {
        return Freedom::none;
    }
    if (star.closed) {
        return Freedom::full;
    }
    if (star.size == 0) {
        return Freedom::none;
    }
    const std::uint32_t last = star.size - 1;
    if (star.y[0] == star.y0 && star.y_next[last] == star.y0) {
        return Freedom::horizontal;
    }
    return star.x[0] == star.x0 && star.x_next[last] == star.x0 ? Freedom::vertical : Freedom::none;
}

// The best place found so far for the centre of a star.
template <class Real>
struct Trial {
    const Star<Real>& star;
    Freedom freedom;
    Point<Real> place;
    double quality;

    bool offer(double x, double y) {
        const Point<Real> point(freedom == Freedom::vertical ? star.x0 : narrowed<Real>(x),
                                freedom == Freedom::horizontal ? star.y0 : narrowed<Real>(y));
        const double worst = worst_quality_at(star, point.template cast<double>());
        if (worst > quality + min_gain && all_positive(star, point.x(), point.y())) {
            quality = worst;
            place = point;
            return true;
        }
        return false;
    }
};

// Searches with decreasing steps for the position at which the worst triangle is best.
template <class Real>
void search(Trial<Real>& trial, double reach) {
    constexpr double diagonal = 0.70710678118654752;
    constexpr std::array<std::array<double, 2>, 8> directions{{{1, 0},
                                                               {diagonal, diagonal},
                                                               {0, 1},
                                                               {-diagonal, diagonal},
                                                               {-1, 0},
                                                               {-diagonal, -diagonal},
                                                               {0, -1},
                                                               {diagonal, -diagonal}}};
    constexpr int halvings = 4;
    constexpr int max_steps = 4;
    double step = 0.25 * reach;
    for (int halving = 0; halving < halvings; ++halving, step *= 0.5) {
        bool moved = true;
        for (int i = 0; i < max_steps && moved; ++i) {
            moved = false;
            const Point<Real> from = trial.place;
            for (const auto& d : directions) {
                moved = trial.offer(static_cast<double>(from.x()) + step * d[0],
                                    static_cast<double>(from.y()) + step * d[1]) ||
                        moved;
            }
        }
    }
}

// The mean of the link and the mean length of the incident edges.
struct Link {
    double x = 0;
    double y = 0;
    double reach = 0;
};

template <class Real>
Link mean_link(const Star<Real>& star) {
    Link mean;
    const std::uint32_t n = star.link_size();
    for (std::uint32_t k = 0; k < n; ++k) {
        // Relative to the centre, so that an offset of the coordinates costs no digits.
        const auto x = static_cast<double>(star.link_x(k) - star.x0);
        const auto y = static_cast<double>(star.link_y(k) - star.y0);
        mean.x += x / n;
        mean.y += y / n;
        mean.reach += std::sqrt(x * x + y * y) / n;
    }
    mean.x += static_cast<double>(star.x0);
    mean.y += static_cast<double>(star.y0);
    return mean;
}

} // namespace

template <class Real>
std::size_t smooth(Complex<Real>& complex, std::span<const std::uint32_t> zone) {
    std::size_t moves = 0;
    Star<Real> star;
    std::vector<Corner> stack;
    for (const std::uint32_t v : zone) {
        if (!complex.is_alive(Vertex{v}) || complex.vertices[v].slot == settled ||
            !gather(complex, Region{}, v, star)) {
            continue;
        }
        const Freedom freedom = freedom_of(complex, star);
        const double before = worst_quality(star);
        Trial<Real> trial{star, freedom, Point<Real>(star.x0, star.y0), before};
        if (freedom != Freedom::none && before < good_star) {
            const Link mean = mean_link(star);
            trial.offer(mean.x, mean.y);
            if (trial.quality < search_below) {
                search(trial, mean.reach);
            }
        }
        if (trial.quality > before) {
            complex.set_position(Vertex{v}, trial.place);
            ++moves;
            legalise_star(complex, v, stack);
        } else {
            complex.vertices[v].slot = settled;
        }
    }
    return moves;
}

template <class Real>
std::size_t thin_out(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                     double edge_length) {
    std::size_t collapses = 0;
    Star<Real> star;
    std::vector<Corner> stack;
    for (const std::uint32_t v : zone) {
        if (!complex.is_alive(Vertex{v}) || !gather(complex, Region{}, v, star) ||
            freedom_of(complex, star) == Freedom::none) {
            continue;
        }
        const double before = worst_quality(star);
        if (before > collapse_below) {
            continue;
        }
        const CollapseChoice best = best_collapse(star, longest_edge * edge_length);
        if (best.quality >= before + collapse_gain &&
            collapse_along(complex, star, best.incident_edge, stack)) {
            ++collapses;
        }
    }
    return collapses;
}

template std::size_t smooth(Complex<double>&, std::span<const std::uint32_t>);
template std::size_t smooth(Complex<float>&, std::span<const std::uint32_t>);
template std::size_t thin_out(Complex<double>&, std::span<const std::uint32_t>, double);
template std::size_t thin_out(Complex<float>&, std::span<const std::uint32_t>, double);

} // namespace dsc::initial

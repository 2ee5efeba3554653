// SPDX-License-Identifier: MIT
#include "geometric_flows/growth_features.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/motion/movement.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "geometric_flows/growth_bend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dsc {

namespace {

// In edge lengths.
constexpr double beside = 0.05; // distance of the vertices of a fan at the start
constexpr double roomy = 0.25;  // the radius at which they move to their rays
constexpr double grown = 1.5;   // the radius from which on a fan may dissolve
constexpr double margin = 0.1;  // added to a notch's way, to find vertices that it will run over
constexpr double bulge = 0.2;   // largest change of the curve if that vertex is removed
constexpr double stray = 1e-3;  // a vertex farther from its ray than this leaves the fan
constexpr std::uint32_t max_members = 32;

template <class Real>
class Corners {
public:
    Corners(Work<Real>& work, const GrowthOptions<Real>& options)
        : work_(work), complex_(work.complex), options_(options), rays_(*fan_rays(work.complex)),
          h_(work.options.edge_length), open_(radians(options.open_degrees)),
          fan_(radians(options.fan_degrees)), notch_(radians(options.notch_degrees)),
          smooth_(radians(options.smooth_degrees)) {}

    void run() {
        // Vertices created here are visited in the next sub-step.
        for (const std::uint32_t v : work_.interface) {
            visit(v);
        }
    }

private:
    static Real radians(double degrees) {
        return static_cast<Real>(degrees * std::numbers::pi / 180);
    }
    [[nodiscard]] Real lengths(double relative) const { return static_cast<Real>(relative) * h_; }

    [[nodiscard]] GrowthBend<Real> bend_of(const Star<Real>& star) const {
        return dsc::bend_of(star, options_, work_.time);
    }

    void visit(std::uint32_t v) {
        Star<Real>& star = work_.star;
        if (!complex_.is_alive(Vertex{v}) || complex_.is_locked(Vertex{v}) ||
            !gather(complex_, work_.submesh.region, v, star)) {
            return;
        }
        const GrowthBend<Real> bend = bend_of(star);
        if (!bend.known) {
            rays_[Vertex{v}] = {};
            return;
        }
        const bool touches =
            may_be_feature(star.link[bend.in]) || may_be_feature(star.link[bend.out]);
        const bool in_fan = rays_[Vertex{v}].state != FanState::none;
        const bool bends = std::abs(bend.turn) > std::min(open_, notch_);
        if (!touches && !in_fan && !bends && !is_feature(v)) {
            return;
        }
        if (!star.owned) {
            work_.deferred.remeshing(v);
            return;
        }
        if (touches && (is_run_over(star, bend, bend.in, bend.out) ||
                        is_run_over(star, bend, bend.out, bend.in))) {
            return;
        }
        if (in_fan) {
            tend(star, bend);
        } else if (bend.turn * bend.speed > 0 && std::abs(bend.turn) > open_ &&
                   (is_feature(v) ||
                    has_longer_edges(bend, lengths(work_.options.interface.shortest)))) {
            open(v, bend);
        } else {
            mark(v, bend);
        }
    }

    // --- notches ------------------------------------------------------------------------------
    [[nodiscard]] bool is_feature(std::uint32_t v) const { return complex_.is_feature(Vertex{v}); }
    // A vertex of another submesh may become a feature at this moment, so its flag is not read.
    [[nodiscard]] bool may_be_feature(std::uint32_t v) const {
        return !owns(complex_, work_.submesh.region, v) || is_feature(v);
    }
    void mark(std::uint32_t v, const GrowthBend<Real>& bend) {
        if (std::abs(bend.turn) < smooth_) {
            complex_.set_feature(Vertex{v}, false);
        } else if (bend.turn * bend.speed < 0 && std::abs(bend.turn) > notch_ &&
                   has_longer_edges(bend, lengths(work_.options.interface.shortest))) {
            complex_.set_feature(Vertex{v}, true);
        }
    }

    // The distance that a vertex moves along its normal in this sub-step.
    [[nodiscard]] Real way(Real speed) const {
        return std::min(std::abs(speed) * work_.dt, lengths(work_.options.sub_step));
    }

    // The distance that a notch moves along its sheets in this sub-step, limited by the largest
    // move.
    [[nodiscard]] Real reach(const GrowthBend<Real>& notch) const {
        const Real half = std::abs(notch.turn) / 2;
        const Real max = lengths(work_.options.sub_step) * std::cos(half);
        return (std::min(way(notch.speed), max) + lengths(margin)) * std::tan(half);
    }

    // Whether the vertex blocked a notch at the end of one of its edges and has been removed. Also
    // true if only another submesh can decide this.
    bool is_run_over(const Star<Real>& star, const GrowthBend<Real>& bend,
                     std::uint32_t incident_edge, std::uint32_t other) {
        const std::uint32_t u = star.link[incident_edge];
        const Point<Real> notch = link_point(star, incident_edge);
        const Point<Real> beyond = link_point(star, other);
        const Real distance = (notch - bend.at).norm();
        if (!is_feature(u) || rays_[Vertex{u}].state != FanState::none ||
            distance > lengths(work_.options.sub_step + 4 * margin)) {
            return false;
        }
        Star<Real>& next_star = work_.other_star;
        const bool gathered = gather(complex_, work_.submesh.region, u, next_star);
        if (!next_star.owned) {
            work_.deferred.remeshing(star.vertex);
            return true;
        }
        const GrowthBend<Real> there = gathered ? bend_of(next_star) : GrowthBend<Real>{};
        if (!there.known || there.turn * there.speed >= 0 || std::abs(there.turn) < smooth_) {
            return false;
        }
        const Point<Real> chord = beyond - notch;
        const Real off = std::abs(cross<Real>(chord, bend.at - notch)) / chord.norm();
        if (distance > reach(there) + lengths(margin) || off > lengths(bulge) ||
            !turns_less<Real>(beyond, bend.at, notch, Real(0))) {
            return false;
        }
        return collapse_into(star, incident_edge) || collapse_into(star, other);
    }

    // Collapses the centre into the other end of an incident edge, if that is legal.
    bool collapse_into(const Star<Real>& star, std::uint32_t incident_edge) {
        return edge_collapse(work_.submesh, prev(star.corner[incident_edge]),
                             rewire::Vanishing::next) == Verdict::legal;
    }

    // --- fans ---------------------------------------------------------------------------------
    // The normal at the feature of the sheet on one side. False if another submesh owns part of it.
    bool sheet_normal(const Star<Real>& star, const GrowthBend<Real>& bend,
                      std::uint32_t incident_edge, Point<Real>& normal) {
        Star<Real>& next_star = work_.other_star;
        const bool gathered =
            gather(complex_, work_.submesh.region, star.link[incident_edge], next_star);
        if (!next_star.owned) {
            return false;
        }
        const Point<Real> before = link_point(star, incident_edge);
        Point<Real> first = before;
        if (const GrowthBend<Real> next = gathered ? bend_of(next_star) : GrowthBend<Real>{};
            next.known && !is_feature(next_star.vertex)) {
            first = incident_edge == bend.in ? next.from : next.to;
        }
        const Point<Real> tangent = end_tangent<Real>(first, before, bend.at);
        normal = incident_edge == bend.in ? Point<Real>(tangent.y(), -tangent.x())
                                          : Point<Real>(-tangent.y(), tangent.x());
        return true;
    }

    void open(std::uint32_t v, const GrowthBend<Real>& bend) {
        const Star<Real>& star = work_.star;
        Point<Real> first;
        Point<Real> last;
        if (!sheet_normal(star, bend, bend.in, first) ||
            !sheet_normal(star, bend, bend.out, last)) {
            work_.deferred.remeshing(v);
            return;
        }
        const Real angle = std::atan2(cross<Real>(first, last), first.dot(last));
        if (angle * bend.turn <= 0) {
            return; // nearly a half turn
        }
        if (std::abs(angle) < smooth_) { // the chords of one bend, and no feature
            complex_.set_feature(Vertex{v}, false);
            return;
        }
        const auto edges = std::min(static_cast<std::uint32_t>(std::ceil(std::abs(angle) / fan_)),
                                    max_members - 1);
        const std::uint32_t before = edges / 2;
        const std::uint32_t after = edges - before;
        const IdPool& pool = *work_.submesh.pool;
        if (!pool.may_grow &&
            (pool.vertices.size() < edges || pool.triangles.size() < 2 * std::size_t{edges})) {
            work_.deferred.remeshing(v);
            return;
        }
        // The members of the fan, in the order of the curve.
        std::array<std::uint32_t, max_members> members{};
        std::uint32_t count = 0;
        const std::uint32_t in = star.link[bend.in];
        const std::uint32_t out = star.link[bend.out];
        count += split_towards(v, in, before, std::span(members).first(before));
        members[count++] = v;
        const std::uint32_t found =
            split_towards(v, out, after, std::span(members).subspan(count, after));
        std::reverse(members.begin() + count, members.begin() + count + found);
        count += found;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Real by =
                count > 1 ? angle * static_cast<Real>(k) / static_cast<Real>(count - 1) : 0;
            const Point<Real> direction = turned<Real>(first, by);
            const Vertex member{members[k]};
            const Real start = (complex_.position(member) - bend.at).dot(direction);
            rays_[member] = {bend.at,
                             direction,
                             static_cast<float>(start),
                             static_cast<float>(-by),
                             k + 1 == count ? 0 : static_cast<float>(angle - by),
                             FanState::opening};
            complex_.set_feature(member, true);
        }
    }

    // Puts up to `wanted` vertices on the edge from v, the farthest first; returns how many.
    std::uint32_t split_towards(std::uint32_t v, std::uint32_t to, std::uint32_t wanted,
                                std::span<std::uint32_t> made) {
        const Point<Real> at = complex_.position(Vertex{v});
        const Point<Real> edge = complex_.position(Vertex{to}) - at;
        const Real length = edge.norm();
        const Real spacing =
            std::min(lengths(beside), Real(0.5) * length / static_cast<Real>(wanted + 1));
        std::uint32_t count = 0;
        for (std::uint32_t k = wanted; k > 0; --k) {
            const Point<Real> point = at + (spacing * static_cast<Real>(k) / length) * edge;
            const Corner corner = complex_.find_half_edge(Vertex{v}, Vertex{to});
            if (corner == no_id || !owns_place(work_.submesh.region, point)) {
                break;
            }
            const SplitResult result = edge_split(work_.submesh, corner, point);
            if (result.verdict != Verdict::legal) {
                break;
            }
            to = result.vertex.id;
            made[count++] = to;
        }
        return count;
    }

    void tend(const Star<Real>& star, const GrowthBend<Real>& bend) {
        const Vertex v{star.vertex};
        FanRay<Real>& ray = rays_[v];
        const FanRay<Real>& before = rays_[Vertex{star.link[bend.in]}];
        const FanRay<Real>& after = rays_[Vertex{star.link[bend.out]}];
        const bool is_inside = belong_together(before, ray) && belong_together(ray, after);
        if (ray.state == FanState::closing) {
            end_closing(star, bend);
            return;
        }
        if (ray.state == FanState::inserted) {
            if (!is_inside) {
                ray = {};
                return;
            }
            const Real radius = (along(before, bend.from) + along(after, bend.to)) / 2;
            place(star, ray, radius);
            return;
        }
        const Real radius = along(ray, bend.at);
        if (ray.state == FanState::opening) {
            if (std::abs(radius) > lengths(roomy)) {
                place(star, ray, radius);
            }
            return;
        }
        const Real aside = std::abs(cross<Real>(ray.direction, bend.at - ray.source));
        // If the speed depends on the position, rays bend.
        const auto differs = [&](const FanRay<Real>& other, const Point<Real>& at) {
            return belong_together(ray, other) && other.state == FanState::open &&
                   std::abs(along(other, at) - radius) > lengths(stray);
        };
        const bool is_free = std::abs(radius) > lengths(grown) &&
                             (differs(before, bend.from) || differs(after, bend.to));
        if (aside > lengths(stray) || is_free) {
            ray = {};
            mark(v.id, bend);
        } else if (bend.speed * radius < 0) {
            close(star, bend, is_inside);
        } else if (is_inside && std::abs(radius) > lengths(grown)) {
            complex_.set_feature(v, false);
        }
    }

    // Closes a fan that would vanish in this sub-step. The sheets meet in a notch on the other side
    // of the source: the last vertex moves there, and the others to places close to it on the first
    // sheet, from where they can be removed without harm.
    void close(const Star<Real>& star, const GrowthBend<Real>& bend, bool is_inside) {
        FanRay<Real>& ray = rays_[Vertex{star.vertex}];
        const Real radius = along(ray, bend.at);
        const Real time = way(bend.speed) / std::abs(bend.speed);
        const Real left = std::abs(radius) - lengths(margin);
        // A vertex inside the fan gets a second chance to be removed, as its star may not allow it
        // at first.
        if (is_inside && left < 2 * way(bend.speed) &&
            (collapse_into(star, bend.in) || collapse_into(star, bend.out))) {
            return;
        }
        if (left > way(bend.speed)) {
            return;
        }
        const Real to_first = static_cast<Real>(ray.to_first);
        const Real to_last = static_cast<Real>(ray.to_last);
        const Point<Real> first = turned<Real>(ray.direction, to_first);
        const Point<Real> sum = first + turned<Real>(ray.direction, to_last);
        const Point<Real> notch =
            ray.source + 2 * (radius + bend.speed * time) / sum.squaredNorm() * sum;
        const Real share = to_last / (to_last - to_first);
        const Point<Real> place =
            notch + lengths(margin) * share * Point<Real>(first.y(), -first.x());
        ray.direction = (place - bend.at) / time;
        ray.state = FanState::closing;
    }

    void end_closing(const Star<Real>& star, const GrowthBend<Real>& bend) {
        FanRay<Real>& ray = rays_[Vertex{star.vertex}];
        const bool is_last = ray.to_last == 0;
        if (is_last || !(collapse_into(star, bend.out) || collapse_into(star, bend.in))) {
            ray = {};
            complex_.set_feature(Vertex{star.vertex}, is_last);
        }
    }

    // Puts the vertex on its ray, if there is room.
    void place(const Star<Real>& star, FanRay<Real>& ray, Real radius) {
        const Point<Real> target = ray.source + radius * ray.direction;
        if (owns_place(work_.submesh.region, target) &&
            all_positive(star, target.x(), target.y())) {
            rewire::move(complex_, work_.log, star.vertex, target.x(), target.y(),
                         MoveReason::flow);
            ray.state = FanState::open;
        }
    }

    Work<Real>& work_;
    Complex<Real>& complex_;
    const GrowthOptions<Real>& options_;
    VertexAttribute<FanRay<Real>>& rays_;
    Real h_;
    Real open_; // angles in radians
    Real fan_;
    Real notch_;
    Real smooth_;
};

} // namespace

template <class Real>
Pass<Real> growth_features(const GrowthOptions<Real>& options) {
    check_growth(options);
    return {"growth corners", [options](Work<Real>& work) { Corners<Real>(work, options).run(); }};
}

template <class Real>
Algorithm<Real> growth_algorithm(Complex<Real>& complex, const GrowthOptions<Real>& options) {
    Algorithm<Real> algorithm = default_algorithm<Real>();
    algorithm.remeshing.push_back(growth_features(options));
    for (const GrowthSpeed& pair : options.speeds) {
        for (const Phase phase : {pair.growing, pair.into}) {
            if (std::ranges::none_of(triangles(complex),
                                     [&](Triangle t) { return complex.phase(t) == phase; })) {
                throw InputError({.what = "a phase that the complex does not have",
                                  .where = "growth.speeds",
                                  .value = std::to_string(phase),
                                  .allowed = "a phase of one of its triangles"});
            }
        }
    }
    add_fan_rays(complex);
    return algorithm;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Pass<Real> growth_features(const GrowthOptions<Real>&);                               \
    template Algorithm<Real> growth_algorithm(Complex<Real>&, const GrowthOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

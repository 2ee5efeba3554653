// SPDX-License-Identifier: MIT
#include "dsc3/geometry/predicates.h"
#include "dsc3/geometry/tet.h"
#include "dsc3/initial/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <tuple>

namespace dsc3 {

namespace {

[[noreturn]] void refuse(const TriangleSurface& surface, const char* what, const std::string& where,
                         const std::string& value, const char* allowed) {
    throw InputError({.what = what,
                      .where = surface.name + (where.empty() ? "" : ", at " + where),
                      .value = value,
                      .allowed = allowed});
}

// The edge from corner k of a triangle to the next.
struct Side {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    std::uint32_t corner;

    friend bool operator<(const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    }
};

// Signed distances from points to the nearest points of the surface.
class SignedDistance {
public:
    explicit SignedDistance(TriangleSurface surface) : surface_(std::move(surface)) {
        check_points();
        link();
        orient();
        tree_ = std::make_unique<BoxTree>(surface_);
        expect_no_crossing();
        find_normals();
    }
    SignedDistance(const SignedDistance&) = delete;
    SignedDistance& operator=(const SignedDistance&) = delete;
    SignedDistance(SignedDistance&&) = delete;
    SignedDistance& operator=(SignedDistance&&) = delete;
    ~SignedDistance() = default;

    [[nodiscard]] Real operator()(const Point& p) const {
        Real best = std::numeric_limits<Real>::infinity();
        Real side = 0;
        tree_->search([&](const Box& box) { return squared_distance_to(box, p) < best; },
                      [&](const Box& one, const Box& other) { // the nearer one comes first
                          return squared_distance_to(one, p) <= squared_distance_to(other, p);
                      },
                      [&](std::uint32_t t) {
                          const Foot foot = nearest(t, p);
                          const Point way = p - foot.place;
                          if (const Real square = way.squaredNorm(); square < best) {
                              best = square;
                              side = way.dot(normal_at(t, foot));
                          }
                      });
        return side < 0 ? -std::sqrt(best) : std::sqrt(best);
    }

    [[nodiscard]] SurfaceFigures figures() const {
        SurfaceFigures sum;
        std::vector<std::uint8_t> is_used(surface_.points.size(), 0);
        for (const auto& [a, b, c] : surface_.triangles) {
            is_used[a] = is_used[b] = is_used[c] = 1;
        }
        const auto vertices = std::count(is_used.begin(), is_used.end(), 1);
        // Half as many edges again as triangles.
        sum.euler_characteristic =
            vertices - static_cast<std::int64_t>(surface_.triangles.size() / 2);
        for (std::uint32_t part = 0; part + 1 < firsts_.size(); ++part) {
            sum.volume += volume_of(part);
        }
        return sum;
    }

private:
    // The nearest point of a triangle lies inside (feature 6), on the edge from corner k (3 + k),
    // or at corner k.
    struct Foot {
        Point place;
        std::uint32_t feature;
    };

    void check_points() {
        for (const Point& p : surface_.points) {
            if (!p.allFinite()) {
                refuse(surface_, "a coordinate is not finite", to_text(p), to_text(p),
                       "finite coordinates");
            }
        }
        for (const Triangle3& t : surface_.triangles) {
            for (const std::uint32_t v : t) {
                if (v >= surface_.points.size()) {
                    refuse(surface_, "no such point", "", std::to_string(v),
                           "below the number of points");
                }
            }
        }
        std::erase_if(surface_.triangles, [](const Triangle3& t) {
            return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        });
        if (surface_.triangles.empty()) {
            refuse(surface_, "the surface has no triangles", "", "0 triangles", "4 or more");
        }
    }

    // Finds the neighbours of each triangle.
    void link() {
        std::vector<Side> sides;
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t a = surface_.triangles[t][k];
                const std::uint32_t b = surface_.triangles[t][(k + 1) % 3];
                sides.push_back({std::min(a, b), std::max(a, b), t, k});
            }
        }
        std::sort(sides.begin(), sides.end());
        beside_.resize(surface_.triangles.size());
        for (std::size_t i = 0; i < sides.size();) {
            std::size_t end = i + 1;
            while (end < sides.size() && sides[end].low == sides[i].low &&
                   sides[end].high == sides[i].high) {
                ++end;
            }
            if (end - i != 2) {
                refuse(surface_, "the surface is not closed",
                       to_text(
                           midpoint(surface_.points[sides[i].low], surface_.points[sides[i].high])),
                       "an edge with " + std::to_string(end - i) +
                           (end - i == 1 ? " triangle" : " triangles"),
                       "two triangles at each edge");
            }
            beside_[sides[i].triangle][sides[i].corner] = sides[i + 1].triangle;
            beside_[sides[i + 1].triangle][sides[i + 1].corner] = sides[i].triangle;
            i = end;
        }
    }

    // Orients each part outwards, or inwards if it lies inside an odd number of the others, so that
    // parts in parts are hollows.
    void orient() {
        find_parts();
        for (std::uint32_t part = 0; part + 1 < firsts_.size(); ++part) {
            const Real enclosed = volume_of(part);
            if (enclosed == 0) {
                refuse(surface_, "the surface encloses nothing", to_text(point_of(part)),
                       "a volume of 0", "a volume above 0");
            }
            if ((enclosed < 0) != is_hollow(part)) {
                for (std::uint32_t k = firsts_[part]; k < firsts_[part + 1]; ++k) {
                    turn_over(order_[k]);
                }
            }
        }
    }
    // Lists the triangles part by part, and orients those of a part alike.
    void find_parts() {
        auto& triangles = surface_.triangles;
        std::vector<std::uint8_t> is_done(triangles.size(), 0);
        for (std::uint32_t first = 0; first < triangles.size(); ++first) {
            if (is_done[first] != 0) {
                continue;
            }
            is_done[first] = 1;
            firsts_.push_back(static_cast<std::uint32_t>(order_.size()));
            order_.push_back(first);
            for (std::size_t at = firsts_.back(); at < order_.size(); ++at) {
                const std::uint32_t t = order_[at];
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const std::uint32_t other = beside_[t][k];
                    const std::uint32_t a = triangles[t][k];
                    const std::uint32_t b = triangles[t][(k + 1) % 3];
                    if (runs_along(other, a, b)) {
                        if (is_done[other] != 0) {
                            refuse(surface_, "the surface has no inside",
                                   to_text(surface_.points[a]), "a one-sided surface",
                                   "surfaces whose triangles can be oriented");
                        }
                        turn_over(other);
                    }
                    if (is_done[other] == 0) {
                        is_done[other] = 1;
                        order_.push_back(other);
                    }
                }
            }
        }
        firsts_.push_back(static_cast<std::uint32_t>(order_.size()));
    }
    [[nodiscard]] const Point& point_of(std::uint32_t part) const {
        return surface_.points[surface_.triangles[order_[firsts_[part]]][0]];
    }
    [[nodiscard]] Real volume_of(std::uint32_t part) const {
        Real sum = 0;
        for (std::uint32_t k = firsts_[part]; k < firsts_[part + 1]; ++k) {
            const auto& [a, b, c] = surface_.triangles[order_[k]];
            sum +=
                volume(point_of(part), surface_.points[a], surface_.points[b], surface_.points[c]);
        }
        return sum;
    }
    // Whether a part lies inside an odd number of the others: its point sees those around it under
    // the solid angle 4 pi. (A. van Oosterom and J. Strackee, "The solid angle of a plane
    // triangle", 1983.)
    [[nodiscard]] bool is_hollow(std::uint32_t part) const {
        const Point& p = point_of(part);
        bool is_odd = false;
        for (std::uint32_t other = 0; other + 1 < firsts_.size(); ++other) {
            Real half_angle = 0;
            for (std::uint32_t k = firsts_[other]; other != part && k < firsts_[other + 1]; ++k) {
                const auto& v = surface_.triangles[order_[k]];
                const Point a = surface_.points[v[0]] - p;
                const Point b = surface_.points[v[1]] - p;
                const Point c = surface_.points[v[2]] - p;
                half_angle += std::atan2(a.dot(b.cross(c)),
                                         a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                             b.dot(c) * a.norm() + c.dot(a) * b.norm());
            }
            is_odd = is_odd != (std::abs(half_angle) > std::numbers::pi);
        }
        return is_odd;
    }
    [[nodiscard]] bool runs_along(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
        const Triangle3& v = surface_.triangles[t];
        return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
    }
    // Reverses a triangle: the edges from corners 0, 1, 2 become those from 1, 0, 2.
    void turn_over(std::uint32_t t) {
        std::swap(surface_.triangles[t][0], surface_.triangles[t][2]);
        std::swap(beside_[t][0], beside_[t][1]);
    }

    void expect_no_crossing() const {
        for (std::uint32_t s = 0; s < surface_.triangles.size(); ++s) {
            const Box box = box_of(surface_, surface_.triangles[s]);
            tree_->search([&](const Box& other) { return overlap(other, box); },
                          [](const Box&, const Box&) { return true; },
                          [&](std::uint32_t t) {
                              if (t != s) {
                                  expect_apart(s, t);
                              }
                          });
        }
    }
    // Throws if an edge of s that shares no vertex with t crosses t.
    void expect_apart(std::uint32_t s, std::uint32_t t) const {
        const Triangle3& of = surface_.triangles[t];
        const auto is_common = [&](std::uint32_t v) {
            return v == of[0] || v == of[1] || v == of[2];
        };
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t p = surface_.triangles[s][k];
            const std::uint32_t q = surface_.triangles[s][(k + 1) % 3];
            if (is_common(p) || is_common(q)) {
                continue;
            }
            const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                  std::uint32_t d) {
                return orientation(surface_.points[a], surface_.points[b], surface_.points[c],
                                   surface_.points[d]);
            };
            if (side(p, of[0], of[1], of[2]) * side(q, of[0], of[1], of[2]) >= 0) {
                continue;
            }
            const int x = side(p, q, of[0], of[1]);
            const int y = side(p, q, of[1], of[2]);
            const int z = side(p, q, of[2], of[0]);
            if ((x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0)) {
                refuse(surface_, "the surface crosses itself",
                       to_text(midpoint(surface_.points[p], surface_.points[q])),
                       "triangles " + std::to_string(std::min(s, t)) + " and " +
                           std::to_string(std::max(s, t)),
                       "surfaces whose triangles share only vertices and edges");
            }
        }
    }

    void find_normals() {
        face_normals_.reserve(surface_.triangles.size());
        vertex_normals_.assign(surface_.points.size(), Point::Zero());
        for (const auto& t : surface_.triangles) {
            const Point& a = surface_.points[t[0]];
            const Point normal = unit((surface_.points[t[1]] - a).cross(surface_.points[t[2]] - a));
            face_normals_.push_back(normal);
            for (std::uint32_t k = 0; k < 3; ++k) {
                vertex_normals_[t[k]] +=
                    angle_degrees(surface_.points[t[k]], surface_.points[t[(k + 1) % 3]],
                                  surface_.points[t[(k + 2) % 3]]) *
                    normal;
            }
        }
    }
    [[nodiscard]] Point normal_at(std::uint32_t t, const Foot& foot) const {
        if (foot.feature < 3) {
            return vertex_normals_[surface_.triangles[t][foot.feature]];
        }
        return foot.feature < 6 ? face_normals_[t] + face_normals_[beside_[t][foot.feature - 3]]
                                : face_normals_[t];
    }

    // C. Ericson, "Real-time collision detection" (2005), section 5.1.5.
    [[nodiscard]] Foot nearest(std::uint32_t t, const Point& p) const {
        const Point& a = surface_.points[surface_.triangles[t][0]];
        const Point& b = surface_.points[surface_.triangles[t][1]];
        const Point& c = surface_.points[surface_.triangles[t][2]];
        const Point ab = b - a;
        const Point ac = c - a;
        const Real d1 = ab.dot(p - a);
        const Real d2 = ac.dot(p - a);
        if (d1 <= 0 && d2 <= 0) {
            return {a, 0};
        }
        const Real d3 = ab.dot(p - b);
        const Real d4 = ac.dot(p - b);
        if (d3 >= 0 && d4 <= d3) {
            return {b, 1};
        }
        const Real vc = d1 * d4 - d3 * d2;
        if (vc <= 0 && d1 >= 0 && d3 <= 0) {
            return {a + d1 / (d1 - d3) * ab, 3};
        }
        const Real d5 = ab.dot(p - c);
        const Real d6 = ac.dot(p - c);
        if (d6 >= 0 && d5 <= d6) {
            return {c, 2};
        }
        const Real vb = d5 * d2 - d1 * d6;
        if (vb <= 0 && d2 >= 0 && d6 <= 0) {
            return {a + d2 / (d2 - d6) * ac, 5};
        }
        const Real va = d3 * d6 - d5 * d4;
        if (va <= 0 && d4 >= d3 && d5 >= d6) {
            return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 4};
        }
        const Real sum = va + vb + vc;
        return {a + vb / sum * ab + vc / sum * ac, 6};
    }

    TriangleSurface surface_;
    std::vector<std::array<std::uint32_t, 3>> beside_; ///< by triangle and corner
    std::vector<std::uint32_t> order_;                 ///< triangles, part by part
    std::vector<std::uint32_t> firsts_;                ///< of each part in `order_`, and the end
    std::unique_ptr<BoxTree> tree_;
    std::vector<Point> face_normals_;
    std::vector<Point> vertex_normals_; ///< of any length
};

} // namespace

Distance closed_surface(TriangleSurface surface, SurfaceFigures* figures) {
    const auto shared = std::make_shared<const SignedDistance>(std::move(surface));
    if (figures != nullptr) {
        *figures = shared->figures();
    }
    return [shared](const Point& p) { return (*shared)(p); };
}

} // namespace dsc3

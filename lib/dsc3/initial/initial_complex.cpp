// SPDX-License-Identifier: MIT
#include "dsc3/initial/initial_complex.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/initial/lattice.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/passes/interface_remeshing.h"
#include "dsc3/passes/repair.h"

#include <algorithm>
#include <cmath>

namespace dsc3 {

namespace {

// Longest edges near the interface before it is cut, in edge lengths; the cut makes them shorter.
constexpr Real longest_near = 1.5;
// A vertex snaps to a shape that is nearer than the first fraction of its shortest edge, if the
// quality of the tets around it stays above the second.
constexpr Real snap_distance = 0.3;
constexpr Real snap_quality = 0.15;
// Target quality of the improvement of the first complex.
constexpr Real start_quality = 0.35;

class Start {
public:
    Start(const Box& domain, std::span<const Shape> shapes, const InitialOptions& options)
        : shapes_(shapes), options_(options), complex_(initial::lattice(domain)) {}

    Complex run() {
        initial::refine(complex_, work_, [&](const std::array<Point, 4>& p) { return limit(p); });
        for (const Shape& shape : shapes_) {
            cut_out(shape);
        }
        improve();
        if (options_.renumber) {
            renumber(complex_);
        }
        return std::move(complex_);
    }

private:
    [[nodiscard]] Real limit(const std::array<Point, 4>& p) const {
        Real nearest = std::numeric_limits<Real>::infinity();
        for (const Shape& shape : shapes_) {
            for (const Point& q : p) {
                nearest = std::min(nearest, std::abs(shape.distance(q)));
            }
        }
        const Real h = options_.edge_length;
        return longest_near * h + options_.growth * std::max(Real(0), nearest - h);
    }

    // Projects p on the surface where the distance is 0, by Newton's method.
    [[nodiscard]] Point project(const Distance& distance, Point p) const {
        const Real e = 1e-5 * options_.edge_length;
        for (int i = 0; i < 4; ++i) {
            Point gradient;
            for (int k = 0; k < 3; ++k) {
                Point to = p;
                to[k] += e;
                Point from = p;
                from[k] -= e;
                gradient[k] = (distance(to) - distance(from)) / (2 * e);
            }
            const Real square = gradient.squaredNorm();
            if (!(square > 1e-6)) {
                break;
            }
            p -= distance(p) / square * gradient;
        }
        return p;
    }

    void cut_out(const Shape& shape) {
        evaluate(shape);
        snap(shape);
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            while (cut(shape, t)) { // the tet keeps its id, and one half
            }
        }
        // No tet after a cut, whether its id is old or new, has a crossing edge.
        bool is_seen = false;
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            if (is_inside(shape, t)) {
                complex_.phases[t] = shape.phase;
                is_seen = true;
            }
        }
        if (!is_seen) {
            throw InputError(
                {.what = "a shape is too small for the mesh",
                 .where = "initial_complex",
                 .value = "an edge length of " + dsc::to_text(options_.edge_length),
                 .allowed = "a shape inside the domain that is several edge lengths wide"});
        }
        mark();
        work_.rewiring.changed.clear();
    }

    void evaluate(const Shape& shape) {
        values_.resize(complex_.vertex_bound());
        shortest_.assign(complex_.vertex_bound(), std::numeric_limits<Real>::infinity());
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            values_[v] = shape.distance(complex_.at(v));
            if (!std::isfinite(values_[v])) {
                throw InputError({.what = "a distance is not finite",
                                  .where = "initial_complex, at " + to_text(complex_.at(v)),
                                  .value = dsc::to_text(values_[v]),
                                  .allowed = "finite distances everywhere in the domain"});
            }
            if (complex_.is_boundary(Vertex{v}) && values_[v] <= 0) {
                throw InputError({.what = "a shape reaches the sides of the domain",
                                  .where = "initial_complex, at " + to_text(complex_.at(v)),
                                  .value = "a distance of " + dsc::to_text(values_[v]),
                                  .allowed = "shapes that lie inside the domain"});
            }
        }
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            const auto& v = complex_.tets[t].v;
            expect_apart(t);
            for (const std::uint32_t a : v) {
                for (const std::uint32_t b : v) {
                    if (a != b) {
                        shortest_[a] =
                            std::min(shortest_[a],
                                     std::sqrt(squared_distance(complex_.at(a), complex_.at(b))));
                    }
                }
            }
        }
    }

    // Throws if a tet that the shape crosses has a vertex on the interface of an earlier shape.
    void expect_apart(std::uint32_t t) const {
        bool is_old = false;
        bool is_inside = false;
        bool is_outside = false;
        for (const std::uint32_t v : complex_.tets[t].v) {
            is_old = is_old || complex_.is_interface(Vertex{v});
            is_inside = is_inside || values_[v] <= 0;
            is_outside = is_outside || values_[v] >= 0;
        }
        if (is_old && is_inside && is_outside) {
            throw InputError(
                {.what = "two shapes are too close to each other",
                 .where = "initial_complex, at " + to_text(complex_.at(complex_.tets[t].v[0])),
                 .value = "less than two edge lengths",
                 .allowed = "shapes that are at least two edge lengths apart, outside or inside "
                            "each other"});
        }
    }

    void snap(const Shape& shape) {
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            if (!(std::abs(values_[v]) < snap_distance * shortest_[v]) ||
                (complex_.vertices[v].flags & (vertex_boundary | vertex_interface)) != 0) {
                continue;
            }
            const Point to = project(shape.distance, complex_.at(v));
            gather(complex_, v, work_.star);
            work_.quality.gather(complex_, work_.star);
            if (work_.quality.worst(to) > snap_quality) {
                complex_.set_position(Vertex{v}, to);
                values_[v] = 0;
            }
        }
    }

    // Cuts an edge of the tet that crosses the shape. Returns whether there was one.
    bool cut(const Shape& shape, std::uint32_t t) {
        const auto v = complex_.tets[t].v;
        for (std::uint32_t i = 0; i < 4; ++i) {
            for (std::uint32_t j = i + 1; j < 4; ++j) {
                if (!((values_[v[i]] < 0 && values_[v[j]] > 0) ||
                      (values_[v[i]] > 0 && values_[v[j]] < 0))) {
                    continue;
                }
                const Vertex made = edge_split(complex_, work_, {t, v[i], v[j]},
                                               crossing(shape.distance, v[i], v[j]));
                if (!made.is_valid()) {
                    throw InvariantError("initial_complex: an edge cannot be cut");
                }
                values_.resize(complex_.vertex_bound());
                values_[made.id] = 0;
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] Point crossing(const Distance& distance, std::uint32_t a, std::uint32_t b) const {
        const Point from = complex_.at(a);
        const Point way = complex_.at(b) - from;
        Real low = 0;
        Real high = 1;
        for (int i = 0; i < 40; ++i) {
            const Real middle = (low + high) / 2;
            const bool is_before = (distance(from + middle * way) < 0) == (values_[a] < 0);
            (is_before ? low : high) = middle;
        }
        // Keeps away from the ends, where the new tets would have no volume.
        return from + std::clamp((low + high) / 2, 1e-3, 1 - 1e-3) * way;
    }

    [[nodiscard]] bool is_inside(const Shape& shape, std::uint32_t t) const {
        Real sum = 0;
        Point centre = Point::Zero();
        for (const std::uint32_t v : complex_.tets[t].v) {
            sum += values_[v];
            centre += 0.25 * complex_.at(v);
        }
        return sum != 0 ? sum < 0 : shape.distance(centre) < 0;
    }

    void mark() {
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            for (std::uint32_t i = 0; i < 4; ++i) {
                const Corner other = complex_.tets[t].n[i];
                if (!is_border(other) && complex_.phase_at(other) != complex_.phases[t]) {
                    for (const std::uint32_t v : complex_.face(corner_of(t, i))) {
                        complex_.vertices[v].flags |= vertex_interface;
                    }
                }
            }
        }
    }

    void improve() {
        Options options;
        options.edge_length = options_.edge_length;
        options.insertion = [this](const Complex& complex, Workspace&, std::uint32_t a,
                                   std::uint32_t b) {
            return project_nearest(midpoint(complex.at(a), complex.at(b)));
        };
        Team team(1);
        PassState state{complex_, options, team};
        state.grow();
        state.find_interface();
        for (int round = 0; round < options_.improve_rounds; ++round) {
            remesh_interface(state);
            state.unfit.clear();
            for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
                if (complex_.is_alive(Tet{t}) && quality_of(complex_, t) < start_quality) {
                    state.unfit.push_back(t);
                }
            }
            repair_mesh(state, start_quality, Effort::more);
        }
    }
    [[nodiscard]] Point project_nearest(const Point& p) const {
        const Shape* nearest = nullptr;
        Real least = std::numeric_limits<Real>::infinity();
        for (const Shape& shape : shapes_) {
            if (const Real d = std::abs(shape.distance(p)); d < least) {
                least = d;
                nearest = &shape;
            }
        }
        if (nearest == nullptr) {
            return p;
        }
        const Point to = project(nearest->distance, p);
        return (to - p).norm() < 0.5 * options_.edge_length ? to : p;
    }

    std::span<const Shape> shapes_;
    const InitialOptions& options_;
    Complex complex_;
    Workspace work_;
    std::vector<Real> values_;
    std::vector<Real> shortest_;
};

} // namespace

Distance ball(const Point& centre, Real radius) {
    return [=](const Point& p) { return (p - centre).norm() - radius; };
}

Complex initial_complex(const Box& domain, std::span<const Shape> shapes,
                        const InitialOptions& options) {
    const Point size = domain.high - domain.low;
    if (!(size.minCoeff() > 0) || !size.allFinite()) {
        throw InputError({.what = "the domain has no volume",
                          .where = "initial_complex",
                          .value = to_text(domain.low) + " to " + to_text(domain.high),
                          .allowed = "finite corners, `high` above `low` in each coordinate"});
    }
    dsc::require(
        options.edge_length > size.maxCoeff() / 4096 && options.edge_length <= size.minCoeff() / 4,
        "edge_length", options.edge_length, "1/4096 of the longest side to 1/4 of the shortest");
    dsc::require(options.growth >= 0 && options.growth <= 2, "growth", options.growth, "0 to 2");
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!shapes[i].distance || shapes[i].phase == border_phase) {
            throw InputError({.what = "a shape has no distance function, or a reserved phase",
                              .where = "initial_complex, shape " + std::to_string(i),
                              .value = std::to_string(shapes[i].phase),
                              .allowed = "a function, and a phase below 4294967295"});
        }
    }
    return Start(domain, shapes, options).run();
}

} // namespace dsc3

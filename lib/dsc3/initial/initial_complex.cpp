// SPDX-License-Identifier: MIT
#include "dsc3/initial/initial_complex.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/initial/lattice.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/passes/interface_remeshing.h"
#include "dsc3/passes/repair.h"
#include "dsc3/queries/interface_star.h"

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
// The same for a vertex that stays on an earlier surface: otherwise a short edge would remain
// there, which the rules of strata then protect.
constexpr Real junction_quality = 0.05;
// A vertex that is nearer, in edge lengths, is on a surface.
constexpr Real on_surface = 1e-3;
constexpr Real junction_insertion = 0.01;
// Target quality of the improvement of the first complex.
constexpr Real start_quality = 0.35;

class Start {
public:
    Start(const Box& domain, std::span<const Shape> shapes, const InitialOptions& options)
        : shapes_(shapes), options_(options), complex_(initial::lattice(domain)) {}

    Complex run() {
        initial::refine(
            complex_, work_, [&](const std::array<Point, 4>& p) { return limit(p); },
            options_.max_tets);
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
    // A vertex that is not yet on the surfaces that meet there.
    struct Beside {
        std::uint32_t vertex;
        Point place;
        std::vector<const Shape*> surfaces;
    };

    [[nodiscard]] Real limit(const std::array<Point, 4>& p) const {
        Real nearest = std::numeric_limits<Real>::infinity();
        for (const Point& q : p) {
            Phase phase = exterior_phase;
            for (const Shape& shape : shapes_) {
                const Phase inside = phase_inside(shape, phase);
                if (inside == phase && !shape.divides.empty()) {
                    continue; // the surfaces around the phases that it divides are nearer
                }
                const Real distance = shape.distance(q);
                nearest = std::min(nearest, std::abs(distance));
                phase = distance < 0 ? inside : phase;
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
        for (bool is_done = false;
             !is_done;) { // a cut may give a lower id to a tet that is not cut
            is_done = true;
            for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
                while (is_within(shape, t) && cut(shape, t)) {
                    is_done = false;
                }
            }
        }
        // No tet after a cut, whether its id is old or new, has a crossing edge.
        bool is_seen = false;
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            if (is_within(shape, t) && is_inside(shape, t)) {
                complex_.phases[t] = phase_inside(shape, complex_.phases[t]);
                is_seen = true;
            }
        }
        if (!is_seen && !shape.divides.empty()) {
            throw InputError({.what = "a shape divides no phase",
                              .where = "initial_complex",
                              .value = "no tet inside it has phase " +
                                       std::to_string(shape.divides.front().from),
                              .allowed = "phases that earlier shapes have there"});
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

    // The phase of what lies inside the shape and had this phase before.
    [[nodiscard]] static Phase phase_inside(const Shape& shape, Phase phase) {
        if (shape.divides.empty()) {
            return shape.phase;
        }
        const auto change =
            std::find_if(shape.divides.begin(), shape.divides.end(),
                         [&](const PhaseChange& each) { return each.from == phase; });
        return change == shape.divides.end() ? phase : change->to;
    }
    // Whether the shape may change the phase of a tet.
    [[nodiscard]] bool is_within(const Shape& shape, std::uint32_t t) const {
        return shape.divides.empty() ||
               phase_inside(shape, complex_.phases[t]) != complex_.phases[t];
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
            if (!shape.divides.empty() && complex_.is_interface(Vertex{v}) && is_on(shape, v)) {
                values_[v] = 0; // another part of this surface has been cut there
            }
            if (complex_.is_boundary(Vertex{v}) && values_[v] <= 0 && shape.divides.empty()) {
                throw InputError({.what = "a shape reaches the sides of the domain",
                                  .where = "initial_complex, at " + to_text(complex_.at(v)),
                                  .value = "a distance of " + dsc::to_text(values_[v]),
                                  .allowed = "shapes that lie inside the domain"});
            }
        }
        for (std::uint32_t t = 1; t < complex_.tet_bound(); ++t) {
            const auto& v = complex_.tets[t].v;
            if (shape.divides.empty()) {
                expect_apart(t);
            }
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

    // Moves vertices onto the surface; those on earlier surfaces stay on them.
    void snap(const Shape& shape) {
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            if (!(std::abs(values_[v]) < snap_distance * shortest_[v]) ||
                complex_.is_boundary(Vertex{v}) ||
                (complex_.is_interface(Vertex{v}) && shape.divides.empty())) {
                continue;
            }
            surfaces_of(v);
            surfaces_.push_back(&shape);
            const Point to = project_on_all(complex_.at(v));
            gather(complex_, v, work_.star);
            work_.quality.gather(complex_, work_.star);
            const bool is_on_old = surfaces_.size() > 1;
            if (work_.quality.worst(to) > (is_on_old ? junction_quality : snap_quality)) {
                complex_.set_position(Vertex{v}, to);
                values_[v] = 0;
            }
        }
    }

    // Lists the shapes on whose surface an interface vertex lies.
    void surfaces_of(std::uint32_t v) {
        surfaces_.clear();
        if (complex_.is_interface(Vertex{v})) {
            for (const Shape& shape : shapes_) {
                if (is_on(shape, v)) {
                    surfaces_.push_back(&shape);
                }
            }
        }
    }
    [[nodiscard]] bool is_on(const Shape& shape, std::uint32_t v) const {
        return std::abs(shape.distance(complex_.at(v))) < on_surface * options_.edge_length;
    }
    // Projects p onto each of the listed surfaces in turn, until it stays where they meet.
    [[nodiscard]] Point project_on_all(Point p) const {
        for (int round = 0; round < (surfaces_.size() > 1 ? 30 : 1); ++round) {
            for (const Shape* shape : surfaces_) {
                p = project(shape->distance, p);
            }
        }
        return p;
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
                if (complex_.is_interface(made)) { // where the surfaces meet
                    surfaces_of_edge(v[i], v[j]);
                    surfaces_.push_back(&shape);
                    if (!nudge(complex_, work_, made, project_on_all(complex_.position(made)),
                               junction_insertion)) {
                        beside_.push_back({made.id, complex_.position(made), surfaces_});
                    }
                }
                return true;
            }
        }
        return false;
    }
    // Lists the shapes on whose surface both ends lie.
    void surfaces_of_edge(std::uint32_t a, std::uint32_t b) {
        surfaces_.clear();
        for (const Shape& shape : shapes_) {
            if (is_on(shape, a) && is_on(shape, b)) {
                surfaces_.push_back(&shape);
            }
        }
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

    // Marks the vertices of the interface; the shape may have covered a part of an earlier one.
    void mark() {
        for (VertexRecord& vertex : complex_.vertices) {
            vertex.flags &= ~static_cast<std::uint32_t>(vertex_interface);
        }
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
        options.insertion = [this](const Complex&, Workspace& work, std::uint32_t a,
                                   std::uint32_t b) { return place_between(work, a, b); };
        Team team;
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
            nudge_again();
        }
    }
    // The place of a new vertex on an edge of the interface: on all surfaces that meet there.
    Point place_between(Workspace& work, std::uint32_t a, std::uint32_t b) {
        const Point middle = midpoint(complex_.at(a), complex_.at(b));
        surfaces_of_edge(a, b);
        if (surfaces_.size() < 2) {
            return surfaces_.empty() ? project_nearest(middle) : project_on_all(middle);
        }
        gather(complex_, a, work.star);
        gather(complex_, work.star, work.interface_star);
        classify(work.interface_star);
        const StarEdge* const edge = work.interface_star.edge_to(b);
        if (edge == nullptr || !edge->is_on_curve()) { // a chord between two vertices of curves
            surfaces_ = {*std::min_element(
                surfaces_.begin(), surfaces_.end(), [&](const Shape* x, const Shape* y) {
                    return std::abs(x->distance(middle)) < std::abs(y->distance(middle));
                })};
        }
        return project_on_all(middle);
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

    // Vertices may reach their places when the tets around them have become better.
    void nudge_again() {
        std::erase_if(beside_, [&](Beside& each) {
            if (!complex_.is_interface(Vertex{each.vertex}) ||
                complex_.at(each.vertex) != each.place) {
                return true;
            }
            surfaces_ = each.surfaces;
            const bool arrives = nudge(complex_, work_, Vertex{each.vertex},
                                       project_on_all(each.place), junction_insertion);
            each.place = complex_.at(each.vertex);
            return arrives;
        });
    }

    std::span<const Shape> shapes_;
    const InitialOptions& options_;
    Complex complex_;
    Workspace work_;
    std::vector<Real> values_;
    std::vector<Real> shortest_;
    std::vector<const Shape*> surfaces_; ///< scratch
    std::vector<Beside> beside_;
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

// SPDX-License-Identifier: MIT
#include "dsc3/initial/initial_complex.h"

#include "dsc3/geometry/tet.h"
#include "dsc3/initial/lattice.h"
#include "dsc3/initial/surfaces.h"
#include "dsc3/operations/edge_split.h"
#include "dsc3/passes/interface_remeshing.h"
#include "dsc3/passes/repair.h"
#include "dsc3/passes/worst_tets.h"

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
// A vertex where surfaces meet moves to its place as long as the quality of its tets stays above
// this.
constexpr Real junction_insertion = 0.01;
// The farthest from a surface, in edge lengths, that a vertex may be to count as on it where no
// edge can be cut.
constexpr Real beside_surface = 0.1;
// Target quality of the improvement of the first complex.
constexpr Real start_quality = 0.35;

class Start {
public:
    Start(const Box& domain, std::span<const Shape> shapes, const InitialOptions& options)
        : shapes_(shapes), options_(options), complex_(initial::lattice(domain)),
          surfaces_(complex_, shapes, options.edge_length) {}

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
        initial::ShapeList surfaces;
    };

    [[nodiscard]] Real limit(const std::array<Point, 4>& p) const {
        Real nearest = std::numeric_limits<Real>::infinity();
        for (const Point& q : p) {
            nearest = std::min(nearest, surfaces_.distance(q));
        }
        const Real h = options_.edge_length;
        return longest_near * h + options_.growth * std::max(Real(0), nearest - h);
    }

    void cut_out(const Shape& shape) {
        evaluate(shape);
        snap(shape);
        for (bool is_done = false; !is_done;) {
            is_done = true; // unless a tet gets a lower id in a cut and is itself not cut yet
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
                complex_.phases[t] = initial::phase_inside(shape, complex_.phases[t]);
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

    // Whether the shape may change the phase of a tet.
    [[nodiscard]] bool is_within(const Shape& shape, std::uint32_t t) const {
        return shape.divides.empty() ||
               initial::phase_inside(shape, complex_.phases[t]) != complex_.phases[t];
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
            if (!shape.divides.empty() && complex_.is_interface(Vertex{v}) &&
                surfaces_.is_on(shape, v)) {
                values_[v] = 0; // another part of this surface has been cut there
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
                (complex_.is_interface(Vertex{v}) && shape.divides.empty())) {
                continue;
            }
            initial::ShapeList surfaces = surfaces_.at(v);
            surfaces.push_back(&shape);
            const std::uint32_t fixed = fixed_at(v);
            const Point to = surfaces_.project(surfaces, complex_.at(v), fixed);
            if (fixed != 0 && !surfaces_.is_on(surfaces, to)) {
                continue; // the surface does not meet this side, or edge of the domain, there
            }
            gather(complex_, v, work_.star);
            work_.quality.gather(complex_, work_.star);
            const bool is_on_old = surfaces.size() > 1;
            if (work_.quality.worst(to) > (is_on_old ? junction_quality : snap_quality)) {
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
                const Point place = crossing(shape.distance, v[i], v[j]);
                const Vertex made = edge_split(complex_, work_, {t, v[i], v[j]}, place);
                if (!made.is_valid()) {
                    count_as_on(shape, place, v[i], v[j]);
                    return true;
                }
                values_.resize(complex_.vertex_bound());
                values_[made.id] = 0;
                if (complex_.is_interface(made)) { // where the surfaces meet
                    initial::ShapeList surfaces = surfaces_.between(v[i], v[j]);
                    surfaces.push_back(&shape);
                    const Point to =
                        surfaces_.project(surfaces, complex_.position(made), fixed_at(made.id));
                    if (!nudge(complex_, work_, made, to, junction_insertion)) {
                        beside_.push_back({made.id, complex_.position(made), std::move(surfaces)});
                    }
                }
                return true;
            }
        }
        return false;
    }

    // Where the tets around an edge are too flat to be cut, the end beside the surface counts as on
    // it, and moves there when they have become better.
    void count_as_on(const Shape& shape, const Point& place, std::uint32_t a, std::uint32_t b) {
        const auto off = [&](std::uint32_t v) { return (complex_.at(v) - place).norm(); };
        const std::uint32_t nearer = off(a) <= off(b) ? a : b;
        if (!(off(nearer) < beside_surface * options_.edge_length)) {
            throw InputError(
                {.what = "an edge that a surface crosses cannot be cut",
                 .where = "initial_complex, at " + to_text(place),
                 .value = "an edge length of " + dsc::to_text(options_.edge_length),
                 .allowed = "a finer mesh, or surfaces farther from each other there"});
        }
        values_[nearer] = 0;
        auto known = std::find_if(beside_.begin(), beside_.end(),
                                  [&](const Beside& each) { return each.vertex == nearer; });
        if (known == beside_.end()) {
            known = beside_.insert(known, {nearer, complex_.at(nearer), surfaces_.at(nearer)});
        }
        known->surfaces.push_back(&shape);
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

    [[nodiscard]] std::uint32_t fixed_at(std::uint32_t v) const {
        return complex_.fixed_along(v, v);
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
                                   std::uint32_t b) { return surfaces_.place_between(work, a, b); };
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
            improve_worst_tets(state, WorstTets::all);
            nudge_again();
        }
    }
    // Vertices may reach their places when the tets around them have become better.
    void nudge_again() {
        std::erase_if(beside_, [&](Beside& each) {
            if (!complex_.is_interface(Vertex{each.vertex}) ||
                complex_.at(each.vertex) != each.place) {
                return true;
            }
            const bool arrives =
                nudge(complex_, work_, Vertex{each.vertex},
                      surfaces_.project(each.surfaces, each.place, fixed_at(each.vertex)),
                      junction_insertion);
            each.place = complex_.at(each.vertex);
            return arrives;
        });
    }

    std::span<const Shape> shapes_;
    const InitialOptions& options_;
    Complex complex_;
    initial::Surfaces surfaces_;
    Workspace work_;
    std::vector<Real> values_;
    std::vector<Real> shortest_;
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
        const bool is_reserved =
            shapes[i].phase == border_phase ||
            std::any_of(shapes[i].divides.begin(), shapes[i].divides.end(),
                        [](const PhaseChange& change) { return change.to == border_phase; });
        if (!shapes[i].distance || is_reserved) {
            throw InputError({.what = "a shape has no distance function, or a reserved phase",
                              .where = "initial_complex, shape " + std::to_string(i),
                              .value = is_reserved ? std::to_string(border_phase) : "no function",
                              .allowed = "a function, and phases below 4294967295"});
        }
    }
    return Start(domain, shapes, options).run();
}

} // namespace dsc3

// SPDX-License-Identifier: MIT
#include "reference/algorithm/dsc.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "reference/algorithm/quality.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace dsc::reference {

namespace {

/// The vertices moved by the velocity, without locked ones and those on the submesh boundary
/// (thesis, section 6.4).
std::set<Vertex> moving_vertices(const Complex& K, const SimplexSet& I, Moving moving) {
    std::set<Vertex> result = I.vertices;
    if (moving == Moving::interior_too) {
        for (const auto& [t, phase] : K.phases()) {
            if (phase != exterior_phase)
                result.insert(t.v.begin(), t.v.end());
        }
    }
    std::erase_if(result,
                  [&](Vertex v) { return K.locked.contains(v) || K.is_submesh_boundary(v); });
    return result;
}

/// Section 6.4: a vertex of the domain boundary may only move such that the domain keeps its shape.
/// Between two collinear boundary edges it slides; in a corner it stays.
Point<double> along_boundary(const Complex& K, Vertex v, const Point<double>& destination) {
    const auto sides = K.straight_boundary(v);
    if (!sides)
        return K.coord(v);
    const Point<double>& a = K.coord((*sides)[0]);
    const Point<double>& b = K.coord((*sides)[1]);
    const Point<double> direction = (b - a).normalized();
    const Point<double> p = K.coord(v) + direction.dot(destination - K.coord(v)) * direction;
    // On a slanted side rounding may move the point off the side: then the vertex stays.
    return orientation(a, p, b) == 0 ? p : K.coord(v);
}

struct Targets {
    Destinations destinations;
    std::set<Vertex> held; ///< vertices whose velocity is not finite
    double furthest = 0;   ///< the largest distance to a destination
};

Targets targets(const Complex& K, const std::set<Vertex>& moving, const Velocity& velocity,
                double time, double dt, Integrator integrator) {
    Targets result;
    for (Vertex v : moving) {
        Point<double> p = advect(velocity, K.coord(v), time, dt, integrator);
        if (!p.allFinite()) {
            result.held.insert(v);
            continue;
        }
        if (K.is_boundary(v)) {
            p = along_boundary(K, v, p);
        }
        if (const double way = distance(K.coord(v), p); way > 0) {
            result.destinations.emplace(v, p);
            result.furthest = std::max(result.furthest, way);
        }
    }
    return result;
}

void update_phases(Complex& K, const PassOptions& options, StepCounts& counts) {
    for (const auto& p : phases(K))
        phase_coarsening(K, p, options, counts);
    for (const auto& p : phases(K))
        phase_refinement(K, p, options, counts);
    optimization(K, options, counts);
    smoothing(K, options, counts);
}

double worst_quality(const Complex& K) {
    double worst = 1;
    for (const auto& item : K.phases()) {
        worst = std::min(worst, quality(K, item.first));
    }
    return worst;
}

} // namespace

void dsc(Complex& K, const SimplexSet& I, Destinations& destinations, const Options& options,
         StepCounts& counts) {
    const PassOptions& passes = options.passes;
    bool last = false;
    for (int iteration = 1; !last; ++iteration) {
        const std::size_t before = destinations.size();
        movement(destinations, K);
        counts.moved += before - destinations.size();
        ++counts.iterations;
        last = destinations.empty() || iteration >= options.max_iterations;
        // The thesis does interface coarsening and refinement in every iteration. A new vertex
        // between one that has arrived and one that has not would belong to no single time, so
        // interface updates wait until all vertices have arrived. (There is no InterfaceSmoothing,
        // because it would move the interface where the velocity did not.)
        if (last) {
            interface_coarsening(K, I, passes, counts);
            interface_refinement(K, I, passes, counts);
        }
        update_phases(K, passes, counts);
    }
    // Q^K is still too low: all vertices have arrived, but triangles that the last updates made
    // poor may be repaired by further updates. (Not all can be repaired: between two parts of the
    // interface there is no free edge.)
    double worst = worst_quality(K);
    for (int i = 0; i < options.max_repairs && worst < passes.poor_quality; ++i) {
        update_phases(K, passes, counts);
        ++counts.iterations;
        const double before = std::exchange(worst, worst_quality(K));
        if (!(worst > before)) {
            break;
        }
    }
}

StepCounts step(Complex& K, const Velocity& velocity, double time, double dt,
                const Options& options) {
    const std::string where = "reference::step";
    if (!std::isfinite(time) || !std::isfinite(dt)) {
        throw InputError({.what = "the time or the time step is not finite",
                          .where = where,
                          .value = std::to_string(time) + ", " + std::to_string(dt),
                          .allowed = "finite numbers"});
    }
    if (!(options.passes.edge_length > 0) || !(options.substep > 0)) {
        throw InputError({.what = "the edge length or the sub-step is not positive",
                          .where = where,
                          .value = std::to_string(options.passes.edge_length) + ", " +
                                   std::to_string(options.substep),
                          .allowed = "above 0"});
    }
    const double reach = options.substep * options.passes.edge_length;
    StepCounts counts;
    std::set<Vertex> unreached;
    for (double done = 0; done < 1;) {
        const SimplexSet I = K.interface();
        const std::set<Vertex> moving = moving_vertices(K, I, options.moving);
        // Divides the rest of the step into the fewest equal parts that keep every displacement
        // within reach.
        double parts = 1;
        const double rest = (1 - done) * dt;
        Targets next = targets(K, moving, velocity, time + done * dt, rest, options.integrator);
        while (next.furthest > reach) {
            parts = std::max(parts + 1, std::ceil(parts * next.furthest / reach));
            if (!(parts + static_cast<double>(counts.substeps) <= options.max_substeps)) {
                throw InputError({.what = "a vertex moves too far in one step",
                                  .where = where,
                                  .value = std::to_string(next.furthest),
                                  .allowed = "at most " + std::to_string(options.max_substeps) +
                                             " sub-steps of " + std::to_string(reach)});
            }
            next = targets(K, moving, velocity, time + done * dt, rest / parts, options.integrator);
        }
        dsc(K, I, next.destinations, options, counts);
        unreached.insert(next.held.begin(), next.held.end());
        for (const auto& item : next.destinations)
            unreached.insert(item.first);
        ++counts.substeps;
        done = parts == 1 ? 1 : done + (1 - done) / parts;
    }
    counts.unreached = unreached.size();
    return counts;
}

} // namespace dsc::reference

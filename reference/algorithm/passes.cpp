// SPDX-License-Identifier: MIT
#include "reference/algorithm/passes.h"

#include "dsc/base/verdict.h"
#include "reference/algorithm/quality.h"
#include "reference/algorithm/selection.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"
#include "reference/operations/edge_collapse.h"
#include "reference/operations/edge_flip.h"
#include "reference/operations/edge_split.h"
#include "reference/operations/laplacian_smoothing.h"
#include "reference/operations/local_retriangulation.h"
#include "reference/operations/loop_subdivision.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace dsc::reference {

namespace {

// After a retriangulation the patch has fewer triangles. If their mean area is above this fraction
// of the target, they would soon be refined again.
constexpr double patch_mean_area = 0.5;

// An interface edge that a collapse makes longer must stay below this fraction of the threshold of
// splits.
constexpr double split_margin = 0.95;

/// The area of `t` relative to the target.
double relative_area(const Complex& K, const TriangleKey& t, Phase p, const PassOptions& options) {
    double h = options.edge_length;
    if (options.phase_edge_length) {
        const Point<double> centre = (K.coord(t.v[0]) + K.coord(t.v[1]) + K.coord(t.v[2])) / 3.0;
        h = options.phase_edge_length(p, centre);
    }
    return area(K, t) / (0.25 * std::numbers::sqrt3 * h * h);
}

/// The vertex after `v` along the interface, coming from `e`; none at a junction or an end.
std::optional<Vertex> next_on_interface(const Complex& K, const EdgeKey& e, Vertex v) {
    std::optional<Vertex> next;
    for (const EdgeKey& f : K.edges_at(v)) {
        if (f != e && K.is_interface(f)) {
            if (next)
                return std::nullopt;
            next = f.v[0] == v ? f.v[1] : f.v[0];
        }
    }
    return next;
}

double distance_to_segment(const Point<double>& p, const Point<double>& a, const Point<double>& b) {
    const double squared = (b - a).squaredNorm();
    const double s = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    return distance(p, a + s * (b - a));
}

/// Removes the end of a short interface edge whose removal changes the curve less. Algorithm 7.7
/// would remove the end with the smaller number, and lose area wherever the curve bends.
Verdict coarsen_interface(const EdgeKey& e, Complex& K, const PassOptions& options) {
    std::vector<std::pair<double, Vertex>> ends;
    for (const auto& [v, w] : {std::pair{e.v[0], e.v[1]}, std::pair{e.v[1], e.v[0]}}) {
        const std::optional<Vertex> u = next_on_interface(K, e, v);
        if (!u || *u == w)
            continue;
        const double deviation = distance_to_segment(K.coord(v), K.coord(*u), K.coord(w));
        if (deviation < options.interface_deviation * options.edge_length &&
            distance(K.coord(*u), K.coord(w)) <
                split_margin * options.interface_split * options.edge_length) {
            ends.emplace_back(deviation, v);
        }
    }
    std::ranges::sort(ends);
    Verdict verdict = Verdict::on_interface;
    for (const auto& end : ends) {
        verdict = collapse_end(e, end.second, K);
        if (verdict == Verdict::legal)
            break;
    }
    return verdict;
}

Verdict refine_interface(const EdgeKey& e, Complex& K, const PassOptions& options) {
    const auto [v1, v2] = e.v;
    const std::optional<Vertex> v0 = next_on_interface(K, e, v1);
    const std::optional<Vertex> v3 = next_on_interface(K, e, v2);
    // Not on the mesh boundary, where the domain must keep its shape, and not beside junctions,
    // where there is no fourth point.
    if (options.interface_point && v0 && v3 && !K.is_boundary(e)) {
        const Point<double> m =
            options.interface_point(K.coord(*v0), K.coord(v1), K.coord(v2), K.coord(*v3));
        if (edge_split(e, K, m) == Verdict::legal)
            return Verdict::legal;
    }
    return edge_split(e, K);
}

/// The quality of `t` if its vertex `v` were at `p`.
double quality_if_moved(const Complex& K, const TriangleKey& t, Vertex v, const Point<double>& p) {
    std::array<Point<double>, 3> x;
    std::ranges::transform(t.v, x.begin(), [&](Vertex u) { return u == v ? p : K.coord(u); });
    return quality(x[0], x[1], x[2]);
}

/// The smallest quality around `v` after its collapse into `w`; 0 if a triangle would invert.
double quality_if_collapsed(const Complex& K, Vertex v, Vertex w) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const TriangleKey& t : K.triangles_at(v)) {
        if (has_vertex(t, w))
            continue;
        if (orientation_if(K, t, v, K.coord(w)) <= 0)
            return 0;
        smallest = std::min(smallest, quality_if_moved(K, t, v, K.coord(w)));
    }
    return smallest;
}

/// Collapses the edge of a poor triangle that leaves the best star, if that is better than the
/// present one. The coarsening of the thesis, LocalRetriangulation, is illegal at the interface,
/// where triangles become poor, and EdgeCollapse alone does not consider the quality.
Verdict collapse_poor(const TriangleKey& t, Complex& K) {
    struct Candidate {
        double quality;
        EdgeKey e;
        Vertex v;
    };
    std::vector<Candidate> candidates;
    for (const EdgeKey& e : edges_of(t)) {
        if (K.is_constrained(e))
            continue;
        for (std::size_t i = 0; i < 2; ++i) {
            const double q = quality_if_collapsed(K, e.v[i], e.v[1 - i]);
            if (q > star_quality(K, e.v[i]))
                candidates.push_back({q, e, e.v[i]});
        }
    }
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::quality);
    Verdict verdict = Verdict::no_gain;
    for (const Candidate& c : candidates) {
        verdict = collapse_end(c.e, c.v, K);
        if (verdict == Verdict::legal)
            break;
    }
    return verdict;
}

/// The longest edge of `t` that is neither on the interface nor on the boundary.
std::optional<EdgeKey> longest_free_edge(const Complex& K, const TriangleKey& t) {
    std::optional<EdgeKey> longest;
    for (const EdgeKey& e : edges_of(t)) {
        if (!K.is_constrained(e) && (!longest || length(K, e) > length(K, *longest)))
            longest = e;
    }
    return longest;
}

/// The smallest quality of the triangles of `e`, before and after a split at its midpoint.
std::pair<double, double> quality_if_split(const Complex& K, const EdgeKey& e) {
    const Point<double> m = compute_midpoint(K.coord(e.v[0]), K.coord(e.v[1]));
    double before = std::numeric_limits<double>::infinity();
    double after = before;
    for (const TriangleKey& t : K.triangles_at(e)) {
        before = std::min(before, quality(K, t));
        for (Vertex v : e.v)
            after = std::min(after, quality_if_moved(K, t, v, m));
    }
    return {before, after};
}

/// Splits the longest free edge of a poor triangle that no collapse could improve: one with a short
/// edge on the interface. This grades the mesh beside the interface.
Verdict split_poor(const TriangleKey& t, Complex& K) {
    const std::optional<EdgeKey> e = longest_free_edge(K, t);
    if (!e)
        return Verdict::on_interface;
    const auto [before, after] = quality_if_split(K, *e);
    return after > before ? edge_split(*e, K) : Verdict::no_gain;
}

} // namespace

Phases phases(const Complex& K) {
    Phases P;
    for (const auto& [t, p] : K.phases())
        P[p].push_back(t);
    return P;
}

void interface_coarsening(Complex& K, const SimplexSet& I, const PassOptions& options,
                          PassCounts& counts) {
    const Measure<EdgeKey> Q = [&](const EdgeKey& e) { return length(K, e); };
    const double threshold = options.interface_collapse * options.edge_length;
    counts.collapses += mesh_update(
        BelowThreshold<EdgeKey>(I.edges, Q, threshold, K),
        [&](const EdgeKey& e, Complex& complex) { return coarsen_interface(e, complex, options); },
        K);
}

void interface_refinement(Complex& K, const SimplexSet& I, const PassOptions& options,
                          PassCounts& counts) {
    const Measure<EdgeKey> Q = [&](const EdgeKey& e) { return -length(K, e); };
    const double threshold = -options.interface_split * options.edge_length;
    counts.splits += mesh_update(
        BelowThreshold<EdgeKey>(I.edges, Q, threshold, K),
        [&](const EdgeKey& e, Complex& complex) { return refine_interface(e, complex, options); },
        K);
}

void phase_coarsening(Complex& K, const Phases::value_type& p, const PassOptions& options,
                      PassCounts& counts) {
    const Phase phase = p.first;
    const auto& triangles = p.second;
    const Measure<TriangleKey> Q_size = [&](const TriangleKey& t) {
        return relative_area(K, t, phase, options);
    };
    counts.retriangulations += mesh_update(
        BelowThreshold<TriangleKey>(triangles, Q_size, options.small_area, K),
        [&](const TriangleKey& t, Complex& complex) {
            const SimplexSet patch = filter(2, star(complex, closure(t)));
            double sum = 0;
            for (const TriangleKey& s : patch.triangles)
                sum += Q_size(s);
            return sum < patch_mean_area * static_cast<double>(patch.size())
                       ? local_retriangulation(t, complex)
                       : Verdict::no_gain;
        },
        K);

    const Measure<TriangleKey> Q_shape = [&](const TriangleKey& t) { return quality(K, t); };
    counts.collapses += mesh_update(
        BelowThreshold<TriangleKey>(triangles, Q_shape, options.poor_quality, K), collapse_poor, K);
}

void phase_refinement(Complex& K, const Phases::value_type& p, const PassOptions& options,
                      PassCounts& counts) {
    const Phase phase = p.first;
    const auto& triangles = p.second;
    const Measure<TriangleKey> Q = [&](const TriangleKey& t) {
        return -relative_area(K, t, phase, options);
    };
    const auto op = [&](const TriangleKey& t, Complex& complex) {
        Verdict verdict = loop_subdivision(t, complex);
        if (verdict == Verdict::legal) {
            ++counts.subdivisions;
        } else if (verdict == Verdict::on_interface) {
            // Section 6.5 forbids LoopSubdivision at the interface, and the thesis keeps such large
            // triangles: behind a moving interface they would grow without bound.
            const std::optional<EdgeKey> e = longest_free_edge(complex, t);
            verdict = e ? edge_split(*e, complex) : verdict;
            counts.splits += verdict == Verdict::legal ? 1U : 0U;
        }
        return verdict;
    };
    mesh_update(BelowThreshold<TriangleKey>(triangles, Q, -options.large_area, K), op, K);
    counts.splits += mesh_update(BelowThreshold<TriangleKey>(
                                     triangles, [&](const TriangleKey& t) { return quality(K, t); },
                                     options.poor_quality, K),
                                 split_poor, K);
}

void optimization(Complex& K, const PassOptions& options, PassCounts& counts) {
    // One sweep replaces the loop over the phases: EdgeFlip refuses edges on the interface.
    const Measure<EdgeKey> Q = [&](const EdgeKey& e) { return delaunay(K, e); };
    for (int sweep = 0; sweep < options.flip_sweeps; ++sweep) {
        std::vector<EdgeKey> edges;
        edges.reserve(K.edges().size());
        for (const auto& entry : K.edges()) {
            edges.push_back(entry.first);
        }
        const std::size_t flips =
            mesh_update(BelowThreshold<EdgeKey>(edges, Q, -options.flip_slack, K), edge_flip, K);
        counts.flips += flips;
        if (flips == 0)
            break;
    }
}

void smoothing(Complex& K, const PassOptions& options, PassCounts& counts) {
    // One sweep over all phases, as above.
    const Measure<Vertex> Q = [&](const Vertex& v) { return star_quality(K, v); };
    counts.smoothed +=
        mesh_update(BelowThreshold<Vertex>(K.vertices(), Q, options.smoothing_quality, K),
                    laplacian_smoothing, K);
}

} // namespace dsc::reference

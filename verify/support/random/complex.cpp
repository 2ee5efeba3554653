// SPDX-License-Identifier: MIT
#include "complex.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace dsc::test {

std::uint64_t Random::bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

std::uint32_t Random::below(std::uint32_t bound) {
    return static_cast<std::uint32_t>(((bits() >> 32U) * bound) >> 32U);
}

double Random::unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

template <class Real>
std::vector<Point<Real>> random_points(Random& random, const RandomComplexOptions& options) {
    std::set<std::pair<Real, Real>> places; // distinct points, sorted for the sweep
    const Real offset = options.at_resolution && options.grid > 0
                            ? 1 / std::numeric_limits<Real>::epsilon()
                            : Real(0);
    for (std::uint32_t tries = 0; tries < 100 * options.points && places.size() < options.points;
         ++tries) {
        const auto draw = [&] {
            return options.grid > 0 ? offset + static_cast<Real>(random.below(options.grid))
                                    : static_cast<Real>(random.unit());
        };
        const Real x = draw();
        places.insert({x, draw()});
    }
    std::vector<Point<Real>> points;
    for (const auto& [x, y] : places) {
        points.push_back({x, y});
    }
    return points;
}

// The sweep: sorted points join the convex hull one by one, each connected by all edges it sees.
// Collinear points on the hull stay on it. Empty if all points are collinear.
template <class Real>
std::vector<Triple> triangulate(const std::vector<Point<Real>>& points) {
    const auto side = [&](Index a, Index b, Index c) {
        return orientation<Real>(points[a], points[b], points[c]);
    };
    const auto count = static_cast<Index>(points.size());
    Index apex = 2;
    while (apex < count && side(0, 1, apex) == 0) {
        ++apex;
    }
    if (apex >= count) {
        return {};
    }
    std::vector<Triple> triangles;
    const bool left = side(0, 1, apex) > 0;
    std::vector<Index> hull; // counter-clockwise
    for (Index i = 0; i < apex; ++i) {
        hull.push_back(i);
        if (i > 0) {
            triangles.push_back({i - 1, i, apex});
        }
    }
    if (!left) {
        std::reverse(hull.begin(), hull.end());
    }
    hull.push_back(apex);
    for (Index p = apex + 1; p < count; ++p) {
        const std::size_t n = hull.size();
        const auto sees = [&](std::size_t i) {
            return side(hull[i % n], hull[(i + 1) % n], p) < 0;
        };
        std::size_t first = 0;
        while (!(sees(first) && !sees(first + n - 1))) {
            ++first;
        }
        std::vector<Index> grown{hull[first % n], p};
        std::size_t i = first;
        for (; sees(i); ++i) {
            triangles.push_back({hull[(i + 1) % n], hull[i % n], p});
        }
        for (; i % n != first % n; ++i) {
            grown.push_back(hull[i % n]);
        }
        hull = std::move(grown);
    }
    return triangles;
}

template <class Real>
Complex<Real> build(const std::vector<Point<Real>>& points, const std::vector<Triple>& triangles) {
    const std::vector<Phase> phases(triangles.size(), exterior_phase);
    return make_complex<Real>(points, triangles, phases);
}

// Removes triangles as long as the rest is a manifold, which makes dents, holes and separate
// pieces.
template <class Real>
std::vector<Triple> punch_holes(Random& random, const std::vector<Point<Real>>& points,
                                std::vector<Triple> triangles, double share) {
    const auto tries = static_cast<int>(share * static_cast<double>(triangles.size()));
    for (int i = 0; i < tries && triangles.size() > 1; ++i) {
        std::vector<Triple> fewer = triangles;
        fewer.erase(fewer.begin() + random.below(static_cast<std::uint32_t>(fewer.size())));
        try {
            build(points, fewer);
            triangles = std::move(fewer);
        } catch (const InputError&) {
            // The triangle stays, because a vertex would have two fans.
        }
    }
    return triangles;
}

template <class Real>
void scramble(Random& random, Complex<Real>& complex, std::uint32_t times) {
    for (std::uint32_t i = 0; i < times; ++i) {
        const Triangle t{random.below(complex.triangle_bound())};
        if (!complex.is_alive(t)) {
            continue;
        }
        const Edge e = complex.edge(corner_of(t.id, random.below(3)));
        const std::uint32_t what = random.below(10);
        if (what < 7) {
            edge_flip(complex, e);
        } else if (what < 8) {
            edge_split(complex, e);
        } else {
            edge_collapse(complex, e);
        }
    }
}

template <class Real>
void give_phases(Random& random, Complex<Real>& complex, const RandomComplexOptions& options) {
    struct Seed {
        double x, y;
        Phase phase;
    };
    const double size = options.grid > 0 ? options.grid : 1;
    const double origin = options.at_resolution && options.grid > 0
                              ? 1 / static_cast<double>(std::numeric_limits<Real>::epsilon())
                              : 0;
    std::vector<Seed> seeds;
    for (std::uint32_t i = 0; i < 2 + options.phases; ++i) {
        const double x = origin + size * random.unit();
        seeds.push_back({x, origin + size * random.unit(), random.below(options.phases)});
    }
    for (const Triangle t : triangles(complex)) {
        Phase phase = exterior_phase;
        switch (options.pattern) {
        case PhasePattern::exterior: break;
        case PhasePattern::interior: phase = 1; break;
        case PhasePattern::salt: phase = random.below(options.phases); break;
        case PhasePattern::clustered: {
            double nearest = std::numeric_limits<double>::max();
            const auto [a, b, c] = complex.vertices_of(t);
            const Point<double> centre =
                (complex.position(a) + complex.position(b) + complex.position(c))
                    .template cast<double>() /
                3;
            for (const Seed& seed : seeds) {
                const double d = (centre - Point<double>(seed.x, seed.y)).squaredNorm();
                if (d < nearest) {
                    nearest = d;
                    phase = seed.phase;
                }
            }
            break;
        }
        }
        complex.set_phase(t, phase);
    }
}

} // namespace

template <class Real>
Complex<Real> random_complex(std::uint64_t seed, const RandomComplexOptions& options) {
    Random random(seed);
    std::vector<Point<Real>> points;
    std::vector<Triple> triangles;
    while (triangles.empty()) {
        points = random_points<Real>(random, options);
        triangles = triangulate(points);
    }
    triangles = punch_holes(random, points, std::move(triangles), options.holes);
    // Ids are shuffled, because in the order of the sweep "smallest id" would mean "leftmost".
    std::vector<Index> name(points.size());
    for (Index i = 0; i < name.size(); ++i) {
        name[i] = i;
        std::swap(name[i], name[random.below(i + 1)]);
    }
    std::vector<Point<Real>> named(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        named[name[i]] = points[i];
    }
    for (Triple& t : triangles) {
        t = {name[t[0]], name[t[1]], name[t[2]]};
    }
    Complex<Real> complex = build(named, triangles);
    scramble(random, complex, options.scramble);
    give_phases(random, complex, options);
    for (const Vertex v : vertices(complex)) {
        if (random.chance(options.locked)) {
            complex.set_locked(v, true);
        }
    }
    return complex;
}

RandomComplexOptions random_options(std::uint64_t seed, std::uint32_t max_points) {
    Random random(~seed);
    RandomComplexOptions options;
    options.points = 3 + random.below(max_points - 2);
    options.grid = random.chance(0.5) ? 0 : 8U << random.below(3);
    options.at_resolution = options.grid > 0 && random.chance(0.2);
    constexpr std::uint32_t patterns = phase_pattern_names.size();
    options.pattern = phase_pattern_names.at(random.below(patterns)).value;
    options.phases = 2 + random.below(3);
    // A rounded midpoint of a boundary edge may lie outside, in a dent that is thinner than the
    // rounding error.
    const bool convex = options.at_resolution || random.chance(0.5);
    options.holes = convex ? 0 : 0.4 * random.unit();
    options.scramble = random.below(5 * options.points);
    options.locked = random.chance(0.5) ? 0 : 0.3 * random.unit();
    return options;
}

template <class Real>
std::vector<std::uint32_t> random_labels(std::uint64_t seed, const Complex<Real>& complex) {
    Random random(seed + 0x5bf03635U);
    std::vector<std::uint32_t> labels(complex.vertex_bound(), 0);
    const std::uint32_t kind = random.below(3);
    const auto centre = complex.position(Vertex{random.below(complex.vertex_bound())});
    const double a = 2 * random.unit() - 1;
    const double b = 2 * random.unit() - 1;
    Point<double> low(1e300, 1e300);
    Point<double> high(-1e300, -1e300);
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const Point<double> p = complex.position(Vertex{v}).template cast<double>();
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double radius = (0.3 + 0.4 * random.unit()) * (high - low).norm();
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const Point<double> d = (complex.position(Vertex{v}) - centre).template cast<double>();
        const bool owned = kind == 0   ? a * d.x() + b * d.y() >= 0
                           : kind == 1 ? d.norm() < radius
                                       : random.chance(0.9);
        labels[v] = owned ? 1 : 0;
    }
    return labels;
}

template Complex<double> random_complex(std::uint64_t, const RandomComplexOptions&);
template Complex<float> random_complex(std::uint64_t, const RandomComplexOptions&);
template std::vector<std::uint32_t> random_labels(std::uint64_t, const Complex<double>&);
template std::vector<std::uint32_t> random_labels(std::uint64_t, const Complex<float>&);

} // namespace dsc::test

// SPDX-License-Identifier: MIT
#include "flows/growing_discs.h"

#include "dsc/complex/ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace dsc::scenes {

namespace {

constexpr int parts = 4; // parts of each side of a triangle, within which fronts count as straight

using Corners = std::array<Point<double>, 3>;

// The time by which another phase has reached a point earlier than the triangle's own phase;
// positive where the triangle's phase is wrong. A piecewise smooth function whose slope is at most
// 2.
double earlier(const GrowingDiscs& discs, double time, Phase phase, const Point<double>& p) {
    double own = phase == exterior_phase ? time : discs.arrival(phase - 1U, p);
    double first = phase == exterior_phase ? std::numeric_limits<double>::infinity() : time;
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        if (i + 1 != phase) {
            first = std::min(first, discs.arrival(i, p));
        }
    }
    return own - first;
}

double area_of(const Corners& c) {
    const Point<double> a = c[1] - c[0];
    const Point<double> b = c[2] - c[0];
    return (a.x() * b.y() - a.y() * b.x()) / 2;
}

// The area where the linear function with these values at the corners is positive.
double positive_area(const Corners& c, const std::array<double, 3>& f) {
    const auto positive = std::ranges::count_if(f, [](double value) { return value > 0; });
    if (positive == 0 || positive == 3) {
        return positive == 0 ? 0 : area_of(c);
    }
    std::size_t apart = 0; // the corner whose sign differs from the other two
    while ((f[apart] > 0) != (positive == 1)) {
        ++apart;
    }
    const double g = f[(apart + 1) % 3];
    const double k = f[(apart + 2) % 3];
    const double tip = area_of(c) * (f[apart] / (f[apart] - g)) * (f[apart] / (f[apart] - k));
    return positive == 1 ? tip : area_of(c) - tip;
}

double wrong_area(const GrowingDiscs& discs, double time, Phase phase, const Corners& c) {
    const double size =
        std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
    const double value = earlier(discs, time, phase, (c[0] + c[1] + c[2]) / 3);
    if (std::abs(value) > 2 * size) {
        return value > 0 ? area_of(c) : 0;
    }
    const auto at = [&](int i, int j) -> Point<double> {
        return c[0] + (i * (c[1] - c[0]) + j * (c[2] - c[0])) / parts;
    };
    double sum = 0;
    const auto add = [&](const Corners& part) {
        std::array<double, 3> f{};
        std::ranges::transform(part, f.begin(), [&](const Point<double>& p) {
            return earlier(discs, time, phase, p);
        });
        sum += positive_area(part, f);
    };
    for (int i = 0; i < parts; ++i) {
        for (int j = 0; i + j < parts; ++j) {
            add({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i + j + 1 < parts) {
                add({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    }
    return sum;
}

// The errors at each vertex of a seam or junction between discs.
template <class Real>
void measure_seams(const GrowingDiscs& discs,
                   const std::map<std::uint32_t, std::set<Phase>>& phases_at,
                   const Complex<Real>& complex, DiagramError& error) {
    double sum = 0;
    int vertices = 0;
    for (const auto& [v, phases] : phases_at) {
        if (phases.size() < 2 || phases.contains(exterior_phase)) {
            continue;
        }
        const Point<double> p = complex.position(Vertex{v}).template cast<double>();
        double first = std::numeric_limits<double>::infinity();
        double last = -first;
        for (const Phase phase : phases) {
            first = std::min(first, discs.arrival(phase - 1U, p));
            last = std::max(last, discs.arrival(phase - 1U, p));
        }
        if (phases.size() > 2) {
            error.triple_max = std::max(error.triple_max, last - first);
            ++error.triples;
            continue;
        }
        constexpr double min_slope = 0.2; // behind a disc, its bisector is far from straight
        const auto towards = [&](Phase phase) -> Point<double> {
            return (p - discs.centres[phase - 1U]).normalized();
        };
        const double slope = (towards(*phases.begin()) - towards(*phases.rbegin())).norm();
        const double off = (last - first) / std::max(min_slope, slope);
        error.seam_max = std::max(error.seam_max, off);
        sum += off * off;
        ++vertices;
    }
    error.seam_rms = vertices > 0 ? std::sqrt(sum / vertices) : 0;
}

// The time at which the first front arrives.
double first_arrival(const GrowingDiscs& discs, const Point<double>& p) {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        first = std::min(first, discs.arrival(i, p));
    }
    return first;
}

// The extent of a disc's cell from its centre in a direction. The fronts of two discs that grow at
// one speed meet on a hyperbola about their centres.
double reach(const GrowingDiscs& discs, std::size_t i, const Point<double>& towards, double time) {
    double smallest = discs.radii[i] + std::max(0.0, time - discs.start(i));
    const Point<double>& centre = discs.centres[i];
    for (int axis = 0; axis < 2; ++axis) { // the sides of the square
        if (towards[axis] != 0) {
            const double side = towards[axis] > 0 ? 1 : 0;
            smallest = std::min(smallest, (side - centre[axis]) / towards[axis]);
        }
    }
    for (std::size_t j = 0; j < discs.radii.size(); ++j) {
        const Point<double> way = discs.centres[j] - centre;
        const double lead = discs.start(i) - discs.radii[i] - discs.start(j) + discs.radii[j];
        const double closing = towards.dot(way) + lead;
        if (j != i && closing > 0) {
            smallest = std::min(smallest, (way.squaredNorm() - lead * lead) / (2 * closing));
        }
    }
    return smallest;
}

} // namespace

GrowingDiscs random_discs(int number, std::uint64_t seed) {
    if (seed == 0 && number == 2) {
        return {{{0.31, 0.52}, {0.72, 0.46}}, {0.14, 0.07}, {}};
    }
    if (seed == 0 && number == 3) {
        return {{{0.31, 0.32}, {0.72, 0.36}, {0.48, 0.71}}, {0.12, 0.07, 0.09}, {}};
    }
    GrowingDiscs discs;
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    std::uniform_real_distribution<double> uniform(0, 1);
    const double scale = number > 30 ? 0.6 : 1; // so that they have room
    const double gap = number > 30 ? 0.024 : 0.06;
    for (int tries = 0; std::ssize(discs.radii) < number && tries < 1'000'000; ++tries) {
        const double y = uniform(random) * 0.8 + 0.1;
        const Point<double> centre(uniform(random) * 0.8 + 0.1, y);
        const double radius = scale * (0.03 + 0.03 * uniform(random));
        bool is_free = true;
        for (std::size_t i = 0; i < discs.radii.size(); ++i) {
            is_free = is_free && discs.arrival(i, centre) > radius + gap;
        }
        if (is_free) {
            discs.centres.push_back(centre);
            discs.radii.push_back(radius);
        }
    }
    return discs;
}

GrowingDiscs nucleating_discs(int number, std::uint64_t seed, double rate) {
    constexpr double radius = 0.04; // of a disc that waits
    constexpr double room = 0.1;    // distance, in time, to the next front
    constexpr double latest = 1.5;
    GrowingDiscs discs = random_discs(number, seed);
    discs.starts.assign(discs.radii.size(), 0);
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed + 1));
    std::uniform_real_distribution<double> uniform(0, 1);
    for (double time = 0; rate > 0;) {
        time -= std::log(1 - uniform(random)) / rate;
        if (time > latest) {
            break;
        }
        const double y = uniform(random) * 0.8 + 0.1;
        const Point<double> centre(uniform(random) * 0.8 + 0.1, y);
        if (first_arrival(discs, centre) > time + radius + room) {
            discs.centres.push_back(centre);
            discs.radii.push_back(radius);
            discs.starts.push_back(time + radius);
        }
    }
    return discs;
}

double filling_time(const GrowingDiscs& discs) {
    constexpr int n = 400; // fronts move by less than 1 / n between neighbouring places
    double last = 0;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            const Point<double> p(static_cast<double>(i) / n, static_cast<double>(j) / n);
            last = std::max(last, first_arrival(discs, p));
        }
    }
    return last;
}

ExactShape exact_cell(const GrowingDiscs& discs, std::size_t i, double time) {
    constexpr int n = 1 << 14;
    const auto outline_of = [&](int stride) {
        Outline outline;
        for (int k = 0; k < n; k += stride) {
            const double angle = 2 * std::numbers::pi * k / n;
            const Point<double> towards(std::cos(angle), std::sin(angle));
            outline.push_back(discs.centres[i] + reach(discs, i, towards, time) * towards);
        }
        return outline;
    };
    ExactShape shape;
    shape.outlines = {outline_of(1)};
    shape.area = signed_area(shape.outlines);
    shape.own_error = std::abs(shape.area - signed_area(outline_of(2)));
    return shape;
}

template <class Real>
DiagramError diagram_error(const Complex<Real>& complex, const GrowingDiscs& discs, double time) {
    DiagramError error;
    std::vector<double> excess(discs.radii.size() + 1); // area of a phase minus its exact one
    std::map<std::uint32_t, std::set<Phase>> phases_at;
    for (const Triangle t : triangles(complex)) {
        Corners c;
        const auto vertices = complex.vertices_of(t);
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = complex.position(vertices[i]).template cast<double>();
            phases_at[vertices[i].id].insert(complex.phase(t));
        }
        const double wrong = wrong_area(discs, time, complex.phase(t), c);
        if (wrong > 0) { // given to the phase, other than its own, to which the centroid belongs
            const Point<double> middle = (c[0] + c[1] + c[2]) / 3;
            std::size_t to = 0;
            double first =
                complex.phase(t) == exterior_phase ? std::numeric_limits<double>::infinity() : time;
            for (std::size_t i = 0; i < discs.radii.size(); ++i) {
                if (i + 1 != complex.phase(t) && discs.arrival(i, middle) < first) {
                    first = discs.arrival(i, middle);
                    to = i + 1;
                }
            }
            excess[complex.phase(t)] += wrong;
            excess[to] -= wrong;
        }
        error.wrong_area += wrong;
    }
    for (std::size_t i = 1; i < excess.size(); ++i) {
        error.phase_error = std::max(error.phase_error, std::abs(excess[i]));
    }
    measure_seams(discs, phases_at, complex, error);
    return error;
}

template DiagramError diagram_error(const Complex<double>&, const GrowingDiscs&, double);
template DiagramError diagram_error(const Complex<float>&, const GrowingDiscs&, double);

} // namespace dsc::scenes

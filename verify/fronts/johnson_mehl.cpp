// SPDX-License-Identifier: MIT
#include "fronts/johnson_mehl.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/growth.h"
#include "geometric_flows/growth_features.h"
#include "measures/mesh_quality.h"
#include "replay/replay.h"
#include "shapes/shapes.h"
#include "topology/stage.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace dsc::fronts {

namespace {

constexpr double latest = 1.5; // by then, any front has crossed the square
constexpr int parts = 4; // of each side of a triangle, within which fronts are taken as straight

using Corners = std::array<Point<double>, 3>;

// How much earlier than a triangle's own phase another has reached a place: positive where the
// place is wrong. A piecewise smooth function whose slope is at most 2.
double earlier(const Discs& discs, double time, Phase phase, const Point<double>& p) {
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

double wrong_area(const Discs& discs, double time, Phase phase, const Corners& c) {
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

// Of each vertex of a seam or junction of the discs alone.
void measure_seams(const Discs& discs, const std::map<std::uint32_t, std::set<Phase>>& phases_at,
                   const Complex<double>& complex, Distance& distance) {
    double sum = 0;
    int vertices = 0;
    for (const auto& [v, phases] : phases_at) {
        if (phases.size() < 2 || phases.contains(exterior_phase)) {
            continue;
        }
        const Point<double> p = complex.position(Vertex{v});
        double first = std::numeric_limits<double>::infinity();
        double last = -first;
        for (const Phase phase : phases) {
            first = std::min(first, discs.arrival(phase - 1U, p));
            last = std::max(last, discs.arrival(phase - 1U, p));
        }
        if (phases.size() > 2) {
            distance.triple_max = std::max(distance.triple_max, last - first);
            ++distance.triples;
            continue;
        }
        constexpr double min_slope = 0.2; // behind a disc its bisector is far from straight
        const auto towards = [&](Phase phase) -> Point<double> {
            return (p - discs.centres[phase - 1U]).normalized();
        };
        const double slope = (towards(*phases.begin()) - towards(*phases.rbegin())).norm();
        const double off = (last - first) / std::max(min_slope, slope);
        distance.seam_max = std::max(distance.seam_max, off);
        sum += off * off;
        ++vertices;
    }
    distance.seam_rms = vertices > 0 ? std::sqrt(sum / vertices) : 0;
}

} // namespace

Discs discs_of(int number, std::uint64_t seed) {
    if (seed == 0 && number == 2) {
        return {{{0.31, 0.52}, {0.72, 0.46}}, {0.14, 0.07}};
    }
    if (seed == 0 && number == 3) {
        return {{{0.31, 0.32}, {0.72, 0.36}, {0.48, 0.71}}, {0.12, 0.07, 0.09}};
    }
    Discs discs;
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

Distance distance_from_exact(const Complex<double>& complex, const Discs& discs, double time) {
    Distance distance;
    std::vector<double> excess(discs.radii.size() + 1); // area of a phase minus its exact one
    std::map<std::uint32_t, std::set<Phase>> phases_at;
    for (const Triangle t : triangles(complex)) {
        Corners c;
        const auto vertices = complex.vertices_of(t);
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = complex.position(vertices[i]);
            phases_at[vertices[i].id].insert(complex.phase(t));
        }
        const double wrong = wrong_area(discs, time, complex.phase(t), c);
        if (wrong > 0) { // given to the phase to which the middle belongs, of all but its own
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
        distance.wrong_area += wrong;
    }
    for (std::size_t i = 1; i < excess.size(); ++i) {
        distance.phase_error = std::max(distance.phase_error, std::abs(excess[i]));
    }
    measure_seams(discs, phases_at, complex, distance);
    return distance;
}

Complex<double> first_complex(const Discs& discs, double h) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        shapes.push_back(
            {scenes::circle(discs.centres[i], discs.radii[i], h), static_cast<Phase>(i + 1)});
    }
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

Result run(const Case& one) {
    const Discs discs = discs_of(one.number, one.seed);
    GrowthOptions<double> growing;
    for (std::size_t i = 0; i < discs.radii.size(); ++i) {
        growing.speeds.push_back({static_cast<Phase>(i + 1), exterior_phase, 1.0});
    }
    Complex<double> complex = first_complex(discs, one.h);
    Options<double> options;
    options.edge_length = one.h;
    const Algorithm<double> algorithm = growth_algorithm(complex, growing);
    Simulation<double> simulation(
        complex, options,
        make_executor(complex, options, Parallel{.threads = one.threads}, algorithm));
    const auto topology = std::make_shared<TopologyStage<double>>(
        TopologyOptions<double>{.rule = Topology::change, .contact = one.contact * one.h});
    simulation.add_stage(topology);
    const InterfaceFlow<double> flow = growth(growing);
    Result result;
    result.min_angle_ever = 60;
    const double dt = one.step * one.h;
    for (int step = 0; step * dt < latest && !result.is_full; ++step) {
        const auto begin = std::chrono::steady_clock::now();
        result.unreached += simulation.step(flow, step * dt, dt).unreached;
        result.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        for (const Event& event : topology->take_events()) {
            ++result.events[std::string(to_string(event.kind))];
        }
        result.time = (step + 1) * dt;
        result.min_angle_last = scenes::measure_quality(complex).min_angle_deg;
        result.min_angle_ever = std::min(result.min_angle_ever, result.min_angle_last);
        result.is_full = std::ranges::none_of(
            triangles(complex), [&](Triangle t) { return complex.phase(t) == exterior_phase; });
    }
    result.last = distance_from_exact(complex, discs, result.time);
    result.is_valid = validate(complex).ok();
    result.mesh_hash = mesh_hash(complex);
    return result;
}

} // namespace dsc::fronts

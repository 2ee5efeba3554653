// SPDX-License-Identifier: MIT
#include "combinations/trial.h"

#include "combinations/course.h"
#include "combinations/tolerance.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/points.h"
#include "dsc/passes/interface/list.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <ranges>
#include <span>
#include <sstream>

namespace dsc::combinations {

namespace {

template <class Real>
std::vector<scenes::Outline> outlines_of(const Complex<Real>& complex, Phase phase) {
    return scenes::interface_outlines(complex, {.phase = phase});
}

template <class Real>
double whole_area(const Complex<Real>& complex, Phase phases) {
    double sum = 0;
    for (Phase phase = 0; phase < phases; ++phase) {
        sum += static_cast<double>(phase_area(complex, phase));
    }
    return sum;
}

using Map = std::function<Point<double>(const Point<double>&)>;

// Outlines of the first complex, at the end.
std::vector<scenes::Outline> mapped(std::vector<scenes::Outline> shape, const Map& exact) {
    for (scenes::Outline& outline : shape) {
        std::ranges::transform(outline, outline.begin(), exact);
    }
    return shape;
}

double perimeter(std::span<const scenes::Outline> shape) { return scenes::perimeter(shape); }

double distance_to(std::span<const scenes::Outline> shape, const Point<double>& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const scenes::Outline& outline : shape) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double>& next = outline[(i + 1) % outline.size()];
            nearest = std::min(nearest, distance<double>(p, outline[i], next));
        }
    }
    return nearest;
}

void keep_worse(Distance& kept, const Distance& other) {
    if (!(other.off * kept.allowed <= kept.off * other.allowed) || kept.allowed == 0) {
        kept = other;
    }
}

// Euler's method, which grows what it turns.
bool goes_by_euler(const Row& row) {
    return row.integrator == scenes::IntegratorChoice::euler && row.told != Told::motion;
}

// The inside of a carried phase that moves as a rigid body is the same points, moved. The mesh has
// settled by half time if edges are all of one length; after that a vertex is made or smoothed only
// where the curve is kept up.
bool has_rigid_inside(const Row& row, const Scene& scene) {
    const bool is_rigid = row.motion == Motion::rest ||
                          (row.motion == Motion::turn && !goes_by_euler(row)) ||
                          (is_translation(row.motion) && !scene.meets);
    return row.inside == Inside::carried && is_rigid && row.sizes == Sizes::uniform &&
           row.interruption != Interruption::edited &&
           row.interruption != Interruption::not_a_number;
}

template <class Real>
std::vector<Point<double>> inside_of(const Complex<Real>& complex) {
    constexpr std::array carried{Phase{1}};
    std::vector<Point<double>> places;
    for (const Vertex v : vertices(complex)) {
        if (is_carried(complex, carried, v)) {
            places.push_back(complex.position(v).template cast<double>());
        }
    }
    return places;
}

// `times`: of all sub-steps. `allowed`: in edge lengths.
template <class Real>
void compare_insides(const Row& row, const Scene& scene, const Outcome<Real>& outcome,
                     std::span<const double> times, double allowed, Findings& findings) {
    const auto half = std::ranges::lower_bound(times, scene.end * (0.5 - 1e-6));
    std::vector<Point<double>> expected = inside_of(outcome.middle);
    for (Point<double>& p : expected) {
        p = by_method(row, scene, {half, times.end()}, p);
    }
    const auto is_there = [&](const Point<double>& p) {
        return std::ranges::any_of(expected, [&](const Point<double>& one) {
            return (one - p).norm() <= allowed * scene.h;
        });
    };
    const std::vector<Point<double>> last = inside_of(outcome.last);
    const auto others = static_cast<std::size_t>(
        std::ranges::count_if(last, [&](const auto& p) { return !is_there(p); }));
    if (3 * others > last.size() + 3) { // all of them, if the inside stays behind
        findings.problems.push_back("of " + std::to_string(last.size()) +
                                    " vertices inside the carried phase " + std::to_string(others) +
                                    " are not where it has brought one");
    }
}

void expect_within(const Distance& one, const char* what, Findings& findings) {
    if (!(one.off <= one.allowed)) {
        std::ostringstream words;
        words << what << " is off by " << one.off << " edge lengths, allowed " << one.allowed;
        findings.problems.push_back(words.str());
    }
}

template <class Real>
void compare_shapes(const Row& row, const Scene& scene, const Outcome<Real>& outcome,
                    Findings& findings) {
    const std::vector<double> asked(outcome.asked.begin(), outcome.asked.end());
    const bool is_euler = goes_by_euler(row);
    const std::vector<double>& times = is_euler ? asked : outcome.times;
    const auto by_integrator = [&](const Point<double>& p) {
        return by_method(row, scene, times, p);
    };
    // Euler's method is so far off that it is what is compared with; of the others the error is
    // allowed, twice, as sub-steps are not all cut alike.
    const bool is_curved = has_method_error(row);
    const Map exact = is_curved && is_euler ? Map(by_integrator) : scene.exact;
    double error = 0;
    for (Phase phase = 1; phase < scene.phases; ++phase) {
        const auto first = outlines_of(outcome.first, phase);
        const auto expected = mapped(first, exact);
        const auto last = outlines_of(outcome.last, phase);
        if (is_curved && !is_euler) {
            for (const Point<double>& p : std::views::join(first)) {
                error = std::max(error, 2 * (by_integrator(p) - exact(p)).norm() / scene.h);
            }
        }
        const double length = std::max(perimeter(first), perimeter(expected)) / scene.h;
        Tolerance allowed = tolerance_of(row, scene, length, outcome.times.size(),
                                         std::numeric_limits<Real>::epsilon());
        allowed += {error, error};
        const double apart = scenes::overlap_areas({expected, scenes::FillRule::nonzero}, {last})
                                 .symmetric_difference();
        keep_worse(findings.mean, {apart / (length * scene.h * scene.h), allowed.mean});
        double farthest = 0;
        for (const Point<double>& p : std::views::join(last)) {
            farthest = std::max(farthest, distance_to(expected, p) / scene.h);
        }
        keep_worse(findings.farthest, {farthest, allowed.farthest});
    }
    expect_within(findings.mean, "the interface", findings);
    expect_within(findings.farthest, "a vertex of the interface", findings);
    if (has_rigid_inside(row, scene)) {
        const double rounding =
            rounding_of(scene, outcome.times.size(), std::numeric_limits<Real>::epsilon());
        compare_insides(row, scene, outcome, times, rounding + error, findings);
    }
}

// What goes there and back must have been away.
template <class Real>
void expect_away(const Scene& scene, const Outcome<Real>& outcome, Findings& findings) {
    double moved = 0;
    for (Phase phase = 1; phase < scene.phases; ++phase) {
        const auto first = outlines_of(outcome.first, phase);
        const double apart =
            scenes::symmetric_difference(first, outlines_of(outcome.middle, phase));
        moved = std::max(moved, apart / (perimeter(first) * scene.h));
    }
    if (moved < 0.05) {
        findings.problems.emplace_back("the interface has not moved by half time");
    }
}

template <class Real>
double interface_length(const Complex<Real>& complex, Phase phases) {
    double length = 0;
    for (Phase phase = 0; phase < phases; ++phase) {
        length += scenes::perimeter(std::span<const scenes::Outline>(outlines_of(complex, phase)));
    }
    return length;
}

template <class Real>
void compare_areas(const Scene& scene, const Outcome<Real>& outcome, Findings& findings) {
    for (Phase phase = 0; phase < scene.area_changes.size(); ++phase) {
        const double change = static_cast<double>(phase_area(outcome.last, phase)) -
                              static_cast<double>(phase_area(outcome.first, phase));
        // Of the change: the angles at the junctions have to form first.
        constexpr double tolerated = 0.05;
        if (!(std::abs(change - scene.area_changes[phase]) <=
              tolerated * std::abs(scene.area_changes[phase]))) {
            std::ostringstream words;
            words << "the area of phase " << phase << " changes by " << change << ", not by "
                  << scene.area_changes[phase];
            findings.problems.push_back(words.str());
        }
    }
}

// What holds at the end of every run.
template <class Real>
void judge(const Row& row, const Scene& scene, const Outcome<Real>& outcome, Findings& findings) {
    findings.problems = outcome.problems;
    if (!findings.problems.empty()) {
        return;
    }
    const auto expect_none = [&](std::uint64_t count, const char* of) {
        if (count != 0) {
            findings.problems.push_back(std::to_string(count) + ' ' + of);
        }
    };
    if (scene.meets) {
        const bool may_change = row.topology != Rule::keep && row.topology != Rule::forbidden;
        expect_none(may_change ? 0 : outcome.events, "events where the topology is kept");
        expect_none(may_change && !scene.runs_into_wall ? outcome.unreached : 0,
                    "vertices did not arrive");
        if (may_change && outcome.events == 0) {
            findings.problems.emplace_back("no event is told");
        }
    } else {
        expect_none(scene.runs_into_wall ? 0 : outcome.unreached, "vertices did not arrive");
        expect_none(row.phases == Phases::many ? 0 : outcome.events, "events where nothing meets");
    }
    if (row.interruption != Interruption::not_a_number) {
        expect_none(outcome.held, "vertices were held");
    } else if (outcome.held == 0) {
        findings.problems.emplace_back("no vertex is held that has no number");
    }
    const double before = whole_area(outcome.first, scene.phases);
    const double change = whole_area(outcome.last, scene.phases) / before - 1;
    if (!(std::abs(change) < (std::is_same_v<Real, double> ? 1e-12 : 1e-5))) {
        findings.problems.push_back("the domain's area changes by a factor of 1 + " +
                                    std::to_string(change));
    }
    if (scene.is_only_conserved) {
        if (!(interface_length(outcome.last, scene.phases) <
              interface_length(outcome.first, scene.phases))) {
            findings.problems.emplace_back("curvature does not shorten the interface");
        }
        return;
    }
    if (!scene.area_changes.empty()) {
        compare_areas(scene, outcome, findings);
    } else {
        compare_shapes(row, scene, outcome, findings);
    }
    if (row.motion == Motion::swirl) {
        expect_away(scene, outcome, findings);
    }
}

// Whether an interruption is to leave no trace in the mesh.
bool leaves_no_trace(const Row& row) {
    switch (row.interruption) {
    case Interruption::resumed:
    case Interruption::listened: return true;
    // Where sizes are graded, a step looks at some more of the mesh.
    case Interruption::pause:
    case Interruption::set_options: return row.sizes == Sizes::uniform;
    // Nothing has moved before the first call, but submeshes have been kept up, and are again.
    case Interruption::thrown: return row.way == Way::sequential && row.sizes == Sizes::uniform;
    case Interruption::none:
    case Interruption::tiny_step:
    case Interruption::renumbered:
    case Interruption::edited:
    case Interruption::not_a_number: break;
    }
    return false;
}

template <class Real>
Findings try_in(const Row& row, double fineness) {
    const Scene scene = scene_of(row, fineness);
    const bool is_parallel = row.way != Way::sequential;
    Findings findings;
    std::uint64_t hash = 0;
    bool is_first = true;
    for (const std::uint32_t threads : {1U, 2U, 3U, 3U}) {
        if (!is_parallel && threads == 3) {
            break; // the sequential method takes no account of them: it has run twice
        }
        const Outcome<Real> outcome = run_course<Real>(row, scene, threads, false);
        if (is_first) {
            judge(row, scene, outcome, findings);
            hash = outcome.hash;
            is_first = false;
        } else if (outcome.hash != hash) {
            findings.problems.push_back(is_parallel
                                            ? std::to_string(threads) + " threads give another mesh"
                                            : std::string("two runs give different meshes"));
        }
        if (is_parallel && outcome.threads < std::min(threads, outcome.submeshes)) {
            findings.problems.push_back("of " + std::to_string(threads) + " threads " +
                                        std::to_string(outcome.threads) + " were used");
        }
    }
    if (leaves_no_trace(row) && findings.problems.empty() &&
        run_course<Real>(row, scene, 1, true).hash != hash) {
        findings.problems.emplace_back("the interruption has left its trace in the mesh");
    }
    return findings;
}

} // namespace

Findings try_row(const Row& row, double fineness) {
    return row.precision == Precision::in_double ? try_in<double>(row, fineness)
                                                 : try_in<float>(row, fineness);
}

std::string refusal_of(const Row& row) {
    try {
        const Scene scene = scene_of(row, 1);
        (void)run_course<double>(row, scene, 1, false);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
#include "combinations/trial.h"

#include "combinations/course.h"
#include "measures/interface_outlines.h"
#include "measures/symmetric_difference.h"

#include "dsc/algebra/mesh_functions.h"
#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dsc::combinations {

namespace {

template <class Real>
std::vector<scenes::Outline> outlines(const Complex<Real>& complex, Phase phase) {
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

// How far an interface may be from where it should, in edge lengths.
double allowed_distance(const Row& row, const Scene& scene) {
    double allowed = 0.02; // chords of arcs, and what upkeep takes from a curve
    if (row.coarsening == Coarsening::length) {
        allowed += 0.01;
    }
    if (row.outline == Outline::loose_corners) {
        allowed += 0.05; // they are cut off
    }
    if (row.told == Told::positions || row.told == Told::seeing) {
        const bool is_euler = row.integrator == Integrator::euler;
        if (row.motion == Motion::turn) {
            allowed += is_euler ? 1.0 : 0.02;
        } else if (row.motion == Motion::swirl) {
            allowed += is_euler ? 0.2 : 0.01;
        }
    }
    if (row.interruption == Interruption::not_a_number) {
        const double speed = scene.velocity ? scene.fastest : 1.0;
        allowed += speed * scene.end / scene.steps / scene.h;
    }
    if (scene.meets) {
        allowed += row.topology == Rule::wide ? 0.2 : 0.05; // where it has met
    }
    return allowed;
}

template <class Real>
void compare_shapes(const Row& row, const Scene& scene, const Outcome<Real>& outcome,
                    Findings& findings) {
    double apart = 0;
    double length = 0;
    for (Phase phase = 1; phase < scene.phases; ++phase) {
        const auto last = outlines(outcome.last, phase);
        auto exact = outlines(outcome.first, phase);
        for (scenes::Outline& outline : exact) {
            for (Point<double>& p : outline) {
                p = scene.exact(p);
            }
        }
        apart += scenes::overlap_areas({exact, scenes::FillRule::nonzero},
                                       {last, scenes::FillRule::even_odd})
                     .symmetric_difference();
        length += scenes::perimeter(std::span<const scenes::Outline>(exact));
    }
    findings.distance = std::max(findings.distance, apart / (length * scene.h));
    findings.allowed = allowed_distance(row, scene);
    if (!(findings.distance <= findings.allowed)) {
        std::ostringstream words;
        words << "the interface is off by " << findings.distance << " edge lengths, allowed "
              << findings.allowed;
        findings.problems.push_back(words.str());
    }
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
        expect_none(may_change ? outcome.unreached : 0, "vertices did not arrive");
        if (may_change && outcome.events == 0) {
            findings.problems.emplace_back("no event is told");
        }
    } else {
        expect_none(scene.runs_into_wall ? 0 : outcome.unreached, "vertices did not arrive");
        expect_none(row.phases == Phases::many ? 0 : outcome.events, "events where nothing meets");
    }
    if (row.interruption != Interruption::not_a_number) {
        expect_none(outcome.held, "vertices were held");
    }
    const double before = whole_area(outcome.first, scene.phases);
    const double change = whole_area(outcome.last, scene.phases) / before - 1;
    if (!(std::abs(change) < (std::is_same_v<Real, double> ? 1e-12 : 1e-5))) {
        findings.problems.push_back("the domain's area changes by a factor of 1 + " +
                                    std::to_string(change));
    }
    if (scene.is_only_conserved) {
        return;
    }
    if (!scene.area_changes.empty()) {
        compare_areas(scene, outcome, findings);
    } else {
        compare_shapes(row, scene, outcome, findings);
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
    case Interruption::none:
    case Interruption::tiny_step:
    case Interruption::renumbered:
    case Interruption::edited:
    case Interruption::thrown:
    case Interruption::not_a_number: break;
    }
    return false;
}

template <class Real>
Findings try_in(const Row& row) {
    const Scene scene = scene_of(row);
    const bool is_parallel = row.way != Way::sequential;
    Findings findings;
    std::uint64_t hash = 0;
    bool is_first = true;
    for (const std::uint32_t threads : {1U, 2U, 3U, 3U}) {
        if (!is_parallel && threads == 2) {
            break; // the second of the sequential runs was made below
        }
        const Outcome<Real> outcome = run_course<Real>(row, scene, threads, false);
        if (is_first) {
            judge(row, scene, outcome, findings);
            hash = outcome.hash;
            is_first = false;
            if (!is_parallel && run_course<Real>(row, scene, threads, false).hash != hash) {
                findings.problems.emplace_back("two runs give different meshes");
            }
        } else if (outcome.hash != hash) {
            findings.problems.push_back(std::to_string(threads) + " threads give another mesh");
        }
        if (is_parallel && row.way != Way::copy &&
            outcome.threads < std::min(threads, outcome.submeshes)) {
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

Findings try_row(const Row& row) {
    return row.precision == Precision::in_double ? try_in<double>(row) : try_in<float>(row);
}

std::string refusal_of(const Row& row) {
    try {
        const Scene scene = scene_of(row);
        (void)run_course<double>(row, scene, 1, false);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

} // namespace dsc::combinations

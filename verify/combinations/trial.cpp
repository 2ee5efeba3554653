// SPDX-License-Identifier: MIT
#include "combinations/trial.h"

#include "combinations/run.h"
#include "combinations/settings.h"
#include "measures/symmetric_difference.h"
#include "support/outline_testing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <sstream>

namespace dsc::combinations {

namespace {

using Outlines = std::span<const scenes::Outline>;
using P = Point<double>;

// --- how far a shape may be off -----------------------------------------------------------------

// Tolerances are derived: for advected straight curves from rounding alone, otherwise also from the
// errors of chords, cut corners, films, and methods of known order. In edge lengths.
struct Tolerance {
    double mean = 0;     ///< symmetric difference over the length of the curve
    double farthest = 0; ///< largest distance of an interface vertex from the curve

    Tolerance& operator+=(const Tolerance& other) {
        mean += other.mean;
        farthest += other.farthest;
        return *this;
    }
};

// Lengths below are in edge lengths, except those of the scene.
const InterfaceThresholds remeshing;

// Coordinates are rounded when a target is found and when it is reached: by half a unit in the last
// place of the largest one, twice, in either direction. Curvature flow gives the ends of curves on
// a side of the domain a tension along it of 1e-9 (curve_network.h), so that no system is singular:
// it moves the ends by up to 1e-9 times the duration, for edges of length 1.
double rounding(const Row& row, const Scene& scene, std::size_t sub_steps) {
    const double epsilon = row.precision == Precision::in_double
                               ? std::numeric_limits<double>::epsilon()
                               : std::numeric_limits<float>::epsilon();
    const double size = std::max(scene.domain.high.x(), scene.domain.high.y()) / scene.h;
    const double boundary_tension =
        is_by_curvature(row) ? 1e-9 * scene.end / (scene.h * scene.h) : 0;
    return 2 * epsilon * size * static_cast<double>(sub_steps) + boundary_tension;
}

// An arc of curvature k and its chord c are k c^2 / 8 apart in the middle and k c^2 / 12 on the
// average. Remeshing leaves no edge that is longer than `longest`, but for one by an end of a
// curve.
Tolerance chords(const Row& row, const Scene& scene) {
    double chord = remeshing.longest;
    double longest = remeshing.longest + remeshing.shortest;
    // Without coarsening, edges keep their initial length times the stretch of the curve.
    const double drawn = scene.longest_at_start * scene.stretch;
    if (row.coarsening == Coarsening::never && drawn < 1) {
        chord = longest = is_normal(row) || is_by_curvature(row) ? drawn : 0;
    }
    const double bend = scene.curvature * scene.h;
    return {bend * chord * chord / 12, bend * longest * longest / 8};
}

// Where pieces meet, the film between them opens once it is thinner than the contact distance. If
// the topology is kept, the sheets block each other at the length of the shortest edge that
// remeshing keeps.
Tolerance meeting(const Row& row, const Scene& scene, double length) {
    if (scene.seam == 0) {
        return {};
    }
    const double thickness = may_change(row) ? contact_of(row) : PhaseThresholds{}.shortest;
    // If the film lies between two different phases, either may get all of its own half.
    const bool are_two = row.phases == Phases::junctions && !scene.meets_boundary;
    const double film = thickness * scene.seam / scene.h / (are_two ? 2 : 1);
    double area = 0;
    if (!may_change(row) || are_two) {
        area += film; // the film stays, or belongs to one of the two phases
    }
    if (row.topology == Rule::given_back) {
        area += film; // the area is given back elsewhere
    }
    // At either end of the seam is a wedge, which closes up to where a triangle across it is as
    // high as the film. An edge of that triangle may lie along a sheet or the domain boundary, and
    // have the longest length there...
    const double edge = scene.meets_boundary ? PhaseThresholds{}.longest : remeshing.longest;
    area += thickness * std::max(edge, thickness); // half of this area at either end
    // ...and two phases, or a sheet and the domain boundary, then meet at the far end of the wedge.
    const double sideways = are_two || scene.meets_boundary ? edge * std::sin(scene.seam_angle) : 0;
    return {area / length, std::max(thickness, sideways)};
}

// `length` is that of the curve, in edge lengths.
Tolerance tolerance_of(const Row& row, const Scene& scene, double length, std::size_t sub_steps) {
    const double smallest = rounding(row, scene, sub_steps);
    Tolerance all{smallest, smallest};
    all += chords(row, scene);
    all += meeting(row, scene, length);
    return all;
}

// The position to which the row's integrator brings a point, in sub-steps that begin at these
// times.
Point<double> by_method(const Row& row, const Scene& scene, std::span<const double> times,
                        const Point<double>& start) {
    using scenes::IntegratorChoice;
    const IntegratorChoice method =
        row.told == Told::motion ? IntegratorChoice::rk4 : row.integrator;
    const auto& v = scene.velocity;
    P p = start;
    P way(0, 0);
    double dt_before = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i];
        const double dt = (i + 1 < times.size() ? times[i + 1] : scene.end) - t;
        const double middle = t + dt / 2;
        const P first = v(p, t);
        const P second = v(P(p + dt / 2 * first), middle);
        P next = dt * second;
        switch (method) {
        case IntegratorChoice::euler: next = dt * first; break;
        case IntegratorChoice::midpoint: break;
        case IntegratorChoice::centred:
            if (dt_before > 0) {
                const double ratio = dt / dt_before;
                next = (1 + ratio) * dt * first - ratio * ratio * way;
            }
            break;
        case IntegratorChoice::rk4:
        case IntegratorChoice::adaptive: {
            const P third = v(P(p + dt / 2 * second), middle);
            const P fourth = v(P(p + dt * third), t + dt);
            next = dt / 6 * (first + 2 * second + 2 * third + fourth);
        }
        }
        p += next;
        way = next;
        dt_before = dt;
    }
    return p;
}

// --- what the end of a run must be ---------------------------------------------------------------

// Compares the end of a run with its exact result.
class Judge {
public:
    Judge(const Row& row, const Scene& scene, const Outcome& outcome)
        : row_(row), scene_(scene), outcome_(outcome), problems_(outcome.problems) {}

    std::vector<std::string> problems() {
        if (!problems_.empty()) {
            return problems_; // later checks would only repeat these faults
        }
        check_counts();
        check_domain();
        if (!scene_.area_changes.empty()) {
            check_areas();
        } else {
            check_shapes();
        }
        if (row_.motion == Motion::swirl) {
            check_way();
        }
        return problems_;
    }

private:
    template <class... Words>
    void expect(bool holds, const Words&... words) {
        if (!holds) {
            std::ostringstream problem;
            (problem << ... << words);
            problems_.push_back(problem.str());
        }
    }

    void check_counts() {
        const bool changes = scene_.meets && may_change(row_);
        const bool arrives = !scene_.runs_into_boundary && (!scene_.meets || may_change(row_));
        expect(!arrives || outcome_.unreached == 0, outcome_.unreached, " vertices did not arrive");
        expect(outcome_.held == 0, outcome_.held, " vertices were held");
        expect(!changes || outcome_.events > 0, "no event is told");
        expect(changes || outcome_.events == 0, outcome_.events, " events where nothing may meet");
    }

    void check_domain() {
        const auto whole = [](const Shapes& shapes) {
            return std::accumulate(shapes.areas.begin(), shapes.areas.end(), 0.0);
        };
        const double change = whole(outcome_.last) / whole(outcome_.first) - 1;
        expect(std::abs(change) < (row_.precision == Precision::in_double ? 1e-12 : 1e-5),
               "the domain's area changes by a factor of 1 + ", change);
    }

    void check_areas() {
        for (Phase phase = 0; phase < scene_.area_changes.size(); ++phase) {
            const double change = outcome_.last.areas[phase] - outcome_.first.areas[phase];
            const double expected = scene_.area_changes[phase];
            // Relative to the change: the angles at the junctions first have to form.
            constexpr double tolerated = 0.05;
            expect(std::abs(change - expected) <= tolerated * std::abs(expected),
                   "the area of phase ", phase, " changes by ", change, ", not by ", expected);
        }
    }

    void check_shapes() {
        // Euler's method enlarges rotated shapes, so much that the result is compared with the
        // shape that Euler's method gives, not with the exact one. For other integrators twice the
        // method's error is allowed, because sub-steps differ in length.
        const bool is_curved = row_.motion == Motion::turn || row_.motion == Motion::swirl;
        const bool is_euler =
            row_.integrator == scenes::IntegratorChoice::euler && row_.told != Told::motion;
        const auto by_integrator = [&](const Point<double>& p) {
            return by_method(row_, scene_, is_euler ? outcome_.asked : outcome_.times, p);
        };
        double error = 0;
        for (Phase phase = 1; phase < scene_.phases; ++phase) {
            const Outlines first = outcome_.first.outlines[phase];
            const Outlines last = outcome_.last.outlines[phase];
            std::vector<scenes::Outline> expected(first.begin(), first.end());
            for (scenes::Outline& outline : expected) {
                for (Point<double>& p : outline) {
                    const Point<double> start = p;
                    p = is_curved && is_euler ? by_integrator(start) : scene_.exact(start);
                    if (is_curved && !is_euler) {
                        error = std::max(error, 2 * (by_integrator(start) - p).norm() / scene_.h);
                    }
                }
            }
            const double length =
                std::max(scenes::perimeter(first), scenes::perimeter(Outlines(expected))) /
                scene_.h;
            Tolerance allowed = tolerance_of(row_, scene_, length, outcome_.times.size());
            allowed += {error, error};
            const double mean = scenes::overlap_areas({expected, scenes::FillRule::nonzero}, {last})
                                    .symmetric_difference() /
                                (length * scene_.h * scene_.h);
            double farthest = 0;
            for (const scenes::Outline& outline : last) {
                for (const Point<double>& p : outline) {
                    farthest = std::max(farthest, test::distance_from(expected, p) / scene_.h);
                }
            }
            expect(mean <= allowed.mean, "phase ", phase, " is off by ", mean,
                   " edge lengths, allowed ", allowed.mean);
            expect(farthest <= allowed.farthest, "a vertex of phase ", phase, " is off by ",
                   farthest, " edge lengths, allowed ", allowed.farthest);
        }
    }

    // Shapes that return to their start must have moved away at half the time.
    void check_way() {
        double moved = 0;
        for (Phase phase = 1; phase < scene_.phases; ++phase) {
            const Outlines first = outcome_.first.outlines[phase];
            const double apart =
                scenes::symmetric_difference(first, outcome_.middle.outlines[phase]);
            moved = std::max(moved, apart / (scenes::perimeter(first) * scene_.h));
        }
        expect(moved >= 0.05, "the interface has not moved by half time");
    }

    const Row& row_;
    const Scene& scene_;
    const Outcome& outcome_;
    std::vector<std::string> problems_;
};

// Whether the mesh must be bitwise identical to that of a run without the interruption.
bool leaves_no_trace(const Row& row) {
    switch (row.interruption) {
    // With graded sizes each further step visits a part of the mesh again.
    case Interruption::pause:
    case Interruption::set_options: return row.sizes == Sizes::uniform;
    // The exception comes before any movement; but in submeshes the interface has been remeshed
    // already, and is remeshed again in the repeated step.
    case Interruption::thrown: return row.way == Way::sequential && row.sizes == Sizes::uniform;
    case Interruption::none:
    case Interruption::tiny_step:
    case Interruption::renumbered: break;
    }
    return false;
}

} // namespace

std::vector<std::string> problems_of(const Row& row, double fineness) {
    const Scene scene = scene_of(row, fineness);
    const Outcome first = run_row(row, scene, {.threads = 1});
    std::vector<std::string> problems = Judge(row, scene, first).problems();
    if (!problems.empty()) {
        return problems;
    }
    const std::uint32_t largest = row.way == Way::sequential ? 2 : 3;
    for (std::uint32_t threads = 2; threads <= largest; ++threads) {
        const std::string of = std::to_string(threads) + " threads";
        // In single precision, products of the lengths of vanishing edges would underflow.
        const bool is_rescaled = threads == largest && row.precision == Precision::in_double;
        const Scene again = is_rescaled ? in_units(scene, 0x1p-40, 0x1p-7) : scene;
        const Outcome other = run_row(row, again, {.threads = threads, .is_resumed = threads == 2});
        if (other.hash != first.hash) {
            problems.push_back(of + " give another mesh" + (threads == 2 ? ", resumed" : "") +
                               (is_rescaled ? ", in other units" : ""));
        }
        if (other.threads < std::min(threads, other.submeshes)) {
            problems.push_back("of " + of + ' ' + std::to_string(other.threads) + " were used");
        }
    }
    if (leaves_no_trace(row) && run_row(row, scene, {.is_unbroken = true}).hash != first.hash) {
        problems.emplace_back("the interruption has left its trace in the mesh");
    }
    return problems;
}

} // namespace dsc::combinations

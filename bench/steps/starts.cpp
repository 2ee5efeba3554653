// SPDX-License-Identifier: MIT
#include "steps/starts.h"

#include "dsc/base/error.h"
#include "measures/interface_outlines.h"
#include "scenes/run/start.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace dsc::bench {

namespace {

constexpr int measured_steps = warm_up_steps + timed_steps;

std::map<std::string, std::shared_ptr<Start>>& starts() {
    static std::map<std::string, std::shared_ptr<Start>> all;
    return all;
}

// The largest relative difference of area between a circle of radius r and a polygon with edges of
// up to 1.4 h: (1.4 h)^2 / (6 r^2) for the chords, plus 2 * 0.02 h / r if all collapses move the
// curve by 0.02 h (InterfaceThresholds).
double area_limit_of_round(const scenes::Setup& setup, double h) {
    double radius = 0; // of the smallest first shape
    for (const auto& outline : setup.outlines) {
        const double r = std::sqrt(scenes::signed_area(outline) / std::numbers::pi);
        radius = radius == 0 ? r : std::min(radius, r);
    }
    return 1.4 * 1.4 * h * h / (6 * radius * radius) + 2 * 0.02 * h / radius;
}

void check_usable(const Workload& workload, const scenes::Setup& setup, const std::string& where) {
    if (workload.part != Part::whole && (setup.sees_interface() || setup.value)) {
        throw InputError({.what = "single steps of this scene cannot be measured",
                          .where = where,
                          .value = workload.scene.name + ", with " +
                                   (setup.curvature ? "curvature"
                                    : setup.growth  ? "growth"
                                    : setup.fluid   ? "a fluid"
                                                    : "a value at its vertices"),
                          .allowed = "scenes that move only by a velocity; or measure = \"run\""});
    }
    if (workload.parameters.real != scenes::RealType::double_precision) {
        throw InputError({.what = "only double precision can be measured",
                          .where = where,
                          .value = "real = 'float'",
                          .allowed = "double"});
    }
}

// The number of steps before the warm-up.
int first_step(const Workload& workload, const scenes::Setup& setup, const std::string& where) {
    if (workload.part == Part::whole) {
        return 0;
    }
    if (workload.part == Part::before_half) {
        if (!setup.half_step) {
            throw InputError({.what = "this flow does not turn back",
                              .where = where,
                              .value = workload.scene.name + " at \"half\"",
                              .allowed = "a time"});
        }
        return std::max(0, *setup.half_step - measured_steps);
    }
    const int middle = workload.part == Part::middle
                           ? setup.steps / 2
                           : static_cast<int>(std::lround(workload.around / setup.dt));
    return std::max(0, middle - timed_steps / 2 - warm_up_steps);
}

std::shared_ptr<Start> plan(const Workload& workload, const std::string& where) {
    const scenes::Scene& scene = workload.scene;
    auto start = std::make_shared<Start>();
    scenes::Parameters& parameters = start->parameters;
    parameters = workload.parameters;
    if (workload.dt_over_h) {
        parameters.dt = *workload.dt_over_h * parameters.h;
    }
    start->setup = scene.prepare(parameters);
    check_usable(workload, start->setup, where);
    parameters.dt = start->setup.dt;
    start->step = first_step(workload, start->setup, where);
    const int last = start->step + measured_steps;
    if (workload.part == Part::around && start->setup.steps < last &&
        !scene.counts_steps_each_way) {
        parameters.steps = last; // extends the scene
        start->setup = scene.prepare(parameters);
    }
    if (workload.part != Part::whole && start->setup.steps < last) {
        throw InputError({.what = "too few steps to measure one",
                          .where = where,
                          .value = scene.name + " with " + std::to_string(start->setup.steps),
                          .allowed = "at least " + std::to_string(last) + ": " +
                                     std::to_string(warm_up_steps) + " to warm up and " +
                                     std::to_string(timed_steps) +
                                     " that are timed; or measure = \"run\""});
    }
    start->area_limit =
        workload.area_error.value_or(area_limit_of_round(start->setup, parameters.h));
    return start;
}

template <class Item>
double mb(const std::vector<Item>& items) {
    return static_cast<double>(items.capacity() * sizeof(Item)) * 1e-6;
}

} // namespace

std::shared_ptr<Start> start_of(const Workload& workload, const std::string& key,
                                const std::string& where) {
    auto& start = starts()[key];
    if (!start) {
        start = plan(workload, where);
    }
    return start;
}

void make_ready(Start& start) {
    if (start.complex.triangle_count() > 0) {
        return;
    }
    auto complex = scenes::first_complex<double>(start.setup, start.parameters);
    const auto options = scenes::scene_options<double>(start.setup, start.parameters);
    const auto simulation = scenes::make_simulation(
        complex, options, scenes::topology_options<double>(start.parameters),
        scenes::Strategy::sequential, {});
    for (int step = 0; step < start.step; ++step) {
        const StepReport report = advance(*simulation, start.setup, step);
        if (report.unreached > 0 || report.gave_up != GiveUp::none) {
            throw InvariantError("a vertex did not arrive before the measurement, in step " +
                                 std::to_string(step));
        }
    }
    start.complex = complex; // a copy has no spare capacity
}

StepReport advance(Simulation<double>& simulation, const scenes::Setup& setup, int step) {
    const double time = step * setup.dt;
    const auto& velocity = scenes::velocity_of_step(setup.flow, time, time + setup.dt);
    if (step > 0 && setup.flow.size() > 1 &&
        &velocity != &scenes::velocity_of_step(setup.flow, time - setup.dt, time)) {
        simulation.forget();
    }
    return simulation.step(velocity, time, setup.dt);
}

double starts_mb() {
    double sum = 0;
    for (const auto& [key, start] : starts()) {
        if (start) {
            const auto& complex = start->complex;
            sum += mb(complex.vertices) + mb(complex.triangles) + mb(complex.ids.vertices) +
                   mb(complex.ids.triangles);
        }
    }
    return sum;
}

} // namespace dsc::bench

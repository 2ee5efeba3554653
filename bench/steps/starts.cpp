// SPDX-License-Identifier: MIT
#include "starts.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"
#include "scenes/run/start.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace dsc::bench {

namespace {

using Starts = std::map<std::pair<std::string, int>, std::unique_ptr<const Start>>;

Starts& starts() {
    static Starts all;
    return all;
}

std::string scene_of(const std::string& family) {
    if (family == "swirl_step") {
        return "swirl";
    }
    return family == "four_circles_step" ? "speedup-four-circles" : "speedup-scaling";
}

std::unique_ptr<const Start> make_start(const std::string& family, int triangles) {
    constexpr double way_of_a_step = 0.3; // in edge lengths; both scenes move at speed 1
    constexpr double short_way_of_a_step = 0.05;
    constexpr double way_to_the_middle = 0.15;
    auto start = std::make_unique<Start>();
    start->family = family;
    const scenes::Scene& scene = scenes::find_scene(scene_of(family));
    auto& parameters = start->parameters;
    parameters = scene.defaults;
    parameters.h = std::sqrt(4 / (std::sqrt(3.0) * triangles));
    if (family == "swirl_step") {
        // The last steps before it turns back: the interface is at its longest.
        start->setup = scene.prepare(parameters);
        parameters.dt = start->setup.dt;
        start->step = *start->setup.half_step - warm_up_steps - timed_steps;
    } else {
        // In a coarse mesh as many whole steps would lead out of the domain.
        const bool is_coarse = triangles < 14000;
        parameters.dt = (is_coarse ? short_way_of_a_step : way_of_a_step) * parameters.h;
        const int middle = static_cast<int>(std::lround(way_to_the_middle / parameters.dt));
        start->step = std::max(0, middle - timed_steps / 2 - warm_up_steps);
        parameters.steps = start->step + warm_up_steps + timed_steps;
        start->setup = scene.prepare(parameters);
    }

    Complex<double> complex = scenes::first_complex<double>(start->setup, parameters);
    const Options<double> options = scenes::scene_options<double>(parameters);
    Simulation<double> simulation(complex, options);
    const auto& velocity = start->setup.flow.front().velocity;
    for (int step = 0; step < start->step; ++step) {
        const StepReport report = simulation.step(velocity, step * parameters.dt, parameters.dt);
        if (report.unreached > 0 || report.gave_up != GiveUp::none) {
            throw InvariantError("a vertex did not arrive on the way to the start, in step " +
                                 std::to_string(step));
        }
    }
    start->complex = complex; // a copy has no spare capacity
    return start;
}

template <class Item>
double mb(const std::vector<Item>& items) {
    return static_cast<double>(items.capacity() * sizeof(Item)) * 1e-6;
}

} // namespace

const Start& start_of(const std::string& family, int triangles) {
    auto& start = starts()[{family, triangles}];
    if (!start) {
        start = make_start(family, triangles);
    }
    return *start;
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

// SPDX-License-Identifier: MIT
#include "accuracy.h"

#include "dsc/base/error.h"
#include "measures/convergence.h"

#include <algorithm>
#include <cmath>

namespace dsc::gate {

namespace {

using scenes::RunResult;
using Settings = std::vector<std::string>;

struct Flow {
    std::string name;
    std::string scene;
    Settings settings;
};

// The vertex spacing of the cubic interpolation needs small time steps: RK4 is of fourth order as
// well.
const std::vector<Flow>& flows() {
    static const std::vector<Flow> all{
        {"vortex T=2 h=1/128", "single-vortex", {"period=2", "h=0.0078125"}},
        {"vortex T=8 h=1/16", "single-vortex", {"h=0.0625", "dt=0.08"}},
        {"vortex T=8 h=1/128", "single-vortex", {"h=0.0078125"}},
        {"vortex T=8 h=1/128 never", "single-vortex", {"h=0.0078125", "coarsening=never"}},
        {"vortex T=8 h=1/64 cubic",
         "single-vortex",
         {"h=0.015625", "dt=0.0078125", "reading=cubic", "coarsening=never"}},
        {"vortex T=8 h=1/96 cubic",
         "single-vortex",
         {"h=0.01041666666666667", "dt=0.005", "reading=cubic", "coarsening=never"}},
        {"vortex T=8 h=1/128 cubic",
         "single-vortex",
         {"h=0.0078125", "dt=0.00390625", "reading=cubic", "coarsening=never"}},
        {"vortex T=8 h=1/256 cubic",
         "single-vortex",
         {"h=0.00390625", "dt=0.001953125", "reading=cubic", "coarsening=never"}},
        {"vortex T=8 h=1/128 cubic 1e-4",
         "single-vortex",
         {"h=0.0078125", "dt=0.00390625", "reading=cubic", "deviation=1e-4"}},
        {"swirl 2x260 h=0.02", "swirl", {"h=0.02"}},
        {"swirl 2x260 h=0.01", "swirl", {}},
        {"swirl 2x260 h=0.005", "swirl", {"h=0.005"}},
        {"swirl 2x420 h=0.01", "swirl", {"steps=420"}},
        {"swirl 2x420 h=0.005", "swirl", {"h=0.005", "steps=420"}},
        {"zalesak h=0.01", "zalesak", {}},
        {"vortex-square", "vortex-square", {}},
    };
    return all;
}

Configuration configuration_of(const std::string& name) {
    const auto flow =
        std::ranges::find_if(flows(), [&](const Flow& one) { return one.name == name; });
    if (flow == flows().end()) {
        throw InputError({.what = "unknown flow",
                          .where = "accuracy",
                          .value = "'" + name + "'",
                          .allowed = "those of its table"});
    }
    Configuration configuration;
    configuration.scene = flow->scene;
    configuration.settings = flow->settings;
    return configuration;
}

const RunResult& run_of(Runs& runs, const std::string& name) {
    return finished(runs, configuration_of(name));
}

std::vector<std::string> names_where(const std::function<bool(const Flow&)>& keeps) {
    std::vector<std::string> names;
    for (const Flow& flow : flows()) {
        if (keeps(flow)) {
            names.push_back(flow.name);
        }
    }
    return names;
}

bool contains(const std::string& text, const char* word) {
    return text.find(word) != std::string::npos;
}

// Vertices that are never removed come closer together than triangles of any angle allow; coarse
// meshes cannot resolve the filament.
bool is_well_resolved(const Flow& flow) {
    return !contains(flow.name, "1/16") &&
           std::ranges::find(flow.settings, "coarsening=never") == flow.settings.end();
}

Check of_flow(std::string name, std::string description, std::string unit, bool at_least,
              std::vector<std::string> names, std::function<double(const RunResult&)> figure,
              Culprit culprit) {
    return {std::move(name),
            std::move(description),
            std::move(unit),
            at_least,
            std::move(names),
            [figure = std::move(figure)](Runs& runs, const std::string& flow) {
                return Measured{figure(run_of(runs, flow)), configuration_of(flow)};
            },
            {},
            culprit};
}

// The order of the cubic interpolation, over four sizes.
Measured cubic_order(Runs& runs, const std::string&) {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const char* size : {"1/64", "1/96", "1/128", "1/256"}) {
        const RunResult& r = run_of(runs, std::string("vortex T=8 h=") + size + " cubic");
        sizes.push_back(r.parameters.h);
        errors.push_back(number(r.last, "sd_rel"));
    }
    return {scenes::fit_order(sizes, errors).order, configuration_of("vortex T=8 h=1/256 cubic")};
}

} // namespace

std::vector<Check> accuracy_checks() {
    using enum Culprit;
    const auto any = [](const Flow&) { return true; };
    const auto returns = [](const Flow& flow) { return flow.scene != "zalesak"; };
    const auto swirls = [](const Flow& flow) { return flow.scene == "swirl"; };
    return {
        of_flow(
            "accuracy", "symmetric difference at the end, over the first area", "1", false,
            names_where(any), [](const RunResult& r) { return number(r.last, "sd_rel"); },
            deviation),
        of_flow(
            "accuracy_half", "the same half-way, where a flow that returns cancels nothing", "1",
            false, names_where(returns),
            [](const RunResult& r) { return number(r.half.value(), "sd_rel"); }, deviation),
        of_flow(
            "accuracy_area", "area at the end against the first, off 1", "1", false,
            {"swirl 2x260 h=0.01", "vortex-square"},
            [](const RunResult& r) { return std::abs(r.area_ratio - 1); }, deviation),
        of_flow(
            "accuracy_jagged",
            "turning angles beyond twice the exact curve's and 2 degrees, at the end", "degrees",
            false, names_where(swirls),
            [](const RunResult& r) { return number(r.last, "jaggedness.largest_excess_deg"); },
            turn),
        of_flow(
            "accuracy_angle", "smallest angle at the end", "degrees", true,
            names_where(is_well_resolved),
            [](const RunResult& r) { return number(r.last, "min_angle_deg"); }, sharpest_corner),
        of_flow(
            "accuracy_median_angle", "median of the triangles' smallest angles at the end",
            "degrees", true, names_where(is_well_resolved),
            [](const RunResult& r) { return number(r.last, "median_angle_deg"); }, sharpest_corner),
        of_flow(
            "accuracy_lost", "triangles inverted and vertices that did not arrive", "1", false,
            names_where(any),
            [](const RunResult& r) { return static_cast<double>(r.inverted + r.unreached); },
            first_failure),
        {"accuracy_order",
         "order of the error of the cubic reading, h = 1/64 to 1/256",
         "1",
         true,
         {"vortex T=8 cubic"},
         cubic_order},
    };
}

} // namespace dsc::gate

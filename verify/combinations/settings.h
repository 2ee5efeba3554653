// SPDX-License-Identifier: MIT
// The settings of a row: options, the flow along normals, threads.
#pragma once

#include "combinations/scene.h"
#include "support/topology/changing.h"

#include "dsc/parallel/parallel.h"
#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/growth.h"
#include "thesis/divisions.h"

#include <array>
#include <cmath>

namespace dsc::combinations {

/// The thickness at which a film opens, in edge lengths.
[[nodiscard]] inline double contact_of(const Row& row) {
    return row.topology == Rule::wide ? 1.5 : default_contact;
}

/// `half`: 0 in the first half of the run, 1 in the second.
template <class Real>
[[nodiscard]] SizeOptions<Real> sizes_of(const Row& row, const Scene& scene, int half) {
    SizeOptions<Real> sizes;
    if (row.sizes == Sizes::uniform || (row.sizes == Sizes::switched_on && half == 0) ||
        (row.sizes == Sizes::switched_off && half == 1)) {
        return sizes;
    }
    const Real h = static_cast<Real>(scene.h);
    sizes.growth = 1.3;
    sizes.longest = 4 * h;
    sizes.changes_in_time = row.sizes == Sizes::in_time;
    if (row.sizes == Sizes::by_place || row.sizes == Sizes::in_time) {
        const Real speed = sizes.changes_in_time ? 1 / static_cast<Real>(scene.end) : 0;
        const Real unit = static_cast<Real>(scene.length_unit);
        sizes.by_place = [h, speed, unit](const Point<Real>& p, Real time, Phase) {
            return h * (Real(2.5) + Real(1.5) * std::sin(9 * (p.x() / unit + speed * time)));
        };
    }
    return sizes;
}

/// The options of the simulation in that half of the run.
template <class Real>
[[nodiscard]] test::ChangingOptions<Real> options_of(const Row& row, const Scene& scene, int half) {
    test::ChangingOptions<Real> options;
    const Real h = static_cast<Real>(scene.h);
    options.edge_length = h;
    options.sizes = sizes_of<Real>(row, scene, half);
    scenes::choose_integrator(options, row.integrator);
    options.insertion = row.insertion;
    options.interface.coarsening = row.coarsening;
    options.interface.feature_degrees = 40;
    if (row.inside == Inside::advected) {
        options.advected_phases = {1};
    }
    auto& topology = options.topology;
    topology.rule = row.topology == Rule::keep ? Topology::keep : Topology::change;
    switch (row.topology) {
    case Rule::keep:
    case Rule::change: break;
    case Rule::forbidden: topology.may_change = [](const Contact&) { return false; }; break;
    case Rule::given_back: topology.gives_back_area = true; break;
    case Rule::wide: topology.contact = static_cast<Real>(contact_of(row)) * h; break;
    case Rule::min_area: topology.min_area = 4 * h * h; break;
    }
    return options;
}

/// The options of `grow` and `shrink`.
template <class Real>
[[nodiscard]] GrowthOptions<Real> growth_of(const Row& row, const Scene& scene) {
    const double unit = scene.length_unit / scene.time_unit;
    const double speed = row.motion == Motion::grow ? unit : -unit;
    GrowthOptions<Real> options;
    options.speeds = {{1, 0, speed}};
    if (row.phases == Phases::nested) {
        options.speeds.push_back({2, 1, speed / 2});
    } else if (row.phases == Phases::junctions) {
        options.speeds.push_back({2, 0, speed});
    }
    return options;
}

/// The options of `curvature` and `vanish`.
[[nodiscard]] inline CurvatureFlowOptions bending_of(const Scene& scene) {
    return {.mobility = scene.length_unit * scene.length_unit / scene.time_unit};
}

/// The parallel options of all ways but the sequential one.
[[nodiscard]] inline Parallel parallel_of(const Row& row, std::uint32_t threads) {
    constexpr std::array divisions{&cells_division,    &cells_division,  &fixed_division,
                                   &counting_division, &active_division, &blocks_division,
                                   &copy_division};
    constexpr std::array submeshes{0U, 2U, 9U};
    return {.threads = threads,
            .division = divisions[static_cast<std::size_t>(row.way)],
            .submeshes = submeshes[static_cast<std::size_t>(row.submeshes)],
            .always_all_threads = true};
}

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
#include "combinations/settings.h"
#include "thesis/divisions.h"

#include <array>
#include <cmath>

namespace dsc::combinations {

namespace {

template <class Real>
SizeOptions<Real> sizes_of(const Row& row, const Scene& scene, int half) {
    SizeOptions<Real> sizes;
    const Sizes asked = row.sizes;
    if (asked == Sizes::uniform || (asked == Sizes::switched_on && half == 0) ||
        (asked == Sizes::switched_off && half == 1)) {
        return sizes;
    }
    const Real h = static_cast<Real>(scene.h);
    sizes.growth = 1.3;
    sizes.longest = 4 * h;
    if (asked == Sizes::by_place || asked == Sizes::in_time) {
        const bool changes = asked == Sizes::in_time;
        const Real end = static_cast<Real>(scene.end);
        sizes.by_place = [h, end, changes](const Point<Real>& p, Real time, Phase) {
            const Real x = p.x() + (changes ? time / end : Real(0));
            return h * (Real(2.5) + Real(1.5) * std::sin(9 * x));
        };
        sizes.changes_in_time = changes;
    }
    return sizes;
}

} // namespace

template <class Real>
test::ChangingOptions<Real> options_of(const Row& row, const Scene& scene, int half) {
    test::ChangingOptions<Real> options;
    const Real h = static_cast<Real>(scene.h);
    options.edge_length = h;
    options.sizes = sizes_of<Real>(row, scene, half);
    scenes::choose_integrator(options, row.integrator);
    options.insertion = row.insertion;
    options.interface.coarsening = row.coarsening;
    options.interface.corner_degrees = row.outline == Outline::loose_corners ? 180 : 40;
    if (row.inside == Inside::carried) {
        options.carried_phases = {1};
    }
    auto& topology = options.topology;
    topology.rule = row.topology == Rule::keep ? Topology::keep : Topology::change;
    switch (row.topology) {
    case Rule::keep:
    case Rule::change: break;
    case Rule::forbidden: topology.may_change = [](const Contact&) { return false; }; break;
    case Rule::given_back: topology.gives_back_area = true; break;
    case Rule::wide: topology.contact = static_cast<Real>(contact_of(row)) * h; break;
    case Rule::least_area: topology.least_area = 4 * h * h; break;
    }
    return options;
}

template <class Real>
GrowthOptions<Real> growth_of(const Row& row) {
    const double speed = row.motion == Motion::grow ? 1 : -1;
    GrowthOptions<Real> options;
    options.speeds = {{1, 0, speed}};
    if (row.phases == Phases::nested) {
        options.speeds.push_back({2, 1, speed / 2});
    } else if (row.phases == Phases::junctions) {
        options.speeds.push_back({2, 0, speed});
    }
    return options;
}

Parallel parallel_of(const Row& row, std::uint32_t threads) {
    constexpr std::array divisions{&cells_division,    &cells_division,  &fixed_division,
                                   &counting_division, &active_division, &blocks_division,
                                   &copy_division};
    constexpr std::array submeshes{0U, 2U, 4U, 9U};
    Parallel parallel;
    parallel.threads = threads;
    parallel.division = divisions[static_cast<std::size_t>(row.way)];
    parallel.submeshes = submeshes[static_cast<std::size_t>(row.submeshes)];
    parallel.always_all_threads = true;
    return parallel;
}

double contact_of(const Row& row) { return row.topology == Rule::wide ? 1.5 : default_contact; }

template test::ChangingOptions<double> options_of(const Row&, const Scene&, int);
template test::ChangingOptions<float> options_of(const Row&, const Scene&, int);
template GrowthOptions<double> growth_of(const Row&);
template GrowthOptions<float> growth_of(const Row&);

} // namespace dsc::combinations

// SPDX-License-Identifier: MIT
#include "measures/grains.h"

#include "dsc/base/error.h"
#include "dsc/geometry/triangle.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

namespace dsc::scenes {

namespace {

void check_positive(double value, const char* name) {
    if (!(value > 0) || !std::isfinite(value)) {
        throw InputError({.what = std::string(name) + " out of range",
                          .where = "measure_growth",
                          .value = std::to_string(value),
                          .allowed = "a finite number above 0"});
    }
}

using Members = std::vector<std::size_t>;

std::map<Phase, Members> by_phase(std::span<const Grain> grains) {
    std::map<Phase, Members> members;
    for (std::size_t i = 0; i < grains.size(); ++i) {
        members[grains[i].phase].push_back(i);
    }
    return members;
}

// The member whose centre is nearest; of several, the first.
std::size_t nearest(const Point<double>& to, std::span<const Grain> grains,
                    const Members& members) {
    return *std::ranges::min_element(
        members, {}, [&](std::size_t i) { return (grains[i].centre - to).squaredNorm(); });
}

// The value that the given share of the sorted values does not exceed.
double quantile(const std::vector<double>& sorted, double share) {
    const auto rank = std::ceil(share * static_cast<double>(sorted.size()));
    return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

} // namespace

template <class Real>
std::vector<Grain> measure_grains(const Complex<Real>& complex) {
    const Components found = components(complex);
    std::vector<Grain> grains;
    grains.reserve(found.list.size());
    for (const Component& component : found.list) {
        grains.push_back({.phase = component.phase,
                          .area = component.area,
                          .holes = component.holes(),
                          .touches_border = component.touches_border});
    }
    for (const Triangle t : triangles(complex)) {
        std::array<Point<double>, 3> at;
        std::ranges::transform(complex.vertices_of(t), at.begin(), [&](Vertex v) {
            return Point<double>(complex.position(v).template cast<double>());
        });
        Grain& grain = grains[found.of[t.id]];
        grain.centre += area(at[0], at[1], at[2]) / (3 * grain.area) * (at[0] + at[1] + at[2]);
    }
    for_each_outline(complex, [&](std::span<const Corner> outline) {
        const auto beyond = [&](Corner c) { return found.of[triangle_of(complex.twin(c))]; };
        std::uint32_t before = beyond(outline.back());
        std::uint32_t& sides = grains[found.of[triangle_of(outline.front())]].sides;
        for (const Corner c : outline) {
            const std::uint32_t here = beyond(c);
            sides += here == before ? 0U : 1U;
            before = here;
        }
    });
    return grains;
}

GrainStatistics summarise(std::span<const Grain> grains) {
    GrainStatistics statistics{.count = grains.size()};
    for (const Grain& grain : grains) {
        statistics.mean_area += grain.area / static_cast<double>(grains.size());
        if (!grain.touches_border) {
            statistics.with_sides.resize(
                std::max(statistics.with_sides.size(), std::size_t{grain.sides} + 1));
            ++statistics.with_sides[grain.sides];
        }
    }
    return statistics;
}

double growth_by_sides(const Grain& grain, double multiplier) {
    return multiplier * std::numbers::pi / 3 *
           (static_cast<double>(grain.sides) + 6.0 * grain.holes - 6);
}

std::vector<GrainGrowth> measure_growth(std::span<const Grain> before, std::span<const Grain> after,
                                        const GrowthOptions& options) {
    check_positive(options.duration, "duration");
    check_positive(options.multiplier, "multiplier");
    const auto then = by_phase(before);
    const auto now = by_phase(after);
    std::vector<GrainGrowth> growth;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Grain& old = before[i];
        const auto members = now.find(old.phase);
        if (members == now.end()) {
            continue;
        }
        const std::size_t match = nearest(old.centre, after, members->second);
        const Grain& grain = after[match];
        if (nearest(grain.centre, before, then.at(old.phase)) != i || old.touches_border ||
            grain.touches_border || grain.sides != old.sides || grain.holes != old.holes) {
            continue;
        }
        const double rate = (grain.area - old.area) / options.duration;
        const double expected = growth_by_sides(old, options.multiplier);
        const double scale =
            expected == 0 ? options.multiplier * std::numbers::pi / 3 : std::abs(expected);
        growth.push_back({old, rate, expected, std::abs(rate - expected) / scale});
    }
    return growth;
}

GrowthFigures summarise(std::span<const GrainGrowth> growth) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (growth.empty()) {
        return {0, nan, nan, nan};
    }
    std::vector<double> errors;
    for (const GrainGrowth& one : growth) {
        errors.push_back(one.error_rel);
    }
    std::ranges::sort(errors);
    return {growth.size(), quantile(errors, 0.5), quantile(errors, 0.9), errors.back()};
}

template std::vector<Grain> measure_grains(const Complex<double>&);
template std::vector<Grain> measure_grains(const Complex<float>&);

} // namespace dsc::scenes

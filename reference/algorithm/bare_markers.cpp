// SPDX-License-Identifier: MIT
#include "reference/algorithm/bare_markers.h"

#include "dsc/base/error.h"

#include <string>

namespace dsc::reference {

namespace {

constexpr std::size_t fewest_markers = 8;

void check_count(std::size_t count, const std::string& where) {
    if (count < 4) {
        throw InputError({.what = "too few markers",
                          .where = where,
                          .value = std::to_string(count),
                          .allowed = "at least 4"});
    }
}

// The four markers around the edge from marker i to the next one.
struct Neighbours {
    const Point<double>& before;
    const Point<double>& first;
    const Point<double>& second;
    const Point<double>& after;
};

Neighbours around_edge(std::span<const Point<double>> markers, std::size_t i) {
    const std::size_t n = markers.size();
    return {markers[(i + n - 1) % n], markers[i], markers[(i + 1) % n], markers[(i + 2) % n]};
}

} // namespace

void move_markers(Markers& markers, const BatchVelocity& velocity, double time, double dt) {
    const std::size_t n = markers.size();
    Markers k1(n);
    Markers k2(n);
    Markers k3(n);
    Markers k4(n);
    Markers at(n);
    const auto shifted = [&](const Markers& slope, double by) -> const Markers& {
        for (std::size_t i = 0; i < n; ++i) {
            at[i] = markers[i] + by * slope[i];
        }
        return at;
    };
    velocity(markers, time, k1);
    velocity(shifted(k1, 0.5 * dt), time + 0.5 * dt, k2);
    velocity(shifted(k2, 0.5 * dt), time + 0.5 * dt, k3);
    velocity(shifted(k3, dt), time + dt, k4);
    for (std::size_t i = 0; i < n; ++i) {
        markers[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
}

MarkerCounts space_markers(Markers& markers, const MarkerOptions& options) {
    check_count(markers.size(), "space_markers");
    if (!(options.shortest >= 0 && options.shortest < 0.5 * options.longest)) {
        throw InputError(
            {.what = "bad band of edge lengths",
             .where = "space_markers: shortest",
             .value = std::to_string(options.shortest),
             .allowed = "from 0 to half of longest (" + std::to_string(options.longest) + ")"});
    }
    MarkerCounts counts;
    Markers halved;
    halved.reserve(markers.size());
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const auto [before, first, second, after] = around_edge(markers, i);
        halved.push_back(first);
        if ((second - first).norm() > options.longest) {
            halved.push_back(options.insertion(before, first, second, after));
            ++counts.inserted;
        }
    }
    markers.clear();
    for (std::size_t i = 0; i < halved.size(); ++i) {
        // The edge from the last marker to the first is not changed.
        const bool is_short = i + 1 < halved.size() &&
                              (halved[i + 1] - halved[i]).norm() < options.shortest &&
                              halved.size() - counts.removed > fewest_markers;
        if (is_short) {
            ++counts.removed;
            ++i; // its neighbour stays, even if the next edge is short
        }
        markers.push_back(halved[i]);
    }
    return counts;
}

Markers read_as_cubic(std::span<const Point<double>> markers, int parts) {
    check_count(markers.size(), "read_as_cubic");
    if (parts < 1) {
        throw InputError({.what = "bad number of parts",
                          .where = "read_as_cubic",
                          .value = std::to_string(parts),
                          .allowed = "at least 1"});
    }
    Markers result;
    result.reserve(markers.size() * static_cast<std::size_t>(parts));
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const auto [before, first, second, after] = around_edge(markers, i);
        result.push_back(first);
        for (int part = 1; part < parts; ++part) {
            result.push_back(
                lagrange_point_at(before, first, second, after, static_cast<double>(part) / parts));
        }
    }
    return result;
}

} // namespace dsc::reference

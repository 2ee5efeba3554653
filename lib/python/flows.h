// SPDX-License-Identifier: MIT
// Flows: Python functions, and the library's own flows.
#pragma once

#include "python/arrays.h"

#include "geometric_flows/geometric_flows.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

namespace dsc::python {

/// Copies the result of a Python function. Throws InputError unless it is array-like, with a row
/// for each velocity.
template <int N>
void read(const py::object& returned, const char* where,
          std::span<Eigen::Matrix<double, N, 1>> velocities) {
    const py::object rows =
        py::module_::import("dsc.arrays").attr("points")(returned, where, velocities.size(), N);
    std::ranges::copy(rows.cast<PointList<N>>(), velocities.begin());
}

/// Calls `function(x, t)`. `Simulation::step` passes on its exceptions.
template <int N>
[[nodiscard]] auto velocity_of(const py::function& function) {
    using Row = Eigen::Matrix<double, N, 1>;
    return [shared = share(function)](std::span<const Row> positions, double time,
                                      std::span<Row> velocities) {
        const py::gil_scoped_acquire gil;
        read<N>((*shared)(array_of(positions), time), "what the velocity returns", velocities);
    };
}

/// The motion of a simulation's interface; made by dsc/flows.py. Steps run without the GIL.
struct AnyFlow {
    std::function<StepReport(Simulation<double>& simulation, double time, double dt)> step;
    std::optional<GrowthOptions<double>> growth = {}; ///< needs a simulation made for it
};

} // namespace dsc::python

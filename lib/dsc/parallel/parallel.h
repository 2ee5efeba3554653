// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/algorithm/simulation.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace dsc {

/// How the mesh is divided into submeshes.
enum class Division : std::uint8_t {
    fixed,    ///< slabs of equal width (thesis, section 6.3)
    counting, ///< slabs of equal numbers of triangles (thesis, section 6.3)
    active,   ///< slabs of equal work
    blocks,   ///< in two directions, with three colours (thesis, section 6)
    cells,    ///< that follow the interface, which is where the work is
    copy,     ///< slabs that are copied out and merged (thesis, algorithms 6.1 and 6.2)
};

inline constexpr std::array<std::pair<Division, std::string_view>, 6> all_divisions{{
    {Division::fixed, "fixed"},
    {Division::counting, "counting"},
    {Division::active, "active"},
    {Division::blocks, "blocks"},
    {Division::cells, "cells"},
    {Division::copy, "copy"},
}};

/// The result depends on `division` and `submeshes`, and on nothing else here.
struct Parallel {
    std::uint32_t threads = 1;
    Division division = Division::cells;
    std::uint32_t submeshes = 0;     ///< 0: 8 slabs, 16 blocks, or as many cells as pay
    double degrees = 0;              ///< slabs are cut across this direction, from the x axis
    bool follow_shape = false;       ///< slabs are cut across the direction of the shape instead
    bool always_all_threads = false; ///< also where there is too little to do for them
    bool profile = false;            ///< an account of times (see in_place/step_profile.h)
};

/// The submeshes that this makes: the number asked for, or the division's own; 0: chosen as it
/// runs.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor that runs so. Throws InputError where the options make no sense together.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc

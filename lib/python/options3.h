// SPDX-License-Identifier: MIT
// The options of a simulation of tets as keyword arguments, in a table of their own.
#pragma once

#include "python/options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace dsc::python {

/// All options of `Simulation(mesh, **options)` of a `Mesh3`, and of its first complex.
struct Choices3 {
    dsc3::Options options;
    dsc3::InitialOptions initial = {.edge_length = 0}; ///< must be given
    std::optional<std::uint32_t> threads;              ///< of `dsc3::Parallel`, like the next one
    std::optional<std::uint32_t> submeshes;

    /// Empty if none of the two was given: the simulation is then sequential.
    [[nodiscard]] std::optional<dsc3::Parallel> parallel() const;
};

/// As for `Choices`.
void apply(Choices3& choices, const py::dict& keywords, Use use = Use::simulation);
[[nodiscard]] py::dict values_of(const Choices3& choices);
[[nodiscard]] std::string option3_help(Use use = Use::simulation);

} // namespace dsc::python

// SPDX-License-Identifier: MIT
// The options of a simulation as keyword arguments, in one table: what is set, what is read back,
// what errors allow and what the help says come from it.
#pragma once

#include "python/arrays.h"

#include "dsc/parallel/executors.h"
#include "topology/topology.h"

#include <cstdint>
#include <optional>
#include <string>

namespace dsc::python {

/// A division by its name.
struct ChosenDivision {
    const Division* division = nullptr;
    bool operator==(const ChosenDivision&) const = default;
};

/// All that `Simulation(mesh, **options)` takes.
struct Choices {
    Options<double> options;
    TopologyOptions<double> topology;
    Detail detail = InitialOptions{}.detail;                     ///< of the initial complex
    double border_tolerance = InitialOptions{}.border_tolerance; ///< the same
    Coverage coverage = InitialOptions{}.coverage;               ///< the same
    std::optional<std::uint32_t> threads; ///< of `Parallel`, like the next two
    std::optional<ChosenDivision> division;
    std::optional<std::uint32_t> submeshes;

    /// Nothing if none of these was given: the simulation is sequential.
    [[nodiscard]] std::optional<Parallel> parallel() const;
};

/// What keywords are given to.
enum class Use : std::uint8_t {
    simulation,      ///< all
    initial_complex, ///< the sizes of edges
};

/// Sets what the keywords name. Throws InputError for an unknown one or a value of another type.
void apply(Choices& choices, const py::dict& keywords, Use use = Use::simulation);

/// All values, by name.
[[nodiscard]] py::dict values_of(const Choices& choices);

/// For each option its name, type and default, and what it is, as numpydoc has them.
/// The name of an option now; warns in Python if `name` is that of release 0.1.
[[nodiscard]] std::string current_option(const std::string& name);

[[nodiscard]] std::string option_help(Use use = Use::simulation);

} // namespace dsc::python

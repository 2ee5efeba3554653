// SPDX-License-Identifier: MIT
// The options of a simulation as keyword arguments, in one table, which is used for setting,
// reading, errors and help texts.
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

/// All options of `Simulation(mesh, **options)`.
struct Choices {
    Options<double> options;
    TopologyOptions<double> topology;
    Detail detail = InitialOptions{}.detail;                     ///< of the initial complex
    double border_tolerance = InitialOptions{}.border_tolerance; ///< the same
    Coverage coverage = InitialOptions{}.coverage;               ///< the same
    std::optional<std::uint32_t> threads; ///< of `Parallel`, like the next two
    std::optional<ChosenDivision> division;
    std::optional<std::uint32_t> submeshes;

    /// Empty if none of these was given: the simulation is then sequential.
    [[nodiscard]] std::optional<Parallel> parallel() const;
};

/// The function to which keywords are given.
enum class Use : std::uint8_t {
    simulation,      ///< all
    initial_complex, ///< the sizes of edges
};

/// Sets options from keywords. Throws InputError for an unknown keyword or a value of the wrong
/// type.
void apply(Choices& choices, const py::dict& keywords, Use use = Use::simulation);

/// All values, by name.
[[nodiscard]] py::dict values_of(const Choices& choices);

/// The current name of an option; warns in Python if `name` is the one of release 0.1.
[[nodiscard]] std::string current_option(const std::string& name);

/// The help text: name, type, default and meaning of each option, in the style of numpydoc.
[[nodiscard]] std::string option_help(Use use = Use::simulation);

} // namespace dsc::python

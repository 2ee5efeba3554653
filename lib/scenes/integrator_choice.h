// SPDX-License-Identifier: MIT
// The integrators of scenes: those of the core, and that of the thesis.
#pragma once

#include "dsc/base/names.h"
#include "dsc/passes/options.h"
#include "thesis/algorithm/centred_difference.h"

#include <cstdint>

namespace dsc::scenes {

enum class IntegratorChoice : std::uint8_t { euler, centred, midpoint, rk4, adaptive };

inline constexpr std::array integrator_choice_names{
    Named{IntegratorChoice::euler, "euler"},       Named{IntegratorChoice::centred, "centred"},
    Named{IntegratorChoice::midpoint, "midpoint"}, Named{IntegratorChoice::rk4, "rk4"},
    Named{IntegratorChoice::adaptive, "adaptive"},
};

[[nodiscard]] constexpr std::string_view to_string(IntegratorChoice choice) {
    return name_in(integrator_choice_names, choice);
}

/// Sets the integrator of the options.
template <class Real>
void choose_integrator(Options<Real>& options, IntegratorChoice choice) {
    if (choice == IntegratorChoice::centred) {
        options.custom_integrator = centred_difference<Real>();
    } else {
        options.custom_integrator = nullptr;
        options.integrator = value_in(integrator_names, to_string(choice)).value();
    }
}

} // namespace dsc::scenes

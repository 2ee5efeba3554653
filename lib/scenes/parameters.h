// SPDX-License-Identifier: MIT
// What the command line can set of a scene (--set key=value). Each scene names the keys that make
// sense for it; anything else is refused.
#pragma once

#include "dsc/passes/options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dsc::scenes {

enum class RealType : std::uint8_t { double_precision, single_precision };

struct Parameters {
    double h = 0.02;   ///< target edge length, in units of the domain
    double dt = 0.01;  ///< time step
    int steps = 0;     ///< time steps; of the swirl: each way
    double period = 0; ///< time from start to return of a reversing flow; 0: none
    Integrator integrator = Integrator::rk4;
    double tolerance = Options<double>{}.tolerance; ///< of `adaptive`, in edge lengths
    Insertion insertion = Insertion::cubic;
    InterfaceThresholds interface;
    RealType real = RealType::double_precision;
    std::uint64_t seed = 0; ///< shuffles the order in which the interface is worked through; 0: not
};

/// Sets one key from text. Throws InputError for an unknown key (naming those of `keys`), a value
/// that is no number, or one out of range.
void set_parameter(Parameters& parameters, const std::vector<std::string>& keys,
                   const std::string& key, const std::string& value);

} // namespace dsc::scenes

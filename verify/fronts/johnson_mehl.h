// SPDX-License-Identifier: MIT
// How exactly fronts meet: discs that grow until the unit square is full, against the exact diagram
// (flows/growing_discs.h).
#pragma once

#include "dsc/complex/complex.h"
#include "flows/growing_discs.h"

#include <map>
#include <string>

namespace dsc::fronts {

struct Case {
    int number = 3;
    std::uint64_t seed = 0;
    double h = 0.02;
    double step = 0.5;         ///< in edge lengths
    double contact = 0;        ///< in edge lengths; 0: the library's default
    std::uint32_t threads = 1; ///< 1: sequential
};

struct Result {
    scenes::DiagramError last;
    double time = 0; ///< time at which the square was full
    bool is_full = false;
    bool is_valid = false;
    std::map<std::string, int> events;
    std::uint64_t unreached = 0;
    double min_angle_last = 0; ///< in degrees
    double min_angle_ever = 0; ///< after any step
    double seconds = 0;        ///< of the steps
    std::uint64_t mesh_hash = 0;
};

[[nodiscard]] Complex<double> first_complex(const scenes::GrowingDiscs& discs, double h);
[[nodiscard]] Result run(const Case& one);

} // namespace dsc::fronts

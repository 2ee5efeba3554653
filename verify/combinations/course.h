// SPDX-License-Identifier: MIT
// One run of a row, from the first complex to the last.
#pragma once

#include "combinations/scene.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/complex.h"

#include <string>
#include <vector>

namespace dsc::combinations {

/// What a run left.
template <class Real>
struct Outcome {
    Complex<Real> first;
    Complex<Real> middle; ///< after half of the steps
    Complex<Real> last;
    std::vector<double> times; ///< at which sub-steps began: those of a step are of one length
    std::vector<Real> asked;   ///< times for which a velocity was asked, each once
    std::uint64_t hash = 0;
    std::uint64_t unreached = 0; ///< but for those that the row itself holds
    std::uint64_t held = 0;
    std::size_t events = 0;
    std::uint32_t threads = 1;   ///< most that were used
    std::uint32_t submeshes = 1; ///< of the first colour, most
    std::vector<std::string> problems;
};

/// Without its interruption if `is_unbroken`.
template <class Real>
[[nodiscard]] Outcome<Real> run_course(const Row& row, const Scene& scene, std::uint32_t threads,
                                       bool is_unbroken);

} // namespace dsc::combinations

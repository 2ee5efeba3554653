// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

namespace dsc {

template <class Real>
Algorithm<Real> default_algorithm() {
    Algorithm<Real> algorithm;
    algorithm.upkeep.push_back({"interface upkeep", &upkeep_interface<Real>, true});
    algorithm.motion.push_back({"movement", &move_vertices<Real>, true});
    algorithm.motion.push_back({"mesh update", &update_mesh<Real>, true});
    return algorithm;
}

template Algorithm<double> default_algorithm();
template Algorithm<float> default_algorithm();

} // namespace dsc

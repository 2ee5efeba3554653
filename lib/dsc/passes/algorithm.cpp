// SPDX-License-Identifier: MIT
#include "dsc/passes/algorithm.h"

namespace dsc {

template <class Real>
Algorithm<Real> default_algorithm() {
    return {.upkeep = {{"interface upkeep", &upkeep_interface<Real>, true}},
            .motion = {{"movement", &move_vertices<Real>, true},
                       {"mesh update", &update_mesh<Real>, true}}};
}

template Algorithm<double> default_algorithm();
template Algorithm<float> default_algorithm();

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/catalogue/families.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

Setup scheduled(const Parameters& p, double duration, double default_dt) {
    Setup setup;
    setup.dt = p.dt > 0 ? p.dt : (p.steps > 0 ? duration / p.steps : default_dt);
    setup.steps = p.steps;
    if (setup.steps == 0) {
        const double count = std::max(1.0, std::round(duration / setup.dt));
        require(count <= 1e8, "--set dt", setup.dt,
                "at most 100000000 steps for a duration of " + to_text(duration));
        setup.steps = static_cast<int>(count);
        if (p.dt <= 0) {
            setup.dt = duration / setup.steps; // a whole number of steps ends where the scene ends
        }
    }
    return setup;
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/catalogue/families.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

Schedule schedule(const Parameters& p, double duration, double default_dt) {
    Schedule s{p.dt > 0 ? p.dt : (p.steps > 0 ? duration / p.steps : default_dt), p.steps};
    if (s.steps == 0) {
        const double count = std::max(1.0, std::round(duration / s.dt));
        if (count > 1e8) {
            throw InputError({.what = "time step too small",
                              .where = "--set dt",
                              .value = std::to_string(s.dt),
                              .allowed = "at most 100000000 steps for a duration of " +
                                         std::to_string(duration)});
        }
        s.steps = static_cast<int>(count);
        if (p.dt <= 0) {
            s.dt = duration / s.steps; // a whole number of steps ends where the scene ends
        }
    }
    return s;
}

Setup scheduled(const Parameters& parameters, double duration, double default_dt) {
    const Schedule s = schedule(parameters, duration, default_dt);
    Setup setup;
    setup.dt = s.dt;
    setup.steps = s.steps;
    return setup;
}

} // namespace dsc::scenes

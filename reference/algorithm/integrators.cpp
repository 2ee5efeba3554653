// SPDX-License-Identifier: MIT
#include "reference/algorithm/integrators.h"

namespace dsc::reference {

Point<double> advect(const Velocity& velocity, const Point<double>& p, double time, double dt,
                     Integrator integrator) {
    const Point<double> k1 = velocity(p, time);
    if (integrator == Integrator::euler) {
        return p + dt * k1;
    }
    const double half = time + 0.5 * dt;
    const Point<double> k2 = velocity(p + 0.5 * dt * k1, half);
    if (integrator == Integrator::midpoint) {
        return p + dt * k2;
    }
    const Point<double> k3 = velocity(p + 0.5 * dt * k2, half);
    const Point<double> k4 = velocity(p + dt * k3, time + dt);
    return p + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

} // namespace dsc::reference

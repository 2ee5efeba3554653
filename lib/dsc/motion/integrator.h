// SPDX-License-Identifier: MIT
// From a velocity field to target positions (thesis, section 5.1, equation 5). One call evaluates
// all vertices, so that the overhead of a call is paid once and the field can use vector
// instructions. An application may supply its own integrator: a multistep method, one with an error
// estimate, or one of another order.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "dsc/complex/complex.h"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace dsc {

/// velocities[i] = v(positions[i], time). Called from several threads at once by the parallel
/// driver: it must not change shared state. NaN or infinity: the vertex is held and counted.
template <class Real>
using Velocity = std::function<void(std::span<const Point<Real>> positions, Real time,
                                    std::span<Point<Real>> velocities)>;

/// How targets are found from velocities.
enum class Integrator : std::uint8_t {
    euler,    ///< first order, one evaluation a step
    midpoint, ///< second order, two evaluations
    rk4,      ///< fourth order, four evaluations
    adaptive, ///< rk4 with an error estimate that controls the step, five evaluations. The estimate
              ///< is 0 for a velocity that is uniform in space, however it changes in time
};

inline constexpr std::array integrator_names{
    Named{Integrator::euler, "euler"},
    Named{Integrator::midpoint, "midpoint"},
    Named{Integrator::rk4, "rk4"},
    Named{Integrator::adaptive, "adaptive"},
};

[[nodiscard]] constexpr std::string_view to_string(Integrator integrator) {
    return name_in(integrator_names, integrator);
}

/// Arrays that an integrator needs; kept from step to step so that nothing is allocated.
template <class Real>
struct IntegratorScratch {
    std::vector<Point<Real>> first; ///< v(positions, time), as the caller leaves it
    std::vector<Point<Real>> stage; ///< positions of a stage
    std::vector<Point<Real>> slope; ///< velocities of a stage
    std::vector<Point<Real>> sum;   ///< of the weighted velocities
    std::size_t worst = 0;          ///< index of the vertex with the largest error estimate
};

/// targets[i] = where positions[i] is at time + dt. `scratch.first` must hold the velocities at
/// (positions, time), which the driver needs to choose its sub-step. Returns the largest finite
/// estimate of the error of this step, a length; 0 for all methods except `adaptive`. O(n).
template <class Real>
Real integrate(Integrator integrator, const Velocity<Real>& velocity,
               std::span<const Point<Real>> positions, Real time, Real dt,
               std::span<Point<Real>> targets, IntegratorScratch<Real>& scratch);

/// Interface vertices in one sub-step; entry i of each array belongs to the same vertex.
template <class Real>
struct IntegratorStep {
    Complex<Real>& complex;                  ///< its attributes hold the integrator's data for
                                             ///< vertices
    std::span<const std::uint32_t> vertices; ///< those of one submesh
    std::span<const Point<Real>> positions;  ///< at the start
    std::span<Point<Real>> targets;          ///< at the end
    std::span<const std::uint8_t> held; ///< not 0: the velocity is not finite, the vertex stays
    Real dt;                            ///< the duration
};

/// A custom integrator replaces `Options::integrator`. An integrator itself is stateless: data of a
/// vertex belong in an attribute, which follows operations, renumbering, copies and checkpoints
/// automatically. One object can serve several simulations.
template <class Real>
class CustomIntegrator : public Unmovable {
public:
    virtual ~CustomIntegrator() = default;

    /// Adds the attributes that the complex does not have yet. Called when the simulation is made,
    /// whenever its options have changed, and after the application has renumbered or replaced the
    /// complex.
    virtual void begin(Complex<Real>& complex) const { (void)complex; }

    /// Writes all `step.targets`: where `step.positions` are at time + step.dt. `scratch.first`
    /// holds the velocities at `time`, 0 for held vertices. Returns the largest finite estimate of
    /// the error, a length, by which `Options::tolerance` chooses the sub-steps; 0 if there is
    /// none. Called again whenever dt changes, and from several threads at once for different
    /// vertices: it may write only data of these vertices, so that the result is bitwise identical
    /// for any number of threads. Not called for a motion of the whole interface.
    virtual Real integrate(const IntegratorStep<Real>& step, const Velocity<Real>& velocity,
                           Real time, IntegratorScratch<Real>& scratch) const = 0;

    /// Called once per sub-step, before the vertices move to these targets, however the targets
    /// were found; also from several threads at once.
    virtual void accept(const IntegratorStep<Real>& step) const { (void)step; }

    /// The vertices start afresh: the flow has changed abruptly (`Simulation::forget`), another
    /// integrator was used before, or the application or a stage has moved them or changed the
    /// phases beside them. Some may have vanished.
    virtual void forget(Complex<Real>& complex, std::span<const std::uint32_t> vertices) const {
        (void)complex, (void)vertices;
    }
};

} // namespace dsc

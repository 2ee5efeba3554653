// SPDX-License-Identifier: MIT
// From a velocity field to target positions (thesis, section 5.1, equation 5). All vertices are
// evaluated in one call, so that a field pays its overhead once and can use all lanes. An
// application may have an integrator of its own: with a memory, with an estimate of its error, or
// of another order.
#pragma once

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
    adaptive, ///< rk4 with an estimate of its error, from which the step is chosen; five. It
              ///< does not notice a velocity that is equal everywhere and changes in time
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
    std::size_t worst = 0;          ///< the index of the largest error estimate, set with it
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
    Complex<Real>& complex;                  ///< its attributes hold what is remembered of vertices
    std::span<const std::uint32_t> vertices; ///< those of one submesh
    std::span<const Point<Real>> positions;  ///< at the start
    std::span<Point<Real>> targets;          ///< at the end
    std::span<const std::uint8_t> held; ///< not 0: the velocity is not finite, the vertex stays
    Real dt;                            ///< the duration
};

/// Takes the place of `Options::integrator`. An integrator itself does not change: what it
/// remembers of a vertex belongs in an attribute, which follows operations, renumbering, copies and
/// checkpoints by itself. One object can serve several simulations.
template <class Real>
class CustomIntegrator : public Unmovable {
public:
    virtual ~CustomIntegrator() = default;

    /// Makes the attributes that the complex does not have yet. Called when the simulation is made,
    /// whenever its options have changed, and after the application has renumbered or replaced the
    /// complex.
    virtual void begin(Complex<Real>& complex) const { (void)complex; }

    /// Writes all `step.targets`: where `step.positions` are at time + step.dt. `scratch.first`
    /// holds the velocities at `time`, 0 for held vertices. Returns the largest finite estimate of
    /// the error, a length, by which `Options::tolerance` chooses the sub-steps; 0 if there is
    /// none. Called again whenever dt changes; from several threads at once, for different
    /// vertices: only what belongs to these may be written, so that the result is the same to the
    /// bit for any number of threads. Not called for a motion of the whole interface.
    virtual Real integrate(const IntegratorStep<Real>& step, const Velocity<Real>& velocity,
                           Real time, IntegratorScratch<Real>& scratch) const = 0;

    /// The vertices are about to move to these targets, once a sub-step, however the targets were
    /// found. From several threads at once as well.
    virtual void accept(const IntegratorStep<Real>& step) const { (void)step; }

    /// The vertices start afresh: the flow has changed abruptly (`Simulation::forget`), another
    /// integrator was used before, or the application or a stage has moved them or changed the
    /// phases beside them. Some may have vanished.
    virtual void forget(Complex<Real>& complex, std::span<const std::uint32_t> vertices) const {
        (void)complex, (void)vertices;
    }
};

} // namespace dsc

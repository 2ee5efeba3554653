// SPDX-License-Identifier: MIT
// Flows that depend on the interface: besides the positions of its vertices they have access to the
// neighbours along the curve, the phases that meet there, the normal and the curvature.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/motion/integrator.h"

#include <functional>
#include <span>
#include <type_traits>
#include <utility>

namespace dsc {

/// Calls `task(share)` once for each share, from 0 to `shares` - 1, and returns when all are done:
/// several at the same time on the threads of the step, in any order. A share should take more than
/// a few microseconds. The call rethrows an exception of a task.
using InShares =
    std::function<void(std::size_t shares, const std::function<void(std::size_t share)>& task)>;
/// Runs all shares on the calling thread.
inline const InShares one_by_one = [](std::size_t shares, const auto& task) {
    for (std::size_t share = 0; share < shares; ++share) {
        task(share);
    }
};

/// Bits of `InterfaceView::flags`.
enum InterfaceFlag : std::uint8_t {
    /// The vertex is not an ordinary point of a curve: it has arms instead of a previous and a next
    /// vertex. Three phases meet here, two sheets of the interface touch, or a curve arrives at the
    /// domain boundary. Where a pass of the application has just put an edge on the interface, the
    /// vertices beside it count as junctions for one sub-step.
    interface_junction = 1U,
    interface_feature = 2U,  ///< is kept; normal and curvature are not those of a smooth curve
    interface_boundary = 4U, ///< lies on the domain boundary, along which alone it can slide
    interface_locked = 8U,   ///< does not move, whatever its velocity
};

/// An interface edge that leaves a junction.
struct InterfaceArm {
    std::uint32_t neighbour = no_id; ///< index in the view
    Phase left = border_phase;  ///< as seen from the junction; border_phase: outside the domain
    Phase right = border_phase; ///< as seen from the junction
};

/// The interface at one moment. Entry i of each array belongs to the same interface vertex;
/// neighbours are indices into these arrays. Curves are directed so that the larger of their two
/// phases is on the left: the outline of a disc of phase 1 in phase 0 runs counter-clockwise, that
/// of a hole in it clockwise. The outside of the domain, `border_phase`, is always on the right. A
/// closed curve has no first vertex: following `next` leads around it.
///
/// Vertices are in about the order of the curves, submesh by submesh; no flow should depend on
/// that. A view is valid only during the call that receives it.
template <class Real>
struct InterfaceView {
    /// The mesh at the start of the sub-step (not at the stage), and its attributes:
    /// `view.complex.attributes.get<Vertex, double>("speed")[view.vertices[i]]`. Look up the name
    /// once for a range, not for each vertex.
    const Complex<Real>& complex;
    std::span<const Vertex> vertices; ///< handles; i is their index here
    /// Their positions in this stage of the integrator. A vertex that a stage has put ahead of the
    /// time is seen where it is at that time.
    std::span<const Point<Real>> positions;
    std::span<const std::uint32_t> previous; ///< no_id at junctions
    std::span<const std::uint32_t> next;     ///< no_id at junctions
    std::span<const Phase> left;             ///< border_phase at junctions
    std::span<const Phase> right;            ///< border_phase at junctions, and on the boundary
    std::span<const std::uint8_t> flags;     ///< InterfaceFlag

    std::span<const std::uint32_t> junctions; ///< their indices, ascending
    std::span<const std::uint32_t> arm_begin; ///< junction k: arms arm_begin[k] to arm_begin[k + 1]
    std::span<const InterfaceArm> arms;       ///< counter-clockwise about each junction

    /// Distributes the work of an `InterfaceMotion` over the threads of the step. An
    /// `InterfaceFlow` must not use it: several threads call it already.
    const InShares& in_shares = one_by_one;

    /// The number of interface vertices.
    [[nodiscard]] std::size_t size() const { return vertices.size(); }
    /// Whether i is not an ordinary point of a curve; see `interface_junction`.
    [[nodiscard]] bool is_junction(std::size_t i) const {
        return (flags[i] & interface_junction) != 0;
    }
    /// Whether i is a feature.
    [[nodiscard]] bool is_feature(std::size_t i) const {
        return (flags[i] & interface_feature) != 0;
    }
    /// Whether i can only slide along the domain boundary.
    [[nodiscard]] bool is_on_boundary(std::size_t i) const {
        return (flags[i] & interface_boundary) != 0;
    }
};

/// The arms of a junction, counter-clockwise; empty for any other vertex. O(log junctions).
template <class Real>
[[nodiscard]] std::span<const InterfaceArm> arms_of(const InterfaceView<Real>& view, std::size_t i);

/// Whether the phase lies at the interface there. O(1); O(log junctions + arms) at junctions.
template <class Real>
[[nodiscard]] bool borders_on(const InterfaceView<Real>& view, std::size_t i, Phase phase);

/// The unit normal of the circle through the vertex and its two neighbours, from the left phase to
/// the right one: outwards for a disc of phase 1 in phase 0. Zero at junctions, and where
/// neighbours coincide. Second order in the edge length, and exact on circles. O(1).
template <class Real>
[[nodiscard]] Point<Real> normal(const InterfaceView<Real>& view, std::size_t i);

/// The curvature of that circle, in 1 / length; positive where the left phase is convex. Zero at
/// junctions. First order in the edge length, second where neighbouring edges are equally long;
/// exact on circles. O(1).
template <class Real>
[[nodiscard]] Real curvature(const InterfaceView<Real>& view, std::size_t i);

/// The part of the interface that belongs to the vertex: half of each of its edges. O(1); O(log
/// junctions + arms) at junctions.
template <class Real>
[[nodiscard]] Real length(const InterfaceView<Real>& view, std::size_t i);

/// A velocity that depends on the interface: writes velocities[i] for each i in [begin, end).
/// Entries not written are zero: the vertex stays. NaN or infinity: the vertex is held and counted.
///
/// It is called in every stage of the integrator, with the positions of that stage for all vertices
/// (locked and held ones stay where they are), once for each submesh, from several threads at once:
/// it may read the whole view and the complex, which nobody modifies meanwhile, and must write
/// nothing else. The velocity of i must not depend on begin and end: then the result is bitwise
/// identical for any number of threads. `Simulation::step` rethrows its exceptions; the complex
/// stays valid.
///
/// Smoothing flows are stiff: explicit integrators need a step that the limit by speed does not
/// ensure. Where v = -curvature * normal, dt * 4 / l^2 must stay below 2 (euler, midpoint) or 2.78
/// (rk4, adaptive), with l the shortest edge, `shortest * edge_length` of the options.
template <class Real>
using InterfaceFlow =
    std::function<void(const InterfaceView<Real>& view, std::size_t begin, std::size_t end,
                       Real time, std::span<Point<Real>> velocities)>;

/// A flow from a function of one vertex, `Point<Real> function(view, i, time)`.
template <class Real, class Function>
[[nodiscard]] InterfaceFlow<Real> vertex_flow(Function function) {
    using Result =
        std::invoke_result_t<const Function&, const InterfaceView<Real>&, std::size_t, Real>;
    // An Eigen expression would refer to destroyed temporaries.
    static_assert(std::is_same_v<Result, Point<Real>>,
                  "the function must return a dsc::Point: write -> dsc::Point<Real>");
    return [function = std::move(function)](const InterfaceView<Real>& view, std::size_t begin,
                                            std::size_t end, Real time,
                                            std::span<Point<Real>> velocities) {
        for (std::size_t i = begin; i < end; ++i) {
            velocities[i] = function(view, i, time);
        }
    };
}

/// A flow that computes the motion of the whole interface at once, for example from a linear system
/// along the curves: writes into displacements[i] how far vertex i moves from `time` to time + dt.
/// Entries not written are zero: the vertex stays. NaN or infinity: the vertex is held and counted.
///
/// It is called once per sub-step, before anything moves, and again whenever the driver changes dt
/// (always positive); by one thread at a time. Work that it distributes with `view.in_shares` must
/// not depend on which thread runs a share: then the result is bitwise identical for any number of
/// threads. No integrator takes part: the targets are the positions plus the displacements. The
/// driver chooses its sub-steps by displacement / dt. `Simulation::step` rethrows its exceptions;
/// the complex stays valid.
template <class Real>
using InterfaceMotion = std::function<void(const InterfaceView<Real>& view, Real time, Real dt,
                                           std::span<Point<Real>> displacements)>;

/// A velocity that is called once in each stage of the integrator, with all interface vertices of
/// all submeshes, by the thread that calls `Simulation::step`: for a function that is expensive to
/// call, such as one written in Python. The result is bitwise identical to that of the plain
/// velocity.
template <class Real>
struct VelocityAtOnce {
    Velocity<Real> velocity; ///< of positions and time
};

/// Any kind of flow, as the driver passes it to an executor. Refers to the function; cheap to copy.
template <class Real>
class Flow {
public:
    /// A function of positions and time.
    Flow(const Velocity<Real>& velocity) : velocity_(&velocity) {} // NOLINT: all are flows
    /// The same, called once for the whole interface.
    Flow(const VelocityAtOnce<Real>& at_once) // NOLINT: the same
        : velocity_(&at_once.velocity), needs_all_(true) {}
    /// A velocity that depends on the interface.
    Flow(const InterfaceFlow<Real>& along_curves) // NOLINT: the same
        : seeing_(&along_curves), needs_all_(true) {}
    /// A motion of the whole interface.
    Flow(const InterfaceMotion<Real>& motion) // NOLINT: the same
        : motion_(&motion), needs_all_(true) {}

    /// The function of positions and time; null for the two other kinds.
    [[nodiscard]] const Velocity<Real>* velocity() const { return velocity_; }
    /// The velocity that depends on the interface; null for the two other kinds.
    [[nodiscard]] const InterfaceFlow<Real>* seeing() const { return seeing_; }
    /// The motion of the whole interface; null for the two other kinds.
    [[nodiscard]] const InterfaceMotion<Real>* motion() const { return motion_; }

    /// Whether a call needs all submeshes at the same stage of the integrator.
    [[nodiscard]] bool needs_all() const { return needs_all_; }

private:
    const Velocity<Real>* velocity_ = nullptr;
    const InterfaceFlow<Real>* seeing_ = nullptr;
    const InterfaceMotion<Real>* motion_ = nullptr;
    bool needs_all_ = false;
};

} // namespace dsc

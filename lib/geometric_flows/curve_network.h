// SPDX-License-Identifier: MIT
// The interface as a network of straight edges under tension, whose linear system a step of
// curvature flow solves. Everything is in double precision.
#pragma once

#include "dsc/motion/interface_flow.h"

#include "geometric_flows/block.h"
#include "geometric_flows/curve_solver.h"

#include <vector>

namespace dsc {

/// The forces that drive and resist the motion of an interface edge.
struct EdgeForces {
    double tension = 1; ///< energy per length
    double drag = 1;    ///< 1 / mobility
};

struct CurveEdge {
    std::uint32_t from = no_id;
    std::uint32_t to = no_id;
    Phase left = border_phase;
    Phase right = border_phase;
    EdgeForces forces{};
};

/// The directions in which a vertex can move, as a symmetric projection.
struct Freedom {
    double xx = 1;
    double xy = 0;
    double yy = 1;

    /// Whether the vertex can move in all directions, as nearly all can.
    [[nodiscard]] bool is_full() const { return xx == 1 && yy == 1; }
    [[nodiscard]] Vector2 of(const Vector2& p) const {
        return {xx * p.x + xy * p.y, xy * p.x + yy * p.y};
    }
};

/// A constant force on a vertex at which a curve ends on the domain boundary.
struct EndForce {
    std::uint32_t vertex = no_id;
    Vector2 force; ///< energy per length
};

/// Indices are those of the view from which the network was made.
struct CurveNetwork {
    std::vector<Vector2> positions;
    std::vector<CurveEdge> edges; ///< each edge once
    std::vector<Freedom> freedom;
    std::vector<std::uint8_t> is_junction;
    std::vector<std::uint8_t> is_between; ///< by vertex: lies on a curve that ends at junctions
    std::vector<EndForce> ends;           ///< those that are not zero
};

/// Builds the network, reusing its memory. Calls `forces_of(left, right)` for each edge between two
/// phases; edges of the domain boundary get a tension that is negligible, and no drag: their
/// vertices spread evenly between the curves that arrive there. `boundary_energy(phase)` is the
/// energy per length of the boundary under a phase, which pulls at the ends of curves.
/// O(interface).
template <class Real, class ForcesOf, class EnergyUnder>
void find_network(const InterfaceView<Real>& view, const ForcesOf& forces_of,
                  const EnergyUnder& boundary_energy, CurveNetwork& network);

/// The directions in which the vertex can move: none if it is locked or at a corner of the domain,
/// along the boundary if it lies there, otherwise all. O(star) on the boundary, else O(1).
template <class Real>
[[nodiscard]] Freedom freedom_of(const InterfaceView<Real>& view, std::size_t i);

/// Implicit Euler steps of a network. One object can serve several networks in turn, and reuses its
/// memory.
class CurveSystem {
public:
    /// Begins with a network, which must live as long as steps of it are made. O(edges).
    void begin(const CurveGraph& graph);
    /// The displacements in a time dt of vertices that are at `positions`; NaN where the system
    /// cannot be solved. With rows, pressures act during the step, so that their areas gain, to
    /// first order, what the rows ask for. Overwrites the rows. O(vertices), and a sparse solution
    /// for the junctions and pressures.
    void step(std::span<const Vector2> positions, double dt, const InShares& in_shares,
              std::vector<Vector2>& displacements, const PressureRows& rows = {});

private:
    /// The drag of a vertex between two edges of a curve.
    struct Drag {
        double size = 0;
        Vector2 tangent; ///< the sum of the two directions, with either sign

        void add(double more, const Vector2& outwards);
        [[nodiscard]] Freedom across() const;
    };
    void assemble(const CurvePart& part, std::span<const Vector2> positions, double dt,
                  std::span<Vector2> forces);

    const CurveGraph* graph_ = nullptr;
    double fastest_ = 0;          ///< tension / drag at most, in area per time
    std::vector<Freedom> own_;    ///< by vertex: the contribution of its edges to its block
    std::vector<Drag> between_;   ///< by vertex
    std::vector<Block> diagonal_; ///< by vertex
    std::vector<Block> coupling_; ///< by edge
    CurveSolver solver_;
};

template <class Real, class ForcesOf, class EnergyUnder>
void find_network(const InterfaceView<Real>& view, const ForcesOf& forces_of,
                  const EnergyUnder& boundary_energy, CurveNetwork& network) {
    const std::size_t n = view.size();
    network.positions.clear();
    network.freedom.clear();
    network.edges.clear();
    network.ends.clear();
    network.is_junction.assign(n, 0);
    network.is_between.assign(n, 0);
    const auto add = [&](std::size_t from, std::uint32_t to, Phase left, Phase right) {
        constexpr EdgeForces on_boundary{.tension = 1e-9, .drag = 0};
        const bool is_on_boundary = left == border_phase || right == border_phase;
        network.edges.push_back({static_cast<std::uint32_t>(from), to, left, right,
                                 is_on_boundary ? on_boundary : forces_of(left, right)});
    };
    for (std::size_t i = 0; i < n; ++i) {
        network.positions.push_back(vector_of(view.positions[i]));
        network.freedom.push_back(freedom_of(view, i));
        if (!view.is_junction(i) && !view.is_junction(view.next[i])) {
            add(i, view.next[i], view.left[i], view.right[i]);
        }
    }
    for (std::size_t k = 0; k < view.junctions.size(); ++k) {
        const std::uint32_t i = view.junctions[k];
        network.is_junction[i] = 1;
        Vector2 pull;
        Vector2 along_boundary;
        for (std::uint32_t a = view.arm_begin[k]; a < view.arm_begin[k + 1]; ++a) {
            const InterfaceArm& arm = view.arms[a];
            if (arm.left == border_phase || arm.right == border_phase) {
                const Phase phase = arm.left == border_phase ? arm.right : arm.left;
                const Vector2 way = network.positions[arm.neighbour] - network.positions[i];
                pull += boundary_energy(phase) * (way / norm(way));
                along_boundary += way / norm(way);
            }
            const bool is_along = arm.left == view.left[arm.neighbour];
            for (std::uint32_t v = arm.neighbour;
                 !view.is_junction(v) && network.is_between[v] == 0;
                 v = is_along ? view.next[v] : view.previous[v]) {
                network.is_between[v] = 1;
            }
            // An edge between two junctions is also listed at its other end.
            if (!view.is_junction(arm.neighbour) || arm.neighbour > i) {
                add(i, arm.neighbour, arm.left, arm.right);
            }
        }
        // The boundary beside the exterior phase has no arm; its direction is opposite to that of
        // the existing arm.
        pull -= boundary_energy(exterior_phase) * along_boundary;
        if (pull != Vector2{}) {
            network.ends.push_back({i, pull});
        }
    }
}

} // namespace dsc

// SPDX-License-Identifier: MIT
// Curvature flow of networks of curves, with a multiplier for each pair of phases, and with areas
// that are kept where the application asks for it.
#pragma once

#include "dsc/motion/interface_flow.h"

#include <vector>

namespace dsc {

/// A pair of phases with values of its own.
struct PairCurvature {
    Phase one = 0;       ///< either phase of the pair
    Phase other = 1;     ///< the other one
    double tension = 1;  ///< as in `CurvatureFlowOptions`
    double mobility = 1; ///< as in `CurvatureFlowOptions`
};

/// The energy of the domain boundary under a phase; 0 for phases that are not listed.
struct BoundaryEnergy {
    Phase phase = 0;   ///< at the domain boundary
    double energy = 0; ///< per length; only differences matter, so that it may be negative
};

/// A phase whose area is kept.
struct KeptArea {
    Phase phase = 1; ///< not the exterior, 0, whose area is constant if all others are
    double area = 0; ///< in units of the domain; usually `phase_area(complex, phase)` at the start
};

/// The interface between two phases moves along its normal at tension * mobility * curvature
/// towards the inside of its bend. Only the ratios of tensions matter for angles: three phases of
/// equal tensions meet at 120 degrees.
struct CurvatureFlowOptions {
    double tension = 1;  ///< energy per length, 0 or more; of all pairs that are not in `pairs`
    double mobility = 1; ///< velocity per tension and curvature, above 0; of the same pairs
    std::vector<PairCurvature> pairs = {}; ///< values of single pairs, in any order, each pair once
    /// An interface meets the domain boundary at the contact angle of T. Young, "An essay on the
    /// cohesion of fluids" (1805): through phase a against phase b its cosine is the energy under b
    /// minus that under a, divided by the tension. Without these it is 90 degrees.
    std::vector<BoundaryEnergy> boundary_energies = {};
    /// The curves of each of these phases also move at one speed along their normals, which is
    /// found such that the phase ends every sub-step with this area. An area that differs from the
    /// present one is reached in the next sub-step.
    std::vector<KeptArea> kept_areas = {};
};

/// Curvature flow for `Simulation::step`. Second order along the curve and, where curves are closed
/// or end on a straight side of the domain at 90 degrees, in time; of order 3/2 in time at
/// junctions and at other contact angles. The steps may be long: the flow is stable for any, and
/// the driver limits its sub-steps by the distance that a vertex moves, so that they are
/// proportional to the edge length where curves are smooth. Curves at junctions move slightly too
/// slowly with such steps: in steps of w^2 / 320, w^2 / 640 and w^2 / 1280 (tension and mobility 1)
/// a lens of width w loses its area too slowly by 0.18, 0.06 and 0.02 % if all tensions are equal,
/// and by 1.1, 0.4 and 0.14 % if that of the line through it is 1.6 times the others.
///
/// Each step is linear in the new positions, with the lengths of the old ones: G. Dziuk, "An
/// algorithm for evolutionary surfaces" (1990), with lumped masses. Junctions are moved by the
/// normal parts of their curves alone, as in J. W. Barrett, H. Garcke, R. Nürnberg, "On the
/// variational approximation of combined second and fourth order geometric evolution equations"
/// (2007), so that the tensions balance there (Young's law); the vertices of these curves slide
/// along them without drag, and share the stretch. One step and two of half the length are
/// extrapolated to second order in time. Curves that end at the domain boundary slide along it and
/// meet it at 90 degrees, or at the angle that `boundary_energies` asks for. Locked vertices stay.
/// A jagged start becomes smooth at once; set `interface.feature_degrees` to 180, or its corners
/// are kept as features, which block junctions.
///
/// O(interface) for each sub-step if junctions are few, in double precision whatever `Real` is; it
/// allocates. Threads share the curves between junctions, and the three solutions (of the whole
/// step and of its two halves); one thread solves for the junctions and pressures of a solution.
/// The function has no memory: simulations in several threads may share it. Throws InputError if an
/// option is out of range.
template <class Real>
[[nodiscard]] InterfaceMotion<Real> curvature_flow(const CurvatureFlowOptions& options = {});

} // namespace dsc

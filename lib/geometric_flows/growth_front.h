// SPDX-License-Identifier: MIT
// What the pass of growing fronts works on: the mesh, the rays, and the options as lengths and
// angles.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/passes/work.h"
#include "geometric_flows/growth_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

/// The growing fronts of one submesh during the pass.
template <class Real>
struct GrowthFronts {
    Work<Real>& work;
    const GrowthOptions<Real>& options;
    Complex<Real>& complex = work.complex;
    VertexAttribute<FanRay<Real>>& rays = *fan_rays(complex);

    // Angles in radians.
    Real open_angle = radians(options.open_degrees);
    Real fan_angle = radians(options.fan_degrees);
    Real notch_angle = radians(options.notch_degrees);
    Real smooth_angle = radians(options.smooth_degrees);

    /// Added to a notch's way, in edge lengths, to find vertices that it will run over.
    static constexpr double margin = 0.1;

    [[nodiscard]] static Real radians(double degrees) {
        return static_cast<Real>(degrees * std::numbers::pi / 180);
    }
    [[nodiscard]] Real lengths(double relative) const {
        return static_cast<Real>(relative) * work.options.edge_length;
    }
    [[nodiscard]] GrowthBend<Real> bend_of(const Star<Real>& star) const {
        return dsc::bend_of(star, options, work.time);
    }
    [[nodiscard]] bool is_feature(std::uint32_t v) const { return complex.is_feature(Vertex{v}); }
    [[nodiscard]] bool is_in_fan(std::uint32_t v) const {
        return rays[Vertex{v}].state != FanState::none;
    }

    /// Whether both edges of the bend are longer than those that remeshing will remove.
    [[nodiscard]] bool has_room(const GrowthBend<Real>& bend) const {
        return has_longer_edges(bend, lengths(work.options.interface.shortest));
    }

    /// The distance that a vertex moves along its normal in this sub-step.
    [[nodiscard]] Real way(Real speed) const {
        return std::min(std::abs(speed) * work.dt, lengths(work.options.sub_step));
    }

    /// Collapses the centre into the other end of an incident edge, if that is legal.
    [[nodiscard]] bool collapse_into(const Star<Real>& star, std::uint32_t incident_edge) const {
        return edge_collapse(work.submesh, prev(star.corner[incident_edge]),
                             rewire::Vanishing::next) == Verdict::legal;
    }
};

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "geometric_flows/growth_features.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/algorithm.h"
#include "geometric_flows/growth_fans.h"
#include "geometric_flows/growth_front.h"
#include "geometric_flows/growth_notches.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc {

namespace {

// A vertex of another submesh may become a feature at this moment, so its flag is not read.
template <class Real>
bool may_be_feature(const GrowthFronts<Real>& fronts, std::uint32_t v) {
    return !owns(fronts.complex, fronts.work.submesh.region, v) || fronts.is_feature(v);
}

template <class Real>
void visit(GrowthFronts<Real>& fronts, std::uint32_t v) {
    Complex<Real>& complex = fronts.complex;
    Star<Real>& star = fronts.work.star;
    if (!complex.is_alive(Vertex{v}) || complex.is_locked(Vertex{v}) ||
        !gather(complex, fronts.work.submesh.region, v, star)) {
        return;
    }
    const GrowthBend<Real> bend = fronts.bend_of(star);
    if (!bend.known) {
        fronts.rays[Vertex{v}] = {};
        return;
    }
    const bool touches =
        may_be_feature(fronts, star.link[bend.in]) || may_be_feature(fronts, star.link[bend.out]);
    const bool bends = std::abs(bend.turn) > std::min(fronts.open_angle, fronts.notch_angle);
    if (!touches && !fronts.is_in_fan(v) && !bends && !fronts.is_feature(v)) {
        return;
    }
    if (!star.owned) {
        fronts.work.deferred.remeshing(v);
        return;
    }
    if (touches && remove_before_notch(fronts, star, bend)) {
        return;
    }
    if (fronts.is_in_fan(v)) {
        tend_fan(fronts, star, bend);
    } else if (bend.turn * bend.speed > 0 && std::abs(bend.turn) > fronts.open_angle &&
               (fronts.is_feature(v) || fronts.has_room(bend))) {
        open_fan(fronts, v, bend);
    } else {
        mark_notch(fronts, v, bend);
    }
}

} // namespace

template <class Real>
Pass<Real> growth_features(const GrowthOptions<Real>& options) {
    check_growth(options);
    return {"growth corners", [options](Work<Real>& work) {
                GrowthFronts<Real> fronts{.work = work, .options = options};
                // Vertices created here are visited in the next sub-step.
                for (const std::uint32_t v : work.interface) {
                    visit(fronts, v);
                }
            }};
}

template <class Real>
Algorithm<Real> growth_algorithm(Complex<Real>& complex, const GrowthOptions<Real>& options) {
    Algorithm<Real> algorithm = default_algorithm<Real>();
    algorithm.remeshing.push_back(growth_features(options));
    for (const GrowthSpeed& pair : options.speeds) {
        for (const Phase phase : {pair.growing, pair.into}) {
            if (std::ranges::none_of(triangles(complex),
                                     [&](Triangle t) { return complex.phase(t) == phase; })) {
                throw InputError({.what = "a phase that the complex does not have",
                                  .where = "growth.speeds",
                                  .value = std::to_string(phase),
                                  .allowed = "a phase of one of its triangles"});
            }
        }
    }
    add_fan_rays(complex);
    return algorithm;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Pass<Real> growth_features(const GrowthOptions<Real>&);                               \
    template Algorithm<Real> growth_algorithm(Complex<Real>&, const GrowthOptions<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

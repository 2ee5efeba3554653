// SPDX-License-Identifier: MIT
// Targets by flows that need the whole interface: at each call the interface vertices of all
// submeshes must be at the same stage, so they are integrated together. An `InterfaceFlow` is
// called submesh by submesh, in parallel; a `VelocityAtOnce` and an `InterfaceMotion` are called
// once.
#include "dsc/algorithm/executor.h"
#include "dsc/base/room.h"
#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/passes/work.h"

namespace dsc {

// Joins all lists after remeshing: those of the submeshes, and that of vertices changing submesh.
template <class Real>
void SubmeshExecutor<Real>::join_interface() {
    auto& list = joined_.interface;
    auto& stars = joined_.stars;
    list.clear();
    ends_.clear();
    stars.clear();
    const auto join = [&](const Work<Real>& part) {
        append(list, part.interface);
        ends_.push_back(list.size());
        append(stars, part.stars);
    };
    for (std::size_t i = 0; i < first_colour_; ++i) {
        join(parts_[i]->work);
    }
    join(whole_);
}

template <class Real>
TargetReport<Real> SubmeshExecutor<Real>::compute_targets_together(const Flow<Real>& flow,
                                                                   Real time, Real dt) {
    join_interface();
    const TargetReport<Real> report = this->sight_->compute_targets(joined_, ends_, flow, time, dt);
    distribute_targets();
    return report;
}

// Copies the targets to the submeshes that list the vertices: `collect_moving_vertices` reads them
// there.
template <class Real>
void SubmeshExecutor<Real>::distribute_targets() {
    const Trajectory<Real>& from = joined_.trajectory;
    std::size_t begin = 0;
    for (std::size_t range = 0; range < ends_.size(); ++range) {
        const std::size_t end = ends_[range];
        Trajectory<Real>& to =
            range < first_colour_ ? parts_[range]->work.trajectory : whole_.trajectory;
        const auto take = [&](const auto& all, auto& part) {
            assign(part, std::span(all).subspan(begin, end - begin));
        };
        take(from.positions, to.positions);
        take(from.targets, to.targets);
        take(from.held, to.held);
        to.dt = from.dt;
        begin = end;
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template TargetReport<Real> SubmeshExecutor<Real>::compute_targets_together(const Flow<Real>&, \
                                                                                Real, Real);       \
    template void SubmeshExecutor<Real>::distribute_targets();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

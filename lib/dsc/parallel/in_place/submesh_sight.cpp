// SPDX-License-Identifier: MIT
// Aiming by a flow that needs all of the interface: whenever it is asked, the interface vertices of
// all submeshes have to be at the same stage, so they are integrated together. A flow that sees the
// interface is evaluated submesh by submesh, in parallel; a velocity that is called for all at once
// and a motion of the whole interface once.
#include "dsc/base/room.h"
#include "dsc/parallel/in_place/submesh_part.h"

namespace dsc {

// Joins all lists once remeshing is over: those of the submeshes, and of what is on its way between
// them.
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

// Back to the submeshes that have the vertices in their lists: `collect_moving_vertices` reads it
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

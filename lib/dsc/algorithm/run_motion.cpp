// SPDX-License-Identifier: MIT
#include "dsc/algorithm/sub_step.h"

#include "dsc/motion/movement.h"
#include "dsc/passes/readers.h"

#include <algorithm>

namespace dsc {

MoveReport& MoveReport::operator+=(const MoveReport& other) {
    passes = std::max(passes, other.passes);
    unreached += other.unreached;
    held += other.held;
    return *this;
}

template <class Real>
void clear_stamps(Complex<Real>& complex) {
    for (auto& vertex : complex.vertices) {
        vertex.stamp = 0;
    }
}

template <class Real>
std::uint32_t next_stamp(Complex<Real>& complex, std::uint32_t& last) {
    if (++last == 0) {
        clear_stamps(complex);
        last = 1;
    }
    return last;
}

template <class Real>
std::uint32_t run_motion(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                         std::uint32_t& next_epoch) {
    std::uint32_t done = 0;
    int idle = 0;
    while (static_cast<int>(done) < work.options.max_passes) {
        work.progressed = 0;
        work.arrived = 0;
        for (const auto& pass : passes) {
            run_pass(work, pass);
            work.stars.clear();
        }
        work.epoch = next_stamp(work.complex, next_epoch);
        ++done;
        const bool has_arrived =
            std::ranges::all_of(work.moving_vertices, [&](const auto& moving_vertex) {
                return is_in_contact(work.complex.vertices[moving_vertex.vertex]);
            });
        if (has_arrived) {
            break;
        }
        idle = work.progressed == 0 ? idle + 1 : 0;
        if (idle >= work.options.max_idle_passes) {
            break;
        }
    }
    return done;
}

// Drops vertices deleted during the step, and those that have come within rounding of their
// targets.
template <class Real>
std::uint64_t give_up_moving_vertices(Work<Real>& work) {
    const auto edge_length = static_cast<Real>(work.options.edge_length);
    std::erase_if(work.moving_vertices, [&](const MovingVertex<Real>& moving_vertex) {
        const Vertex v{moving_vertex.vertex};
        if (!work.complex.is_alive(v)) {
            return true;
        }
        const Point<Real> target(moving_vertex.x, moving_vertex.y);
        const bool is_there = is_at<Real>(work.complex.position(v), target, edge_length);
        if (is_there) {
            work.complex.vertices[v.id].flags &=
                ~static_cast<std::uint32_t>(vertex_contact | vertex_on_way);
        }
        return is_there;
    });
    for (const auto& moving_vertex : work.moving_vertices) {
        auto& flags = work.complex.vertices[moving_vertex.vertex].flags;
        flags &= ~static_cast<std::uint32_t>(vertex_on_way);
        flags += (flags & vertex_contact) == vertex_contact ? 0U : std::uint32_t{vertex_missed};
    }
    return work.moving_vertices.size();
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::uint32_t run_motion(Work<Real>&, const std::vector<Pass<Real>>&,                 \
                                      std::uint32_t&);                                             \
    template std::uint32_t next_stamp(Complex<Real>&, std::uint32_t&);                             \
    template void clear_stamps(Complex<Real>&);                                                    \
    template std::uint64_t give_up_moving_vertices(Work<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

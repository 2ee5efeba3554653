// SPDX-License-Identifier: MIT
// The step itself: what the submeshes do, what they hand on, and what is left in the end.
#include "dsc/parallel/submesh_part.h"

#include <algorithm>

namespace dsc {

namespace {

/// Nowhere: for the serial clean-up.
constexpr std::uint32_t nowhere = 0xffffffffU;

} // namespace

// --- tasks -------------------------------------------------------------------------------------

// Where what was put off since the last call goes.
template <class Real>
void SubmeshExecutor<Real>::route(Part& part) {
    Work<Real>& work = part.work;
    std::size_t hint = 0;
    const auto destination = [&](std::uint32_t vertex) {
        const Point<double> place = place_of(vertex);
        // What has left this submesh is unknown to those that wait for it.
        if (part.next == nullptr || !work.submesh.region.owns(vertex, place.x(), place.y())) {
            return nowhere;
        }
        hint = part.next->locate(vertex, place.x(), place.y(), hint);
        return hint < part.next->regions.size() ? static_cast<std::uint32_t>(part.next_first + hint)
                                                : nowhere;
    };
    for (std::size_t i = part.mover_routes.size(); i < work.put_off_movers.size(); ++i) {
        part.mover_routes.push_back(destination(work.put_off_movers[i].vertex));
    }
    for (std::size_t i = part.active_routes.size(); i < work.put_off_active.size(); ++i) {
        part.active_routes.push_back(destination(work.put_off_active[i]));
    }
    for (std::size_t i = part.interface_routes.size(); i < work.put_off_interface.size(); ++i) {
        part.interface_routes.push_back(destination(work.put_off_interface[i]));
    }
}

template <class Real>
void SubmeshExecutor<Real>::aim_part(Part& part, const Velocity<Real>& velocity, Real time,
                                     Real dt) {
    Timer timer(submeshes_.profile);
    Work<Real>& work = part.work;
    part.forget_put_off();
    const Region& region = work.submesh.region;
    if (!region.is_whole()) {
        std::erase_if(work.interface, [&](std::uint32_t v) {
            const Point<double> place = place_of(v);
            if (region.owns(v, place.x(), place.y())) {
                return false;
            }
            part.emigrants.push_back(v);
            return true;
        });
    }
    for (const auto& pass : algorithm_.upkeep) {
        pass.run(work);
    }
    if (region.is_whole()) {
        work.put_off_interface.clear();
    }
    part.upkeep_s = timer.lap();
    part.aimed = find_velocities(work, velocity, time);
    part.aimed.farthest = find_targets(work, velocity, time, dt);
    part.velocities_s = timer.lap();
    part.aim_s = part.upkeep_s + part.velocities_s;
}

// What the submeshes that this one waited for put off, and what lies in this one.
template <class Real>
void SubmeshExecutor<Real>::take_from_predecessors(Part& part, std::size_t task) {
    Work<Real>& work = part.work;
    const auto number = static_cast<std::uint32_t>(task);
    for (const std::uint32_t earlier : moving_.tasks.predecessors(task)) {
        const Part& from = *parts_[earlier];
        for (std::size_t i = 0; i < from.mover_routes.size(); ++i) {
            if (from.mover_routes[i] == number) {
                work.movers.push_back(from.work.put_off_movers[i]);
            }
        }
        for (std::size_t i = 0; i < from.active_routes.size(); ++i) {
            const std::uint32_t v = from.work.put_off_active[i];
            if (from.active_routes[i] == number && complex_.is_alive(Vertex{v})) {
                work.activate(v);
            }
        }
        for (std::size_t i = 0; i < from.interface_routes.size(); ++i) {
            if (from.interface_routes[i] == number) {
                part.taken.push_back(from.work.put_off_interface[i]);
            }
        }
    }
}

template <class Real>
void SubmeshExecutor<Real>::move_part(std::size_t task) {
    Timer timer(submeshes_.profile);
    Part& part = *parts_[task];
    Work<Real>& work = part.work;
    const bool is_first = task < first_colour_;
    part.moved = {};
    std::ranges::fill(part.passes_s, 0.0);
    if (is_first) {
        work.movers.clear();
        part.moved.held = collect_movers(work);
        work.movers.insert(work.movers.end(), part.immigrants.begin(), part.immigrants.end());
        part.immigrants.clear();
    } else {
        part.forget_put_off();
        take_from_predecessors(part, task);
    }
    std::uint32_t epoch = work.epoch;
    if (is_first || !work.movers.empty() || !work.active.empty()) {
        part.moved.passes = run_motion(work, part.motion, epoch);
    }
    // Who is blocked here may find room when others have moved, unless it is in contact.
    const bool has_arrived = work.movers.empty();
    for (const auto& mover : work.movers) {
        if (is_in_contact(complex_.vertices[mover.vertex])) {
            ++part.moved.unreached;
        } else {
            work.put_off_movers.push_back(mover);
        }
    }
    work.movers.clear();
    if (!has_arrived) {
        work.put_off_interface.insert(work.put_off_interface.end(), part.taken.begin(),
                                      part.taken.end());
        part.taken.clear();
    } else if (!part.taken.empty()) {
        // All that it owns is at the new time level now: upkeep of the next sub-step.
        work.interface = part.taken;
        for (const auto& pass : algorithm_.upkeep) {
            pass.run(work);
        }
        if (!work.active.empty()) {
            run_motion(work, part.motion, epoch);
        }
    }
    route(part);
    part.move_s = timer.lap();
}

// --- the step ----------------------------------------------------------------------------------

template <class Real>
AimReport<Real> SubmeshExecutor<Real>::aim(const Velocity<Real>& velocity, Real time, Real dt) {
    Timer timer(submeshes_.profile);
    under_way_ = true;
    std::size_t number = 0;
    for (const Colour& colour : partition_.colours) {
        const std::uint32_t epoch = next_epochs();
        for (std::size_t i = 0; i < colour.regions.size(); ++i, ++number) {
            refill(*parts_[number]);
            parts_[number]->work.epoch = epoch;
        }
    }
    const double set_up = timer.lap();
    aiming_.run(threads_, submeshes_.assignment,
                [&](std::size_t i) { aim_part(*parts_[i], velocity, time, dt); });
    const double wall = timer.lap();
    AimReport<Real> report;
    for (std::size_t i = 0; i < first_colour_; ++i) {
        report += parts_[i]->aimed;
    }
    report += hand_over_emigrants(velocity, time, dt);
    if (submeshes_.profile) {
        SubStepProfile& profile = profile_.sub_steps.emplace_back();
        profile.set_up = set_up;
        profile.aim_wall = wall;
        profile.hand_over = timer.lap();
        for (std::size_t i = 0; i < first_colour_; ++i) {
            profile.aim.push_back(parts_[i]->aim_s);
            profile.upkeep += parts_[i]->upkeep_s;
            profile.velocities += parts_[i]->velocities_s;
        }
    }
    return report;
}

// Vertices that have left their submesh go to the one where they are; upkeep looks at them in the
// next sub-step.
template <class Real>
AimReport<Real> SubmeshExecutor<Real>::hand_over_emigrants(const Velocity<Real>& velocity,
                                                           Real time, Real dt) {
    whole_.interface.clear();
    for (std::size_t i = 0; i < first_colour_; ++i) {
        for (const std::uint32_t v : parts_[i]->emigrants) {
            if (complex_.is_alive(Vertex{v})) {
                whole_.interface.push_back(v);
            }
        }
        parts_[i]->emigrants.clear();
    }
    if (whole_.interface.empty()) {
        return {};
    }
    AimReport<Real> report = find_velocities(whole_, velocity, time);
    report.farthest = find_targets(whole_, velocity, time, dt);
    return report;
}

template <class Real>
Real SubmeshExecutor<Real>::aim_again(const Velocity<Real>& velocity, Real time, Real dt) {
    aiming_.run(threads_, submeshes_.assignment, [&](std::size_t i) {
        Part& part = *parts_[i];
        part.aimed.farthest = find_targets(part.work, velocity, time, dt);
    });
    Real farthest = find_targets(whole_, velocity, time, dt);
    for (std::size_t i = 0; i < first_colour_; ++i) {
        farthest = std::max(farthest, parts_[i]->aimed.farthest);
    }
    return farthest;
}

template <class Real>
MoveReport SubmeshExecutor<Real>::move() {
    Timer timer(submeshes_.profile);
    MoveReport report;
    if (!whole_.interface.empty()) {
        whole_.movers.clear();
        report.held += collect_movers(whole_);
        for (const auto& mover : whole_.movers) {
            owner_of(mover.vertex).immigrants.push_back(mover);
        }
        whole_.movers.clear();
        for (const std::uint32_t v : whole_.interface) {
            // Not yet: this sub-step's targets are listed by place.
            owner_of(v).newcomers.push_back(v);
        }
        whole_.interface.clear();
    }
    const double hand_over = timer.lap();
    moving_.run(threads_, submeshes_.assignment, [&](std::size_t task) { move_part(task); });
    const double wall = timer.lap();
    for (const auto& part : parts_) {
        report += part->moved;
    }
    clean_up(report);
    report.unreached += report.held;
    under_way_ = false;
    if (submeshes_.profile) {
        SubStepProfile& profile = profile_.sub_steps.back();
        profile.hand_over += hand_over;
        profile.move_wall = wall;
        profile.clean_up = timer.lap();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            profile.move.push_back(parts_[i]->move_s);
            profile.later_colours += i < first_colour_ ? 0 : parts_[i]->move_s;
            profile.motion_passes.resize(algorithm_.motion.size());
            for (std::size_t k = 0; i < first_colour_ && k < algorithm_.motion.size(); ++k) {
                profile.motion_passes[k] += parts_[i]->passes_s[k];
            }
        }
    }
    return report;
}

template <class Real>
void SubmeshExecutor<Real>::clean_up(MoveReport& report) {
    whole_.epoch = next_epochs();
    whole_before_.clear();
    const std::size_t last_colour = parts_.size() - partition_.colours.back().regions.size();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = *parts_[i];
        const bool is_last = i >= last_colour;
        for (std::size_t k = 0; k < part.mover_routes.size(); ++k) {
            if (is_last || part.mover_routes[k] == nowhere) {
                whole_.movers.push_back(part.work.put_off_movers[k]);
            }
        }
        for (std::size_t k = 0; k < part.active_routes.size(); ++k) {
            const std::uint32_t v = part.work.put_off_active[k];
            if ((is_last || part.active_routes[k] == nowhere) && complex_.is_alive(Vertex{v})) {
                whole_.activate(v);
            }
        }
        for (std::size_t k = 0; k < part.interface_routes.size(); ++k) {
            if (is_last || part.interface_routes[k] == nowhere) {
                whole_before_.push_back(part.work.put_off_interface[k]);
            }
        }
    }
    std::uint32_t epoch = whole_.epoch;
    if (!whole_.movers.empty() || !whole_.active.empty()) {
        report.passes = std::max(report.passes, run_motion(whole_, algorithm_.motion, epoch));
    }
    report.unreached += whole_.movers.size();
    for (const auto& mover : whole_.movers) {
        note_miss(complex_.vertices[mover.vertex]);
    }
    whole_.movers.clear();
    if (!whole_before_.empty()) {
        whole_.interface = whole_before_;
        for (const auto& pass : algorithm_.upkeep) {
            pass.run(whole_);
        }
        if (!whole_.active.empty()) {
            run_motion(whole_, algorithm_.motion, epoch);
        }
        mend_lists(whole_before_, whole_.interface);
        whole_.interface.clear();
    }
    whole_.put_off_active.clear();
    whole_.put_off_interface.clear();
    for (std::size_t i = first_colour_; i < parts_.size(); ++i) {
        Part& part = *parts_[i];
        if (!part.taken.empty()) {
            mend_lists(part.taken, part.work.interface);
            part.work.interface.clear();
        }
    }
    for (std::size_t i = 0; i < first_colour_; ++i) {
        auto& newcomers = parts_[i]->newcomers;
        auto& list = parts_[i]->work.interface;
        list.insert(list.end(), newcomers.begin(), newcomers.end());
        newcomers.clear();
    }
}

// What upkeep by another than the owner of the list did to it: rare, so that it may search.
template <class Real>
void SubmeshExecutor<Real>::mend_lists(const std::vector<std::uint32_t>& before,
                                       const std::vector<std::uint32_t>& after) {
    if (before == after) {
        return;
    }
    const auto contains = [](const std::vector<std::uint32_t>& list, std::uint32_t v) {
        return std::ranges::find(list, v) != list.end();
    };
    for (const std::uint32_t v : before) {
        if (!contains(after, v)) {
            for (std::size_t i = 0; i < first_colour_; ++i) {
                std::erase(parts_[i]->work.interface, v);
                std::erase(parts_[i]->newcomers, v);
            }
        }
    }
    for (const std::uint32_t v : after) {
        if (!contains(before, v)) {
            owner_of(v).work.interface.push_back(v);
        }
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template AimReport<Real> SubmeshExecutor<Real>::aim(const Velocity<Real>&, Real, Real);        \
    template Real SubmeshExecutor<Real>::aim_again(const Velocity<Real>&, Real, Real);             \
    template MoveReport SubmeshExecutor<Real>::move();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc

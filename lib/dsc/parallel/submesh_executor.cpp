// SPDX-License-Identifier: MIT
#include "dsc/parallel/submesh_executor.h"

#include "dsc/algorithm/interface_upkeep.h"
#include "dsc/base/error.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace dsc {

namespace {

/// Ids that each submesh holds beyond one for each of its interface vertices; what does not fit is
/// put off to the next colour, never lost.
constexpr std::size_t spare_vertices = 64;
/// Nowhere: for the serial clean-up.
constexpr std::uint32_t nowhere = 0xffffffffU;

void check(const SubmeshOptions& options) {
    const auto refuse = [](const char* what, const std::string& value, const char* allowed) {
        throw InputError("value out of range", what, value, allowed);
    };
    if (options.threads < 1 || options.threads > 1024) {
        refuse("threads", std::to_string(options.threads), "1 to 1024");
    }
    if (options.vertices_per_thread < 1) {
        refuse("vertices_per_thread", std::to_string(options.vertices_per_thread), "1 or more");
    }
}

// Adds the time since the last call to an account; reads no clock where there is none to keep.
class Timer {
public:
    explicit Timer(bool on) : on_(on) {
        if (on_) {
            last_ = std::chrono::steady_clock::now();
        }
    }
    double lap() {
        if (!on_) {
            return 0;
        }
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    bool on_;
    std::chrono::steady_clock::time_point last_;
};

} // namespace

/// One submesh: its work, its ids, and where what it put off goes.
template <class Real>
struct SubmeshExecutor<Real>::Part {
    Part(Complex<Real>& complex, const Options<Real>& options) : work(complex, options) {
        pool.may_grow = false;
        work.submesh.pool = &pool;
    }

    Work<Real> work;
    IdPool pool;
    const Colour* next = nullptr;  // the next colour; null: there is none
    std::size_t next_first = 0;    // number of its first part

    std::vector<std::uint32_t> emigrants; // interface vertices that have left the region
    std::vector<std::uint32_t> newcomers; // and those that came: listed when the sub-step is over
    std::vector<Mover<Real>> immigrants;  // the same, on their way
    std::uint64_t examined = 0;           // stars, since the last division
    // By entry of the lists of what was put off: the part of the next colour, or nowhere.
    std::vector<std::uint32_t> mover_routes;
    std::vector<std::uint32_t> active_routes;
    std::vector<std::uint32_t> interface_routes;
    std::vector<std::uint32_t> taken; // later colours: interface vertices to look at, as they came
    AimReport<Real> aimed;
    MoveReport moved;

    // Account of times.
    double upkeep_s = 0;
    double velocities_s = 0;
    double aim_s = 0;
    double move_s = 0;
    std::vector<double> passes_s;
    std::vector<Pass<Real>> motion; // the algorithm's, with a clock about each where times are kept

    void forget_put_off() {
        work.put_off_movers.clear();
        work.put_off_active.clear();
        work.put_off_interface.clear();
        mover_routes.clear();
        active_routes.clear();
        interface_routes.clear();
        emigrants.clear();
        taken.clear();
    }
};

template <class Real>
SubmeshExecutor<Real>::SubmeshExecutor(Complex<Real>& complex, const Options<Real>& options,
                                       Algorithm<Real> algorithm,
                                       std::unique_ptr<Partitioner<Real>> partitioner,
                                       const SubmeshOptions& submeshes)
    : complex_(complex), options_(options), algorithm_(std::move(algorithm)),
      partitioner_(std::move(partitioner)), submeshes_(submeshes), whole_(complex, options) {
    check(submeshes);
    if (!partitioner_) {
        throw InputError("no partitioner", "SubmeshExecutor", "null", "an object");
    }
    for (const auto& vertex : complex.vertices) {
        epoch_ = std::max(epoch_, vertex.stamp);
    }
    // Until the first division all of the interface is in this list.
    whole_.interface = collect_interface(complex, options.shuffle_seed);
}

template <class Real>
SubmeshExecutor<Real>::~SubmeshExecutor() {
    for (auto& part : parts_) {
        give_back(part->pool, 0, 0);
    }
    complex_.lent_vertices = 0;
    complex_.lent_triangles = 0;
}

// --- set-up ------------------------------------------------------------------------------------

template <class Real>
void SubmeshExecutor<Real>::give_back(IdPool& pool, std::size_t vertices, std::size_t triangles) {
    const auto give = [](std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
                         std::size_t keep) {
        while (from.size() > keep) {
            to.push_back(from.back());
            from.pop_back();
        }
    };
    give(pool.vertices, complex_.ids.vertices, vertices);
    give(pool.triangles, complex_.ids.triangles, triangles);
}

template <class Real>
void SubmeshExecutor<Real>::refill(Part& part) {
    IdPool& pool = part.pool;
    if (part.work.submesh.region.is_whole()) {
        return; // it has those of the complex
    }
    const std::size_t least = spare_vertices + part.work.interface.size() / 2;
    if (pool.vertices.size() >= least && pool.triangles.size() >= 2 * least) {
        return;
    }
    // Twice as many, so that this is rare.
    while (pool.vertices.size() < 2 * least) {
        const std::uint32_t id = complex_.take_vertex(complex_.ids);
        complex_.vertices[id].flags = vertex_dead;
        pool.vertices.push_back(id);
    }
    while (pool.triangles.size() < 4 * least) {
        const std::uint32_t id = complex_.take_triangle(complex_.ids);
        complex_.triangles[id].v = {no_id, no_id, no_id};
        pool.triangles.push_back(id);
    }
}

// Stamps for one parallel section: all its submeshes may use the same, their vertices are not.
template <class Real>
std::uint32_t SubmeshExecutor<Real>::next_epochs() {
    const auto needed = 2 * static_cast<std::uint32_t>(options_.max_passes) + 8;
    if (epoch_ > 0xffffffffU - 4 * needed) {
        for (auto& vertex : complex_.vertices) {
            vertex.stamp = 0; // once in some hundred million steps
        }
        epoch_ = 0;
    }
    const std::uint32_t first = epoch_ + 1;
    epoch_ += needed;
    return first;
}

template <class Real>
void SubmeshExecutor<Real>::begin_step() {
    Timer timer(submeshes_.profile);
    profile_.sub_steps.clear();
    status_.interface_vertices = interface_size();
    divide();
    ++status_.step;
    ++status_.steps_since_all;
    threads_ = static_cast<std::uint32_t>(
        std::clamp<std::size_t>(status_.interface_vertices / submeshes_.vertices_per_thread, 1,
                                std::min<std::size_t>(submeshes_.threads, first_colour_)));
    profile_.serial_outside = timer.lap();
}

template <class Real>
void SubmeshExecutor<Real>::divide() {
    const Recut recut = parts_.empty() ? Recut::all : partitioner_->is_due(status_);
    if (recut == Recut::none) {
        return;
    }
    std::vector<std::uint32_t> list;
    append_interface(list);
    if (recut == Recut::all && options_.shuffle_seed == 0 && !parts_.empty()) {
        // New vertices of the boundaries stand at the ends of lists.
        order_interface(complex_, list, next_epochs());
    }
    partitioner_->divide({complex_, list, work_of(list), static_cast<double>(options_.edge_length)},
                         recut, partition_);
    make_parts(recut);
    if (recut == Recut::all) {
        hand_out(std::move(list));
        status_.steps_since_all = 0;
    }
    connect();
}

// The work that each vertex has been since the last division, as its submesh's average.
template <class Real>
std::vector<float> SubmeshExecutor<Real>::work_of(const std::vector<std::uint32_t>& list) const {
    std::vector<float> work(list.size(), 1.0F);
    if (first_colour_ < 2) {
        return work;
    }
    const Colour& colour = partition_.colours.front();
    std::size_t at = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        at = colour.locate(list[i], place_of(list[i]).x(), place_of(list[i]).y(), at);
        if (at < first_colour_) {
            const Part& part = *parts_[at];
            work[i] = 1.0F + static_cast<float>(part.examined) /
                                 static_cast<float>(part.work.interface.size() + 1);
        }
    }
    return work;
}

template <class Real>
void SubmeshExecutor<Real>::make_parts(Recut recut) {
    const std::size_t kept = recut == Recut::all ? 0 : first_colour_;
    std::size_t wanted = 0;
    for (const Colour& colour : partition_.colours) {
        wanted += colour.regions.size();
    }
    while (parts_.size() > wanted) {
        give_back(parts_.back()->pool, 0, 0);
        parts_.pop_back();
    }
    while (parts_.size() < wanted) {
        parts_.push_back(std::make_unique<Part>(complex_, options_));
        keep_times(*parts_.back());
    }
    first_colour_ = partition_.colours.front().regions.size();
    std::size_t number = 0;
    for (const Colour& colour : partition_.colours) {
        for (const Region& region : colour.regions) {
            Part& part = *parts_[number];
            part.work.submesh.region = region;
            part.work.submesh.pool = region.is_whole() ? &complex_.ids : &part.pool;
            if (number >= kept) {
                part.work.interface.clear();
                part.examined = 0;
            }
            ++number;
        }
    }
}

template <class Real>
void SubmeshExecutor<Real>::keep_times(Part& part) {
    part.passes_s.assign(algorithm_.motion.size(), 0);
    part.motion = algorithm_.motion;
    for (std::size_t i = 0; submeshes_.profile && i < part.motion.size(); ++i) {
        part.motion[i].run = [&part, i, run = algorithm_.motion[i].run](Work<Real>& work) {
            Timer timer(true);
            run(work);
            part.passes_s[i] += timer.lap();
        };
    }
}

template <class Real>
void SubmeshExecutor<Real>::hand_out(std::vector<std::uint32_t> list) {
    whole_.interface.clear();
    const Colour& colour = partition_.colours.front();
    std::size_t at = 0;
    for (const std::uint32_t v : list) {
        at = colour.locate(v, place_of(v).x(), place_of(v).y(), at);
        if (at == first_colour_) {
            throw InvariantError("vertex " + std::to_string(v) +
                                 " is in no submesh of the first colour");
        }
        parts_[at]->work.interface.push_back(v);
    }
}

// Tasks: a submesh waits for those of the colour before it that it meets. It is then alone with all
// it owns: what is in none of these it cannot reach.
template <class Real>
void SubmeshExecutor<Real>::connect() {
    aiming_.tasks.clear();
    moving_.tasks.clear();
    aiming_.tasks.add_colour(first_colour_);
    std::size_t before = 0; // first part of the colour before
    std::size_t first = 0;
    for (std::size_t c = 0; c < partition_.colours.size(); ++c) {
        const Colour& colour = partition_.colours[c];
        const std::size_t count = colour.regions.size();
        moving_.tasks.add_colour(count);
        for (std::size_t i = 0; i < count; ++i) {
            Part& part = *parts_[first + i];
            const bool is_last = c + 1 == partition_.colours.size();
            part.next = is_last ? nullptr : &partition_.colours[c + 1];
            part.next_first = first + count;
            for (std::size_t j = before; j < first; ++j) {
                if (colour.regions[i].may_meet(partition_.colours[c - 1].regions[j - before])) {
                    moving_.tasks.wait_for(first + i, j);
                }
            }
        }
        before = first;
        first += count;
    }
}

// --- tasks -------------------------------------------------------------------------------------

template <class Real>
Point<double> SubmeshExecutor<Real>::place_of(std::uint32_t vertex) const {
    const auto& record = complex_.vertices[vertex];
    return {static_cast<double>(read_shared(record.x)), static_cast<double>(read_shared(record.y))};
}

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
        return hint < part.next->regions.size()
                   ? static_cast<std::uint32_t>(part.next_first + hint)
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
    // Who is blocked here may find room when others have moved.
    work.put_off_movers.insert(work.put_off_movers.end(), work.movers.begin(), work.movers.end());
    work.movers.clear();
    if (!part.taken.empty()) {
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

template <class Real>
typename SubmeshExecutor<Real>::Part& SubmeshExecutor<Real>::owner_of(std::uint32_t vertex) {
    const Point<double> place = place_of(vertex);
    const std::size_t at = partition_.colours.front().locate(vertex, place.x(), place.y());
    return *parts_[at < first_colour_ ? at : 0];
}

template <class Real>
void SubmeshExecutor<Real>::recover() {
    for (auto& part : parts_) {
        part->forget_put_off();
        part->immigrants.clear();
        part->newcomers.clear();
        part->work.movers.clear();
        part->work.active.clear();
        part->work.interface.clear();
    }
    whole_.movers.clear();
    whole_.active.clear();
    whole_.put_off_active.clear();
    whole_.put_off_interface.clear();
    hand_out(collect_interface(complex_, options_.shuffle_seed));
    under_way_ = false;
}

template <class Real>
void SubmeshExecutor<Real>::end_step() {
    if (under_way_) {
        recover();
    }
    complex_.lent_vertices = 0;
    complex_.lent_triangles = 0;
    for (auto& part : parts_) {
        const std::size_t most = 4 * (spare_vertices + part->work.interface.size());
        give_back(part->pool, most, 2 * most);
        complex_.lent_vertices += static_cast<std::uint32_t>(part->pool.vertices.size());
        complex_.lent_triangles += static_cast<std::uint32_t>(part->pool.triangles.size());
    }
}

// --- questions ---------------------------------------------------------------------------------

template <class Real>
std::size_t SubmeshExecutor<Real>::interface_size() const {
    std::size_t size = whole_.interface.size();
    for (std::size_t i = 0; i < first_colour_; ++i) {
        size += parts_[i]->work.interface.size();
    }
    return size;
}

template <class Real>
void SubmeshExecutor<Real>::append_interface(std::vector<std::uint32_t>& list) const {
    list.insert(list.end(), whole_.interface.begin(), whole_.interface.end());
    for (std::size_t i = 0; i < first_colour_; ++i) {
        const auto& part = parts_[i]->work.interface;
        list.insert(list.end(), part.begin(), part.end());
    }
}

template <class Real>
OperationCounts SubmeshExecutor<Real>::take_counts() {
    OperationCounts total = std::exchange(whole_.counts, {});
    for (auto& part : parts_) {
        part->examined += part->work.counts.examined;
        total += std::exchange(part->work.counts, {});
    }
    return total;
}

template class SubmeshExecutor<double>;
template class SubmeshExecutor<float>;

} // namespace dsc

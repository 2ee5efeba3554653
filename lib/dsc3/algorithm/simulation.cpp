// SPDX-License-Identifier: MIT
#include "dsc3/algorithm/simulation.h"

#include "dsc3/passes/arrival.h"
#include "dsc3/passes/interface_remeshing.h"
#include "dsc3/passes/repair.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dsc3 {

namespace {

// Vertices may move farther than the speed at the beginning of a sub-step predicts, up to this
// factor; otherwise the sub-step is shortened.
constexpr Real sub_step_slack = 1.25;
// Tets are renumbered after this many operations per tet. With twice as many, Enright's test takes
// a tenth more time at h = 1/64; with half as many it takes no less.
constexpr Real worn_after = 0.25;

const Options& checked(const Options& options) {
    check_options(options);
    return options;
}

const Parallel& checked(const Parallel& parallel) {
    const auto refuse = [](const char* what, std::uint32_t value, const char* allowed) {
        throw InputError({.what = what,
                          .where = "Simulation",
                          .value = std::to_string(value),
                          .allowed = allowed});
    };
    if (parallel.threads < 1 || parallel.threads > 1024) {
        refuse("bad number of threads", parallel.threads, "1 to 1024");
    }
    if (parallel.submeshes > submesh_limit ||
        (parallel.submeshes != 0 && !std::has_single_bit(parallel.submeshes))) {
        refuse("bad number of submeshes", parallel.submeshes, "0, or a power of two up to 64");
    }
    return parallel;
}

} // namespace

Simulation::Simulation(Complex& complex, const Options& options)
    : Simulation(complex, options, nullptr) {}

Simulation::Simulation(Complex& complex, const Options& options, const Parallel& parallel)
    : Simulation(complex, options, &parallel) {}

Simulation::Simulation(Complex& complex, const Options& options, const Parallel* parallel)
    : complex_(complex), claim_(complex.in_use), options_(checked(options)),
      team_(parallel == nullptr ? Team() : Team(checked(*parallel).threads, parallel->profile)),
      state_{complex_, options_, team_}, version_(complex.version) {
    if (parallel != nullptr) {
        submeshes_ = std::make_unique<Submeshes>(complex_, options_.edge_length, *parallel, team_);
        state_.submeshes = submeshes_.get();
        state_.work.rewiring.ownership = &submeshes_->ownership();
    }
    state_.grow();
    state_.find_interface();
}

StepReport Simulation::advance(const Velocity& velocity, bool in_chunks, Real time, Real dt) {
    if (!(dt >= 0) || !std::isfinite(dt) || !std::isfinite(time)) {
        throw InputError({.what = "cannot step: bad time or dt",
                          .where = "Simulation::step",
                          .value = "time " + dsc::to_text(time) + ", dt " + dsc::to_text(dt),
                          .allowed = "finite times, dt of 0 or more"});
    }
    if (complex_.attributes.has_fields()) {
        throw InputError({.what = "attributes that sample a field are not supported in 3D",
                          .where = "Simulation::step",
                          .value = "set_field(true)",
                          .allowed = "attributes whose values belong to vertices"});
    }
    team_.start_profile();
    if (version_ != complex_.version) { // the application has edited the complex
        state_.grow();
        state_.find_interface();
        state_.late.clear();
    }
    state_.unimproved.clear(); // of a step that an exception ended
    rewirings_ += state_.work.counts.rewirings();
    state_.work.counts = {};
    if (static_cast<Real>(rewirings_) > worn_after * complex_.tet_count()) {
        state_.renumber();
        rewirings_ = 0;
        version_ = complex_.version;
    }
    if (submeshes_ != nullptr) {
        state_.update_interface();
        submeshes_->divide(state_.interface);
    }
    in_chunks_ = in_chunks;
    state_.work.treated = 0;
    state_.work.treated_together = 0;
    state_.unjammed = 0;
    report_ = {};
    note(time);
    Real remaining = dt;
    while (remaining > 0) {
        remesh_interface(state_);
        repair_mesh(state_, options_.quality, Effort::usual);
        find_origins();
        version_ = complex_.version; // if the velocity throws, the next step goes on from here
        const Real part = find_targets(velocity, time + dt - remaining, remaining);
        if (part == 0) {
            report_.gave_up = GiveUp::too_many_sub_steps;
            break;
        }
        move();
        remaining = part < remaining ? remaining - part : 0;
        note(time + (dt - remaining));
        complex_.attributes.failure.rethrow();
    }
    state_.update_interface();
    note(report_.reached);
    version_ = complex_.version;
    return report_;
}

void Simulation::note(Real reached) {
    report_.operations = state_.work.counts;
    report_.unjammed = state_.unjammed;
    report_.treated = state_.work.treated;
    report_.treated_together = state_.work.treated_together;
    report_.interface_vertices = static_cast<std::uint32_t>(state_.interface.size());
    report_.reached = reached;
}

// The positions from which the flow moves the vertices: their own, or those where they should be.
void Simulation::find_origins() {
    state_.update_interface();
    state_.drop_stale_late();
    auto& late = state_.late;
    std::sort(late.begin(), late.end(),
              [](const LateVertex& x, const LateVertex& y) { return x.vertex < y.vertex; });
    origins_.resize(state_.interface.size());
    constexpr std::size_t grain = 1024;
    team_.chunks(origins_.size(), grain,
                 [&](std::uint32_t, std::size_t begin, std::size_t end, std::uint32_t) {
                     for (std::size_t i = begin; i < end; ++i) {
                         origins_[i] = complex_.at(state_.interface[i]);
                     }
                 });
    auto next = state_.interface.begin();
    for (const LateVertex& one : late) {
        next = std::lower_bound(next, state_.interface.end(), one.vertex);
        if (next != state_.interface.end() && *next == one.vertex) {
            origins_[static_cast<std::size_t>(next - state_.interface.begin())] = one.target;
        }
    }
    fixed_.clear();
    if (state_.ends_on_sides) {
        for (const std::uint32_t v : state_.interface) {
            fixed_.push_back(complex_.vertices[v].flags & vertex_boundary);
        }
    }
}

// Calls `work(share, begin, end)` for shares of the vertices: all of them if the simulation is
// sequential, or the velocity is called once.
template <class Work>
void Simulation::in_shares(std::size_t n, Work work) {
    largest_.fill(0);
    farthest_.fill(0);
    if (!in_chunks_) {
        work(0, 0, n);
        return;
    }
    constexpr std::size_t grain = 128;
    team_.chunks(n, grain,
                 [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t) {
                     work(chunk, begin, end);
                 });
}

Real Simulation::find_targets(const Velocity& velocity, Real time, Real remaining) {
    const std::size_t n = origins_.size();
    targets_.resize(n);
    held_.assign(n, 0);
    const std::span<const Point> origins(origins_);
    const std::span<Point> targets(targets_);
    const std::span<const std::uint32_t> fixed(fixed_);
    const auto fixed_of = [&](std::size_t begin, std::size_t end) {
        return fixed.empty() ? fixed : fixed.subspan(begin, end - begin);
    };
    in_shares(n, [&](std::uint32_t share, std::size_t begin, std::size_t end) {
        auto& first = scratch_[share].first;
        first.resize(end - begin);
        velocity(origins.subspan(begin, end - begin), time, first);
        keep_on_sides(first, fixed_of(begin, end));
        Real fastest = 0;
        for (std::size_t i = begin; i < end; ++i) {
            Point& v = first[i - begin];
            if (!v.allFinite()) {
                v.setZero();
                held_[i] = 1;
            }
            fastest = std::max(fastest, v.norm());
        }
        largest_[share] = fastest;
    });
    const Real fastest = *std::max_element(largest_.begin(), largest_.end());
    const Real limit = options_.sub_step * options_.edge_length;
    const Real room = static_cast<Real>(options_.max_sub_steps) - report_.sub_steps;
    Real pieces = std::max(std::ceil(remaining * fastest / limit - 1e-9), 1.0);
    for (; pieces <= room; pieces *= 2) {
        const Real part = remaining / pieces;
        in_shares(n, [&](std::uint32_t share, std::size_t begin, std::size_t end) {
            largest_[share] = integrate(
                options_.integrator, velocity, origins.subspan(begin, end - begin), time, part,
                targets.subspan(begin, end - begin), scratch_[share], fixed_of(begin, end));
            Real farthest = 0;
            for (std::size_t i = begin; i < end; ++i) {
                if (const Real way = (targets[i] - origins[i]).norm(); std::isfinite(way)) {
                    farthest = std::max(farthest, way);
                }
            }
            farthest_[share] = farthest;
        });
        const Real error = *std::max_element(largest_.begin(), largest_.end());
        const Real farthest = *std::max_element(farthest_.begin(), farthest_.end());
        const bool is_exact = options_.integrator != Integrator::adaptive ||
                              error <= options_.tolerance * options_.edge_length;
        if (farthest <= sub_step_slack * limit && is_exact) {
            report_.error = std::max(report_.error, static_cast<double>(error));
            return part;
        }
    }
    return 0;
}

MeshQuality Simulation::mesh_quality() {
    std::array<MeshQuality, Team::max_chunks> parts;
    constexpr std::size_t grain = 1024;
    team_.chunks(complex_.tets.size(), grain,
                 [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t) {
                     parts[chunk] = dsc3::mesh_quality(complex_, static_cast<std::uint32_t>(begin),
                                                       static_cast<std::uint32_t>(end));
                 });
    MeshQuality all;
    for (const MeshQuality& part : parts) {
        all += part;
    }
    return all;
}

void Simulation::archive(dsc::Archive& archive) {
    dsc::as_a_whole(archive, [this](dsc::Archive& each) { transfer(each); });
    if (archive.is_reading()) {
        team_.start_profile(); // the last step was that of another state
    }
}

void Simulation::transfer(dsc::Archive& archive) {
    bool is_edited = version_ != complex_.version; // since the last step
    archive(complex_, is_edited);
    version_ = complex_.version - (is_edited ? 1 : 0);
    std::uint64_t rewirings = rewirings_ + state_.work.counts.rewirings();
    archive(rewirings);
    rewirings_ = rewirings;
    state_.work.counts = {};
    const std::uint64_t count = archive.length(state_.late.size(), 4 + 2 * sizeof(Point));
    state_.late.resize(count);
    for (LateVertex& late : state_.late) {
        archive(late.vertex);
        archive.raw(late.place.data(), sizeof late.place);
        archive.raw(late.target.data(), sizeof late.target);
        archive.expect(late.vertex < complex_.vertex_bound(), "names a vertex that does not exist");
    }
    const std::uint32_t mine = submeshes_ == nullptr ? no_id : submeshes_->kind();
    std::uint32_t kind = mine;
    archive(kind);
    archive.expect(kind == mine, "was written with another division or number of submeshes");
    if (submeshes_ != nullptr) {
        submeshes_->archive(archive);
    }
    archive(state_.unfit);
    for (const std::uint32_t t : state_.unfit) {
        archive.expect(t < complex_.tet_bound(), "names a tet that does not exist");
    }
    state_.grow();
    state_.find_interface();
}

void Simulation::move() {
    std::uint64_t held = 0;
    for (std::size_t i = 0; i < origins_.size(); ++i) {
        if (held_[i] != 0 || !targets_[i].allFinite()) {
            targets_[i] = complex_.at(state_.interface[i]);
            ++held;
        }
        state_.targets[state_.interface[i]] = targets_[i];
    }
    state_.pending = state_.interface;
    report_.held += held;
    report_.moves += state_.pending.size();
    ++report_.sub_steps;
    report_.passes += arrive(state_);
    report_.unreached += state_.pending.size() + held;
    state_.late.clear();
    for (const std::uint32_t v : state_.pending) {
        state_.late.push_back({v, complex_.at(v), state_.targets[v]});
    }
}

} // namespace dsc3

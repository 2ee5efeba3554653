// SPDX-License-Identifier: MIT
#include "thesis/copies/copy_executor.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/interface/list.h"
#include "dsc/passes/work.h"

#include <algorithm>
#include <utility>

namespace dsc {

namespace {

/// Free ids of a submesh, in addition to two for each of its interface vertices: a sub-step of at
/// most one edge length creates about one vertex for each. Edits that need more are deferred, never
/// lost.
constexpr std::size_t spare_ids = 256;

template <class Real>
void forget(Work<Real>& work) {
    work.interface.clear();
    work.moving_vertices.clear();
    work.active.clear();
    work.resized.clear();
    work.deferred.clear();
    work.changed_interface.clear(); // not used here
}

} // namespace

template <class Real>
CopyExecutor<Real>::CopyExecutor(Complex<Real>& complex, const Options<Real>& options,
                                 Algorithm<Real> algorithm, const CopyOptions& copy)
    : Executor<Real>(complex, options, std::move(algorithm)), copy_(copy) {
    check_division({copy.submeshes, copy.normal_x, copy.normal_y});
    require(copy.threads >= 1 && copy.threads <= 1024, "threads", copy.threads, "1 to 1024");
}

template <class Real>
void CopyExecutor<Real>::begin_step() {
    Executor<Real>::begin_step();
    ++costs_.steps;
}

template <class Real>
MoveReport CopyExecutor<Real>::move() {
    MoveReport report;
    report.held = this->begin_movement();
    // Algorithm 6.3: the mesh is divided again until nothing is deferred, except operations that
    // neither colour can do. A vertex that is blocked although nothing is deferred stays blocked.
    const bool is_left = run_round(RedBlack::red, report) && run_round(RedBlack::black, report);
    Timer timer;
    if (is_left) {
        report.passes += run_motion(whole_, algorithm_.motion, epoch_);
    }
    report.unreached = give_up_moving_vertices(whole_) + report.held;
    whole_.deferred.clear();
    costs_.whole_s += timer.lap();
    this->end_movement();
    return report;
}

// Runs one colour. The remaining work is in `whole_` afterwards, under the new ids.
template <class Real>
bool CopyExecutor<Real>::run_round(RedBlack colour, MoveReport& report) {
    Timer timer;
    create_submeshes(complex_, {copy_.submeshes, copy_.normal_x, copy_.normal_y, colour},
                     submeshes_);
    distribute_work();
    costs_.create_s += timer.lap();
    run_tasks();
    costs_.run_s += timer.lap();
    merge_submeshes(submeshes_, complex_);
    whole_.poor.assign(1, no_id);
    if (whole_.log.readers > 0) {
        whole_.log.records.push_back({.kind = EditKind::rebuild});
    }
    const bool is_deferred = collect_work();
    costs_.merge_s += timer.lap();
    ++costs_.rounds;
    for (const auto& task : tasks_) {
        report.passes = std::max(report.passes, task->passes);
    }
    return is_deferred;
}

template <class Real>
void CopyExecutor<Real>::distribute_work() {
    while (tasks_.size() < submeshes_.list.size()) {
        tasks_.push_back(std::make_unique<Task>(submeshes_.list[tasks_.size()]->complex, options_));
    }
    for (const auto& task : tasks_) {
        forget(task->work);
        task->passes = 0;
        // The stamps of a new submesh are 0.
        task->work.epoch = 1;
        task->work.time = whole_.time;
    }
    waiting_vertices_.clear();
    waiting_active_.clear();
    const auto work_of = [&](std::uint32_t vertex) -> Work<Real>* {
        const std::uint32_t owner = submeshes_.owner[vertex];
        return owner < tasks_.size() ? &tasks_[owner]->work : nullptr;
    };
    for (const MovingVertex<Real>& moving_vertex : whole_.moving_vertices) {
        if (Work<Real>* work = work_of(moving_vertex.vertex)) {
            work->moving_vertices.push_back(
                {submeshes_.local[moving_vertex.vertex], moving_vertex.x, moving_vertex.y});
        } else {
            waiting_vertices_.push_back(moving_vertex);
        }
    }
    for (const std::uint32_t v : whole_.resized) {
        if (complex_.is_alive(Vertex{v})) {
            whole_.activate(v);
        }
    }
    whole_.resized.clear();
    for (const std::uint32_t v : whole_.active) {
        if (Work<Real>* work = work_of(v)) {
            work->activate(submeshes_.local[v]);
        } else {
            waiting_active_.push_back(v);
        }
    }
    for (const std::uint32_t v : whole_.interface) {
        if (Work<Real>* work = work_of(v)) {
            work->interface.push_back(submeshes_.local[v]);
        }
    }
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        Task& task = *tasks_[i];
        task.given = task.work.interface;
        lend_ids(*submeshes_.list[i], spare_ids + 2 * task.given.size());
        // A single submesh is the whole mesh, so there are no others that could move first.
        task.work.submesh.region = tasks_.size() > 1 ? submeshes_.list[i]->region() : Region{};
    }
}

template <class Real>
void CopyExecutor<Real>::run_tasks() {
    const auto count = static_cast<std::ptrdiff_t>(tasks_.size());
    const int threads = static_cast<int>(std::min(copy_.threads, copy_.submeshes));
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) if (threads > 1)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        Task& task = *tasks_[static_cast<std::size_t>(i)];
        try {
            std::uint32_t epoch = task.work.epoch;
            task.passes = run_motion(task.work, algorithm_.motion, epoch);
            task.work.complex.attributes.failure.rethrow();
        } catch (...) {
            task.failure = std::current_exception();
        }
    }
    std::exception_ptr first;
    for (const auto& task : tasks_) {
        whole_.log.counts += std::exchange(task->work.log.counts, {});
        std::exception_ptr failure = std::exchange(task->failure, nullptr);
        if (!first) {
            first = failure;
        }
    }
    if (first) {
        std::rethrow_exception(first);
    }
}

template <class Real>
bool CopyExecutor<Real>::collect_work() {
    // In the merged complex all stamps are 0.
    whole_.moving_vertices.clear();
    whole_.active.clear();
    whole_.epoch = this->new_stamp();
    for (const MovingVertex<Real>& moving_vertex : waiting_vertices_) {
        whole_.moving_vertices.push_back(
            {submeshes_.merged_vertex(moving_vertex.vertex), moving_vertex.x, moving_vertex.y});
    }
    for (const std::uint32_t v : waiting_active_) {
        if (const std::uint32_t merged = submeshes_.merged_vertex(v); merged != no_id) {
            whole_.activate(merged);
        }
    }
    bool is_deferred = !waiting_vertices_.empty() || !waiting_active_.empty();
    bool is_as_given = true;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        const Work<Real>& work = tasks_[i]->work;
        const auto& merged = submeshes_.list[i]->merged;
        // A vertex that is blocked here may find room once others have moved.
        const auto add_moving_vertex = [&](const MovingVertex<Real>& moving_vertex) {
            whole_.moving_vertices.push_back(
                {merged[moving_vertex.vertex], moving_vertex.x, moving_vertex.y});
        };
        const auto add_star = [&](std::uint32_t v) {
            if (merged[v] != no_id) {
                whole_.activate(merged[v]);
            }
        };
        std::ranges::for_each(work.moving_vertices, add_moving_vertex);
        std::ranges::for_each(work.active, add_star);
        for (const std::uint32_t v : work.resized) {
            if (merged[v] != no_id) {
                whole_.resized.push_back(merged[v]);
            }
        }
        for (const Deferred<Real>& one : work.deferred.entries) {
            if (one.kind == DeferredKind::moving_vertex) {
                add_moving_vertex(one.moving_vertex());
                is_deferred = true;
            } else if (one.kind == DeferredKind::star) {
                add_star(one.vertex);
                is_deferred = true;
            }
        }
        is_as_given = is_as_given && work.interface == tasks_[i]->given;
    }
    restore_interface(is_as_given);
    std::erase_if(whole_.moving_vertices,
                  [](const auto& moving_vertex) { return moving_vertex.vertex == no_id; });
    return is_deferred;
}

// Keeps the order of the list, unless passes of an application rewrote it.
template <class Real>
void CopyExecutor<Real>::restore_interface(bool is_as_given) {
    if (!is_as_given) {
        whole_.interface = collect_moved(complex_, options_);
        return;
    }
    for (std::uint32_t& v : whole_.interface) {
        v = submeshes_.merged_vertex(v);
    }
    std::erase(whole_.interface, no_id);
}

// After an exception: drops the moving vertices, and finds the interface again. Vertices that are
// still alive stay active, so that stars that changed before the exception are visited in the next
// step. O(mesh).
template <class Real>
void CopyExecutor<Real>::recover() {
    const std::vector<std::uint32_t> active = std::move(whole_.active);
    forget(whole_);
    whole_.epoch = this->new_stamp();
    for (const std::uint32_t v : active) {
        if (complex_.is_alive(Vertex{v})) {
            whole_.activate(v);
        }
    }
    this->list_interface();
}

template <class Real>
void CopyExecutor<Real>::end_step() {
    if (progress_ == Progress::under_way) {
        recover();
    }
    Executor<Real>::end_step();
}

template <class Real>
void CopyExecutor<Real>::archive(Archive& archive) {
    Executor<Real>::archive(archive);
    archive(costs_.steps, costs_.rounds);
}

namespace {

template <class Real>
std::unique_ptr<Executor<Real>> make_copies(Complex<Real>& complex, const Options<Real>& options,
                                            const Parallel& parallel, Algorithm<Real> algorithm) {
    return std::make_unique<CopyExecutor<Real>>(
        complex, options, std::move(algorithm),
        CopyOptions{.submeshes = submeshes_of(parallel), .threads = parallel.threads});
}

} // namespace

constinit const Division copy_division{
    "copy", "submeshes created and merged (thesis, algorithms 6.1 and 6.2)",
    CopyOptions{}.submeshes, make_copies<double>, make_copies<float>};

template class CopyExecutor<double>;
template class CopyExecutor<float>;

} // namespace dsc

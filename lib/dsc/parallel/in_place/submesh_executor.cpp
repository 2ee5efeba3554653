// SPDX-License-Identifier: MIT
#include "dsc/parallel/in_place/submesh_part.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dsc {

namespace {

/// A thread pays off from about this many interface vertices on; fewer threads are used if there is
/// less to do.
constexpr std::size_t vertices_per_thread = 32;

std::size_t size_of(const Partition& partition) {
    std::size_t size = 0;
    for (const Colour& colour : partition.colours) {
        size += colour.regions.size();
    }
    return size;
}

// Whether each colour has a single region, which is then the whole plane.
bool is_one(const Partition& partition) { return size_of(partition) == partition.colours.size(); }

} // namespace

template <class Real>
SubmeshExecutor<Real>::SubmeshExecutor(Complex<Real>& complex, const Options<Real>& options,
                                       Algorithm<Real> algorithm,
                                       std::unique_ptr<Partitioner<Real>> partitioner,
                                       const Parallel& parallel)
    : Executor<Real>(complex, options, std::move(algorithm)), partitioner_(std::move(partitioner)),
      parallel_(parallel), choice_(parallel.threads), joined_(complex, options_) {
    check_options(options); // a partitioner uses the edge length
    require(parallel.threads >= 1 && parallel.threads <= 1024, "threads", parallel.threads,
            "1 to 1024");
    if (!partitioner_) {
        throw InputError({.what = "null partitioner",
                          .where = "SubmeshExecutor",
                          .value = "null",
                          .allowed = "a Partitioner object"});
    }
    this->in_shares_ = [this](std::size_t shares, const std::function<void(std::size_t)>& task) {
        if (sharing_.tasks.size() != shares) {
            sharing_.tasks.clear();
            sharing_.tasks.add_colour(shares);
        }
        sharing_.run(pool_, threads_, parallel_.assignment, task);
    };
    // All work that takes longer in a large mesh is done here rather than in a step: the first
    // division, reserving memory, lending ids, and starting threads.
    generation_ = complex_.ids.generation;
    divide();
    choose_threads();
    make_room();
    for (auto& part : parts_) {
        refill(*part);
    }
}

template <class Real>
SubmeshExecutor<Real>::~SubmeshExecutor() {
    if (has_pools()) {
        complex_.ids.collect();
    }
}

// --- set-up ------------------------------------------------------------------------------------

// Stamps for one parallel section: all its submeshes may use the same stamps, since they share no
// vertices.
template <class Real>
std::uint32_t SubmeshExecutor<Real>::next_epochs() {
    const auto needed = 2 * static_cast<std::uint32_t>(options_.max_passes) + 8;
    if (epoch_ > 0xffffffffU - 4 * needed) {
        clear_stamps(complex_); // once in some 500,000 sub-steps
        epoch_ = 0;
    }
    const std::uint32_t first = epoch_ + 1;
    epoch_ += needed;
    return first;
}

template <class Real>
void SubmeshExecutor<Real>::begin_step() {
    (void)step_timer_.lap();
    Executor<Real>::begin_step();
    lend_pools();
    choose_threads();
    pool_.wake(threads_);
    profile_.clear();
    status_.interface_vertices = this->interface_size();
    if (status_.step > 0) { // the first step uses the division made at construction
        divide();
    }
    ++status_.step;
    ++status_.steps_since_all;
}

// The number of threads that have enough to do.
template <class Real>
void SubmeshExecutor<Real>::choose_threads() {
    const std::size_t size = this->interface_size();
    const std::size_t share = parallel_.always_all_threads ? 1 : vertices_per_thread;
    const std::size_t pay_off = size / share;
    useful_threads_ = static_cast<std::uint32_t>(
        std::clamp<std::size_t>(pay_off, 1, std::max<std::size_t>(first_colour_, 1)));
    threads_ = std::min(useful_threads_,
                        parallel_.always_all_threads ? parallel_.threads : choice_.threads());
    // Threads are started before they are needed, since a new one takes milliseconds to get a core
    // of its own; but not while the interface is far too short, since a start also delays the
    // steps.
    const std::size_t soon = (size + size / 2) / share;
    pool_.start(static_cast<std::uint32_t>(std::min<std::size_t>(soon, parallel_.threads)));
}

template <class Real>
void SubmeshExecutor<Real>::divide() {
    const Recut recut = partition_.colours.empty() ? Recut::all : partitioner_->is_due(status_);
    if (recut == Recut::none) {
        return;
    }
    std::vector<std::uint32_t> list;
    this->append_interface(list);
    if (recut == Recut::all && options_.shuffle_seed == 0 && !parts_.empty()) {
        // New vertices of submesh boundaries are at the ends of lists.
        order_interface(complex_, list, next_epochs());
    }
    partitioner_->divide({complex_, list, work_of(list), static_cast<double>(options_.edge_length)},
                         recut, partition_);
    make_parts(recut);
    const std::uint32_t lost = recut == Recut::all ? distribute_interface(std::move(list)) : no_id;
    connect();
    if (lost != no_id) { // the next step asks for another division
        throw InputError({.what = "the partition's first colour does not cover a vertex",
                          .where = "Partitioner::divide",
                          .value = "vertex " + std::to_string(lost) + " at " +
                                   to_text(complex_.position(Vertex{lost})),
                          .allowed = "regions that cover the plane, in each colour"});
    }
    if (recut == Recut::all) {
        status_.steps_since_all = 0;
    }
}

// Estimates the work of each vertex since the last division by its submesh's average.
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
    const std::size_t wanted = is_one(partition_) ? 0 : size_of(partition_);
    while (parts_.size() > wanted) {
        move_ids(*parts_.back()->pool, complex_.ids, 0, 0);
        const std::vector<std::uint32_t>& resized = parts_.back()->work.resized;
        whole_.resized.insert(whole_.resized.end(), resized.begin(), resized.end());
        parts_.back()->work.resized.clear();
        spare_parts_.push_back(std::move(parts_.back()));
        parts_.pop_back();
    }
    while (parts_.size() < wanted) {
        if (spare_parts_.empty()) {
            spare_parts_.push_back(std::make_unique<Part>(complex_, options_));
        }
        parts_.push_back(std::move(spare_parts_.back()));
        spare_parts_.pop_back();
        parts_.back()->pool = &complex_.ids.lend(parts_.size() - 1);
        parts_.back()->make_room(Part::min_room);
        parts_.back()->work.log.readers = whole_.log.readers;
        parts_.back()->work.watched_quality = whole_.watched_quality;
    }
    first_colour_ = parts_.empty() ? 0 : partition_.colours.front().regions.size();
    works_.clear();
    for (const Colour& colour : partition_.colours) {
        for (std::size_t i = 0; i < colour.regions.size() && works_.size() < wanted; ++i) {
            Part& part = *parts_[works_.size()];
            part.work.remeshing = algorithm_.remeshing;
            part.work.submesh.region = colour.regions[i].simplest();
            part.work.submesh.pool = colour.regions[i].is_whole() ? &complex_.ids : part.pool;
            if (works_.size() >= kept) {
                part.work.interface.clear();
                part.examined = 0;
            }
            works_.push_back(&part.work);
        }
    }
    works_.push_back(&whole_);
}

// Distributes interface vertices to the submeshes. Returns a vertex in a gap of the partition, or
// no_id.
template <class Real>
std::uint32_t SubmeshExecutor<Real>::distribute_interface(std::vector<std::uint32_t> list) {
    whole_.interface.clear();
    if (parts_.empty()) {
        whole_.interface = std::move(list);
        return no_id;
    }
    std::uint32_t lost = no_id;
    const Colour& colour = partition_.colours.front();
    std::size_t at = 0;
    for (const std::uint32_t v : list) {
        at = colour.locate(v, place_of(v).x(), place_of(v).y(), at);
        if (at == first_colour_) {
            lost = v;
            at = 0; // as `owner_of`
        }
        parts_[at]->work.interface.push_back(v);
    }
    for (std::size_t i = 0; i < first_colour_; ++i) {
        parts_[i]->make_room(2 * parts_[i]->work.interface.size());
    }
    return lost;
}

// Makes the tasks: a submesh waits for the overlapping submeshes of the previous colour, and then
// has exclusive access to everything it owns.
template <class Real>
void SubmeshExecutor<Real>::connect() {
    targets_schedule_.tasks.clear();
    moving_.tasks.clear();
    if (parts_.empty()) {
        return;
    }
    targets_schedule_.tasks.add_colour(first_colour_);
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

template <class Real>
Point<double> SubmeshExecutor<Real>::place_of(std::uint32_t vertex) const {
    const auto& record = complex_.vertices[vertex];
    return {static_cast<double>(read_shared(record.x)), static_cast<double>(read_shared(record.y))};
}

template <class Real>
void SubmeshExecutor<Real>::end_step() {
    if (!parts_.empty() && progress_ != Progress::none) {
        put_back();
    }
    Executor<Real>::end_step();
    std::uint64_t examined = whole_.log.counts.examined;
    for (auto& part : parts_) {
        part->examined += part->work.log.counts.examined;
        examined += part->work.log.counts.examined;
        if (has_pools()) { // a stage may have replaced the complex
            give_back_surplus(*part);
        }
    }
    choice_.took(step_timer_.lap(), static_cast<double>(examined), useful_threads_);
}

template class SubmeshExecutor<double>;
template class SubmeshExecutor<float>;

} // namespace dsc

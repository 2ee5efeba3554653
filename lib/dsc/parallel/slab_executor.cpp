// SPDX-License-Identifier: MIT
#include "dsc/parallel/slab_executor.h"

#include "dsc/algorithm/interface_upkeep.h"
#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

namespace dsc {

namespace {

/// Ids that each slab holds before it runs: a step of at most an edge length makes about one vertex
/// per interface vertex; what does not fit is put off to the next colour, never lost.
constexpr std::size_t spare_vertices = 256;

void check(const SlabOptions& options) {
    const auto refuse = [](const char* what, const std::string& value, const char* allowed) {
        throw InputError("value out of range", what, value, allowed);
    };
    if (options.submeshes < 1 || options.submeshes > 65536) {
        refuse("submeshes", std::to_string(options.submeshes), "1 to 65536");
    }
    if (options.threads < 1 || options.threads > 1024) {
        refuse("threads", std::to_string(options.threads), "1 to 1024");
    }
    const double norm = std::hypot(options.normal_x, options.normal_y);
    if (!(std::abs(norm - 1) < 1e-9)) {
        refuse("normal", std::to_string(norm), "a direction of length 1");
    }
    if (!(options.least_width >= 2)) {
        refuse("least_width", std::to_string(options.least_width), "2 edge lengths or more");
    }
    if (options.recount < 1) {
        refuse("recount", std::to_string(options.recount), "1 step or more");
    }
}

// Concatenates one list of all slabs, in their order, and empties it there.
template <class Item, class SlabList, class Member>
void collect(std::vector<Item>& out, SlabList& slabs, Member member) {
    for (auto& slab : slabs) {
        auto& list = member(slab->work);
        out.insert(out.end(), list.begin(), list.end());
        list.clear();
    }
}

} // namespace

template <class Real>
SlabExecutor<Real>::Slab::Slab(Complex<Real>& complex, const Options<Real>& options)
    : work(complex, options) {
    pool.may_grow = false;
    work.submesh.pool = &pool;
}

template <class Real>
SlabExecutor<Real>::SlabExecutor(Complex<Real>& complex, const Options<Real>& options,
                                 Algorithm<Real> algorithm, const SlabOptions& slabs)
    : complex_(complex), options_(options), algorithm_(std::move(algorithm)), slabs_(slabs),
      whole_(complex, options) {
    check(slabs);
    for (const auto& vertex : complex.vertices) {
        epoch_ = std::max(epoch_, vertex.stamp);
    }
    interface_ = collect_interface(complex, options.shuffle_seed);
}

template <class Real>
SlabExecutor<Real>::~SlabExecutor() {
    for (auto* slabs : {&red_, &black_}) {
        for (auto& slab : *slabs) {
            return_all(slab->pool);
        }
    }
    complex_.lent_vertices = 0;
    complex_.lent_triangles = 0;
}

template <class Real>
void SlabExecutor<Real>::return_all(IdPool& pool) {
    IdPool& ids = complex_.ids;
    ids.vertices.insert(ids.vertices.end(), pool.vertices.begin(), pool.vertices.end());
    ids.triangles.insert(ids.triangles.end(), pool.triangles.begin(), pool.triangles.end());
    pool.vertices.clear();
    pool.triangles.clear();
}

template <class Real>
std::size_t SlabExecutor<Real>::slab_at(const std::vector<double>& cuts,
                                        std::uint32_t vertex) const {
    const auto& record = complex_.vertices[vertex];
    return slab_of(cuts, slabs_.normal_x * static_cast<double>(record.x) +
                             slabs_.normal_y * static_cast<double>(record.y));
}

template <class Real>
void SlabExecutor<Real>::choose_cuts() {
    const bool recount = steps_ % slabs_.recount == 0;
    if (slabs_.slabbing != Slabbing::active && !recount) {
        return;
    }
    const double least = slabs_.least_width * static_cast<double>(options_.edge_length);
    const auto along = [&](double x, double y) {
        return slabs_.normal_x * x + slabs_.normal_y * y;
    };
    scratch_.clear();
    if (slabs_.slabbing == Slabbing::active) {
        for (const std::uint32_t v : interface_) {
            const auto& record = complex_.vertices[v];
            scratch_.push_back(along(static_cast<double>(record.x), static_cast<double>(record.y)));
        }
    } else {
        // Every vertex stands for the two triangles that it owns on average.
        for (const auto& record : complex_.vertices) {
            if ((record.flags & vertex_dead) == 0) {
                scratch_.push_back(
                    along(static_cast<double>(record.x), static_cast<double>(record.y)));
            }
        }
    }
    if (slabs_.slabbing == Slabbing::fixed && !scratch_.empty()) {
        const auto [low, high] = std::minmax_element(scratch_.begin(), scratch_.end());
        cuts_ = cuts_of_equal_width(*low, *high, slabs_.submeshes, least);
    } else {
        cuts_ = cuts_of_equal_share(scratch_, slabs_.submeshes, least);
    }
    scratch_.shrink_to_fit();
}

template <class Real>
void SlabExecutor<Real>::begin_step() {
    choose_cuts();
    ++steps_;
    const auto prepare = [&](Slabs& slabs, const std::vector<double>& cuts) {
        while (slabs.size() < cuts.size() - 1) {
            slabs.push_back(std::make_unique<Slab>(complex_, options_));
        }
        while (slabs.size() > cuts.size() - 1) {
            return_all(slabs.back()->pool);
            slabs.pop_back();
        }
        for (std::size_t i = 0; i < slabs.size(); ++i) {
            slabs[i]->work.submesh.region = slab_region(cuts, i, slabs_.normal_x, slabs_.normal_y);
        }
    };
    prepare(red_, cuts_.red);
    prepare(black_, cuts_.black);
}

template <class Real>
void SlabExecutor<Real>::refill(Slabs& slabs) {
    for (auto& slab : slabs) {
        IdPool& pool = slab->pool;
        const std::size_t vertices = spare_vertices + 2 * slab->work.interface.size();
        while (pool.vertices.size() < vertices / 2 + 1 || pool.triangles.size() < vertices + 1) {
            // Half full is enough; then fill up, so that this is rare.
            while (pool.vertices.size() < vertices) {
                const std::uint32_t id = complex_.take_vertex(complex_.ids);
                complex_.vertices[id].flags = vertex_dead;
                pool.vertices.push_back(id);
            }
            while (pool.triangles.size() < 2 * vertices) {
                const std::uint32_t id = complex_.take_triangle(complex_.ids);
                complex_.triangles[id].v = {no_id, no_id, no_id};
                pool.triangles.push_back(id);
            }
        }
    }
}

template <class Real>
void SlabExecutor<Real>::return_surplus(Slabs& slabs) {
    for (auto& slab : slabs) {
        IdPool& pool = slab->pool;
        const std::size_t vertices = 2 * (spare_vertices + 2 * slab->work.interface.size());
        const auto give_back = [](std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
                                  std::size_t keep) {
            while (from.size() > keep) {
                to.push_back(from.back());
                from.pop_back();
            }
        };
        give_back(pool.vertices, complex_.ids.vertices, vertices);
        give_back(pool.triangles, complex_.ids.triangles, 2 * vertices);
        complex_.lent_vertices += static_cast<std::uint32_t>(pool.vertices.size());
        complex_.lent_triangles += static_cast<std::uint32_t>(pool.triangles.size());
    }
}

template <class Real>
void SlabExecutor<Real>::run_colour(Slabs& slabs, const std::vector<Pass<Real>>& passes,
                                    bool combine_ends) {
    refill(slabs);
    ++epoch_;
    const std::size_t count = slabs.size();
    const std::size_t tasks = combine_ends && count > 1 ? count - 1 : count;
    std::exception_ptr failure;
    const auto run_slab = [&](std::size_t i) {
        Work<Real>& work = slabs[i]->work;
        work.epoch = epoch_;
        for (const auto& pass : passes) {
            pass.run(work);
        }
    };
    const auto signed_tasks = static_cast<std::ptrdiff_t>(tasks);
    const int threads = static_cast<int>(std::min<std::size_t>(slabs_.threads, tasks));
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) if (threads > 1)
    for (std::ptrdiff_t task = 0; task < signed_tasks; ++task) {
        try {
            run_slab(static_cast<std::size_t>(task));
            if (task == 0 && tasks < count) {
                run_slab(count - 1);
            }
        } catch (...) {
#pragma omp critical(dsc_slab_failure)
            failure = std::current_exception();
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

template <class Real>
void SlabExecutor<Real>::run_upkeep() {
    under_way_ = true;
    for (const std::uint32_t v : interface_) {
        red_[slab_at(cuts_.red, v)]->work.interface.push_back(v);
    }
    interface_.clear();
    run_colour(red_, algorithm_.upkeep, false);
    collect(
        interface_, red_, [](auto& work) -> auto& { return work.interface; });
    std::vector<std::uint32_t> put_off;
    const auto take_put_off = [&](Slabs& slabs) {
        put_off.clear();
        collect(
            put_off, slabs, [](auto& work) -> auto& { return work.put_off_interface; });
    };
    take_put_off(red_);
    if (!put_off.empty()) {
        for (const std::uint32_t v : put_off) {
            black_[slab_at(cuts_.black, v)]->work.interface.push_back(v);
        }
        run_colour(black_, algorithm_.upkeep, true);
        collect(
            interface_, black_, [](auto& work) -> auto& { return work.interface; });
        take_put_off(black_);
    }
    if (!put_off.empty()) {
        whole_.epoch = ++epoch_;
        whole_.interface = put_off;
        for (const auto& pass : algorithm_.upkeep) {
            pass.run(whole_);
        }
        interface_.insert(interface_.end(), whole_.interface.begin(), whole_.interface.end());
        whole_.interface.clear();
        whole_.put_off_interface.clear();
    }
    under_way_ = false;
}

template <class Real>
std::size_t SlabExecutor<Real>::run_motion() {
    under_way_ = true;
    std::size_t progressed = 0;
    const auto count_progress = [&](Slabs& slabs) {
        for (auto& slab : slabs) {
            progressed += std::exchange(slab->work.progressed, 0);
        }
    };
    const auto hand_out = [&](Slabs& slabs, const std::vector<double>& cuts) {
        for (const auto& mover : movers_) {
            slabs[slab_at(cuts, mover.vertex)]->work.movers.push_back(mover);
        }
        movers_.clear();
    };
    std::vector<Mover<Real>> blocked; // moved as far as they could: for the next pass
    std::vector<std::uint32_t> active;
    const auto take_back = [&](Slabs& slabs) {
        collect(
            blocked, slabs, [](auto& work) -> auto& { return work.movers; });
        collect(
            movers_, slabs, [](auto& work) -> auto& { return work.put_off_movers; });
        active.clear();
        collect(
            active, slabs, [](auto& work) -> auto& { return work.put_off_active; });
        count_progress(slabs);
    };

    hand_out(red_, cuts_.red);
    run_colour(red_, algorithm_.motion, false);
    take_back(red_);

    hand_out(black_, cuts_.black);
    ++epoch_;
    for (const std::uint32_t v : active) {
        auto& record = complex_.vertices[v];
        if ((record.flags & vertex_dead) == 0 && record.stamp != epoch_) {
            record.stamp = epoch_;
            black_[slab_at(cuts_.black, v)]->work.active.push_back(v);
        }
    }
    run_colour(black_, algorithm_.motion, true);
    take_back(black_);

    if (!movers_.empty() || !active.empty() || !whole_.active.empty()) {
        whole_.epoch = ++epoch_;
        whole_.movers.swap(movers_);
        for (const std::uint32_t v : active) {
            if (complex_.is_alive(Vertex{v})) {
                whole_.activate(v);
            }
        }
        for (const auto& pass : algorithm_.motion) {
            pass.run(whole_);
        }
        progressed += std::exchange(whole_.progressed, 0);
        blocked.insert(blocked.end(), whole_.movers.begin(), whole_.movers.end());
        whole_.movers.clear();
        whole_.put_off_active.clear();
    }
    movers_.swap(blocked);
    under_way_ = false;
    return progressed;
}

template <class Real>
void SlabExecutor<Real>::recover() {
    const auto forget = [](Work<Real>& work) {
        work.interface.clear();
        work.movers.clear();
        work.active.clear();
        work.put_off_interface.clear();
        work.put_off_movers.clear();
        work.put_off_active.clear();
    };
    for (auto* slabs : {&red_, &black_}) {
        for (auto& slab : *slabs) {
            forget(slab->work);
        }
    }
    forget(whole_);
    movers_.clear();
    interface_ = collect_interface(complex_, options_.shuffle_seed);
    under_way_ = false;
}

template <class Real>
void SlabExecutor<Real>::end_step() {
    if (under_way_) {
        recover();
    }
    complex_.lent_vertices = 0;
    complex_.lent_triangles = 0;
    return_surplus(red_);
    return_surplus(black_);
}

template <class Real>
void SlabExecutor<Real>::for_pieces(std::size_t n,
                                    const typename Executor<Real>::PieceFunction& run) {
    const auto pieces = static_cast<std::ptrdiff_t>(slabs_.submeshes);
    const int threads = static_cast<int>(std::min(slabs_.threads, slabs_.submeshes));
    std::exception_ptr failure;
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
    for (std::ptrdiff_t piece = 0; piece < pieces; ++piece) {
        const auto p = static_cast<std::size_t>(piece);
        const auto count = static_cast<std::size_t>(pieces);
        try {
            run(p, n * p / count, n * (p + 1) / count);
        } catch (...) {
#pragma omp critical(dsc_slab_failure)
            failure = std::current_exception();
        }
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

template <class Real>
OperationCounts SlabExecutor<Real>::take_counts() {
    OperationCounts total = std::exchange(whole_.counts, {});
    for (auto* slabs : {&red_, &black_}) {
        for (auto& slab : *slabs) {
            total += std::exchange(slab->work.counts, {});
        }
    }
    return total;
}

template class SlabExecutor<double>;
template class SlabExecutor<float>;

} // namespace dsc

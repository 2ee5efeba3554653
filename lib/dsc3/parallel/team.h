// SPDX-License-Identifier: MIT
// Loops whose iterations are independent of each other, in chunks that do not depend on the number
// of threads: results that are gathered chunk by chunk do not either.
#pragma once

#include "dsc/parallel/threads/thread_pool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <vector>

namespace dsc3 {

/// The times of the loops of a step, if `Parallel::profile` asks for them, in seconds.
struct StepProfile {
    /// A loop whose iterations the threads shared.
    struct Section {
        std::size_t first_task; ///< its first one in `tasks`
        double wall;
    };
    std::vector<Section> sections;
    std::vector<double> tasks; ///< of each section in the order in which threads take them
};

/// The threads of one simulation.
class Team : public dsc::Unmovable {
public:
    /// No loop has more chunks.
    static constexpr std::size_t max_chunks = 32;

    /// Without threads, loops have one chunk: the sequential method, whose order is its own.
    Team() : threads_(1), chunks_(1) {}
    Team(std::uint32_t threads, bool is_profiled)
        : threads_(threads), chunks_(max_chunks), is_profiled_(is_profiled) {
        if (threads > 1) {
            pool_.start(threads);
        }
    }

    /// Whether loops are divided at all.
    [[nodiscard]] bool is_parallel() const { return chunks_ > 1; }
    /// The largest number of threads, the caller included.
    [[nodiscard]] std::uint32_t size() const { return threads_; }
    /// The times of all loops since `start_profile`; empty unless they are profiled.
    [[nodiscard]] const StepProfile& profile() const { return profile_; }
    void start_profile() {
        profile_.sections.clear();
        profile_.tasks.clear();
    }

    /// Calls `work(item, thread)` for each item below `count`, on any thread, in any order.
    /// Rethrows the exception of the lowest item that threw one, when all have ended.
    template <class Work>
    void each(std::uint32_t count, Work work) {
        failures_.assign(count, nullptr);
        const std::size_t first = profile_.tasks.size();
        profile_.tasks.resize(is_profiled_ ? first + count : 0);
        const auto begin = now();
        std::atomic<std::uint32_t> next = 0;
        const auto take = [&](std::uint32_t thread) {
            for (std::uint32_t item = next++; item < count; item = next++) {
                const auto item_begin = now();
                try {
                    work(item, thread);
                } catch (...) {
                    failures_[item] = std::current_exception();
                }
                if (is_profiled_) {
                    profile_.tasks[first + item] = seconds_since(item_begin);
                }
            }
        };
        if (threads_ == 1 || count <= 1) {
            take(0);
        } else {
            pool_.run(std::min(threads_, count), std::cref(take));
        }
        if (is_profiled_) {
            profile_.sections.push_back({first, seconds_since(begin)});
        }
        for (const std::exception_ptr& failure : failures_) {
            if (failure != nullptr) {
                std::rethrow_exception(failure);
            }
        }
    }

    /// Calls `work(chunk, begin, end, thread)` for the chunks of [0, n), each of `grain` iterations
    /// or more. Returns the number of chunks.
    template <class Work>
    std::uint32_t chunks(std::size_t n, std::size_t grain, Work work) {
        const auto count =
            static_cast<std::uint32_t>(std::clamp<std::size_t>(n / grain, n > 0 ? 1 : 0, chunks_));
        each(count, [&](std::uint32_t chunk, std::uint32_t thread) {
            work(chunk, n * chunk / count, n * (chunk + 1) / count, thread);
        });
        return count;
    }

private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] Clock::time_point now() const {
        return is_profiled_ ? Clock::now() : Clock::time_point();
    }
    static double seconds_since(Clock::time_point begin) {
        return std::chrono::duration<double>(Clock::now() - begin).count();
    }

    std::uint32_t threads_;
    std::size_t chunks_;
    bool is_profiled_ = false;
    StepProfile profile_;
    dsc::ThreadPool pool_;
    std::vector<std::exception_ptr> failures_;
};

/// The results of a chunk. No cache line is also that of another one: threads that append to two of
/// them would take it from each other.
template <class Value>
struct alignas(64) ChunkList : std::vector<Value> {};

/// The results of a loop, by chunk.
template <class Value>
using ByChunk = std::array<ChunkList<Value>, Team::max_chunks>;

/// Appends the results of the first chunks in their order.
template <class Value>
void append_chunks(std::vector<Value>& list, const ByChunk<Value>& parts, std::uint32_t chunks) {
    for (std::uint32_t chunk = 0; chunk < chunks; ++chunk) {
        list.insert(list.end(), parts[chunk].begin(), parts[chunk].end());
    }
}

} // namespace dsc3

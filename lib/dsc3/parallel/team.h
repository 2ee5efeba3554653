// SPDX-License-Identifier: MIT
// Loops whose iterations are independent of each other, in chunks that do not depend on the number
// of threads: results that are gathered chunk by chunk do not either.
#pragma once

#include "dsc/parallel/threads/thread_pool.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <vector>

namespace dsc3 {

/// The threads of one simulation.
class Team : public dsc::Unmovable {
public:
    /// No loop has more chunks.
    static constexpr std::size_t max_chunks = 32;

    /// Without threads, loops have one chunk: the sequential method, whose order is its own.
    Team() : threads_(1), chunks_(1) {}
    explicit Team(std::uint32_t threads) : threads_(threads), chunks_(max_chunks) {
        if (threads > 1) {
            pool_.start(threads);
        }
    }

    /// Whether loops are divided at all.
    [[nodiscard]] bool is_parallel() const { return chunks_ > 1; }
    /// The largest number of threads, the caller included.
    [[nodiscard]] std::uint32_t size() const { return threads_; }

    /// Calls `work(item, thread)` for each item below `count`, on any thread, in any order.
    /// Rethrows the exception of the lowest item that threw one, when all have ended.
    template <class Work>
    void each(std::uint32_t count, Work work) {
        failures_.assign(count, nullptr);
        std::atomic<std::uint32_t> next = 0;
        const auto take = [&](std::uint32_t thread) {
            for (std::uint32_t item = next++; item < count; item = next++) {
                try {
                    work(item, thread);
                } catch (...) {
                    failures_[item] = std::current_exception();
                }
            }
        };
        if (threads_ == 1 || count <= 1) {
            take(0);
        } else {
            pool_.run(std::min(threads_, count), std::cref(take));
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
    std::uint32_t threads_;
    std::size_t chunks_;
    dsc::ThreadPool pool_;
    std::vector<std::exception_ptr> failures_;
};

/// The results of a loop, by chunk.
template <class Value>
using ByChunk = std::array<std::vector<Value>, Team::max_chunks>;

/// Appends the results of the first chunks in their order.
template <class Value>
void append_chunks(std::vector<Value>& list, const ByChunk<Value>& parts, std::uint32_t chunks) {
    for (std::uint32_t chunk = 0; chunk < chunks; ++chunk) {
        list.insert(list.end(), parts[chunk].begin(), parts[chunk].end());
    }
}

} // namespace dsc3

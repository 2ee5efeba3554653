// SPDX-License-Identifier: MIT
// Parallel loops with threads that are started for each loop: a step takes milliseconds, and
// starting a thread a few hundredths of a millisecond.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace dsc {

/// Calls `work(i)` once for each i below `count`, in any order, on `threads` threads including the
/// caller, or on fewer if there are fewer chunks or no more threads can be started. Rethrows one of
/// the exceptions of `work`.
template <class Work>
void share_out(std::size_t count, std::uint32_t threads, const Work& work, std::size_t chunk = 64) {
    const auto run = [&](std::atomic<std::size_t>& next) {
        for (std::size_t i = next.fetch_add(chunk); i < count; i = next.fetch_add(chunk)) {
            for (std::size_t k = i; k < std::min(i + chunk, count); ++k) {
                work(k);
            }
        }
    };
    std::atomic<std::size_t> next = 0;
    if (threads <= 1 || count <= chunk) {
        run(next);
        return;
    }
    std::mutex door;
    std::exception_ptr failure;
    const auto guarded = [&] {
        try {
            run(next);
        } catch (...) {
            const std::scoped_lock lock(door);
            failure = std::current_exception();
        }
    };
    std::vector<std::jthread> others;
    try {
        const std::size_t chunks = (count + chunk - 1) / chunk;
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, chunks); ++i) {
            others.emplace_back(guarded);
        }
    } catch (const std::system_error&) { // the threads already started do the work
    }
    guarded();
    others.clear(); // joins them
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace dsc

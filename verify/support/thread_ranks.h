// SPDX-License-Identifier: MIT
// Ranks that are threads of one process: what holds for them holds for processes, and the
// sanitizers see all of it.
#pragma once

#include "dsc/parallel/ranks/ranks.h"

#include <barrier>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace dsc {

/// What the threads share: the bytes of each.
class ThreadGroup {
public:
    explicit ThreadGroup(std::uint32_t size)
        : bytes_(size), barrier_(static_cast<std::ptrdiff_t>(size)) {}

    /// A rank has ended: the others are not to wait for it.
    void end(std::uint32_t rank) {
        bytes_[rank] = {};
        barrier_.arrive_and_drop();
    }

private:
    friend class ThreadTransport;
    std::vector<std::span<const std::byte>> bytes_;
    std::barrier<> barrier_;
};

class ThreadTransport final : public Transport {
public:
    ThreadTransport(ThreadGroup& group, std::uint32_t rank) : group_(group), rank_(rank) {}

    [[nodiscard]] std::uint32_t rank() const override { return rank_; }
    [[nodiscard]] std::uint32_t size() const override {
        return static_cast<std::uint32_t>(group_.bytes_.size());
    }
    [[nodiscard]] RankBytes all_gather(std::span<const std::byte> mine) override {
        group_.bytes_[rank_] = mine;
        group_.barrier_.arrive_and_wait();
        copies_.clear();
        for (const auto& bytes : group_.bytes_) {
            copies_.emplace_back(bytes.begin(), bytes.end());
        }
        all_.assign(copies_.begin(), copies_.end());
        group_.barrier_.arrive_and_wait(); // until then the others read
        for (std::size_t rank = 0; rank < all_.size(); ++rank) {
            if (all_[rank].empty()) { // no message is
                throw std::runtime_error("rank " + std::to_string(rank) +
                                         " has ended before the others");
            }
        }
        return all_;
    }

private:
    ThreadGroup& group_;
    std::uint32_t rank_;
    std::vector<std::vector<std::byte>> copies_;
    std::vector<std::span<const std::byte>> all_;
};

/// Calls `run` for each rank, in threads of their own. A rank that throws leaves, as a program
/// would. Returns what each has thrown.
inline std::vector<std::exception_ptr> run_ranks(std::uint32_t size,
                                                 const std::function<void(Ranks&)>& run) {
    ThreadGroup group(size);
    std::vector<std::exception_ptr> thrown(size);
    std::vector<std::thread> threads;
    for (std::uint32_t rank = 0; rank < size; ++rank) {
        threads.emplace_back([&, rank] {
            ThreadTransport transport(group, rank);
            Ranks ranks(transport);
            try {
                run(ranks);
                ranks.wait_for_all();
            } catch (...) {
                thrown[rank] = std::current_exception();
                ranks.leave(thrown[rank]);
            }
            group.end(rank);
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    return thrown;
}

/// The same, where none may throw: rethrows the first.
inline void run_all_ranks(std::uint32_t size, const std::function<void(Ranks&)>& run) {
    for (const std::exception_ptr& thrown : run_ranks(size, run)) {
        if (thrown) {
            std::rethrow_exception(thrown);
        }
    }
}

} // namespace dsc

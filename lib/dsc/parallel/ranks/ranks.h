// SPDX-License-Identifier: MIT
// The ranks of a simulation: exchanges by which all of them know the same, and an end that they
// find together. What goes wrong on one rank is told in its next message, and thrown on all of
// them.
#pragma once

#include "dsc/parallel/ranks/message.h"
#include "dsc/parallel/ranks/transport.h"

#include <atomic>
#include <exception>
#include <vector>

namespace dsc {

/// Seconds of one rank in the sections that ranks share.
struct RankTimes {
    double work = 0;   ///< in its own submeshes
    double tell = 0;   ///< in writing what they did
    double wait = 0;   ///< until all had told
    double repeat = 0; ///< in doing what the others told

    /// Adds those of another section.
    RankTimes& operator+=(const RankTimes& more) {
        work += more.work;
        tell += more.tell;
        wait += more.wait;
        repeat += more.repeat;
        return *this;
    }
};

/// One object for each rank, on top of a transport. Its calls are made in the same order on all
/// ranks; only `leave` may be called at any time in place of another one.
class Ranks {
public:
    /// Refers to the transport, which has to outlive it.
    explicit Ranks(Transport& transport) : transport_(transport) {}

    /// The number of this rank: 0 to size() - 1.
    [[nodiscard]] std::uint32_t rank() const { return transport_.rank(); }
    /// How many ranks there are.
    [[nodiscard]] std::uint32_t size() const { return transport_.size(); }

    /// Begins the message of this rank for the next exchange.
    MessageWriter& begin();
    /// Gives the message to all ranks and returns those of all, to be read from where `begin` left
    /// off. If `failure` is set on any rank, `failed_with` has the first one afterwards, on all
    /// ranks. Throws it where that rank has left.
    std::span<MessageReader> exchange(std::exception_ptr failure = nullptr);
    /// The failure that the last exchange has told of, of the type that it had where it happened,
    /// or null. Types of an application arrive as std::runtime_error, with their text.
    [[nodiscard]] const std::exception_ptr& failed_with() const { return failure_; }

    /// Tells the others that this rank goes no further, in place of its next message: they throw
    /// the failure. Once a failure has been told, nothing happens.
    void leave(const std::exception_ptr& failure) noexcept;
    /// Whether a failure has been told since the last call of `start_over`.
    [[nodiscard]] bool has_failed() const { return has_failed_; }
    /// After a failure that all ranks have survived.
    void start_over() { has_failed_ = false; }

    /// Whether any of them wants it. An exchange of its own.
    [[nodiscard]] bool any(bool mine);
    /// Returns when all ranks have called it. Throws what one has left with.
    void wait_for_all();

    /// From now on each message says whether this flag is set.
    void stop_by(const std::atomic<bool>* flag) { stop_ = flag; }
    /// Whether it was set on any rank at the last exchange: the same answer on all of them.
    [[nodiscard]] bool is_to_stop() const { return is_to_stop_; }

    /// The bytes of all messages of all ranks so far.
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// How many exchanges there were.
    [[nodiscard]] std::uint64_t exchanges() const { return exchanges_; }
    /// Where the time of this rank has gone in what it shares with others.
    [[nodiscard]] const RankTimes& times() const { return times_; }
    /// To be called after a section by whoever runs it.
    void add(const RankTimes& times) { times_ += times; }

private:
    Transport& transport_;
    MessageWriter message_;
    std::vector<MessageReader> readers_;
    std::exception_ptr failure_;
    const std::atomic<bool>* stop_ = nullptr;
    bool has_failed_ = false;
    bool is_to_stop_ = false;
    std::uint64_t bytes_ = 0;
    std::uint64_t exchanges_ = 0;
    RankTimes times_;
};

} // namespace dsc

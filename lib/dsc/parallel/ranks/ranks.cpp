// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/ranks.h"

#include "dsc/parallel/ranks/told_error.h"

namespace dsc {

namespace {

// The first byte of each message.
constexpr std::byte flag_failed{1};
constexpr std::byte flag_left{2}; // failed, and nothing but the failure follows
constexpr std::byte flag_stop{4};

bool has(std::byte flags, std::byte flag) { return (flags & flag) != std::byte{0}; }

} // namespace

MessageWriter& Ranks::begin() {
    message_.clear();
    message_.raw(std::byte{0}, std::uint32_t{0}); // flags, and where a failure is written
    return message_;
}

std::span<MessageReader> Ranks::exchange(std::exception_ptr failure) {
    std::byte flags = message_.at(0);
    if (stop_ != nullptr && stop_->load()) {
        flags |= flag_stop;
    }
    if (failure) {
        flags |= flag_failed;
        const auto place = static_cast<std::uint32_t>(message_.bytes().size());
        std::memcpy(&message_.at(1), &place, sizeof place);
        write_error(message_, failure);
    }
    message_.at(0) = flags;

    const RankBytes all = transport_.all_gather(message_.bytes());
    ++exchanges_;
    readers_.clear();
    failure_ = nullptr;
    is_to_stop_ = false;
    bool has_left = false;
    for (std::uint32_t rank = 0; rank < all.size(); ++rank) {
        bytes_ += all[rank].size();
        MessageReader& reader = readers_.emplace_back(all[rank]);
        const auto theirs = reader.one<std::byte>();
        const auto place = reader.one<std::uint32_t>();
        is_to_stop_ = is_to_stop_ || has(theirs, flag_stop);
        has_left = has_left || has(theirs, flag_left);
        if (has(theirs, flag_failed) && !failure_) {
            failure_ = rank == this->rank() ? failure : read_error(all[rank].subspan(place));
        }
    }
    if (failure_) {
        has_failed_ = true;
        if (has_left) {
            std::rethrow_exception(failure_);
        }
    }
    return readers_;
}

void Ranks::leave(const std::exception_ptr& failure) noexcept {
    if (has_failed_ || size() == 1) {
        return;
    }
    try {
        begin();
        message_.at(0) = flag_left;
        (void)exchange(failure);
    } catch (...) { // NOLINT: what was told, or the others are gone: there is nobody left to tell
        has_failed_ = true;
    }
}

bool Ranks::any(bool mine) {
    begin().raw(mine);
    bool is_wanted = false;
    for (MessageReader& reader : exchange()) {
        is_wanted = reader.one<bool>() || is_wanted;
    }
    return is_wanted;
}

void Ranks::wait_for_all() {
    begin();
    (void)exchange();
}

} // namespace dsc

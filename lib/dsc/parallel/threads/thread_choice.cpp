// SPDX-License-Identifier: MIT
#include "dsc/parallel/threads/thread_choice.h"

namespace dsc {

namespace {

constexpr std::uint32_t steps_of_a_try = 4;
constexpr std::uint32_t min_pause = 16;
constexpr std::uint32_t max_pause = 2048;
/// While other programs run, a few steps take ten times as long as the others, so only a mean of
/// many is reliable.
constexpr std::uint32_t steps_of_a_mean = 32;
/// A single step has at most the weight of this many others in the mean.
constexpr double max_share_of_step = 4;
/// A try whose steps take longer than the previous ones by this factor ends at once.
constexpr double hopeless = 1.15;
/// Steps that take longer than at the last try by this factor cause another try.
constexpr double much_slower = 1.5;
/// The number of threads changes only if steps take less than this fraction of the time, so that
/// noise does not change it.
constexpr double worthwhile = 0.97;

} // namespace

// All threads at first; later fewer and more threads alternately, where both are possible.
ThreadChoice::Level ThreadChoice::next_try() {
    if (settled_ == 0) {
        return 0;
    }
    const bool can_be_more = home_ > 0;
    const bool can_be_fewer = home_ + 1 < levels && (max_ >> home_) > 1;
    was_fewer_ = can_be_fewer && (!can_be_more || !was_fewer_);
    return was_fewer_ ? home_ + 1 : home_ - 1;
}

void ThreadChoice::took(double seconds, double work, std::uint32_t useful) {
    if (!(work > 0) || max_ <= 1) {
        return;
    }
    if (useful <= 1) {
        *this = ThreadChoice(max_); // else noise would choose
        return;
    }
    if (warm_up_ > 0) {
        --warm_up_;
        return;
    }
    Mean& mean = means_[now_];
    double one = seconds / work;
    if (mean.steps > 0) {
        one = std::min(one, max_share_of_step * mean.value);
    }
    mean.steps = std::min(mean.steps + 1, steps_of_a_mean);
    mean.value += (one - mean.value) / mean.steps;

    if (tries_left_ > 0) {
        --tries_left_;
        const bool is_hopeless = mean.steps > 1 && mean.value > hopeless * means_[home_].value;
        if (tries_left_ == 0 || is_hopeless) {
            end_try();
        }
        return;
    }
    // If steps have become much slower, another program may be running.
    until_try_ = settled_ > 0 && mean.value > much_slower * settled_ ? 0 : until_try_ - 1;
    if (until_try_ == 0) {
        now_ = next_try();
        means_[now_] = {};
        warm_up_ = 1; // threads have to wake up
        tries_left_ = steps_of_a_try;
    }
}

void ThreadChoice::end_try() {
    tries_left_ = 0;
    if (means_[now_].value < worthwhile * means_[home_].value) {
        home_ = now_;
        pause_ = min_pause;
    } else {
        pause_ = std::min(4 * pause_, max_pause);
    }
    now_ = home_;
    until_try_ = pause_;
    settled_ = means_[home_].value;
}

} // namespace dsc

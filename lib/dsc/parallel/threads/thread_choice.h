// SPDX-License-Identifier: MIT
// Chooses the number of threads by measured times of steps, which is allowed because results do not
// depend on it. A second thread does not pay off for a short interface, or while another program
// occupies the second core.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace dsc {

/// Begins with one thread, then tries all allowed threads, and later sometimes half or twice as
/// many, for a few steps each. It keeps the number that takes less time for the same work. Tries
/// that change nothing become rarer, down to four steps in two thousand. O(1) for each step.
class ThreadChoice {
public:
    /// At most so many threads.
    explicit ThreadChoice(std::uint32_t max_threads)
        : max_(max_threads), home_(static_cast<Level>(std::bit_width(max_threads) - 1)),
          now_(home_) {}

    /// The threads for the next step.
    [[nodiscard]] std::uint32_t threads() const { return std::max(max_ >> now_, 1U); }
    /// Reports the time of that step, in seconds, and its work, always in the same unit. `useful`:
    /// the number of threads that had enough to do, whatever was chosen. With 1 there was no
    /// choice, and the next step that has a choice starts afresh.
    void took(double seconds, double work, std::uint32_t useful);

private:
    /// The number of halvings of the allowed threads; 0: all of them.
    using Level = std::size_t;
    static constexpr Level levels = 12;
    struct Mean {
        double value = 0;        ///< seconds for each unit of work
        std::uint32_t steps = 0; ///< number of steps in the mean; later ones have more weight
    };

    [[nodiscard]] Level next_try();
    void end_try();

    std::array<Mean, levels> means_{};
    std::uint32_t max_;
    Level home_;                   ///< what steps use
    Level now_;                    ///< level of the next step: another one during a try
    std::uint32_t warm_up_ = 2;    ///< steps that do not count
    std::uint32_t tries_left_ = 0; ///< steps of the present try
    std::uint32_t until_try_ = 2;  ///< steps
    std::uint32_t pause_ = 16;     ///< steps from the last try to the next one
    double settled_ = 0;           ///< the mean at the last try
    bool was_fewer_ = false;       ///< whether the last try was with fewer threads
};

} // namespace dsc

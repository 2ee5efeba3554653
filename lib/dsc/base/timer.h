// SPDX-License-Identifier: MIT
// A clock that can be switched off.
#pragma once

#include <chrono>
#include <utility>

namespace dsc {

/// Seconds from call to call. Switched off, it reads no clock and returns 0.
class Timer {
public:
    /// Starts, unless it is switched off.
    explicit Timer(bool on = true) : on_(on) {
        if (on_) {
            last_ = std::chrono::steady_clock::now();
        }
    }
    /// Seconds since the last call, or since construction.
    double lap() {
        if (!on_) {
            return 0;
        }
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    bool on_;
    std::chrono::steady_clock::time_point last_;
};

} // namespace dsc

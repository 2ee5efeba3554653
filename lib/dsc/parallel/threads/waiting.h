// SPDX-License-Identifier: MIT
// How a thread waits for another one that is about to be done.
#pragma once

#include <thread>

namespace dsc {

/// Tells the core that this is a loop that waits.
inline void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/// The turns of a loop that waits: brief pauses at first, since a task takes tens of microseconds;
/// then the core is given to any other thread that wants it.
class WaitingTurns {
public:
    void wait() {
        constexpr int turns_before_yield = 2000;
        if (turns_ < turns_before_yield) {
            ++turns_;
            pause_briefly();
        } else {
            std::this_thread::yield();
        }
    }
    void start_over() { turns_ = 0; }

private:
    int turns_ = 0;
};

} // namespace dsc

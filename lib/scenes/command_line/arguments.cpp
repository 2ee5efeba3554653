// SPDX-License-Identifier: MIT
#include "scenes/command_line/arguments.h"

#include <csignal>

namespace dsc::scenes {

std::atomic<bool> interrupted{false};

namespace {

// A second signal ends the program at once; but a terminal that closes often sends two SIGHUP.
void on_interrupt(int number) {
    interrupted.store(true);
    if (number != SIGHUP) {
        std::signal(number, SIG_DFL);
    }
}

} // namespace

// What is ignored, as under nohup, stays so.
void heed_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (std::signal(number, on_interrupt) == SIG_IGN) {
            std::signal(number, SIG_IGN);
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace dsc::scenes

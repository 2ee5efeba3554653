// SPDX-License-Identifier: MIT
#include "scenes/output/progress.h"

#include <iostream>
#include <utility>

namespace dsc::scenes {

Progress::Progress(bool enabled, std::string name, int steps)
    : enabled_(enabled), name_(std::move(name)), steps_(steps),
      next_(std::chrono::steady_clock::now() + std::chrono::milliseconds(500)) {}

Progress::~Progress() {
    if (enabled_) {
        std::cerr << "\r\033[K" << std::flush;
    }
}

void Progress::show(int step, std::uint64_t triangles) {
    if (!enabled_) {
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) {
        return;
    }
    next_ = now + std::chrono::milliseconds(100);
    std::cerr << "\r\033[K" << name_ << ": step " << step << " of " << steps_ << ", " << triangles
              << " triangles" << std::flush;
}

} // namespace dsc::scenes

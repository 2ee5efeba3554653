// SPDX-License-Identifier: MIT
#include "scenes/output/progress.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr double first_after_s = 2; // shorter runs need no line
constexpr double shortest_wait_s = 0.1;
constexpr const char* clear_line = "\r\033[K";

std::string hours_and_minutes(double seconds) {
    const auto whole = static_cast<long long>(std::clamp(seconds, 0.0, 3.6e8) + 0.5);
    char text[40];
    if (whole >= 3600) {
        std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    } else {
        std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
    }
    return text;
}

} // namespace

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

Progress::Progress(std::ostream* out, std::string name, int begin, int steps, Clock clock)
    : out_(out), clock_(std::move(clock)), name_(std::move(name)), begin_(begin), steps_(steps),
      started_(clock_()), next_(started_ + first_after_s) {}

Progress::~Progress() {
    if (is_shown_) {
        *out_ << clear_line << std::flush;
    }
}

void Progress::show(int step, std::uint64_t triangles) {
    if (out_ == nullptr) {
        return;
    }
    const double now = clock_();
    if (now < next_) {
        return;
    }
    next_ = now + shortest_wait_s;
    const double per_step = (now - started_) / std::max(step - begin_, 1);
    *out_ << clear_line << name_ << ": step " << step << " of " << steps_ << ", "
          << hours_and_minutes(per_step * (steps_ - step)) << " left, " << triangles << " triangles"
          << std::flush;
    is_shown_ = true;
}

} // namespace dsc::scenes

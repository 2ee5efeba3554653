// SPDX-License-Identifier: MIT
#include "scenes/output/progress.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

namespace dsc::scenes {

namespace {

constexpr double first_after_s = 2; // shorter runs need no line
constexpr double shortest_wait_s = 0.1;
constexpr double wait_per_look = 20; // times as long as it took to find the worst angle
constexpr const char* clear_line = "\r\033[K";

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

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

std::string progress_line(const std::string& name, int step, int steps, double seconds_left,
                          std::uint64_t triangles, double worst_angle_deg) {
    char angle[32];
    std::snprintf(angle, sizeof angle, "%.1f", worst_angle_deg);
    return name + ": step " + std::to_string(step) + " of " + std::to_string(steps) + ", " +
           hours_and_minutes(seconds_left) + " left, " + std::to_string(triangles) +
           " triangles, worst angle " + angle + " degrees";
}

Progress::Progress(std::ostream& out, Clock clock, std::string name, int begin, int steps)
    : out_(&out), clock_(std::move(clock)), name_(std::move(name)), begin_(begin), steps_(steps),
      started_(clock_()), next_(started_ + first_after_s) {}

Progress::Progress(bool enabled, std::string name, int begin, int steps)
    : Progress(std::cerr, steady_seconds, std::move(name), begin, steps) {
    if (!enabled) {
        out_ = nullptr;
    }
}

Progress::~Progress() {
    if (is_shown_) {
        *out_ << clear_line << std::flush;
    }
}

void Progress::show(int step, std::uint64_t triangles, const std::function<double()>& worst_angle) {
    if (out_ == nullptr || clock_() < next_) {
        return;
    }
    const double before = clock_();
    const double angle = worst_angle();
    const double now = clock_();
    next_ = now + std::max(shortest_wait_s, wait_per_look * (now - before));
    const double per_step = (now - started_) / std::max(step - begin_, 1);
    *out_ << clear_line
          << progress_line(name_, step, steps_, per_step * (steps_ - step), triangles, angle)
          << std::flush;
    is_shown_ = true;
}

} // namespace dsc::scenes

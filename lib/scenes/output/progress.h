// SPDX-License-Identifier: MIT
// A progress line on stderr for runs longer than two seconds; none if stderr is not a terminal.
#pragma once

#include "scenes/run/clock.h"

#include <cstdint>
#include <iostream>
#include <string>

namespace dsc::scenes {

class Progress {
public:
    /// `begin`: the step after which the run begins, 0 unless it is resumed.
    Progress(bool is_watched, int begin, int steps)
        : is_watched_(is_watched), begin_(begin), steps_(steps) {}
    /// Removes the line.
    ~Progress() {
        if (is_shown_) {
            std::cerr << clear_line << std::flush;
        }
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// "swirl: step 120 of 520, 14 s left, 3612 triangles", at most ten times a second.
    void show(const std::string& scene, int step, std::uint64_t cells,
              const char* kind = "triangles") {
        const double now = watch_.wall();
        if (!is_watched_ || now < next_) {
            return;
        }
        next_ = now + 0.1;
        is_shown_ = true;
        const double left = now / (step - begin_) * (steps_ - step);
        std::cerr << clear_line << scene << ": step " << step << " of " << steps_ << ", "
                  << static_cast<std::int64_t>(left + 0.5) << " s left, " << cells << ' ' << kind
                  << std::flush;
    }

private:
    static constexpr const char* clear_line = "\r\033[K";

    bool is_watched_;
    int begin_;
    int steps_;
    Stopwatch watch_;
    double next_ = 2;
    bool is_shown_ = false;
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// A progress line on stderr, for runs that take longer than two seconds; nothing at all if nobody
// is watching.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace dsc::scenes {

/// Seconds that have passed since some moment.
[[nodiscard]] double steady_seconds();

class Progress {
public:
    using Clock = std::function<double()>; ///< seconds, from any beginning

    /// `out`: null where nobody is watching; `begin`: the step after which the run begins, 0 unless
    /// it goes on from a checkpoint.
    Progress(std::ostream* out, std::string name, int begin, int steps,
             Clock clock = steady_seconds);
    /// Removes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// "swirl: step 120 of 520, 0:14 left, 3612 triangles", at most ten times a second.
    void show(int step, std::uint64_t triangles);

private:
    std::ostream* out_;
    Clock clock_;
    std::string name_;
    int begin_;
    int steps_;
    double started_;
    double next_;
    bool is_shown_ = false;
};

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// A progress line on stderr, for runs that take longer than two seconds; nothing at all if nobody
// is watching.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace dsc::scenes {

/// "swirl: step 120 of 520, 0:14 left, 3612 triangles, worst angle 24.1 degrees".
[[nodiscard]] std::string progress_line(const std::string& name, int step, int steps,
                                        double seconds_left, std::uint64_t triangles,
                                        double worst_angle_deg);

class Progress {
public:
    using Clock = std::function<double()>; ///< seconds, from any beginning

    /// `begin`: the step after which the run begins, 0 unless it goes on from a checkpoint.
    Progress(bool enabled, std::string name, int begin, int steps);
    /// For tests: another stream, another clock.
    Progress(std::ostream& out, Clock clock, std::string name, int begin, int steps);
    /// Removes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// At most ten times a second, and so that `worst_angle`, which looks at the whole mesh, takes
    /// no more than a twentieth of the time.
    void show(int step, std::uint64_t triangles, const std::function<double()>& worst_angle);

private:
    std::ostream* out_ = nullptr; ///< null: nobody is watching
    Clock clock_;
    std::string name_;
    int begin_;
    int steps_;
    double started_;
    double next_;
    bool is_shown_ = false;
};

} // namespace dsc::scenes

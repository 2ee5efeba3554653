// SPDX-License-Identifier: MIT
// A progress line on stderr; nothing at all if nobody is watching.
#pragma once

#include <chrono>
#include <string>

namespace dsc::scenes {

class Progress {
public:
    Progress(bool enabled, std::string name, int steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// At most ten times a second.
    void show(int step, std::uint64_t triangles);

private:
    bool enabled_;
    std::string name_;
    int steps_;
    std::chrono::steady_clock::time_point next_;
};

} // namespace dsc::scenes

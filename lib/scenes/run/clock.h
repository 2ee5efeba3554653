// SPDX-License-Identifier: MIT
// Wall time, CPU time of all threads, and peak memory of this process.
#pragma once

namespace dsc::scenes {

/// Starts at construction.
class Stopwatch {
public:
    Stopwatch();
    [[nodiscard]] double wall() const; ///< seconds
    [[nodiscard]] double cpu() const;  ///< seconds, all threads

private:
    double wall_begin_;
    double cpu_begin_;
};

/// In 10^6 bytes.
[[nodiscard]] double peak_memory_mb();

} // namespace dsc::scenes

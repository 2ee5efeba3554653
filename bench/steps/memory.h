// SPDX-License-Identifier: MIT
// The peak memory of a part of a run, rather than of the process since its start.
#pragma once

namespace dsc::bench {

/// Starts measuring: gives freed memory back to the system, and resets the peak if the kernel
/// allows it.
class PeakMemory {
public:
    PeakMemory();
    /// The peak of resident memory since construction, in 10^6 bytes. If the peak cannot be reset,
    /// the larger of the resident memory now and at construction. 0 without /proc.
    [[nodiscard]] double mb() const;

private:
    bool reset_;
    double first_mb_;
};

} // namespace dsc::bench

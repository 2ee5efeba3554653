// SPDX-License-Identifier: MIT
// The most memory that a part of a run needed, rather than the whole process since its start.
#pragma once

namespace dsc::bench {

/// Starts measuring: gives freed memory back to the system, and resets the peak if the kernel
/// allows it.
class PeakMemory {
public:
    PeakMemory();
    /// The most resident memory since then, in 10^6 bytes. If the peak cannot be reset, the larger
    /// of the resident memory now and at the start. 0 if there is no /proc.
    [[nodiscard]] double mb() const;

private:
    bool reset_;
    double first_mb_;
};

} // namespace dsc::bench

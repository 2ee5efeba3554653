// SPDX-License-Identifier: MIT
// The most memory that a part of a run needed, rather than the whole process since its start.
#pragma once

namespace dsc::bench {

/// Starts measuring: gives freed memory back, and forgets the peak where the kernel lets us.
class PeakMemory {
public:
    PeakMemory();
    /// The most resident memory since then, in 10^6 bytes. Where the peak cannot be reset, the
    /// larger of what is resident now and was at the start. 0 where there is no /proc.
    [[nodiscard]] double mb() const;

private:
    bool reset_;
    double first_mb_;
};

} // namespace dsc::bench

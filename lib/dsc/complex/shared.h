// SPDX-License-Identifier: MIT
// Coordinates of a vertex that another submesh may be moving at this moment: such a vertex always
// fails the test of ownership, so the order of reads and writes does not matter, but none may tear.
#pragma once

#include <atomic>

namespace dsc {

/// Reads without tearing; any value that was there at some moment.
template <class Real>
Real read_shared(const Real& value) {
    return std::atomic_ref<Real>(const_cast<Real&>(value)).load(std::memory_order_relaxed);
}
/// Writes without tearing.
template <class Real>
void write_shared(Real& value, Real next) {
    std::atomic_ref<Real>(value).store(next, std::memory_order_relaxed);
}

} // namespace dsc

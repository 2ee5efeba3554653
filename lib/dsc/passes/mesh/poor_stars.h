// SPDX-License-Identifier: MIT
// Stars listed for `watch_quality`: called after the last edit of a star in a pass. If one of its
// triangles changes later, another vertex of the triangle is listed.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Not inlined: few stars are listed, and the code would crowd the loops that call it.
template <class Real>
[[gnu::noinline]] void list_poor(Work<Real>& work, std::uint32_t v) {
    work.poor.push_back(v);
}

/// `quality`: squared, the worst of the triangles. O(1).
template <class Real>
void list_if_poor(Work<Real>& work, std::uint32_t v, Real quality) {
    if (static_cast<double>(quality) <= work.watched_quality) [[unlikely]] {
        list_poor(work, v);
    }
}

/// A star whose quality is not known.
template <class Real>
void list_unexamined(Work<Real>& work, std::uint32_t v) {
    list_if_poor(work, v, Real(0));
}

} // namespace dsc

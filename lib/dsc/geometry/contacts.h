// SPDX-License-Identifier: MIT
// Finds out whether straight lines meet anywhere but at common ends: one sweep over all lines, in
// O(n log n) and with exact signs (M. I. Shamos, D. Hoey, "Geometric intersection problems", 1976).
#pragma once

#include "dsc/base/types.h"

#include <optional>
#include <span>

namespace dsc {

/// A straight line, given by the numbers of its ends, which lie at different points. Lines that
/// share a number may meet there; coincident points with different numbers are a contact.
struct NetworkLine {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

/// Two lines in contact, the smaller number first.
struct LineContact {
    std::uint32_t line = 0;
    std::uint32_t other = 0;

    friend bool operator==(const LineContact&, const LineContact&) = default;
};

/// One of the contacts; empty if there is none. All coordinates must be finite.
std::optional<LineContact> find_contact(std::span<const Point<double>> points,
                                        std::span<const NetworkLine> lines);

} // namespace dsc

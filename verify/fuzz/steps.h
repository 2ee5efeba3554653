// SPDX-License-Identifier: MIT
// The target of random scenes, and counts that show whether a scene tests enough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dsc::fuzz {

struct Steps {
    std::uint64_t edits = 0;
    std::size_t submeshes = 0; ///< largest number of the first colour
    std::uint32_t threads = 0; ///< largest number used
};

/// Throws a Finding (target.h) if a guarantee is broken.
Steps try_steps(std::span<const std::uint8_t> bytes);

} // namespace dsc::fuzz

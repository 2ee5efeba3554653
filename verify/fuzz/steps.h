// SPDX-License-Identifier: MIT
// The target of random scenes, and what tells whether much has happened in one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dsc::fuzz {

struct Steps {
    std::uint64_t edits = 0;
    std::size_t submeshes = 0; ///< of the first colour, at most
    std::uint32_t threads = 0; ///< used, at most
};

/// Throws a Finding (target.h) where a promise is not kept.
Steps try_steps(std::span<const std::uint8_t> bytes);

} // namespace dsc::fuzz

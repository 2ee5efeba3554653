// SPDX-License-Identifier: MIT
// What has changed in a list of ids that both sides have, so that a message is as long as the
// change and not as long as the list.
#pragma once

#include "dsc/parallel/ranks/message.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// Writes how `after` is made of `before`: runs that stay, entries that go, entries that come.
/// O(list) and O(1) for each of a few changes next to each other.
void write_difference(MessageWriter& message, std::span<const std::uint32_t> before,
                      std::span<const std::uint32_t> after);

/// Makes the list that was `before` the one that was `after`. Throws InvariantError if it was
/// another.
void read_difference(MessageReader& message, std::vector<std::uint32_t>& list);

} // namespace dsc

// SPDX-License-Identifier: MIT
// The values of vertices, of all attributes: what passes have written there is not in the log of
// edits.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/parallel/ranks/message.h"

#include <cstdint>
#include <vector>

namespace dsc {

/// Appends the values of all attributes of vertices at these. Throws InputError for an attribute
/// whose class cannot be archived.
void write_values(MessageWriter& message, const AttributeSet& attributes,
                  const std::vector<std::uint32_t>& vertices);

/// Takes over the values that were written. Throws InvariantError if the attributes are others.
void read_values(MessageReader& message, AttributeSet& attributes);

} // namespace dsc

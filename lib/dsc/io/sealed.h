// SPDX-License-Identifier: MIT
// The bytes of a sealed file (part_file.h), for what is kept elsewhere: in a pickle, a database, a
// message.
#pragma once

#include "dsc/io/part_file.h"

namespace dsc {

/// The bytes with the header of a sealed file in front. O(bytes). Throws InputError if `kind.name`
/// has not 1 to 8 bytes.
[[nodiscard]] std::string sealed(const SealedKind& kind, const std::string& bytes);

/// What was sealed. `name` is what errors call it. O(bytes). Throws FileError if it is of another
/// kind or version, is too short or too long, or its bytes have changed.
[[nodiscard]] std::string unsealed(std::string bytes, const SealedKind& kind,
                                   const std::string& name);

} // namespace dsc

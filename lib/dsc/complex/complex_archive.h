// SPDX-License-Identifier: MIT
// A complex as bytes, exactly as it is: ids, free ids in their order, flags, the entries of the
// attributes, and the edits that nobody has read yet.
#pragma once

#include "dsc/complex/complex.h"

#include <span>

namespace dsc {

/// Writes a complex, or reads it back into one that has the same attributes; what was there before
/// is gone. Throws FileError for one of the other scalar type, or with other attributes. Whether
/// what was read is a complex is for `validate` to say. O(n).
template <class Real>
void archive(Archive& archive, Complex<Real>& complex);

void archive(Archive& archive, Edit& edit);
void archive(Archive& archive, OperationCounts& counts);
void archive(Archive& archive, IdPool& pool);

/// Refuses a list with an id that no vertex of the complex has, dead or alive. O(list).
template <class Real>
void expect_vertices(const Archive& archive, const Complex<Real>& complex,
                     std::span<const std::uint32_t> list);

} // namespace dsc

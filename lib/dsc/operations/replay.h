// SPDX-License-Identifier: MIT
// Replays a log of edits on the complex that it began with: the result is the same mesh, bit for
// bit.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/submesh.h"

#include <cstdint>
#include <functional>
#include <span>

namespace dsc {

/// What became of the records.
struct ReplayReport {
    std::uint64_t done = 0;    ///< records that were repeated
    std::uint64_t skipped = 0; ///< records that name simplices that do not exist
};

/// Repeats a record of an operation that the core does not have: a `retriangulate`, an
/// `insert_triangle` or a `remove_triangle`. Returns false, and changes nothing, if its simplices
/// do not exist. The pool and the log are not read afterwards; the next triangle that the complex
/// gives out is the one that an `insert_triangle` names.
template <class Real>
using RepeatEdit = std::function<bool(const Submesh<Real>& submesh, const Edit& edit)>;

/// Repeats the edits without testing whether they are legal: the same simplices with the same ids,
/// so that handles in later records mean what they meant. A record whose simplices do not exist, or
/// differ from what the record says, is skipped; in an unbroken log none is. Vertex attributes are
/// blended as in the run. Whatever reads the journal learns of one `rebuild`. O(edits); O(mesh) for
/// each `renumber`, and once at the end for the pool of free ids. Throws InputError, and does
/// nothing, if a log has a `rebuild`, because it does not contain how the other mesh came about, or
/// a record that `others` would have to repeat, and there is none.
template <class Real>
ReplayReport replay(Complex<Real>& complex, std::span<const Edit> edits,
                    const RepeatEdit<Real>& others = {});

} // namespace dsc

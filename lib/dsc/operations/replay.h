// SPDX-License-Identifier: MIT
// A log of edits played again on the complex that it began with: the same mesh to the bit. A run
// that failed is kept as its first complex and its log, and cut down by leaving out records.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dsc {

struct ReplayReport {
    std::uint64_t done = 0;
    std::uint64_t skipped = 0; ///< records that name simplices that are not there
};

/// Does the edits again, without asking whether they are legal: the same simplices with the same
/// ids, so that handles in later records mean what they meant. A record whose simplices are not
/// there, or are others than the record says, is skipped; of an unbroken log none is. Vertex
/// attributes are blended as in the run; nothing is noted in the journal. O(edits); O(mesh) for
/// each `renumber`, and once at the end for the pool of free ids. Throws InputError where a log has
/// a `rebuild`: what create and merge did is not in it.
template <class Real>
ReplayReport replay(Complex<Real>& complex, std::span<const Edit> edits);

/// Leaves out records for as long as `fails(first complex with the rest replayed)` stays true, in
/// ever smaller pieces (A. Zeller, R. Hildebrandt, "Simplifying and isolating failure-inducing
/// input", 2002). Returns the records that are left: all of them where `fails` is false to begin
/// with. O(edits^2) replays at worst, O(edits log edits) as a rule.
template <class Real>
[[nodiscard]] std::vector<Edit>
cut_down(const Complex<Real>& first, std::vector<Edit> edits,
         const std::function<bool(const Complex<Real>& replayed)>& fails);

} // namespace dsc

// SPDX-License-Identifier: MIT
// Readers of the log of edits: what has to be looked at again, and which vertices are on the
// interface now. The default passes do this as they go; the readers do it for the passes of an
// application, and for what an application does to the mesh between two steps.
#pragma once

#include "dsc/passes/algorithm.h"

#include <span>
#include <vector>

namespace dsc {

/// The edits after the last one that gave everything new ids: those before it name vertices that
/// are others now. The whole span where there is none.
[[nodiscard]] std::span<const Edit> edits_after_renumbering(std::span<const Edit> edits);

/// Puts the vertices whose stars the edits changed into the active set, in the order of the edits.
/// O(edits), with the degree of the vertices that moved or took a star.
template <class Real>
void wake(Work<Real>& work, std::span<const Edit> edits);

/// The vertices that the edits may have put on the interface, or taken off it; ascending, once
/// each. Empty for most edits: those of the inside of a phase. O(edits log edits).
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> interface_changes(const Complex<Real>& complex,
                                                           std::span<const Edit> edits);

/// Takes those of `changed` (ascending) off the list. O(list log changed).
void take_off(std::vector<std::uint32_t>& list, std::span<const std::uint32_t> changed);

/// Those of `changed` that are on the interface now. O(their degrees).
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> on_interface(const Complex<Real>& complex,
                                                      std::span<const std::uint32_t> changed);

/// Runs a pass, and reads its log unless the pass attends to its own edits: `wake`, and the changes
/// of the interface, which are made in `work.interface` and noted in `work.changed_interface` for
/// lists elsewhere.
template <class Real>
void run_pass(Work<Real>& work, const Pass<Real>& pass);

} // namespace dsc

// SPDX-License-Identifier: MIT
// Readers of the log of edits: they find the vertices that must be visited again, and those now on
// the interface. The default passes do this themselves; the readers do it for passes of an
// application, and for its edits between two steps.
#pragma once

#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <span>
#include <vector>

namespace dsc {

/// The edits after the last one that gave everything new ids: earlier edits use ids that now mean
/// other vertices. The whole span if there is none.
[[nodiscard]] std::span<const Edit> edits_after_renumbering(std::span<const Edit> edits);

/// Puts the vertices whose stars the edits changed into the active set, in the order of the edits.
/// O(edits), plus the degrees of the vertices that moved or took over a star.
template <class Real>
void wake(Work<Real>& work, std::span<const Edit> edits);

/// The vertices that the edits removed, whose ids may be in use again, or moved: the targets that
/// they had are void. In the order of the edits. O(edits).
[[nodiscard]] std::vector<std::uint32_t> without_target(std::span<const Edit> edits);

/// The vertices that the edits may have put on the interface, or taken off it; ascending, once
/// each. Empty for most edits, which are inside a phase. O(edits log edits).
[[nodiscard]] std::vector<std::uint32_t> interface_changes(std::span<const Edit> edits);
/// Writes the same to `changed`, whose entries are replaced and whose memory is reused.
void find_interface_changes(std::span<const Edit> edits, std::vector<std::uint32_t>& changed);

/// Removes the vertices in `changed` (ascending) from the list. O(list log changed).
void take_off(std::vector<std::uint32_t>& list, std::span<const std::uint32_t> changed);

/// Whether a vertex lives, in a triangle, and is on the interface. O(degree).
template <class Real>
[[nodiscard]] bool is_on_interface(const Complex<Real>& complex, std::uint32_t vertex);

/// The vertices of `changed` that are on the interface now. O(their degrees).
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> on_interface(const Complex<Real>& complex,
                                                      std::span<const std::uint32_t> changed);

/// Runs a pass, and reads its log unless the pass attends to its own edits: calls `wake`, and
/// applies the changes of the interface to `work.interface`, noting them in
/// `work.changed_interface` for lists kept elsewhere. With advected phases, the list is updated
/// after every pass: any pass may add or remove vertices inside.
template <class Real>
void run_pass(Work<Real>& work, const Pass<Real>& pass);

} // namespace dsc

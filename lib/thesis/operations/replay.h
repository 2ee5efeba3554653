// SPDX-License-Identifier: MIT
// Replay of a log that contains operations of this module: `replay<double>(complex, edits,
// repeat_edit<double>)`.
#pragma once

#include "replay/replay.h"

namespace dsc {

/// Repeats a local retriangulation, an insertion or a removal; see `RepeatEdit`.
template <class Real>
bool repeat_edit(const Submesh<Real>& submesh, const Edit& edit);

} // namespace dsc

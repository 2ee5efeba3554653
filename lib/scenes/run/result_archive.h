// SPDX-License-Identifier: MIT
// The sums and figures of a run so far, as bytes. What is measured at the end is not part of it.
#pragma once

#include "dsc/base/archive.h"
#include "scenes/run/run.h"
#include "scenes/run/standard_archive.h"

namespace dsc {

void archive(Archive& archive, Event& event);
void archive(Archive& archive, AreaAccount& account);

} // namespace dsc

namespace dsc::scenes {

void archive(Archive& archive, Figure& figure);
void archive(Archive& archive, SeriesRow& row);
void archive(Archive& archive, RunResult& result);

/// The scene, its parameters and the division, as a text that differs for runs that could not
/// continue each other.
[[nodiscard]] std::string identity_of(const RunResult& result, const Submeshing& submeshing);

} // namespace dsc::scenes

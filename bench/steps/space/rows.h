// SPDX-License-Identifier: MIT
// The rows of a case whose scene is in three dimensions.
#pragma once

#include "steps/rows.h"

#include "scenes/space/scene_file.h"

#include <optional>
#include <string>

namespace dsc::bench {

/// The scene of the catalogue, or of a file, if it is in three dimensions.
[[nodiscard]] std::optional<scenes::space::SceneFile>
find_in_space(const scenes::CaseReader& reader, const std::string& scene);

/// Adds a row for each size, strategy and number of threads. Throws InputError for keys and
/// strategies that are not available in three dimensions.
void add_rows_in_space(const SuiteCase& c, const scenes::space::SceneFile& file,
                       const std::string& name, Suite& suite);

} // namespace dsc::bench

// SPDX-License-Identifier: MIT
// The rows of a case: one for each of its scenes, sizes, strategies and numbers of threads.
#pragma once

#include "steps/suite.h"

#include "scenes/file/case_reader.h"

#include <string>
#include <vector>

namespace dsc::bench {

/// The keys of a [[case]] that do not depend on its scenes.
struct SuiteCase {
    const scenes::CaseReader* reader = nullptr; ///< must outlive this
    std::vector<std::string> scenes{};
    std::vector<std::string> names{}; ///< one for each scene; empty: the scene's own name
    Measure measure = Measure::run;
    std::vector<scenes::CaseSize> sizes{};
    std::vector<scenes::Strategy> strategies{};
    std::vector<std::uint32_t> threads{};
    std::vector<int> between_us{};
};

/// Prepares the scenes without making their meshes, and adds their rows or comparisons to the
/// suite. Throws InputError for keys that are not allowed for a scene.
void add_rows(const SuiteCase& c, Suite& suite);

} // namespace dsc::bench

// SPDX-License-Identifier: MIT
// The origin of a result, which every result file states.
#pragma once

#include <string>

namespace dsc::scenes {

/// "CPU model, N cores".
[[nodiscard]] std::string machine();
/// The compiler that built the library, with its version.
[[nodiscard]] std::string compiler();
/// The commit that was checked out when the build was configured, with "+" if it had changes;
/// "unknown" outside a repository.
[[nodiscard]] std::string commit();

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// Processes that a launcher of MPI (mpirun, srun) has started. By the environment alone: a program
// that was started by itself has nothing to do with MPI.
#pragma once

#include <string>

namespace dsc::scenes {

/// Whether a launcher has started this process.
[[nodiscard]] bool is_launched();

/// Goes on as the program of that name in the same folder, with the same arguments. Returns if
/// there is none.
void become(const std::string& name, char** arguments);

/// Whether the launcher has started no other process. If it has, the first one says on stderr that
/// `program` was built without MPI, so that they would all do the same.
[[nodiscard]] bool is_alone(const std::string& program);

} // namespace dsc::scenes

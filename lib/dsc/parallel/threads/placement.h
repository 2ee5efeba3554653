// SPDX-License-Identifier: MIT
// Where threads run. A thread that has just been started is often on the core of the one that
// started it, and stays there for milliseconds, while another core is idle.
#pragma once

#include <vector>

namespace dsc {

/// The core that the calling thread is on at this moment; -1 where the system does not tell.
[[nodiscard]] int current_core();

/// Moves the calling thread off this core: to the `number`th of the others that it is allowed to
/// use, counted in circles. Later the system may move it again, as any thread. Without another
/// core, or where the system does not know how, nothing happens.
void leave_core(int core, unsigned number);

/// The cores of all places of OpenMP, if it binds threads to places (`OMP_PROC_BIND`): the caller
/// may then be confined to one of them, and a thread that it starts would be too. Empty if not.
[[nodiscard]] std::vector<int> cores_of_openmp();

/// Allows the calling thread these cores. Nothing happens if there are none, or where the system
/// does not know how.
void use_cores(const std::vector<int>& cores);

} // namespace dsc

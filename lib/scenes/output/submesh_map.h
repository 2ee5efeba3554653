// SPDX-License-Identifier: MIT
// The submeshes in force, as a file next to a frame: to be drawn on the mesh.
#pragma once

#include "dsc/parallel/in_place/submesh_executor.h"

#include <string>

namespace dsc::scenes {

/// {"colours": [{"regions": [{kind, normal, low, high, side_low, side_high, work_us}]}]} as in
/// `Region`; null: infinite. `work_us`: of the last step. Throws FileError.
template <class Real>
void write_submesh_map(const SubmeshExecutor<Real>& executor, const std::string& path);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// The current submeshes as a file beside a frame, to be drawn on the mesh.
#pragma once

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"

#include <string>

namespace dsc::scenes {

/// {"colours": [{"regions": [{kind, normal, low, high, side_low, side_high, work_us}]}]} as in
/// `Region`; null: infinite. `work_us`: of the last step. Throws FileError.
void write_submesh_map(const SubmeshView& submeshes, const std::string& path);

} // namespace dsc::scenes

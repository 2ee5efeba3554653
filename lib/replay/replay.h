// SPDX-License-Identifier: MIT
// Records of a run: logs of edits, files with a checksum, and a mesh's fingerprint; in reading
// order.
#pragma once

#include "replay/mesh_hash.h"

#include "replay/edits.h"
#include "replay/sealed_file.h"

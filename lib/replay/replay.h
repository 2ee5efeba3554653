// SPDX-License-Identifier: MIT
// What outlives a run: logs of edits, files that tell whether they are whole, and a mesh's
// fingerprint; in reading order.
#pragma once

#include "replay/mesh_hash.h"

#include "replay/edits.h"
#include "replay/sealed_file.h"

// SPDX-License-Identifier: MIT
// The mesh of a frame, written by several processes at the same time.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/io/vtu.h"
#include "dsc/parallel/ranks/ranks.h"

#include <span>
#include <string>

namespace dsc::scenes {

/// Each rank writes a share of the triangles, of the same size for all, to a file beside `path`,
/// which ends in .pvtu; when all of these are there, the first rank writes the list of them to
/// `path`. Called by all ranks. An error of one of them, such as a full disk, is thrown on all:
/// then there is no list. Throws FileError.
template <class Real>
void write_in_pieces(const std::string& path, const Complex<Real>& complex,
                     std::span<const VtuArray> more, Ranks& ranks);

} // namespace dsc::scenes

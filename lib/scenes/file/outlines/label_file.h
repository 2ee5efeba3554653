// SPDX-License-Identifier: MIT
// Files of label images: .npy of whole numbers in rows and columns (numpy.save), .pgm (Netpbm,
// plain or raw), and texts with a row of numbers in each line, with blanks or commas between them
// and comments after #.
#pragma once

#include "dsc/initial/label_image.h"

#include <string>

namespace dsc::scenes {

/// The image in the content of a file, whose name is for messages; the kind of file is told by how
/// the content begins. Throws InputError for anything else, and for numbers that are no phases.
[[nodiscard]] LabelImage read_labels(const std::string& content, const std::string& where);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// Files of label images: .npy with a two-dimensional array of whole numbers (numpy.save), .pgm
// (Netpbm, plain or raw), and texts with a row of numbers in each line, separated by blanks or
// commas, with comments after #.
#pragma once

#include "dsc/initial/label_image.h"

#include <string>

namespace dsc::scenes {

/// The image in the content of a file; `where` is its name in errors. The beginning of the content
/// determines the format. Throws InputError for any other format, and for numbers that are not
/// phases.
[[nodiscard]] LabelImage read_labels(const std::string& content, const std::string& where);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// A frame as a picture: the colouring of triangles, and the lines drawn on them.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "dsc/complex/complex.h"

#include <set>
#include <string>

namespace dsc::scenes {

enum class Layer : std::uint8_t {
    phases,  ///< colours triangles; excludes `quality`
    quality, ///< equation 4 of the thesis, from 0 (dark) to 1 (bright)
    edges,
    interface,
};

inline constexpr std::array layer_names{
    Named{Layer::phases, "phases"},
    Named{Layer::quality, "quality"},
    Named{Layer::edges, "edges"},
    Named{Layer::interface, "interface"},
};

using Layers = std::set<Layer>;

/// Parses a list such as "quality,interface". Throws InputError for an unknown name, or two layers
/// that colour triangles.
[[nodiscard]] Layers parse_layers(const std::string& names);

/// Writes the picture; triangles are coloured by phase unless a layer says otherwise. O(n). Throws
/// FileError.
template <class Real>
void write_picture(const Complex<Real>& complex, const Layers& layers, const std::string& title,
                   const std::string& path);

} // namespace dsc::scenes

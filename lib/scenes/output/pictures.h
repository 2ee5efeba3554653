// SPDX-License-Identifier: MIT
// A frame as a picture: what the triangles are coloured by, and what is drawn on them.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"
#include "dsc/io/pictures.h"
#include "topology/events.h"

#include <set>
#include <span>
#include <string>

namespace dsc::scenes {

enum class Layer : std::uint8_t {
    phases,    ///< this one and the next three colour the triangles: one of them
    quality,   ///< equation 4 of the thesis, from 0 (dark) to 1 (bright)
    targets,   ///< the target length of edges, from the shortest (dark) to the longest
    submeshes, ///< those of the first colour; grey where triangles straddle two
    edges,
    interface,
    events, ///< rings around changes of topology since the frame before
};

inline constexpr std::array layer_names{
    Named{Layer::phases, "phases"},   Named{Layer::quality, "quality"},
    Named{Layer::targets, "targets"}, Named{Layer::submeshes, "submeshes"},
    Named{Layer::edges, "edges"},     Named{Layer::interface, "interface"},
    Named{Layer::events, "events"},
};

/// From dark blue at `low` and below to yellow at `high` and above, in 32 steps of equal lightness
/// (the map viridis, readable by the colour-blind and in grey). NaN is grey. Throws InputError
/// unless low < high, both finite.
[[nodiscard]] SvgFill fill_by_value(std::string name, std::span<const double> values, double low,
                                    double high);

/// A colour for each number, the palette again and again; negative numbers are grey.
[[nodiscard]] SvgFill fill_by_number(std::string name, std::span<const std::int32_t> numbers);

using Layers = std::set<Layer>;

/// "quality,interface". Throws InputError for a name that is none, or two that colour triangles.
[[nodiscard]] Layers parse_layers(const std::string& names);

/// Writes the picture. `arrays`: those of `frame_arrays`; without them there are neither targets
/// nor submeshes, and triangles are coloured by phase. O(n). Throws FileError.
template <class Real>
void write_picture(const Complex<Real>& complex, const Layers& layers,
                   std::span<const VtuArray> arrays, std::span<const Event> events,
                   const std::string& title, const std::string& path);

} // namespace dsc::scenes

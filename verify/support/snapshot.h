// SPDX-License-Identifier: MIT
// All bytes of a complex, to check that nothing changed; and its triangles as positions, to compare
// two meshes with different numbering.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/ranges.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace dsc::test {

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(std::to_string(values.size())).append(":");
    if (!values.empty()) {
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
}

/// Records, free ids and the attributes of type double. None of these has padding.
template <class Real>
std::string snapshot(const Complex<Real>& complex) {
    std::string bytes;
    append_bytes(bytes, complex.vertices);
    append_bytes(bytes, complex.triangles);
    append_bytes(bytes, complex.ids.vertices);
    append_bytes(bytes, complex.ids.triangles);
    for (const auto& attribute : complex.attributes.list()) {
        const auto append = [&](const auto* typed) {
            if (typed != nullptr) {
                append_bytes(bytes, typed->data());
            }
        };
        append(dynamic_cast<const VertexAttribute<double>*>(attribute.get()));
        append(dynamic_cast<const EdgeAttribute<double>*>(attribute.get()));
        append(dynamic_cast<const TriangleAttribute<double>*>(attribute.get()));
    }
    return bytes;
}

/// A triangle as the positions of its corners, counter-clockwise from the smallest, and its phase.
struct PlacedTriangle {
    std::array<std::array<double, 2>, 3> at;
    Phase phase;
    friend auto operator<=>(const PlacedTriangle&, const PlacedTriangle&) = default;
};

inline PlacedTriangle placed(std::array<std::array<double, 2>, 3> at, Phase phase) {
    std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
    return {at, phase};
}

/// The triangles for which `wanted(id)` holds, sorted.
template <class Real, class Wanted>
std::vector<PlacedTriangle> placed_triangles(const Complex<Real>& complex, Wanted wanted) {
    std::vector<PlacedTriangle> list;
    for (const Triangle t : triangles(complex)) {
        if (wanted(t.id)) {
            std::array<std::array<double, 2>, 3> at;
            for (std::uint32_t i = 0; i < 3; ++i) {
                const auto p = complex.position(Vertex{complex.triangles[t.id].v[i]});
                at[i] = {static_cast<double>(p.x()), static_cast<double>(p.y())};
            }
            list.push_back(placed(at, complex.phase(t)));
        }
    }
    std::sort(list.begin(), list.end());
    return list;
}

} // namespace dsc::test

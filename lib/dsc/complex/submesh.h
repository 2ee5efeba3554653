// SPDX-License-Identifier: MIT
// The part of a complex that an operation may change [6.4]. A vertex is owned by its place, or by a
// label; a simplex lies in the submesh if all its vertices are owned; everything else is locked:
// triangles that straddle two submeshes are never rewritten, so that submeshes need neither locks
// nor copies.
#pragma once

#include "dsc/complex/complex.h"

#include <atomic>

namespace dsc {

/// Which vertices a submesh owns.
struct Region {
    enum class Kind : std::uint8_t { whole, slab, labels };

    Kind kind = Kind::whole;
    /// slab: owns p where low <= normal . p < high.
    double normal_x = 1;
    double normal_y = 0;
    double low = 0;
    double high = 0;
    /// labels: owns v where labels[v] == label.
    const std::uint32_t* labels = nullptr;
    std::uint32_t label = 0;

    [[nodiscard]] bool is_whole() const { return kind == Kind::whole; }
    [[nodiscard]] bool owns(std::uint32_t vertex, double x, double y) const {
        switch (kind) {
        case Kind::whole: return true;
        case Kind::slab: {
            const double s = normal_x * x + normal_y * y;
            return low <= s && s < high;
        }
        case Kind::labels: return labels[vertex] == label;
        }
        return false;
    }
};

/// A region and the ids that its operations draw from. `K.whole()`-style calls use `whole_submesh`.
struct Submesh {
    Region region;
    IdPool* pool = nullptr;
};

template <class Real>
Submesh whole_submesh(Complex<Real>& complex) {
    return Submesh{Region{}, &complex.ids};
}

/// Coordinates of a vertex that another submesh may be moving at this moment: it can only fail the
/// test of ownership, so the order does not matter, but the read must not tear.
template <class Real>
Real read_shared(const Real& value) {
    return std::atomic_ref<Real>(const_cast<Real&>(value)).load(std::memory_order_relaxed);
}
template <class Real>
void write_shared(Real& value, Real next) {
    std::atomic_ref<Real>(value).store(next, std::memory_order_relaxed);
}

template <class Real>
bool owns(const Complex<Real>& complex, const Region& region, std::uint32_t vertex) {
    if (region.is_whole()) {
        return true;
    }
    const auto& record = complex.vertices[vertex];
    return region.owns(vertex, static_cast<double>(read_shared(record.x)),
                       static_cast<double>(read_shared(record.y)));
}

/// True if all three vertices are owned.
template <class Real>
bool owns_triangle(const Complex<Real>& complex, const Region& region, std::uint32_t triangle) {
    if (region.is_whole()) {
        return true;
    }
    const auto& v = complex.triangles[triangle].v;
    return owns(complex, region, v[0]) && owns(complex, region, v[1]) &&
           owns(complex, region, v[2]);
}

} // namespace dsc

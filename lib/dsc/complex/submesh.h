// SPDX-License-Identifier: MIT
// The part of a complex that an operation may change (thesis, section 6.4). Its position or a label
// decides whether a vertex is owned; a simplex lies in the submesh if all its vertices are owned;
// everything else is locked: triangles that straddle two submeshes are never rewritten, so that
// submeshes need neither locks nor copies.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/records.h"

#include <limits>
#include <utility>

namespace dsc {

/// Which vertices a submesh owns.
struct Region {
    /// The rule by which a region owns vertices.
    enum class Kind : std::uint8_t {
        whole,  ///< everything is owned
        box,    ///< by position, in a frame that may be turned
        places, ///< by a function of the position
        labels, ///< by the id
        /// A box along the axes that does not wrap around: its test needs comparisons only.
        /// `simplest` turns such boxes into this kind.
        upright,
    };
    /// The number of the submesh that holds a point, by the partition of an application.
    using PlaceFunction = std::uint32_t (*)(const void* context, double x, double y);
    /// The bound of a box on a side without one.
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Kind kind = Kind::whole; ///< how ownership is decided
    /// box: with u along the normal and w along its left, owns (u, w) where low <= u < high and
    /// side_low <= w < side_high. If low > high the slab wraps around the ends of the mesh: it owns
    /// u < high and u >= low, because the first and the last black slab form one (thesis, section
    /// 8.5).
    double normal_x = 1;
    double normal_y = 0;         ///< with normal_x a unit vector
    double low = -infinity;      ///< the smallest u
    double high = infinity;      ///< u is below this
    double side_low = -infinity; ///< the smallest w
    double side_high = infinity; ///< w is below this
    /// places: owns p where place(context, p) == label.
    PlaceFunction place = nullptr;
    const void* context = nullptr; ///< handed to `place`
    /// labels: owns v where labels[v] == label.
    const std::uint32_t* labels = nullptr;
    std::uint32_t label = 0; ///< of this region, for places and labels

    /// Whether everything is owned.
    [[nodiscard]] bool is_whole() const { return kind == Kind::whole; }
    /// An axis-aligned box that does not wrap around.
    [[nodiscard]] bool is_upright() const {
        return kind == Kind::upright ||
               (kind == Kind::box && low <= high && normal_y == 0 && normal_x == 1);
    }
    /// The same region, as the kind with the fastest test.
    [[nodiscard]] Region simplest() const {
        Region region = *this;
        region.kind = is_upright() ? Kind::upright : kind;
        return region;
    }
    /// Whether an upright box owns a point.
    [[nodiscard]] bool is_inside(double x, double y) const {
        return (low <= x) & (x < high) & (side_low <= y) & (y < side_high);
    }
    /// The coordinate along the normal, u.
    [[nodiscard]] double along(double x, double y) const { return normal_x * x + normal_y * y; }
    /// The coordinate along the left of the normal, w.
    [[nodiscard]] double aside(double x, double y) const { return normal_x * y - normal_y * x; }
    /// Whether a box owns a point.
    [[nodiscard]] bool owns_place(double x, double y) const {
        const double u = along(x, y);
        const double w = aside(x, y);
        const bool is_along = low <= high ? (low <= u) & (u < high) : (low <= u) | (u < high);
        return is_along & (side_low <= w) & (w < side_high);
    }
    /// Whether the region owns a vertex at (x, y). Upright boxes, which almost all submeshes are,
    /// are inlined. O(1), or what `place` takes.
    [[nodiscard]] bool owns(std::uint32_t vertex, double x, double y) const {
        return kind == Kind::upright ? is_inside(x, y) : is_owner(vertex, x, y);
    }
    /// The same for every kind.
    [[nodiscard]] bool is_owner(std::uint32_t vertex, double x, double y) const {
        switch (kind) {
        case Kind::whole: return true;
        case Kind::box: return owns_place(x, y);
        case Kind::places: return place(context, x, y) == label;
        case Kind::labels: return labels[vertex] == label;
        case Kind::upright: return is_inside(x, y);
        }
        return false;
    }
    /// Whether two regions may overlap: false only if no point can lie in both; always true for
    /// labels and places.
    [[nodiscard]] bool may_meet(const Region& other) const {
        const auto is_box = [](const Region& region) {
            return region.kind == Kind::box || region.kind == Kind::upright;
        };
        const bool comparable = is_box(*this) && is_box(other) && normal_x == other.normal_x &&
                                normal_y == other.normal_y;
        if (!comparable) {
            return true;
        }
        const bool sides = side_low < other.side_high && other.side_low < side_high;
        const bool round = low > high || other.low > other.high;
        if (!round) {
            return sides && low < other.high && other.low < high;
        }
        if (low > high && other.low > other.high) {
            return sides;
        }
        const Region& ring = low > high ? *this : other;
        const Region& slab = low > high ? other : *this;
        return sides && (slab.low < ring.high || ring.low < slab.high);
    }
};

/// What an operation edits: a region of a complex, with the pool of ids that new simplices draw
/// from and the log that notes the edits. A complex converts to a submesh that owns everything.
template <class Real>
struct Submesh {
    using Scalar = Real; ///< of coordinates

    /// Owns everything, with the pool and the journal of the complex.
    Submesh(Complex<Real>& whole) // NOLINT(google-explicit-constructor): wherever a submesh may be
        : complex(whole), pool(&whole.ids), log(&whole.journal) {}
    /// Owns a region; complex, pool and log must outlive the submesh.
    Submesh(Complex<Real>& complex_in, const Region& region_in, IdPool& pool_in, EditLog& log_in)
        : complex(complex_in), region(region_in), pool(&pool_in), log(&log_in) {}

    Complex<Real>& complex; ///< the complex that it is a part of
    Region region;          ///< what it owns
    IdPool* pool;           ///< ids for new simplices
    EditLog* log;           ///< where edits are noted
};

/// The argument of operations: a submesh, or a complex, which stands for its whole.
template <class T>
concept Editable = requires(T& where) {
    Submesh(where);
};

/// The scalar of the coordinates there.
template <Editable Where>
using ScalarOf = typename decltype(Submesh(std::declval<Where&>()))::Scalar;

/// Rethrows the exception of an attribute if the submesh is the whole complex. For submeshes that
/// run side by side, the executor does so at the end.
template <class Real>
void rethrow_failure(const Submesh<Real>& submesh) {
    if (submesh.region.is_whole()) {
        submesh.complex.attributes.failure.rethrow();
    }
}

/// Whether the region owns a vertex at its current position. Safe while another submesh moves it.
/// Inlined: each movement asks for all vertices of a star.
template <class Real>
[[gnu::always_inline]] inline bool owns(const Complex<Real>& complex, const Region& region,
                                        std::uint32_t vertex) {
    if (region.is_whole()) {
        return true;
    }
    const auto& record = complex.vertices[vertex];
    return region.owns(vertex, static_cast<double>(read_shared(record.x)),
                       static_cast<double>(read_shared(record.y)));
}

/// Whether the region contains a point; always true for labels, which do not depend on positions.
template <class Real>
bool owns_place(const Region& region, const Point<Real>& point) {
    return region.is_whole() || region.kind == Region::Kind::labels ||
           region.owns(no_id, static_cast<double>(point.x()), static_cast<double>(point.y()));
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

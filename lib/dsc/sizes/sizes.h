// SPDX-License-Identifier: MIT
// Target edge lengths: uniform, growing away from the interface, or given by functions of the
// application. Each vertex stores its target in an attribute of the complex, which follows splits,
// renumbering and copies. Targets are computed for the whole mesh at the start, and after changes
// that the update of single stars does not notice.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"

#include <functional>
#include <limits>

namespace dsc {

/// Lengths are in units of the domain. The edge length of the options is the finest target, unless
/// `shortest` allows finer ones: results of the functions are clamped to at least that. If a
/// function returns NaN or a value that is not above 0, the caller (a simulation, an initial
/// complex, a step) throws InputError with the place. The functions are called from several threads
/// at once where submeshes run in parallel.
template <class Real>
struct SizeOptions {
    /// A length by place, time and phase.
    using ByPlace = std::function<Real(const Point<Real>&, Real time, Phase)>;
    /// A length by place and time, on the interface.
    using OnInterface = std::function<Real(const Point<Real>&, Real time)>;
    /// A length by the distance to the interface.
    using ByDistance = std::function<Real(Real distance)>;

    /// How much longer an edge may be than its neighbour towards the interface: above 1, up to 2.
    /// At the distance d from edges of length h, the target is h + (growth - 1) d. 0: uniform, and
    /// no other option here may be set.
    double growth = 0;
    Real longest = 0; ///< the longest target; 0: the extent of the mesh
    /// The shortest target that the functions may give, at most the edge length. 0: the edge
    /// length.
    Real shortest = 0;
    /// A target by place, time and phase; where phases meet, the shortest applies. It also applies
    /// to edges that end on the interface, but not to edges of the interface. Empty: none.
    ByPlace by_place = {};
    /// A target for the edges of the interface itself, by place and time: their thresholds are
    /// relative to it, and it limits the edges beside them. Empty: the edge length.
    OnInterface on_interface = {};
    /// True if `by_place` or `on_interface` depends on time. All vertices are then visited in each
    /// step.
    bool changes_in_time = false;
    /// A target by the distance to the interface. Empty: none.
    ByDistance by_distance = {};

    /// Whether all edges have the same target.
    [[nodiscard]] bool is_uniform() const { return growth == 0; }
};

/// The same options for a complex of another scalar.
template <class Real, class From>
SizeOptions<Real> sizes_in(const SizeOptions<From>& sizes) {
    SizeOptions<Real> result;
    result.growth = sizes.growth;
    result.longest = static_cast<Real>(sizes.longest);
    result.shortest = static_cast<Real>(sizes.shortest);
    result.changes_in_time = sizes.changes_in_time;
    if (sizes.by_place) {
        result.by_place = [by_place = sizes.by_place](const Point<Real>& p, Real time,
                                                      Phase phase) {
            return static_cast<Real>(
                by_place(p.template cast<From>(), static_cast<From>(time), phase));
        };
    }
    if (sizes.on_interface) {
        result.on_interface = [on_interface = sizes.on_interface](const Point<Real>& p, Real time) {
            return static_cast<Real>(
                on_interface(p.template cast<From>(), static_cast<From>(time)));
        };
    }
    if (sizes.by_distance) {
        result.by_distance = [by_distance = sizes.by_distance](Real distance) {
            return static_cast<Real>(by_distance(static_cast<From>(distance)));
        };
    }
    return result;
}

/// Throws InputError if a value is out of range, or set although sizes are uniform.
template <class Real>
void check_sizes(const SizeOptions<Real>& sizes, Real edge_length);

/// The sizes at a vertex. Infinite for vertices that no edge split created.
template <class Real>
struct VertexSize {
    Real length = std::numeric_limits<Real>::infinity();   ///< target of edges
    Real distance = std::numeric_limits<Real>::infinity(); ///< distances to the interface; stored
                                                           ///< only for `by_distance`
};

template <class Real>
void archive(Archive& archive, VertexSize<Real>& size) {
    archive(size.length, size.distance);
}

/// The attribute that holds the targets.
template <class Real>
using SizeField = VertexAttribute<VertexSize<Real>>;

/// The attribute, created if there is none yet.
template <class Real>
SizeField<Real>& size_field(Complex<Real>& complex);

/// The larger side of the box around the vertices. O(vertices).
template <class Real>
Real extent_of(const Complex<Real>& complex);

/// Computes the targets of all vertices from scratch, and the distances to the interface if they
/// are needed; the targets are those of the attribute `size_field`. The same complex gives the same
/// bits. O(n log n).
template <class Real>
void measure_sizes(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length,
                   Real time);

/// The shortest target that an edge of the interface may have.
template <class Real>
[[nodiscard]] Real finest_on_interface(const SizeOptions<Real>& sizes, Real edge_length) {
    const bool is_finer = sizes.on_interface && sizes.shortest > 0 && sizes.shortest < edge_length;
    return is_finer ? sizes.shortest : edge_length;
}

} // namespace dsc

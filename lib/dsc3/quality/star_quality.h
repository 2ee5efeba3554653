// SPDX-License-Identifier: MIT
// The quality of all tets of a star, for any position of its centre. The faces opposite to the
// centre are gathered once, as planes and sums of their vertices; each position then costs about
// ten operations per tet, on all lanes at once.
#pragma once

#include "dsc3/complex/star.h"

#include <vector>

namespace dsc3 {

/// The faces of a star, relative to the position of its centre when they were gathered.
class StarQuality {
public:
    /// Gathers the faces of a star. Tets with the vertex `without` come last, so that `worst` of
    /// the first `others()` tets leaves them out. O(degree).
    void gather(const Complex& complex, const Star& star, std::uint32_t without = no_id);
    /// Gathers the faces of the star that a vertex at `place` would have after a split of the edge.
    /// O(tets around the edge).
    void gather(const Complex& complex, const EdgeAt& edge, const Ring& ring, const Point& place);
    /// Number of tets.
    [[nodiscard]] std::uint32_t size() const { return size_; }
    /// Number of tets that do not have the vertex `without`.
    [[nodiscard]] std::uint32_t others() const { return others_; }
    /// The smallest quality of the first `count` tets with the centre at p. O(count).
    Real worst(const Point& p, std::uint32_t count);
    /// The same of all tets.
    Real worst(const Point& p) { return worst(p, size_); }
    /// The tet that was the worst in the last call of `worst`.
    [[nodiscard]] std::uint32_t worst_tet(std::uint32_t count) const;
    /// The gradient of the quality of a tet at p.
    [[nodiscard]] Point gradient(std::uint32_t tet, const Point& p) const;
    /// The mean of the vertices of the faces, each counted once per face.
    [[nodiscard]] Point mean() const;
    /// The root mean square of the edges of the first tet.
    [[nodiscard]] Real length() const;

private:
    void reset(const Point& origin, std::uint32_t size);
    void put(const Complex& complex, Corner corner, std::uint32_t place);

    // Of face i with vertices a, b, c relative to the origin: the determinant with the centre at p
    // is offset - plane . p, the sum of squared edges 3 p^2 - 2 sum . p + squares.
    struct Lanes {
        std::vector<Real> plane_x, plane_y, plane_z, offset;
        std::vector<Real> sum_x, sum_y, sum_z, squares;
        std::vector<Real> quality;
    };
    Lanes lanes_;
    Point origin_ = Point::Zero();
    std::uint32_t size_ = 0;
    std::uint32_t others_ = 0;
};

} // namespace dsc3

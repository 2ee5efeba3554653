// SPDX-License-Identifier: MIT
// The quality of all tets of a star, for any position of its centre. The faces opposite to the
// centre are gathered once, as planes and sums of their vertices; each position then costs about
// ten operations per tet, on all lanes of a block at once.
#pragma once

#include "dsc3/complex/star.h"

#include <array>
#include <limits>
#include <vector>

namespace dsc3 {

/// The faces of a star, relative to the position of its centre when they were gathered.
class StarQuality {
public:
    /// Gathers the faces of a star; `worst_of_others` leaves out tets with the vertex `without`.
    /// O(degree).
    void gather(const Complex& complex, const Star& star, std::uint32_t without = no_id);
    /// Gathers the faces of the star that a vertex at `place` would have after a split of the edge.
    /// O(tets around the edge).
    void gather(const Complex& complex, const EdgeAt& edge, const Ring& ring, const Point& place);
    /// Whether there are tets with the vertex `without`.
    [[nodiscard]] bool leaves_out() const { return other_blocks_ < blocks_.size(); }
    /// The smallest quality of all tets with the centre at p. O(degree).
    Real worst(const Point& p) { return evaluate<true>(p, blocks_.size(), never); }
    /// The same of the tets that do not have the vertex `without`.
    Real worst_of_others(const Point& p) { return evaluate<true>(p, other_blocks_, never); }
    /// `worst(p)` if that is above the bound; otherwise a value that is not, found sooner.
    Real worst_above(const Point& p, Real bound) {
        return evaluate<true>(p, blocks_.size(), bound);
    }
    /// Whether `worst(p)` would be above the bound; does not change `worst_tet`.
    bool is_above(const Point& p, Real bound) {
        return evaluate<false>(p, blocks_.size(), bound) > bound;
    }
    /// The tet that was the worst in the last call of `worst`, or of `worst_above` above the bound.
    /// This, `gradient` and `mean` need faces that were gathered with no vertex left out.
    [[nodiscard]] std::uint32_t worst_tet() const;
    /// The gradient of the quality of a tet at p.
    [[nodiscard]] Point gradient(std::uint32_t tet, const Point& p) const;
    /// The mean of the vertices of the faces, each counted once per face.
    [[nodiscard]] Point mean() const;
    /// The root mean square of the edges of the first tet.
    [[nodiscard]] Real length() const;

private:
    static constexpr std::uint32_t lanes = 8;
    static constexpr Real never = -std::numeric_limits<Real>::infinity();
    using Lane = std::array<Real, lanes>;
    // Of face i with vertices a, b, c relative to the origin: the determinant with the centre at p
    // is offset - plane . p, the sum of squared edges 3 p^2 - 2 sum . p + squares.
    struct alignas(64) Block {
        Lane plane_x, plane_y, plane_z, offset;
        Lane sum_x, sum_y, sum_z, squares;
        Lane quality;
    };

    void fill_block();
    void put_faces(const Complex& complex);
    template <bool stores>
    Real evaluate(const Point& p, std::size_t blocks, Real bound);

    std::vector<Corner> corners_; // repeated to fill whole blocks
    std::vector<Block> blocks_;
    std::size_t other_blocks_ = 0;
    std::uint32_t size_ = 0; // number of tets, without the repeated ones
    Point origin_ = Point::Zero();
};

} // namespace dsc3

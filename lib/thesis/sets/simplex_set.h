// SPDX-License-Identifier: MIT
// Sets of simplices, grouped by dimension (thesis, sections 3.1 and 8.2). The thesis keeps three
// std::set; three sorted flat arrays do the same without a node or pointer per simplex.
#pragma once

#include "dsc/base/types.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace dsc {

/// A set of vertices, edges and triangles of one complex. Each array is sorted by id and free of
/// duplicates at all times. An edge's handle changes when its triangles do: a set with edges is
/// valid until the complex changes next to them.
class SimplexSet {
public:
    SimplexSet() = default;
    /// From arrays in any order, duplicates allowed. O(n log n); O(n) where they are sorted.
    SimplexSet(std::vector<Vertex> vertices, std::vector<Edge> edges,
               std::vector<Triangle> triangles);

    /// Ascending by id.
    [[nodiscard]] const std::vector<Vertex>& vertices() const& { return vertices_; }
    /// Ascending by id.
    [[nodiscard]] const std::vector<Edge>& edges() const& { return edges_; }
    /// Ascending by id.
    [[nodiscard]] const std::vector<Triangle>& triangles() const& { return triangles_; }
    // A temporary returns its arrays by value, so that `for (Vertex v: link(k, w).vertices())` is
    // sound.
    /// Moves the array out.
    [[nodiscard]] std::vector<Vertex> vertices() && { return std::move(vertices_); }
    /// Moves the array out.
    [[nodiscard]] std::vector<Edge> edges() && { return std::move(edges_); }
    /// Moves the array out.
    [[nodiscard]] std::vector<Triangle> triangles() && { return std::move(triangles_); }

    /// The number of simplices of all dimensions, |Sigma|. O(1).
    [[nodiscard]] std::size_t size() const {
        return vertices_.size() + edges_.size() + triangles_.size();
    }
    /// Whether there is no simplex at all. O(1).
    [[nodiscard]] bool empty() const { return size() == 0; }

    /// O(log n).
    [[nodiscard]] bool contains(Vertex v) const;
    [[nodiscard]] bool contains(Edge e) const;
    [[nodiscard]] bool contains(Triangle t) const;
    /// True if every simplex of `other` is in this set. O(n + m).
    [[nodiscard]] bool contains(const SimplexSet& other) const;

    /// Inserts one simplex; returns whether it was new. O(n); O(log n) if it comes last. To build a
    /// large set, collect arrays and use the constructor.
    bool insert(Vertex v);
    bool insert(Edge e);
    bool insert(Triangle t);
    /// Inserts a whole set. O(n + m).
    void insert(const SimplexSet& other);

    /// Empties the set.
    void clear();

    friend bool operator==(const SimplexSet&, const SimplexSet&) = default;

    /// Union, difference and intersection. O(n + m).
    friend SimplexSet operator|(const SimplexSet& a, const SimplexSet& b);
    friend SimplexSet operator-(const SimplexSet& a, const SimplexSet& b);
    friend SimplexSet operator&(const SimplexSet& a, const SimplexSet& b);

private:
    std::vector<Vertex> vertices_;
    std::vector<Edge> edges_;
    std::vector<Triangle> triangles_;
};

/// The k-skeleton: the simplices of dimension k or lower (thesis, section 3.1, figure 3.8). O(size
/// of the result). Throws InputError where k is not 0, 1 or 2.
[[nodiscard]] SimplexSet skeleton(const SimplexSet& set, int k);

/// The k-filter: the simplices of dimension exactly k (thesis, section 3.1, figure 3.9). O(size of
/// the result). Throws InputError where k is not 0, 1 or 2.
[[nodiscard]] SimplexSet filter(const SimplexSet& set, int k);

} // namespace dsc

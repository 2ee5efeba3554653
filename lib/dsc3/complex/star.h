// SPDX-License-Identifier: MIT
// The star of a vertex or an edge. Walks do not modify the complex: each walk has its own small
// table of visited tets.
#pragma once

#include "dsc3/complex/complex.h"

#include <array>
#include <vector>

namespace dsc3 {

/// The ids that a walk has visited: a hash table that fits into the first-level cache.
class IdTable {
public:
    /// Removes all ids.
    void clear();
    /// Adds an id, which must not be `no_id`. Returns whether it is new. O(1).
    bool enter(std::uint32_t id) {
        std::uint32_t place = (id * 2654435761U) >> shift_;
        for (; slots_[place] != no_id; place = (place + 1) & mask_) {
            if (slots_[place] == id) {
                return false;
            }
        }
        slots_[place] = id;
        if (2 * ++count_ > mask_) {
            grow();
        }
        return true;
    }

private:
    void grow();

    std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(256, no_id);
    std::uint32_t mask_ = 255;
    std::uint32_t shift_ = 24;
    std::uint32_t count_ = 0;
};

/// The tets around a vertex, by their corners there.
struct Star {
    std::uint32_t centre = no_id;       ///< the vertex
    std::vector<Corner> corners;        ///< in the order of a walk from the vertex's corner
    IdTable met;                        ///< scratch
    std::vector<std::uint32_t> entries; ///< scratch: by tet, the face through which it was met
};

/// Gathers the star of a living vertex. O(degree).
void gather(const Complex& complex, std::uint32_t vertex, Star& star);

/// The stars that were gathered last, so that few are gathered again. Whoever edits the complex
/// forgets those of the vertices concerned.
class StarCache {
public:
    /// Begins without stars: while it is open, all edits must be reported.
    void open();
    /// Ends: `gather` searches again.
    void close() { is_open_ = false; }
    /// Forgets the star of a vertex. O(1).
    void forget(std::uint32_t vertex) {
        Entry& entry = entries_[vertex % size];
        if (entry.centre == vertex) {
            entry.centre = no_id;
        }
    }
    /// `gather` of a star, if it is not known. O(degree).
    void gather(const Complex& complex, std::uint32_t vertex, Star& star);

private:
    static constexpr std::size_t size = 128;
    struct Entry {
        std::uint32_t centre = no_id;
        std::vector<Corner> corners;
    };

    std::array<Entry, size> entries_;
    bool is_open_ = false;
};

/// Keeps a cache open, also until an exception ends the edits: later ones may not be reported.
class OpenStars : public dsc::Unmovable {
public:
    explicit OpenStars(StarCache& stars) : stars_(stars) { stars_.open(); }
    ~OpenStars() { stars_.close(); }

private:
    StarCache& stars_;
};

/// An edge, named by a tet that has it and its two vertices.
struct EdgeAt {
    std::uint32_t tet = border_tet;
    std::uint32_t a = no_id;
    std::uint32_t b = no_id;

    /// Whether there is such an edge.
    [[nodiscard]] bool is_valid() const { return tet != border_tet; }
};

/// The index of a vertex in a tet that has it.
[[nodiscard]] inline std::uint32_t index_in(const TetRecord& tet, std::uint32_t vertex) {
    return tet.v[0] == vertex ? 0U : tet.v[1] == vertex ? 1U : tet.v[2] == vertex ? 2U : 3U;
}
/// Whether a tet has the vertex.
[[nodiscard]] inline bool has_vertex(const TetRecord& tet, std::uint32_t vertex) {
    return tet.v[0] == vertex || tet.v[1] == vertex || tet.v[2] == vertex || tet.v[3] == vertex;
}

/// The edge between two vertices; not valid if there is none. `star` becomes that of a. O(degree).
[[nodiscard]] EdgeAt find_edge(const Complex& complex, std::uint32_t a, std::uint32_t b,
                               Star& star);

/// No operation edits edges with more tets.
inline constexpr std::uint32_t ring_limit = 60;

/// The tets around an edge (a, b): tet i is (a, b, vertices[i], vertices[i + 1]).
struct Ring {
    std::uint32_t size = 0; ///< number of tets
    bool closed = true;     ///< false: the edge lies on the domain boundary
    /// Its link, counter-clockwise as seen from b: `size` vertices, and one more if it is open.
    std::array<std::uint32_t, ring_limit + 2> vertices{};
    std::array<std::uint32_t, ring_limit + 2> tets{};

    /// Vertex i, cyclically.
    [[nodiscard]] std::uint32_t vertex(std::uint32_t i) const {
        return vertices[closed && i >= size ? i - size : i];
    }
};

/// Gathers the star of an edge; false if it has more than `ring_limit` tets. O(size).
[[nodiscard]] bool gather(const Complex& complex, const EdgeAt& edge, Ring& ring);

} // namespace dsc3

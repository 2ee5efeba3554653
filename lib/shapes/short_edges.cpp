// SPDX-License-Identifier: MIT
// Removes the short edges of a Voronoi diagram.
#include "shapes/voronoi_diagram.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace dsc::scenes {

namespace {

struct ShortEdge {
    double squared_length;
    std::uint32_t from;
    std::uint32_t to;

    friend auto operator<=>(const ShortEdge&, const ShortEdge&) = default;
};

// The cell with vertex `b` replaced by `a`, and without the edge between them.
VoronoiCell with_one_for_both(const VoronoiCell& cell, std::uint32_t a, std::uint32_t b) {
    const auto now = [&](std::size_t k) {
        const std::uint32_t v = cell.vertices[k < cell.vertices.size() ? k : 0];
        return v == b ? a : v;
    };
    VoronoiCell result;
    for (std::size_t k = 0; k < cell.vertices.size(); ++k) {
        if (now(k) != now(k + 1)) {
            result.vertices.push_back(now(k));
            result.beyond.push_back(cell.beyond[k]);
        }
    }
    return result;
}

class Contraction {
public:
    explicit Contraction(VoronoiDiagram& diagram)
        : diagram_(diagram), merged_(diagram.vertices.size(), 1), now_(diagram.vertices.size()),
          cells_(diagram.vertices.size()) {
        std::iota(now_.begin(), now_.end(), 0U);
        for (std::uint32_t i = 0; i < diagram.cells.size(); ++i) {
            for (const std::uint32_t v : diagram.cells[i].vertices) {
                cells_[v].push_back(i);
            }
            centres_.push_back(centroid(diagram.corners_of(diagram.cells[i])));
        }
    }

    // Tries to contract each short edge once, the shortest first. Returns whether any was
    // contracted.
    bool contract(double shortest) {
        bool any = false;
        for (const ShortEdge& edge : edges_below(shortest)) {
            const std::uint32_t a = vertex_now(edge.from);
            const std::uint32_t b = vertex_now(edge.to);
            // The edge may have vanished or become longer since the list was made.
            if (a != b && (diagram_.vertices[a] - diagram_.vertices[b]).norm() < shortest) {
                any = merge(std::min(a, b), std::max(a, b)) || any;
            }
        }
        return any;
    }

private:
    [[nodiscard]] std::uint32_t vertex_now(std::uint32_t v) const {
        while (now_[v] != v) {
            v = now_[v];
        }
        return v;
    }

    [[nodiscard]] std::vector<ShortEdge> edges_below(double shortest) const {
        std::vector<ShortEdge> edges;
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            const VoronoiCell& cell = diagram_.cells[i];
            const std::size_t n = cell.vertices.size();
            for (std::size_t k = 0; k < n; ++k) {
                const auto [a, b] =
                    std::minmax(cell.vertices[k], cell.vertices[k + 1 < n ? k + 1 : 0]);
                const double squared = (diagram_.vertices[a] - diagram_.vertices[b]).squaredNorm();
                if (cell.beyond[k] > i && squared < shortest * shortest) {
                    edges.push_back({squared, a, b});
                }
            }
        }
        std::ranges::sort(edges);
        return edges;
    }

    // The position of two merged vertices. A vertex at a corner of the domain keeps its position,
    // and so does one on a side when merged with one inside; two of the same kind move to the mean
    // of the vertices that they contain.
    [[nodiscard]] std::optional<Point<double>> place_of(std::uint32_t a, std::uint32_t b) const {
        const unsigned at_a = diagram_.sides[a];
        const unsigned at_b = diagram_.sides[b];
        const Point<double>& p = diagram_.vertices[a];
        const Point<double>& q = diagram_.vertices[b];
        if ((at_a | at_b) != at_a && (at_a | at_b) != at_b) {
            return std::nullopt; // the vertices are on two different sides
        }
        if (at_a != at_b) {
            return (at_a | at_b) == at_a ? p : q;
        }
        Point<double> mean = (merged_[a] * p + merged_[b] * q) / (merged_[a] + merged_[b]);
        if (at_a != 0) { // stays exactly on its side
            const bool is_level = (at_a & 0b0101U) != 0;
            mean[is_level ? 1 : 0] = p[is_level ? 1 : 0];
        }
        return mean;
    }

    // Merges vertex `b` into `a` if all cells around them stay valid. A cell that has lost its
    // third side is found because it turns clockwise along its second one.
    bool merge(std::uint32_t a, std::uint32_t b) {
        const auto place = place_of(a, b);
        if (!place) {
            return false;
        }
        std::vector<std::uint32_t> around;
        std::ranges::set_union(cells_[a], cells_[b], std::back_inserter(around));
        const Point<double> before = std::exchange(diagram_.vertices[a], *place);
        std::vector<VoronoiCell> cells;
        for (const std::uint32_t i : around) {
            cells.push_back(with_one_for_both(diagram_.cells[i], a, b));
            if (!is_seen_from(centres_[i], diagram_.corners_of(cells.back()),
                              cells.back().beyond)) {
                diagram_.vertices[a] = before;
                return false;
            }
        }
        for (std::size_t k = 0; k < around.size(); ++k) {
            diagram_.cells[around[k]] = std::move(cells[k]);
        }
        if (diagram_.sides[a] == diagram_.sides[b]) {
            merged_[a] += merged_[b];
        } else if ((diagram_.sides[a] | diagram_.sides[b]) != diagram_.sides[a]) {
            merged_[a] = merged_[b];
        }
        diagram_.sides[a] |= diagram_.sides[b];
        cells_[a] = std::move(around);
        now_[b] = a;
        return true;
    }

    VoronoiDiagram& diagram_;
    std::vector<double> merged_;     // by vertex: the number of vertices that it contains
    std::vector<std::uint32_t> now_; // by vertex: itself, or the vertex it was merged into
    std::vector<std::vector<std::uint32_t>> cells_; // by vertex, ascending
    std::vector<Point<double>> centres_; // centres of the cells, before anything is contracted
};

} // namespace

VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest) {
    Contraction contraction(diagram);
    while (contraction.contract(shortest)) {
    }
    return diagram;
}

} // namespace dsc::scenes

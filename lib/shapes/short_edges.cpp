// SPDX-License-Identifier: MIT
#include "shapes/short_edges.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace dsc::scenes {

namespace {

// Vertices that have become one, by the smallest of their numbers.
struct Cluster {
    std::vector<std::uint32_t> members; // ascending
    std::vector<std::uint32_t> cells;   // ascending
    Point<double> place{0.0, 0.0};
};

struct ShortEdge {
    double squared_length;
    std::uint32_t from;
    std::uint32_t to;

    friend auto operator<=>(const ShortEdge&, const ShortEdge&) = default;
};

std::vector<std::uint32_t> merged(const std::vector<std::uint32_t>& a,
                                  const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

class Contraction {
public:
    explicit Contraction(VoronoiDiagram diagram) : diagram_(std::move(diagram)) {
        clusters_.resize(diagram_.vertices.size());
        for (std::uint32_t v = 0; v < clusters_.size(); ++v) {
            cluster_of_.push_back(v);
            clusters_[v].members = {v};
            clusters_[v].place = diagram_.vertices[v];
        }
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            for (const std::uint32_t v : diagram_.cells[i].vertices) {
                clusters_[v].cells.push_back(i);
            }
            centres_.push_back(centroid(corners_of(diagram_.cells[i])));
        }
    }

    // Tries each short edge once, the shortest first; returns how many are gone.
    std::size_t contract(double shortest) {
        std::size_t gone = 0;
        for (const ShortEdge& edge : edges_below(shortest)) {
            const std::uint32_t a = cluster_of_[edge.from];
            const std::uint32_t b = cluster_of_[edge.to];
            // The edge may be gone, or longer, since the list was made.
            if (a != b && (clusters_[a].place - clusters_[b].place).norm() < shortest) {
                gone += merge(std::min(a, b), std::max(a, b)) ? 1U : 0U;
            }
        }
        return gone;
    }

    VoronoiDiagram result() {
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            diagram_.cells[i] = shrunk(i);
        }
        for (std::uint32_t v = 0; v < clusters_.size(); ++v) {
            diagram_.vertices[v] = clusters_[v].place;
            for (const std::uint32_t member : clusters_[v].members) {
                diagram_.sides[v] |= diagram_.sides[member];
            }
        }
        return std::move(diagram_);
    }

private:
    [[nodiscard]] std::vector<Point<double>> corners_of(const VoronoiCell& cell) const {
        std::vector<Point<double>> corners;
        for (const std::uint32_t v : cell.vertices) {
            corners.push_back(clusters_[v].place);
        }
        return corners;
    }

    // The cell with one vertex for each cluster, and without contracted edges.
    [[nodiscard]] VoronoiCell shrunk(std::uint32_t cell) const {
        const VoronoiCell& whole = diagram_.cells[cell];
        VoronoiCell result;
        const std::size_t n = whole.vertices.size();
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t v = cluster_of_[whole.vertices[k]];
            if (v != cluster_of_[whole.vertices[k + 1 < n ? k + 1 : 0]]) {
                result.vertices.push_back(v);
                result.beyond.push_back(whole.beyond[k]);
            }
        }
        return result;
    }

    [[nodiscard]] std::vector<ShortEdge> edges_below(double shortest) const {
        std::vector<ShortEdge> edges;
        for (std::uint32_t i = 0; i < diagram_.cells.size(); ++i) {
            const VoronoiCell cell = shrunk(i);
            const std::size_t n = cell.vertices.size();
            for (std::size_t k = 0; k < n; ++k) {
                const auto [a, b] =
                    std::minmax(cell.vertices[k], cell.vertices[k + 1 < n ? k + 1 : 0]);
                const double squared = (clusters_[a].place - clusters_[b].place).squaredNorm();
                if (cell.beyond[k] > i && squared < shortest * shortest) {
                    edges.push_back({squared, a, b});
                }
            }
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    }

    // Where these vertices become one: a corner of the domain stays, and so does its side.
    [[nodiscard]] std::optional<Point<double>>
    place_of(const std::vector<std::uint32_t>& members) const {
        unsigned sides = 0;
        for (const std::uint32_t v : members) {
            sides |= diagram_.sides[v];
        }
        if (members.front() < domain_corners) {
            return sides == diagram_.sides[members.front()]
                       ? std::optional(diagram_.vertices[members.front()])
                       : std::nullopt;
        }
        if (std::popcount(sides) > 1) {
            return std::nullopt;
        }
        Point<double> sum = Point<double>::Zero();
        const Point<double>* on_side = nullptr;
        int count = 0;
        for (const std::uint32_t v : members) {
            if (diagram_.sides[v] == sides) {
                sum += diagram_.vertices[v];
                on_side = &diagram_.vertices[v];
                ++count;
            }
        }
        Point<double> place = sum / count;
        if (sides != 0) { // not even by rounding off its side
            const bool level = (sides & 0b0101U) != 0;
            place[level ? 1 : 0] = (*on_side)[level ? 1 : 0];
        }
        return place;
    }

    // Makes cluster `b` part of `a` if all cells around them stay sound.
    bool merge(std::uint32_t a, std::uint32_t b) {
        const std::vector<std::uint32_t> members =
            merged(clusters_[a].members, clusters_[b].members);
        const auto place = place_of(members);
        if (!place) {
            return false;
        }
        const Point<double> before = clusters_[a].place;
        const std::vector<std::uint32_t> cells = merged(clusters_[a].cells, clusters_[b].cells);
        for (const std::uint32_t v : clusters_[b].members) {
            cluster_of_[v] = a;
        }
        clusters_[a].place = *place;
        if (!std::all_of(cells.begin(), cells.end(),
                         [&](std::uint32_t cell) { return is_sound(cell); })) {
            for (const std::uint32_t v : clusters_[b].members) {
                cluster_of_[v] = b;
            }
            clusters_[a].place = before;
            return false;
        }
        clusters_[a].members = members;
        clusters_[a].cells = cells;
        clusters_[b].members.clear();
        clusters_[b].cells.clear();
        return true;
    }

    // A cell that has lost its third side turns clockwise on the way back along its second one.
    [[nodiscard]] bool is_sound(std::uint32_t cell) const {
        const VoronoiCell shape = shrunk(cell);
        return is_seen_from(centres_[cell], corners_of(shape), shape.beyond);
    }

    VoronoiDiagram diagram_;
    std::vector<Point<double>> centres_;    // of the cells, before anything is contracted
    std::vector<std::uint32_t> cluster_of_; // by vertex
    std::vector<Cluster> clusters_;         // by the smallest member; the others are empty
};

} // namespace

VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest) {
    Contraction contraction(std::move(diagram));
    while (contraction.contract(shortest) > 0) {
    }
    return contraction.result();
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "fluid/system/dissection.h"

#include <algorithm>
#include <span>

namespace dsc {

namespace {

constexpr std::size_t few = 8;    // parts of at most this many triangles are not cut
constexpr std::size_t many = 100; // triangles for which both axes are tried
constexpr int passes = 3;         // over the triangles, to straighten a cut

class Dissector {
public:
    explicit Dissector(const MeshSnapshot& mesh)
        : mesh_(mesh), side_(mesh.triangles.size(), 0), in_half_(mesh.nodes.size(), 0),
          is_taken_(mesh.nodes.size(), 0) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            result_.triangles.push_back(t);
            const auto& nodes = mesh.triangles[t].nodes;
            centres_.push_back(mesh.nodes[nodes[0]] + mesh.nodes[nodes[1]] + mesh.nodes[nodes[2]]);
        }
        (void)cut(result_.triangles, 0);
    }
    [[nodiscard]] Dissection take() { return std::move(result_); }

private:
    using Triangles = std::span<std::uint32_t>;

    // Returns the index of the part.
    std::uint32_t cut(Triangles triangles, std::uint32_t depth) {
        MeshPart part{.first_triangle =
                          static_cast<std::uint32_t>(triangles.data() - result_.triangles.data()),
                      .triangle_count = static_cast<std::uint32_t>(triangles.size()),
                      .depth = depth};
        std::vector<std::uint32_t> inner;
        if (triangles.size() <= few) {
            std::ranges::sort(triangles);
            inner = left_in(triangles);
        } else {
            Eigen::Index axis = longer_axis(triangles);
            std::size_t half = divide(triangles, axis);
            inner = on_cut(triangles, half);
            if (triangles.size() > many) {
                const std::size_t other = divide(triangles, 1 - axis);
                auto other_inner = on_cut(triangles, other);
                if (other_inner.size() < inner.size()) {
                    axis = 1 - axis;
                    half = other;
                    inner = std::move(other_inner);
                } else {
                    half = divide(triangles, axis);
                    inner = on_cut(triangles, half);
                }
            }
            // In the order along the cut, so that neighbouring nodes have consecutive numbers.
            std::ranges::sort(inner, {}, [&](std::uint32_t node) {
                return std::pair(mesh_.nodes[node][1 - axis], node);
            });
            for (const std::uint32_t node : inner) {
                is_taken_[node] = 1;
            }
            part.halves = {cut(triangles.first(half), depth + 1),
                           cut(triangles.subspan(half), depth + 1)};
        }
        part.first_node = static_cast<std::uint32_t>(result_.nodes.size());
        part.node_count = static_cast<std::uint32_t>(inner.size());
        result_.nodes.insert(result_.nodes.end(), inner.begin(), inner.end());
        result_.parts.push_back(part);
        return static_cast<std::uint32_t>(result_.parts.size() - 1);
    }

    [[nodiscard]] Eigen::Index longer_axis(Triangles triangles) const {
        Point<double> low = centres_[triangles[0]];
        Point<double> high = low;
        for (const std::uint32_t t : triangles) {
            low = low.cwiseMin(centres_[t]);
            high = high.cwiseMax(centres_[t]);
        }
        return high.x() - low.x() > high.y() - low.y() ? 0 : 1;
    }

    // Partitions the triangles at the median along the axis, and returns the size of the first
    // half. The order within the halves is kept, so that it does not depend on the standard
    // library.
    std::size_t divide(Triangles triangles, Eigen::Index axis) {
        std::vector<std::pair<double, std::uint32_t>> places; // no two are equal
        places.reserve(triangles.size());
        for (const std::uint32_t t : triangles) {
            places.emplace_back(centres_[t][axis], t);
        }
        const auto median = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
        std::nth_element(places.begin(), median, places.end());
        ++stamp_;
        for (const std::uint32_t t : triangles) {
            side_[t] = 2 * stamp_ + (std::pair(centres_[t][axis], t) < *median ? 0 : 1);
        }
        // Straightens the cut: a triangle with most of its neighbours in the other half changes
        // sides.
        for (int pass = 0; pass < passes; ++pass) {
            for (const std::uint32_t t : triangles) {
                int beyond = 0;
                for (const std::uint32_t other : mesh_.triangles[t].across) {
                    if (other != no_id && side_[other] / 2 == stamp_) {
                        beyond += side_[other] == side_[t] ? -1 : 1;
                    }
                }
                if (beyond > 0) {
                    side_[t] ^= 1U;
                }
            }
        }
        const auto end = std::stable_partition(triangles.begin(), triangles.end(),
                                               [&](std::uint32_t t) { return side_[t] % 2 == 0; });
        const auto first = static_cast<std::size_t>(end - triangles.begin());
        return first == 0 || first == triangles.size() ? triangles.size() / 2 : first;
    }

    // The nodes that both halves have and that belong to no cut yet.
    std::vector<std::uint32_t> on_cut(Triangles triangles, std::size_t half) {
        std::vector<std::uint32_t> nodes;
        ++stamp_;
        for (const std::uint32_t t : triangles.first(half)) {
            for (const std::uint32_t node : mesh_.triangles[t].nodes) {
                in_half_[node] = stamp_;
            }
        }
        for (const std::uint32_t t : triangles.subspan(half)) {
            for (const std::uint32_t node : mesh_.triangles[t].nodes) {
                if (in_half_[node] == stamp_ && is_taken_[node] == 0) {
                    in_half_[node] = 0;
                    nodes.push_back(node);
                }
            }
        }
        return nodes;
    }
    std::vector<std::uint32_t> left_in(Triangles triangles) {
        std::vector<std::uint32_t> nodes;
        for (const std::uint32_t t : triangles) {
            for (const std::uint32_t node : mesh_.triangles[t].nodes) {
                if (is_taken_[node] == 0) {
                    is_taken_[node] = 1;
                    nodes.push_back(node);
                }
            }
        }
        return nodes;
    }

    const MeshSnapshot& mesh_;
    std::vector<Point<double>> centres_; // of the triangles, times three
    std::vector<std::uint32_t> side_;    // by triangle: twice the last stamp, and 1 beyond the cut
    std::vector<std::uint32_t> in_half_; // by node: the last stamp
    std::vector<std::uint8_t> is_taken_; // by node
    std::uint32_t stamp_ = 0;
    Dissection result_;
};

} // namespace

Dissection dissect(const MeshSnapshot& mesh) { return Dissector(mesh).take(); }

} // namespace dsc

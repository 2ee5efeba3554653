// SPDX-License-Identifier: MIT
#include "fluid/interface/boundary_flow.h"

#include "dsc/complex/circulate.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/side.h"
#include "fluid/system/walls.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dsc {

namespace {

std::vector<double> swept_by_boundary(const Complex<double>& complex,
                                      std::span<const Vertex> interface,
                                      const std::vector<PhaseArea>& areas) {
    std::vector<double> swept(areas.size(), 0);
    for (const Vertex v : interface) {
        for_each_corner(complex, v, [&](Corner c) {
            const auto phase = std::ranges::find(areas, complex.phase_at(c), &PhaseArea::phase);
            if (phase != areas.end() && is_border(complex.twin(prev(c)))) {
                swept[static_cast<std::size_t>(phase - areas.begin())] +=
                    cross<double>(complex.position(v),
                                  complex.position(Vertex{complex.vertex(next(c))})) /
                    2;
            }
        });
    }
    return swept;
}

// The neighbours along the boundary of a vertex on it.
std::array<Point<double>, 2> beside(const Complex<double>& complex, Vertex v) {
    std::array<Point<double>, 2> both{Point<double>(0, 0), Point<double>(0, 0)};
    for_each_corner(complex, v, [&](Corner c) {
        if (is_border(complex.twin(prev(c)))) {
            both[0] = complex.position(Vertex{complex.vertex(next(c))});
        }
        if (is_border(complex.twin(next(c)))) {
            both[1] = complex.position(Vertex{complex.vertex(prev(c))});
        }
    });
    return both;
}

} // namespace

std::vector<double> swept_by_boundary(const MeshSnapshot& mesh,
                                      const std::vector<PhaseArea>& areas) {
    std::vector<double> swept(areas.size(), 0);
    bool is_box = true;
    for (const SnapshotTriangle& triangle : mesh.triangles) {
        const auto phase = std::ranges::find(areas, triangle.phase, &PhaseArea::phase);
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (triangle.across[i] == no_id) {
                const Point<double>& from = mesh.nodes[triangle.nodes[next_index(i)]];
                const Point<double>& to = mesh.nodes[triangle.nodes[prev_index(i)]];
                is_box = is_box && (from.x() == to.x() || from.y() == to.y());
                if (phase != areas.end()) {
                    swept[static_cast<std::size_t>(phase - areas.begin())] +=
                        cross<double>(from, to) / 2;
                }
            }
        }
    }
    return is_box ? std::vector<double>() : swept;
}

BoundaryFlow::BoundaryFlow(const std::vector<PhaseArea>& before, double start,
                           std::vector<double> inflows, std::vector<double> swept,
                           const Rectangle& box, const FluidOptions& options)
    : areas_(before), start_(start), inflows_(std::move(inflows)), swept_(std::move(swept)),
      conditions_(box, options), has_sides_(!inflows_.empty() || !swept_.empty()) {}

void BoundaryFlow::begin(const InterfaceView<double>& view, double time) {
    if (time == start_ && !swept_.empty()) {
        const std::vector<double> now = swept_by_boundary(view.complex, view.vertices, areas_);
        for (std::size_t i = 0; i < now.size(); ++i) {
            areas_[i].area += now[i] - swept_[i];
        }
        swept_.clear();
    }
}

void BoundaryFlow::cut_at_outlets(const InterfaceView<double>& view,
                                  std::span<Point<double>> targets) const {
    constexpr double shortest = 0.05; // of the edge
    for (std::size_t k = 0; k < view.junctions.size() && !inflows_.empty(); ++k) {
        const std::uint32_t end = view.junctions[k];
        std::uint32_t last = no_id;
        for (std::uint32_t a = view.arm_begin[k]; a < view.arm_begin[k + 1]; ++a) {
            const InterfaceArm& arm = view.arms[a];
            if (arm.left != border_phase && arm.right != border_phase) {
                last = last == no_id ? arm.neighbour : end; // or several curves end here
            }
        }
        if (!view.is_on_boundary(end) || last == no_id || last == end) {
            continue;
        }
        const auto [from, to] = beside(view.complex, view.vertices[end]);
        const auto slips = [&](const Point<double>& neighbour) {
            return conditions_.between(neighbour, view.positions[end]).wall == Wall::slip;
        };
        if (slips(from) || slips(to)) { // the end slides along a side that may be curved
            continue;
        }
        const Point<double> inwards = turned_left((from - to).normalized());
        const double out = -inwards.dot(targets[end] - view.positions[end]);
        double in = inwards.dot(targets[last] - view.positions[end]);
        const double length = (view.positions[last] - view.positions[end]).norm();
        if (out > 1e-9 * length) {
            if (in < shortest * length) {
                targets[last] += (shortest * length - in) * inwards;
                in = shortest * length;
            }
            targets[end] += out / (in + out) * (targets[last] - targets[end]);
        }
    }
}

void BoundaryFlow::keep_on_boundary(const InterfaceView<double>& view,
                                    std::span<Point<double>> targets) const {
    for (std::size_t i = 0; i < view.size() && has_sides_; ++i) {
        if (!view.is_on_boundary(i)) {
            continue;
        }
        const Vertex v = view.vertices[i];
        if (view.complex.is_boundary_feature(v)) {
            targets[i] = view.positions[i];
            continue;
        }
        bool is_end = false;
        const Phase first = view.complex.phase_at(view.complex.vertices[v.id].corner);
        for_each_corner(view.complex, v,
                        [&](Corner c) { is_end = is_end || view.complex.phase_at(c) != first; });
        const auto [from, to] = beside(view.complex, v);
        targets[i] = slid_on_side<double>(from, view.positions[i], to, targets[i], is_end);
    }
}

std::vector<PhaseArea> BoundaryFlow::areas_at(double time) const {
    std::vector<PhaseArea> areas = areas_;
    for (std::size_t i = 0; i < inflows_.size(); ++i) {
        areas[i].area += (time - start_) * inflows_[i];
    }
    return areas;
}

} // namespace dsc

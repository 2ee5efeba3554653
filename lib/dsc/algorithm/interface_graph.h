// SPDX-License-Identifier: MIT
// The interface as a graph: the arrays behind an `InterfaceView`, from lists of interface vertices.
#pragma once

#include "dsc/motion/interface_flow.h"

#include <vector>

namespace dsc {

/// Built in three rounds; in the first two, threads may work on different ranges of the list:
///
///     graph.resize(size, ranges);   // then for each range, at once: number
///                                   // when all are done, for each range, at once: connect
///     graph.join();
///
/// Uses `VertexRecord::slot` of the interface vertices. Reuses its memory.
template <class Real>
class InterfaceGraph {
public:
    /// Makes room for that many vertices in that many ranges.
    void resize(std::size_t vertices, std::size_t ranges);
    /// Numbers the vertices of `list` from `begin` on. O(list).
    void number(Complex<Real>& complex, std::span<const std::uint32_t> list, std::size_t begin);
    /// Finds the neighbours of numbers `begin` to `end`, which are range `range`. A neighbour
    /// without a number is left out: a pass of the application may just have put it on the
    /// interface, and it is listed from the next sub-step on. O(stars).
    void connect(const Complex<Real>& complex, std::size_t range, std::size_t begin,
                 std::size_t end);
    /// Puts the junctions of all ranges together. O(junctions).
    void join();
    /// All three rounds at once. O(stars of list).
    void build(Complex<Real>& complex, std::span<const std::uint32_t> list);

    /// `positions`: those of the stage, one for each vertex. What is returned refers to all three.
    [[nodiscard]] InterfaceView<Real> view(const Complex<Real>& complex,
                                           std::span<const Point<Real>> positions) const;

private:
    struct Junctions { // of one range; the last entry of `begin` is the number of arms
        std::vector<std::uint32_t> indices;
        std::vector<std::uint32_t> begin;
        std::vector<InterfaceArm> arms;
    };
    void connect_one(const Complex<Real>& complex, std::size_t i, Junctions& found);

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> next_;
    std::vector<Phase> left_;
    std::vector<Phase> right_;
    std::vector<std::uint8_t> flags_;
    Junctions junctions_;
    std::vector<Junctions> found_; // by range
};

} // namespace dsc

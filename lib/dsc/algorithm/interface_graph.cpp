// SPDX-License-Identifier: MIT
#include "dsc/algorithm/interface_graph.h"

#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"

namespace dsc {

namespace {

/// Which of two phases is on the left of a curve.
constexpr bool is_left(Phase one, Phase other) {
    return other == border_phase || (one != border_phase && one > other);
}

} // namespace

template <class Real>
void InterfaceGraph<Real>::resize(std::size_t vertices, std::size_t ranges) {
    vertices_.resize(vertices);
    previous_.resize(vertices);
    next_.resize(vertices);
    left_.resize(vertices);
    right_.resize(vertices);
    flags_.resize(vertices);
    found_.resize(ranges);
}

template <class Real>
void InterfaceGraph<Real>::number(Complex<Real>& complex, std::span<const std::uint32_t> list,
                                  std::size_t begin) {
    for (std::size_t k = 0; k < list.size(); ++k) {
        vertices_[begin + k] = Vertex{list[k]};
        complex.vertices[list[k]].slot = static_cast<std::uint32_t>(begin + k);
    }
}

template <class Real>
void InterfaceGraph<Real>::connect(const Complex<Real>& complex, std::size_t range,
                                   std::size_t begin, std::size_t end) {
    Junctions& found = found_[range];
    found.indices.clear();
    found.begin.clear();
    found.arms.clear();
    for (std::size_t i = begin; i < end; ++i) {
        connect_one(complex, i, found);
    }
}

// The arms of each vertex are collected at the end of the list of its range, and stay there if they
// form a junction.
template <class Real>
void InterfaceGraph<Real>::connect_one(const Complex<Real>& complex, std::size_t i,
                                       Junctions& found) {
    const Vertex vertex = vertices_[i];
    auto& arms = found.arms;
    const std::size_t first = arms.size();
    std::size_t spokes = 0;
    const auto add = [&](std::uint32_t to, Phase left, Phase right) {
        const std::uint32_t slot = complex.vertices[to].slot;
        ++spokes;
        if (slot < vertices_.size() && vertices_[slot] == Vertex{to}) {
            arms.push_back({slot, left, right});
        }
    };
    bool is_on_boundary = false;
    for_each_corner(complex, vertex, [&](Corner c) {
        const Phase after = complex.phase_at(c);
        const Phase before = complex.phase_at(complex.twin(prev(c)));
        if (is_interface_pair(after, before)) {
            add(complex.vertex(next(c)), after, before);
        }
        // The last spoke of an open star.
        if (is_border(complex.twin(next(c)))) {
            is_on_boundary = true;
            if (is_interface_pair(after, border_phase)) {
                add(complex.vertex(prev(c)), border_phase, after);
            }
        }
    });
    const std::uint32_t record_flags = complex.vertices[vertex.id].flags;
    unsigned flags = 0;
    const auto mark = [&](bool holds, unsigned flag) { flags |= holds ? flag : 0U; };
    mark(is_on_boundary, interface_boundary);
    mark((record_flags & vertex_corner) != 0, interface_corner);
    mark((record_flags & vertex_locked) != 0, interface_locked);
    if (spokes == 2 && arms.size() - first == 2 && arms[first].left == arms[first + 1].right &&
        arms[first].right == arms[first + 1].left) {
        const bool first_is_next = is_left(arms[first].left, arms[first].right);
        const InterfaceArm& ahead = arms[first_is_next ? first : first + 1];
        previous_[i] = arms[first_is_next ? first + 1 : first].neighbour;
        next_[i] = ahead.neighbour;
        left_[i] = ahead.left;
        right_[i] = ahead.right;
        arms.resize(first);
    } else {
        previous_[i] = no_id;
        next_[i] = no_id;
        left_[i] = border_phase;
        right_[i] = border_phase;
        flags |= interface_junction;
        found.indices.push_back(static_cast<std::uint32_t>(i));
        found.begin.push_back(static_cast<std::uint32_t>(first));
    }
    flags_[i] = static_cast<std::uint8_t>(flags);
}

template <class Real>
void InterfaceGraph<Real>::join() {
    junctions_.indices.clear();
    junctions_.begin.clear();
    junctions_.arms.clear();
    for (const Junctions& found : found_) {
        const auto before = static_cast<std::uint32_t>(junctions_.arms.size());
        for (std::size_t k = 0; k < found.indices.size(); ++k) {
            junctions_.indices.push_back(found.indices[k]);
            junctions_.begin.push_back(before + found.begin[k]);
        }
        junctions_.arms.insert(junctions_.arms.end(), found.arms.begin(), found.arms.end());
    }
    junctions_.begin.push_back(static_cast<std::uint32_t>(junctions_.arms.size()));
}

template <class Real>
void InterfaceGraph<Real>::build(Complex<Real>& complex, std::span<const std::uint32_t> list) {
    resize(list.size(), 1);
    number(complex, list, 0);
    connect(complex, 0, 0, list.size());
    join();
}

template <class Real>
InterfaceView<Real> InterfaceGraph<Real>::view(const Complex<Real>& complex,
                                               std::span<const Point<Real>> positions) const {
    return {.complex = complex,
            .vertices = vertices_,
            .positions = positions,
            .previous = previous_,
            .next = next_,
            .left = left_,
            .right = right_,
            .flags = flags_,
            .junctions = junctions_.indices,
            .arm_begin = junctions_.begin,
            .arms = junctions_.arms};
}

template class InterfaceGraph<double>;
template class InterfaceGraph<float>;

} // namespace dsc

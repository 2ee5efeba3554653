// SPDX-License-Identifier: MIT
// The complex as it would be if all pending vertices had arrived.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// A tet below this quality at the targets is taken for inverted.
inline constexpr Real inverted_quality = 1e-4;

/// While it lives, the vertices that have not arrived are at their targets.
class PendingAtTargets : public dsc::Unmovable {
public:
    explicit PendingAtTargets(PassState& state) : state_(state) {
        for (const std::uint32_t v : state_.pending) {
            enter(v);
        }
    }
    ~PendingAtTargets() {
        for (const std::uint32_t v : state_.pending) {
            state_.complex.vertices[v].position = state_.moving[v].origin;
        }
    }
    /// Gives one more vertex a target.
    void add(std::uint32_t v, const Point& target) {
        state_.targets[v] = target;
        state_.pending.push_back(v);
        enter(v);
    }

private:
    void enter(std::uint32_t v) {
        state_.moving[v].origin = state_.complex.at(v);
        state_.complex.vertices[v].position = state_.targets[v];
    }

    PassState& state_;
};

} // namespace dsc3

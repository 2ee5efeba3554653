// SPDX-License-Identifier: MIT
#include "dsc3/passes/movement.h"

#include "dsc3/geometry/tet.h"

#include <cmath>

namespace dsc3 {

namespace {

// A move must keep this fraction of a tet's quality.
constexpr Real kept_quality = 0.7;
// After this number of halvings a vertex stays, so that the roll-back ends.
constexpr std::uint32_t halvings = 4;

class Movement {
public:
    Movement(PassState& state, Real move_quality)
        : state_(state), complex_(state.complex), moving_(state.moving),
          move_quality_(move_quality) {}

    void run() {
        begin();
        find_layers();
        go();
        roll_back();
        end();
    }

private:
    [[nodiscard]] bool moves(std::uint32_t v) const { return moving_[v].stamp == state_.pass; }
    [[nodiscard]] bool touches(const TetRecord& tet) const {
        return moves(tet.v[0]) || moves(tet.v[1]) || moves(tet.v[2]) || moves(tet.v[3]);
    }
    void enter(std::uint32_t v) {
        moving_[v].stamp = state_.pass;
        moving_[v].origin = complex_.at(v);
        moving_[v].fraction = 1;
        state_.moving_vertices.push_back(v);
    }
    void enter_tet(std::uint32_t t) {
        if (state_.tet_stamps[t] != state_.pass) {
            state_.tet_stamps[t] = state_.pass;
            state_.near.push_back(t);
        }
    }

    void begin() {
        state_.grow();
        if (++state_.pass == 0) { // the counter wrapped around: old stamps would look new
            state_.moving.assign(state_.moving.size(), {});
            state_.tet_stamps.assign(state_.tet_stamps.size(), 0);
            state_.pass = 1;
        }
        state_.moving_vertices.clear();
        state_.near.clear();
        for (const std::uint32_t v : state_.pending) {
            enter(v);
            moving_[v].way = state_.targets[v] - complex_.at(v);
            enter_tet(tet_of(complex_.vertices[v].corner));
        }
    }

    // Lists the tets of the moving vertices.
    void flood(std::size_t first) {
        for (std::size_t k = first; k < state_.near.size(); ++k) {
            for (const Corner corner : complex_.tets[state_.near[k]].n) {
                const std::uint32_t t = tet_of(corner);
                if (t != border_tet && state_.tet_stamps[t] != state_.pass &&
                    touches(complex_.tets[t])) {
                    enter_tet(t);
                }
            }
        }
    }

    // Each layer follows the mean of its neighbours in the layers before.
    void find_layers() {
        const int layers = state_.options.layers;
        std::size_t seen = 0; // tets whose vertices have been visited
        flood(0);
        for (int layer = 0; layer < layers; ++layer) {
            auto& followers = state_.listed;
            followers.clear();
            for (std::size_t k = seen; k < state_.near.size(); ++k) {
                ask(complex_.tets[state_.near[k]]);
            }
            const std::size_t before = seen;
            seen = state_.near.size();
            const Real share = Real(layers - layer) / (layers + 1 - layer);
            for (const std::uint32_t v : followers) {
                moving_[v].way *= share / static_cast<Real>(moving_[v].changed);
                enter(v);
            }
            flood(before);
        }
    }
    void ask(const TetRecord& tet) {
        for (const std::uint32_t v : tet.v) {
            if (moves(v) ||
                (complex_.vertices[v].flags & (vertex_interface | vertex_boundary)) != 0) {
                continue;
            }
            MovingVertex& follower = moving_[v];
            if (follower.stamp != ~state_.pass) {
                follower.stamp = ~state_.pass; // listed, and not moving yet
                follower.changed = 0;
                follower.way.setZero();
                state_.listed.push_back(v);
            }
            for (const std::uint32_t w : tet.v) {
                if (moves(w)) {
                    follower.way += moving_[w].way;
                    ++follower.changed;
                }
            }
        }
    }

    void go() {
        for (const std::uint32_t v : state_.moving_vertices) {
            MovingVertex& one = moving_[v];
            one.changed = 0;
            one.wanted = 0;
            complex_.vertices[v].position = one.origin + one.way;
            complex_.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
        for (const std::uint32_t v : state_.pending) { // without rounding
            complex_.vertices[v].position = state_.targets[v];
        }
        ++complex_.version;
    }

    void roll_back() {
        state_.near_quality.resize(state_.near.size());
        for (std::uint32_t round = 0;; ++round) {
            auto& blocked = state_.listed;
            blocked.clear();
            for (std::size_t k = 0; k < state_.near.size(); ++k) {
                const TetRecord& tet = complex_.tets[state_.near[k]];
                if (round > 0 && !was_changed(tet, round)) {
                    continue;
                }
                const Real quality = quality_of(complex_, state_.near[k]);
                state_.near_quality[k] = quality;
                if (quality >= move_quality_ ||
                    (quality > quality_floor && quality >= kept_quality * quality_before(tet))) {
                    continue;
                }
                for (const std::uint32_t v : tet.v) {
                    MovingVertex& one = moving_[v];
                    if (moves(v) && one.fraction > 0 && one.wanted != round + 1) {
                        one.wanted = round + 1;
                        blocked.push_back(v);
                    }
                }
            }
            if (blocked.empty()) {
                return;
            }
            for (const std::uint32_t v : blocked) {
                MovingVertex& one = moving_[v];
                one.fraction = round < halvings ? one.fraction / 2 : 0;
                one.changed = round + 1;
                complex_.vertices[v].position =
                    one.fraction == 0 ? one.origin
                                      : Point(one.origin + Real(one.fraction) * one.way);
            }
        }
    }
    [[nodiscard]] bool was_changed(const TetRecord& tet, std::uint32_t round) const {
        for (const std::uint32_t v : tet.v) {
            if (moves(v) && moving_[v].changed == round) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] Real quality_before(const TetRecord& tet) const {
        std::array<const Point*, 4> p{};
        for (std::uint32_t i = 0; i < 4; ++i) {
            p[i] = moves(tet.v[i]) ? &moving_[tet.v[i]].origin : &complex_.at(tet.v[i]);
        }
        return quality(*p[0], *p[1], *p[2], *p[3]);
    }

    void end() {
        for (std::size_t k = 0; k < state_.near.size(); ++k) {
            if (state_.near_quality[k] < state_.options.quality) {
                state_.unfit.push_back(state_.near[k]);
            }
        }
        std::erase_if(state_.pending, [&](std::uint32_t v) { return moving_[v].fraction == 1; });
    }

    PassState& state_;
    Complex& complex_;
    std::vector<MovingVertex>& moving_;
    Real move_quality_;
};

} // namespace

void move_vertices(PassState& state, Real move_quality) { Movement(state, move_quality).run(); }

} // namespace dsc3

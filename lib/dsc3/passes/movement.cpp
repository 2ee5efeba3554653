// SPDX-License-Identifier: MIT
#include "dsc3/passes/movement.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc3 {

namespace {

// A move must keep this fraction of a tet's quality.
constexpr Real kept_quality = 0.7;
// Values of `PassState::moves`. The second marks vertices that went back in the last round.
constexpr std::uint8_t is_moving = 1;
constexpr std::uint8_t went_back = 2;
// After this number of halvings a vertex stays, so that the roll-back ends.
constexpr std::uint32_t halvings = 4;

class Movement {
public:
    Movement(PassState& state, Real move_quality)
        : state_(state), complex_(state.complex), team_(state.team), moves_(state.moves),
          moving_(state.moving), move_quality_(move_quality) {}

    void run() {
        try {
            begin();
            for (int layer = 0; layer < state_.options.layers; ++layer) {
                add_layer(layer);
            }
            list_near();
            go();
            roll_back();
            end();
        } catch (...) { // out of memory: no vertex may look as if it moved in the next pass
            std::fill(moves_.begin(), moves_.end(), std::uint8_t{0});
            throw;
        }
    }

private:
    // Smallest chunks: of vertices or tets that are known, and of tets that are only looked at.
    static constexpr std::size_t grain = 256;
    static constexpr std::size_t scan_grain = 2048;

    // Calls `work(k, chunk)` for k below n, shared by the threads; returns the number of chunks.
    template <class Work>
    std::uint32_t for_each(std::size_t n, Work work) {
        return team_.chunks(
            n, grain, [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t) {
                for (std::size_t k = begin; k < end; ++k) {
                    work(k, chunk);
                }
            });
    }
    // Calls `work(tet, chunk, thread)` for tets of which some have a vertex that moves; returns the
    // number of chunks. If few vertices move, these are the listed tets since `seen_`; otherwise
    // all tets are looked at.
    template <class Work>
    std::uint32_t scan(Work work) {
        const std::size_t first = is_dense_ ? 0 : seen_;
        const std::size_t count = (is_dense_ ? complex_.tets.size() : state_.near.size()) - first;
        return team_.chunks(
            count, scan_grain,
            [&](std::uint32_t chunk, std::size_t begin, std::size_t end, std::uint32_t thread) {
                for (std::size_t k = first + begin; k < first + end; ++k) {
                    const std::uint32_t t =
                        is_dense_ ? static_cast<std::uint32_t>(k) : state_.near[k];
                    if (complex_.tets[t].v[0] != no_id) {
                        work(t, chunk, thread);
                    }
                }
            });
    }
    [[nodiscard]] int any_of_moves(const TetRecord& tet) const {
        return moves_[tet.v[0]] | moves_[tet.v[1]] | moves_[tet.v[2]] | moves_[tet.v[3]];
    }
    [[nodiscard]] bool touches(const TetRecord& tet) const { return any_of_moves(tet) != 0; }
    void enter_tet(std::uint32_t t) {
        if (state_.tet_stamps[t] != state_.pass) {
            state_.tet_stamps[t] = state_.pass;
            state_.near.push_back(t);
        }
    }
    // Lists the tets with a vertex that moves, from those listed since `first`.
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
    void clear(ByChunk<std::uint32_t>& lists) {
        for (auto& list : lists) {
            list.clear();
        }
    }

    void enter(std::uint32_t v) {
        moves_[v] = is_moving;
        moving_[v].origin = complex_.at(v);
        moving_[v].fraction = 1;
    }

    void begin() {
        state_.grow();
        for_each(state_.pending.size(), [&](std::size_t k, std::uint32_t) {
            const std::uint32_t v = state_.pending[k];
            enter(v);
            moving_[v].way = state_.targets[v] - complex_.at(v);
        });
        state_.moving_vertices = state_.pending;
        state_.near.clear();
        is_dense_ = state_.is_dense(state_.pending.size());
        if (++state_.pass == 0) { // the counter wrapped around: old stamps would look new
            state_.tet_stamps.assign(state_.tet_stamps.size(), 0);
            state_.pass = 1;
        }
        if (!is_dense_) {
            for (const std::uint32_t v : state_.pending) {
                enter_tet(tet_of(complex_.vertices[v].corner));
            }
            flood(0);
        }
    }

    // Each layer follows the mean of its neighbours in the layers before. Sums are formed chunk by
    // chunk, so that rounding does not depend on the threads.
    void add_layer(int layer) {
        for (auto& list : state_.followers) {
            list.clear();
        }
        const std::uint32_t chunks = scan([&](std::uint32_t t, std::uint32_t chunk,
                                              std::uint32_t thread) {
            add_followers(complex_.tets[t], state_.followers[chunk], state_.threads[thread].places);
        });
        const std::size_t before = seen_;
        seen_ = state_.near.size();
        auto& listed = state_.listed;
        listed.clear();
        for (std::uint32_t chunk = 0; chunk < chunks; ++chunk) {
            for (const Follower& part : state_.followers[chunk]) {
                MovingVertex& sum = moving_[part.vertex];
                if (moves_[part.vertex] == 0) {
                    moves_[part.vertex] = is_moving;
                    listed.push_back(part.vertex);
                    sum.way = part.way;
                    sum.leaders = part.count;
                } else {
                    sum.way += part.way;
                    sum.leaders += part.count;
                }
            }
        }
        const int layers = state_.options.layers;
        const Real share = Real(layers - layer) / (layers + 1 - layer);
        for_each(listed.size(), [&](std::size_t k, std::uint32_t) {
            const std::uint32_t v = listed[k];
            moving_[v].way *= share / static_cast<Real>(moving_[v].leaders);
            keep_on_sides(moving_[v].way, Point::Zero(), complex_.vertices[v].flags);
            enter(v);
        });
        state_.moving_vertices.insert(state_.moving_vertices.end(), listed.begin(), listed.end());
        if (!is_dense_) {
            flood(before);
        }
    }
    void add_followers(const TetRecord& tet, std::vector<Follower>& followers,
                       std::vector<std::uint32_t>& places) {
        const auto& v = tet.v;
        const std::array<std::uint8_t, 4> moves{moves_[v[0]], moves_[v[1]], moves_[v[2]],
                                                moves_[v[3]]};
        const int count = moves[0] + moves[1] + moves[2] + moves[3];
        if (count == 0 || count == 4) {
            return;
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t flags = complex_.vertices[v[i]].flags;
            if (moves[i] != 0 || (flags & vertex_interface) != 0) {
                continue;
            }
            // A vertex on a side follows those that move along this side.
            const auto leads = [&](std::uint32_t j) {
                return moves[j] != 0 &&
                       ((flags & vertex_boundary) == 0 ||
                        (flags & complex_.vertices[v[j]].flags & vertex_boundary) != 0);
            };
            const auto leaders =
                static_cast<std::uint32_t>(leads(0) + leads(1) + leads(2) + leads(3));
            if (leaders == 0) {
                continue;
            }
            // An entry is valid if the list confirms it, so nothing has to be reset.
            std::uint32_t& place = places[v[i]];
            if (place >= followers.size() || followers[place].vertex != v[i]) {
                place = static_cast<std::uint32_t>(followers.size());
                followers.push_back({Point::Zero(), v[i], 0});
            }
            for (std::uint32_t j = 0; j < 4; ++j) {
                if (leads(j)) {
                    followers[place].way += moving_[v[j]].way;
                }
            }
            followers[place].count += leaders;
        }
    }

    // Lists all tets with a vertex that moves.
    void list_near() {
        if (!is_dense_) {
            return;
        }
        clear(state_.lists);
        clear(state_.lists_beyond);
        const std::uint32_t chunks = scan([&](std::uint32_t t, std::uint32_t chunk, std::uint32_t) {
            const auto& v = complex_.tets[t].v;
            if (!touches(complex_.tets[t])) {
                return;
            }
            const bool is_beside = std::any_of(v.begin(), v.end(), [&](std::uint32_t x) {
                return complex_.is_interface(Vertex{x});
            });
            (is_beside ? state_.lists : state_.lists_beyond)[chunk].push_back(t);
        });
        append_chunks(state_.near, state_.lists, chunks); // in this order they are repaired
        append_chunks(state_.near, state_.lists_beyond, chunks);
    }

    void go() {
        for_each(state_.moving_vertices.size(), [&](std::size_t k, std::uint32_t) {
            const std::uint32_t v = state_.moving_vertices[k];
            MovingVertex& one = moving_[v];
            one.wanted = 0;
            complex_.vertices[v].position = // without rounding, if it has a target
                k < state_.pending.size() ? state_.targets[v] : Point(one.origin + one.way);
            complex_.vertices[v].flags &= ~static_cast<std::uint32_t>(vertex_settled);
        });
        ++complex_.version;
    }

    void roll_back() {
        state_.near_quality.resize(state_.near.size());
        for (std::uint32_t round = 0;; ++round) {
            clear(state_.lists);
            const std::uint32_t chunks =
                for_each(state_.near.size(), [&](std::size_t k, std::uint32_t chunk) {
                    look(k, round, state_.lists[chunk]);
                });
            auto& blocked = state_.listed;
            if (round > 0) {
                for (const std::uint32_t v : blocked) {
                    moves_[v] = is_moving;
                }
            }
            blocked.clear();
            for (std::uint32_t chunk = 0; chunk < chunks; ++chunk) {
                for (const std::uint32_t v : state_.lists[chunk]) {
                    if (moving_[v].wanted != round + 1) {
                        moving_[v].wanted = round + 1;
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
                moves_[v] = is_moving | went_back;
                complex_.vertices[v].position =
                    one.fraction == 0 ? one.origin
                                      : Point(one.origin + Real(one.fraction) * one.way);
            }
        }
    }
    // Lists the vertices of a tet that have to go back.
    void look(std::size_t k, std::uint32_t round, std::vector<std::uint32_t>& blocked) {
        const TetRecord& tet = complex_.tets[state_.near[k]];
        if (round > 0 && (any_of_moves(tet) & went_back) == 0) {
            return;
        }
        const Real quality = quality_of(complex_, state_.near[k]);
        state_.near_quality[k] = quality;
        if (quality >= move_quality_ ||
            (quality > quality_floor && quality >= kept_quality * quality_before(tet))) {
            return;
        }
        for (const std::uint32_t v : tet.v) {
            if (moves_[v] != 0 && moving_[v].fraction > 0) {
                blocked.push_back(v);
            }
        }
    }
    [[nodiscard]] Real quality_before(const TetRecord& tet) const {
        std::array<const Point*, 4> p{};
        for (std::uint32_t i = 0; i < 4; ++i) {
            p[i] = moves_[tet.v[i]] != 0 ? &moving_[tet.v[i]].origin : &complex_.at(tet.v[i]);
        }
        return quality(*p[0], *p[1], *p[2], *p[3]);
    }

    void end() {
        for_each(state_.moving_vertices.size(),
                 [&](std::size_t k, std::uint32_t) { moves_[state_.moving_vertices[k]] = 0; });
        clear(state_.lists);
        const std::uint32_t chunks =
            for_each(state_.near.size(), [&](std::size_t k, std::uint32_t chunk) {
                if (state_.near_quality[k] < state_.options.quality) {
                    state_.lists[chunk].push_back(state_.near[k]);
                }
            });
        append_chunks(state_.unfit, state_.lists, chunks);
        std::erase_if(state_.pending, [&](std::uint32_t v) { return moving_[v].fraction == 1; });
    }

    PassState& state_;
    Complex& complex_;
    Team& team_;
    std::vector<std::uint8_t>& moves_;
    std::vector<MovingVertex>& moving_;
    Real move_quality_;
    bool is_dense_ = true;
    std::size_t seen_ = 0; ///< listed tets whose vertices have been looked at
};

} // namespace

void move_vertices(PassState& state, Real move_quality) { Movement(state, move_quality).run(); }

} // namespace dsc3

// SPDX-License-Identifier: MIT
#include "topology/films/remnants.h"

#include "topology/films/last_piece.h"
#include "topology/fronts/division.h"
#include "topology/junctions/sectors.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace dsc {

namespace {

template <class Real>
class Remnants {
public:
    explicit Remnants(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), min_area_(min_area(work)),
          max_triangles_(most_of(min_area_ / (work.edge_length * work.edge_length))) {}

    void run(std::span<const Candidate> candidates) {
        for (const Corner c : outlines_at(candidates)) {
            if (complex_.is_alive(Triangle{triangle_of(c)}) &&
                is_outline(complex_, c)) { // it may have vanished since
                visit(c);
            }
        }
    }

private:
    // The largest number of triangles of a small piece, unless their edges are very short; `area`
    // is the smallest area, in squared edge lengths.
    static std::size_t most_of(Real area) {
        constexpr Real largest = 1e6;
        return static_cast<std::size_t>(static_cast<Real>(max_share_of_piece) *
                                        std::clamp(area, Real(1), largest));
    }

    // The half-edges of outlines that start at the vertices, in the order of their positions.
    std::vector<Corner> outlines_at(std::span<const Candidate> candidates) const {
        std::vector<std::tuple<Real, Real, Corner>> found;
        const auto look = [this](const Candidate& candidate, auto& outlines) {
            const std::uint32_t v = candidate.vertex;
            if (!candidate.is_sharp || !complex_.is_alive(Vertex{v})) {
                return;
            }
            (void)find_corner(complex_, Vertex{v}, [&](Corner at) {
                const Corner c = prev(at); // the half-edge that starts at v
                if (is_sheet(complex_, c) && may_be_small(at)) {
                    const Point<Real> place = centroid(complex_, Triangle{triangle_of(c)});
                    outlines.emplace_back(place.x(), place.y(), c);
                }
                return false; // visits all corners
            });
        };
        find_at(work_.in_shares, candidates, found, look);
        std::ranges::sort(found);
        std::vector<Corner> list;
        for (const auto& one : found) {
            list.push_back(std::get<2>(one));
        }
        return list;
    }

    // Whether the triangles of the phase around this one have less than the smallest area together.
    // A few triangles exclude nearly every piece, long before its outline has been followed.
    bool may_be_small(Corner at) const {
        constexpr std::size_t handful = 16;
        const Phase phase = complex_.phase_at(at);
        std::array<std::uint32_t, handful> seen{};
        std::size_t size = 0;
        Real doubled = 0;
        const auto add = [&](std::uint32_t t) {
            seen[size++] = t;
            doubled += doubled_area(complex_, Triangle{t});
        };
        add(triangle_of(at));
        for (std::size_t i = 0; i < size; ++i) {
            for (const Corner across : complex_.triangles[seen[i]].n) {
                const std::uint32_t t = triangle_of(across);
                const auto end = seen.begin() + static_cast<std::ptrdiff_t>(size);
                if (size < handful && complex_.triangles[t].phase == phase &&
                    std::find(seen.begin(), end, t) == end) {
                    add(t);
                }
            }
            if (doubled / 2 >= min_area_) {
                return false;
            }
        }
        return true;
    }

    // Collects the triangles of a piece. As a piece may be a large part of the complex, it is
    // followed only up to the smallest area, and only once for all vertices on it.
    bool gather_small_piece(Triangle start) {
        const std::size_t number = ++pieces_;
        const Phase phase = complex_.phase(start);
        if (!piece_of_.try_emplace(start.id, number).second) {
            return false;
        }
        piece_.assign(1, start);
        edges_ = 0;
        Real doubled = 0;
        for (std::size_t i = 0; i < piece_.size(); ++i) {
            doubled += doubled_area(complex_, piece_[i]);
            if (doubled / 2 >= min_area_ || piece_.size() > max_triangles_) {
                return false;
            }
            for (std::uint32_t k = 0; k < 3; ++k) {
                const Corner across = complex_.twin(corner_of(piece_[i].id, k));
                const Triangle t{triangle_of(across)};
                if (complex_.phase_at(across) != phase) {
                    ++edges_;
                } else if (const auto [at, is_new] = piece_of_.try_emplace(t.id, number); is_new) {
                    piece_.push_back(t);
                } else if (at->second != number) {
                    return false; // already followed from another vertex
                }
            }
        }
        return true;
    }

    void visit(Corner start) {
        if (!gather_small_piece(Triangle{triangle_of(start)})) {
            return;
        }
        outline_.clear();
        Corner c = start;
        do {
            outline_.push_back(c);
            c = along_outline(complex_, c);
        } while (c != start && outline_.size() < edges_);
        // If the piece has more edges than this outline, another phase lies inside it.
        if (outline_.size() != edges_) {
            return;
        }
        const Phase phase = complex_.phase_at(start);
        find_heirs();
        if (heirs_.empty()) {
            return;
        }
        const Phase to = heirs_.front();
        Event event{.kind = phase == exterior_phase ? EventKind::fill : EventKind::remove,
                    .time = work_.time,
                    .lost = phase,
                    .taken = {to, to}};
        for (const Triangle t : piece_) {
            const auto area = static_cast<double>(doubled_area(complex_, t)) / 2;
            const Point<Real> place = centroid(complex_, t);
            event.area += area;
            event.x += area * static_cast<double>(place.x());
            event.y += area * static_cast<double>(place.y());
        }
        event.x /= event.area;
        event.y /= event.area;
        if (!meet_in_points(phase)) {
            heirs_.resize(1);
        }
        const Closing closing =
            heirs_.size() == 1 ? Closing::impossible
                               : close_last_piece<Real>(work_, piece_, outline_, heirs_.size());
        if (closing == Closing::later) {
            return;
        }
        if (closing == Closing::impossible) {
            std::erase_if(piece_, [&](Triangle t) {
                return !complex_.is_alive(t) || complex_.phase(t) != phase;
            });
            for (const Share& share : divide_by_arrival<Real>(work_, piece_, heirs_)) {
                give(work_, share.triangle, share.to);
            }
        }
        work_.events.push_back(event);
        piece_of_.clear(); // the piece is now a part of another one
    }

    // The phases into which the piece may vanish. That with the longest share of the outline comes
    // first, and of two equal ones that with the smaller number.
    void find_heirs() {
        std::vector<std::pair<Phase, Real>> lengths;
        const Phase phase = complex_.phase_at(outline_.front());
        for (const Corner c : outline_) {
            const Corner across = complex_.twin(c);
            const Phase other = complex_.phase_at(across);
            if (is_border(across) || !may_change(work_, phase, other)) {
                continue;
            }
            const auto at = std::ranges::find(lengths, other, &std::pair<Phase, Real>::first);
            auto& entry = at != lengths.end() ? *at : lengths.emplace_back(other, Real(0));
            entry.second += direction(complex_, c).norm();
        }
        std::ranges::sort(lengths, [](const auto& one, const auto& other) {
            return std::pair(-one.second, one.first) < std::pair(-other.second, other.first);
        });
        heirs_.clear();
        for (const auto& one : lengths) {
            heirs_.push_back(one.first);
        }
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Real min_area_;
    std::size_t max_triangles_;
    std::vector<Corner> outline_;
    std::vector<Triangle> piece_;                             ///< of the last piece
    std::vector<Phase> heirs_;                                ///< of the last piece
    std::size_t edges_ = 0;                                   ///< of all its outlines
    std::size_t pieces_ = 0;                                  ///< that have been followed
    std::unordered_map<std::uint32_t, std::size_t> piece_of_; ///< by triangle
};

} // namespace

template <class Real>
void remove_remnants(TopologyWork<Real>& work, std::span<const Candidate> candidates) {
    Remnants<Real>(work).run(candidates);
}

template void remove_remnants(TopologyWork<double>&, std::span<const Candidate>);
template void remove_remnants(TopologyWork<float>&, std::span<const Candidate>);

} // namespace dsc

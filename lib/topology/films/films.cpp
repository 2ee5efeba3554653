// SPDX-License-Identifier: MIT
#include "topology/films/films.h"

#include "topology/films/bridge.h"

#include <algorithm>
#include <tuple>

namespace dsc {

namespace {

/// Cosine of the largest angle between two sheets that meet at the end of a seam. Three successive
/// vertices of one curve have a larger one.
constexpr double seam_angle = 0.5;
/// A piece whose mean thickness is less than this many contact distances is the rest of a film that
/// has opened at its ends. Oblique triangles are thinner than their film, by half at most.
constexpr double rest_of_film = 2.5;
/// A relative slack of thicknesses, larger than their rounding errors.
constexpr double thickness_slack = 1e-3;

template <class Real>
class Films {
public:
    explicit Films(TopologyWork<Real>& work) : work_(work), complex_(work.complex) {
        const Real contact =
            std::min(largest_contact(work.options, work.edge_length),
                     static_cast<Real>(max_contact_of_triangles) * work.edge_length);
        max_squared_ = static_cast<Real>(1 + thickness_slack) * contact * contact;
    }

    void run(std::span<const Candidate> candidates, std::span<const Candidate> notable) {
        // The notes on stars that face a sheet are valid only if nothing has changed since.
        if (work_.touched.empty()) {
            find_near(notable, &Candidate::is_facing);
        } else {
            find_near(candidates, &Candidate::is_thin);
        }
        if (near_.empty()) {
            return;
        }
        Bridge<Real> bridge{};
        const std::size_t before = work_.events.size();
        const auto opens = [&](Triangle t) { return find_bridge(work_, candidates, t, bridge); };
        for (const Triangle t : thin_triangles(opens)) {
            if (is_thin(work_, t) && opens(t)) { // earlier openings may have closed it
                open(bridge);
            }
        }
        if (!work_.options.follows_seams) {
            return;
        }
        // Continues seams of earlier events, whose sheets have come closer since, and of the new
        // events.
        if (work_.events.size() != before) {
            find_near(candidates, &Candidate::is_thin);
        }
        const auto goes_on = [&](Triangle t) { return is_end_of_seam(t); };
        for (const Triangle t : thin_triangles(goes_on)) {
            if (is_thin(work_, t) && is_end_of_seam(t)) {
                follow_seam(t);
            }
        }
    }

private:
    // --- candidates ---------------------------------------------------------------------------
    // Each triangle that bridges a film has a vertex on one of its sheets and the opposite edge on
    // the other; so has the end of a seam. Before the first event almost no interface vertex has
    // such a triangle.
    void find_near(std::span<const Candidate> candidates, bool Candidate::*may_be) {
        near_.clear();
        for (const auto& candidate : candidates) {
            if (!(candidate.*may_be) || !complex_.is_alive(Vertex{candidate.vertex})) {
                continue;
            }
            (void)find_corner(complex_, Vertex{candidate.vertex}, [&](Corner c) {
                if (is_sheet(complex_, c) && !is_thick(c) && !is_plain_ear(c)) {
                    near_.push_back(Triangle{triangle_of(c)});
                }
                return false; // all of them, in any order
            });
        }
    }

    // Whether the triangle lies between two successive edges of one sheet, away from seams, with no
    // blocked vertex: it bridges no film, and is not the end of a seam.
    bool is_plain_ear(Corner c) const {
        const auto is_plain = [&](std::uint32_t v) {
            return !is_seam(v) && (complex_.vertices[v].flags & vertex_contact) == 0;
        };
        return (is_sheet(complex_, next(c)) || is_sheet(complex_, prev(c))) &&
               is_plain(complex_.vertex(c)) && is_plain(complex_.vertex(next(c))) &&
               is_plain(complex_.vertex(prev(c)));
    }

    // The thin triangles in the order of their positions, which does not depend on the division of
    // the mesh.
    template <class Test>
    std::vector<Triangle> thin_triangles(Test test) const {
        std::vector<std::tuple<Real, Real, std::uint32_t>> found;
        for (const Triangle t : near_) {
            if (complex_.is_alive(t) && test(t) && is_thin(work_, t)) {
                const Point<Real> place = centroid(complex_, t);
                found.emplace_back(place.x(), place.y(), t.id);
            }
        }
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        std::vector<Triangle> list;
        for (const auto& one : found) {
            list.push_back(Triangle{std::get<2>(one)});
        }
        return list;
    }

    // Thicker than any contact distance: `is_thin` would say no. The squares of thickness and
    // contact are compared, both times the longest edge squared.
    bool is_thick(Corner c) const {
        const Point<Real> a = direction(complex_, c);
        const Point<Real> b = direction(complex_, next(c));
        const Real doubled = cross<Real>(a, b);
        const Real longest =
            std::max(std::max(a.squaredNorm(), b.squaredNorm()), (a + b).squaredNorm());
        return doubled * doubled > max_squared_ * longest;
    }

    // --- events -------------------------------------------------------------------------------
    // If both sheets are on one outline of the film, the film splits into two pieces; if they are
    // on two outlines, these become one. If one of the two pieces is too small to stay, the bridge
    // belongs to a seam ahead of its end, or to the end of a filament, and `pocket_` is set to that
    // piece. A larger piece that is thin everywhere is the rest of a film that has opened at its
    // other end: the seam will close it.
    EventKind kind_of(const Bridge<Real>& bridge, Phase one, Phase other) {
        pocket_.clear();
        const auto [first, second] = bridge.sheets;
        Area ahead{};
        Area behind{};
        bool is_same = false;
        Area* side = &ahead;
        const Point<Real> origin = complex_.position(Vertex{complex_.vertex(first)});
        for (Corner c = along_outline(complex_, first); c != first;
             c = along_outline(complex_, c)) {
            if (c == second) {
                is_same = true;
                side = &behind;
                continue;
            }
            add(c, origin, *side);
        }
        if (is_same) {
            // The bridge, whose area is negligible, closes the outline on each side. A side that
            // encloses the outside has a negative area.
            const bool is_ahead =
                ahead.doubled > 0 && !(behind.doubled > 0 && behind.doubled < ahead.doubled);
            const Area& smaller = is_ahead ? ahead : behind;
            if (smaller.doubled > 0 && smaller.doubled / 2 < min_area(work_)) {
                pocket_ = smaller.at;
                return smaller.on_seam
                           ? EventKind::widen
                           : (complex_.phase_at(first) == exterior_phase ? EventKind::fill
                                                                         : EventKind::remove);
            }
            const Real contact = std::max(contact_at(work_, first), contact_at(work_, second));
            if (is_rest_of_film(ahead, contact) || is_rest_of_film(behind, contact)) {
                return EventKind::widen;
            }
        }
        if (one != other) {
            return EventKind::meet;
        }
        return is_same ? EventKind::split : EventKind::merge;
    }

    struct Area {
        Real doubled = 0;
        Real perimeter = 0;
        std::vector<Triangle> at; ///< the first few
        bool on_seam = false;
    };

    void add(Corner c, const Point<Real>& origin, Area& area) const {
        const std::uint32_t v = complex_.vertex(next(c));
        const Point<Real> from = complex_.position(Vertex{v}) - origin;
        const Point<Real> way = direction(complex_, c);
        area.doubled += cross<Real>(from, way);
        area.perimeter += way.norm();
        if (area.at.size() < max_share_of_piece) {
            area.at.push_back(Triangle{triangle_of(c)});
        }
        area.on_seam = area.on_seam || is_seam(v);
    }

    // The mean thickness of a long piece is its area over half its outline.
    static bool is_rest_of_film(const Area& piece, Real contact) {
        return piece.on_seam && piece.doubled > 0 &&
               piece.doubled < static_cast<Real>(rest_of_film) * contact * piece.perimeter;
    }

    // Whether the vertex lies on a seam that may extend.
    bool is_seam(std::uint32_t v) const {
        return work_.options.follows_seams && is_on_seam(work_, v);
    }

    void open(const Bridge<Real>& bridge) {
        const Triangle t{triangle_of(bridge.sheets[0])};
        const Triangle u{triangle_of(bridge.sheets[1])};
        const Phase film = complex_.phase(t);
        const Phase one = complex_.phase_at(complex_.twin(bridge.sheets[0]));
        const Phase other = complex_.phase_at(complex_.twin(bridge.sheets[1]));
        const Point<Real> place = (centroid(complex_, t) + centroid(complex_, u)) / Real(2);
        const auto x = static_cast<double>(place.x());
        const auto y = static_cast<double>(place.y());
        const auto& may_change = work_.options.may_change;
        if (may_change && !may_change({.film = film,
                                       .sides = {one, other},
                                       .x = x,
                                       .y = y,
                                       .thickness = static_cast<double>(bridge.thickness)})) {
            return;
        }
        Event event{.kind = kind_of(bridge, one, other),
                    .time = work_.time,
                    .x = x,
                    .y = y,
                    .lost = film,
                    .taken = {one, other}};
        const auto other_area = static_cast<double>(doubled_area(complex_, u));
        event.area = (static_cast<double>(doubled_area(complex_, t)) + other_area) / 2;
        close(t, one);
        close(u, other);
        for (const Triangle end : {t, u}) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                event.area += close_from(complex_.twin(corner_of(end.id, i)), film);
            }
        }
        for (const Triangle rest : pocket_) {
            if (complex_.phase(rest) == film) {
                event.area += give_piece(rest, one);
            }
        }
        work_.events.push_back(event);
    }

    void close(Triangle t, Phase phase) {
        give(work_, t, phase);
        mark_seam(work_, t);
    }

    double give_piece(Triangle start, Phase to) {
        double area = 0;
        gather_piece(complex_, start, piece_);
        if (piece_.size() > max_share_of_piece) {
            return 0;
        }
        for (const Triangle t : piece_) {
            area += static_cast<double>(doubled_area(complex_, t)) / 2;
            close(t, to);
        }
        return area;
    }

    // --- seams --------------------------------------------------------------------------------
    // A triangle that an earlier event has left at the end of its seam: one of its two sheets is
    // the end itself, across the film, or the two meet in a sharp notch there. A notch that is
    // closing counts anywhere.
    bool is_end_of_seam(Triangle t) const {
        std::array<Corner, 3> sheets{};
        if (sheets_of(complex_, t, sheets) != 2) {
            return false;
        }
        for (const Corner c : {sheets[0], sheets[1]}) {
            if (is_seam(complex_.vertex(next(c))) && is_seam(complex_.vertex(prev(c)))) {
                return true;
            }
        }
        // The vertex that both share is opposite to neither.
        const Corner shared = next(sheets[0]) == sheets[1] ? prev(sheets[0]) : next(sheets[0]);
        const Point<Real> a = direction(complex_, sheets[0]);
        const Point<Real> b = direction(complex_, sheets[1]);
        // The two sides of the notch block each other.
        const auto is_blocked = [&](Corner c) {
            const std::uint32_t v = complex_.vertex(next(c) == shared ? prev(c) : next(c));
            return (complex_.vertices[v].flags & vertex_contact) != 0;
        };
        const bool is_closing = is_blocked(sheets[0]) && is_blocked(sheets[1]);
        return (is_closing || is_seam(complex_.vertex(shared))) &&
               -a.dot(b) > static_cast<Real>(seam_angle) * a.norm() * b.norm();
    }

    void follow_seam(Triangle t) {
        const Phase film = complex_.phase(t);
        const Point<Real> place = centroid(complex_, t);
        Event event{.kind = EventKind::widen,
                    .time = work_.time,
                    .x = static_cast<double>(place.x()),
                    .y = static_cast<double>(place.y()),
                    .lost = film};
        if (!is_beside_seam(t) && !may_close(t)) {
            return;
        }
        const Phase taken = close(t);
        if (taken == film) {
            return;
        }
        event.taken = {taken, taken};
        event.area = closed_;
        for (std::uint32_t i = 0; i < 3; ++i) {
            event.area += close_from(complex_.twin(corner_of(t.id, i)), film);
        }
        work_.events.push_back(event);
    }

    [[nodiscard]] bool is_beside_seam(Triangle t) const {
        return std::ranges::any_of(complex_.vertices_of(t),
                                   [this](Vertex v) { return is_seam(v.id); });
    }

    // Whether a notch that no event has made may close. A whole small piece is no notch; it
    // vanishes instead.
    [[nodiscard]] bool may_close(Triangle t) {
        if (is_small_piece(t)) {
            return false;
        }
        std::array<Corner, 3> sheets{};
        (void)sheets_of(complex_, t, sheets);
        const Point<double> place = centroid(complex_, t).template cast<double>();
        return may_open(
            work_, {.film = complex_.phase(t),
                    .sides = {phase_beyond(complex_, sheets[0]), phase_beyond(complex_, sheets[1])},
                    .x = place.x(),
                    .y = place.y(),
                    .thickness = static_cast<double>(thickness(complex_, t))});
    }

    [[nodiscard]] bool is_small_piece(Triangle start) {
        gather_piece(complex_, start, piece_);
        Real doubled = 0;
        for (const Triangle t : piece_) {
            doubled += doubled_area(complex_, t);
        }
        return piece_.size() <= max_share_of_piece && doubled / 2 < min_area(work_);
    }

    // Between a front and the seam with another, or between two fronts: the fronts meet in points.
    [[nodiscard]] static bool is_corner_of_front(Phase film, Phase one, Phase other) {
        return one != other &&
               (meet_in_points(film) || meet_in_points(one) || meet_in_points(other));
    }

    // Closes a triangle that has only one open side left: it goes to the phase beyond its longest
    // sheet. Returns that phase, or its own if it stays; `closed_` is its area.
    Phase close(Triangle t) {
        const Phase film = complex_.phase(t);
        std::array<Corner, 3> sheets{};
        if (!is_thin(work_, t) || sheets_of(complex_, t, sheets) < 2) {
            return film;
        }
        Phase to = film;
        Real longest = -1;
        for (const Corner c : sheets) {
            if (is_border(c) || !(contact_at(work_, c) > 0)) {
                continue;
            }
            if (to != film && is_corner_of_front(film, to, phase_beyond(complex_, c))) {
                return film;
            }
            const Real length = direction(complex_, c).squaredNorm();
            if (length > longest) {
                longest = length;
                to = phase_beyond(complex_, c);
            }
        }
        closed_ = static_cast<double>(doubled_area(complex_, t)) / 2;
        if (to != film) {
            close(t, to);
        }
        return to;
    }

    // Closes the film from this triangle on, as far as the seam extends. Returns the area that was
    // closed.
    double close_from(Corner c, Phase film) {
        double area = 0;
        std::vector<Corner> ahead;
        if (work_.options.follows_seams) {
            ahead.push_back(c);
        }
        while (!ahead.empty()) {
            const Corner here = ahead.back();
            ahead.pop_back();
            const Triangle t{triangle_of(here)};
            if (is_border(here) || complex_.phase(t) != film || close(t) == film) {
                continue;
            }
            area += closed_;
            ahead.push_back(complex_.twin(next(here)));
            ahead.push_back(complex_.twin(prev(here)));
        }
        return area;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Real max_squared_; ///< of the contact distances
    std::vector<Triangle> near_;
    double closed_ = 0;
    std::vector<Triangle> piece_;
    std::vector<Triangle> pocket_;
};

} // namespace

template <class Real>
void open_films(TopologyWork<Real>& work, std::span<const Candidate> candidates,
                std::span<const Candidate> notable) {
    Films<Real>(work).run(candidates, notable);
}

template void open_films(TopologyWork<double>&, std::span<const Candidate>,
                         std::span<const Candidate>);
template void open_films(TopologyWork<float>&, std::span<const Candidate>,
                         std::span<const Candidate>);

} // namespace dsc

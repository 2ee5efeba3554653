// SPDX-License-Identifier: MIT
#include "topology/films/meeting.h"

#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "topology/candidates.h"
#include "topology/films/bridge.h"
#include "topology/junctions/merging.h"
#include "topology/junctions/sectors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace dsc {

namespace {

/// A front sees another within its sector of the film, this far from both of its edges (radians).
constexpr double min_angle = 0.5;
/// A narrower sector (radians) is the end of a seam or the tip of a film, and no front.
constexpr double min_sector = 1.9;
/// Nothing is nearer than this, in edge lengths, where fronts meet within a sub-step.
constexpr double farthest = 1.25;
/// A vertex takes the place of a foot that is nearer than this, in edge lengths.
constexpr double snap = 0.3;
/// Fronts approach if they come closer by this share of their way.
constexpr double min_closing = 0.05;
/// Below this quality vertices inside a phase make room.
constexpr double poor_height = 0.02;
constexpr int max_cleared = 7;
/// Below this one the star is mended at once.
constexpr double slender = 0.1;
/// A pocket beside a seam has no more edges than this on each side.
constexpr int edges_of_pocket = 6;
/// Edges of the domain boundary between the ends of two fronts.
constexpr int edges_along_wall = 4;

/// A vertex of a front, and what it sees across a film.
template <class Real>
struct Sight {
    std::uint32_t v = no_id;
    std::uint32_t q = no_id; ///< a vertex of the other front...
    Corner edge = no_id;     ///< ...or the edge on which its foot lies,
    Real share = 0;          ///< at this share of it
    Real gap = 0;
    Phase film = 0;
    Phase one = 0;                              ///< beyond v
    Phase other = 0;                            ///< beyond q
    Point<Real> normal_v = Point<Real>::Zero(); ///< of the fronts, into the film
    Point<Real> normal_q = Point<Real>::Zero();
    Real speed_v = 0; ///< ways towards each other in the last sub-step
    Real speed_q = 0;
    bool is_on_boundary = false; ///< both lie on the domain boundary
};

template <class Real>
class Meeting {
public:
    Meeting(TopologyWork<Real>& work, std::span<const std::uint32_t> interface, std::uint32_t round)
        : work_(work), complex_(work.complex), submesh_(work.complex), interface_(interface),
          round_(round) {}

    void run() {
        for (const std::uint32_t v : vertices_that_see()) {
            std::vector<std::uint32_t> ahead{v};
            begun_ = work_.events.size();
            // Each that joins takes a vertex away or makes one of an edge, which joins once.
            for (std::size_t left = 8 * interface_.size(); !ahead.empty() && left > 0; --left) {
                const std::uint32_t next = ahead.back();
                ahead.pop_back();
                if (const auto sight = see(next)) {
                    if (const std::uint32_t kept = join(*sight); kept != no_id) {
                        if (work_.options.follows_seams) {
                            add_around(kept, ahead);
                        }
                    }
                }
            }
        }
    }

private:
    // --- search -------------------------------------------------------------------------------
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Those with the smallest gap come first.
    std::vector<std::uint32_t> vertices_that_see() const {
        using Found = std::tuple<Real, Real, Real, std::uint32_t>;
        std::array<std::vector<Found>, ranges_of_places> parts;
        look_in_ranges(work_.in_shares, interface_.size(),
                       [&](std::size_t range, std::size_t begin, std::size_t end) {
                           for (const std::uint32_t v : interface_.subspan(begin, end - begin)) {
                               if (const auto sight = see(v)) {
                                   parts[range].emplace_back(sight->gap, at(v).x(), at(v).y(), v);
                               }
                           }
                       });
        std::vector<Found> found;
        for (const auto& part : parts) {
            found.insert(found.end(), part.begin(), part.end());
        }
        std::ranges::sort(found);
        std::vector<std::uint32_t> list;
        for (const Found& one : found) {
            list.push_back(std::get<3>(one));
        }
        return list;
    }

    // The neighbours of a vertex of a seam, in the order of their places.
    void add_around(std::uint32_t kept, std::vector<std::uint32_t>& ahead) const {
        std::vector<std::tuple<Real, Real, std::uint32_t>> around;
        for (const std::uint32_t w : link_of(kept)) {
            around.emplace_back(at(w).x(), at(w).y(), w);
        }
        around.emplace_back(at(kept).x(), at(kept).y(), kept);
        std::ranges::sort(around, std::greater{});
        for (const auto& one : around) {
            ahead.push_back(std::get<2>(one));
        }
    }

    // Whether the star of an interface vertex reaches another front at all: nearly none does.
    [[nodiscard]] bool may_see(std::uint32_t v) const {
        const Real most = static_cast<Real>(farthest) * work_.edge_length;
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   if (is_sheet(complex_, c)) {
                       return true;
                   }
                   if (is_border(complex_.twin(prev(c)))) {
                       return true;
                   }
                   const std::uint32_t w = complex_.vertex(next(c));
                   return !is_outline(complex_, prev(c)) &&
                          (work_.notes[Vertex{w}].round == round_ || is_on_seam(work_, w)) &&
                          (at(w) - at(v)).norm() < Real(1.5) * most;
               }) != no_id;
    }

    [[nodiscard]] std::optional<Sight<Real>> see(std::uint32_t v) const {
        if (!complex_.is_alive(Vertex{v}) || complex_.vertices[v].corner == no_id || !may_see(v) ||
            is_locked(v)) {
            return {};
        }
        Sectors<Real> sectors;
        find_sectors(complex_, Vertex{v}, sectors);
        std::optional<Sight<Real>> best;
        if (sectors.is_on_boundary) {
            look_along_wall(v, sectors, best);
            return best;
        }
        if (sectors.size() < 2) {
            return {};
        }
        for (std::size_t k = 0; k < sectors.size(); ++k) {
            look_into(v, sectors, k, best);
        }
        return best;
    }

    void look_into(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k,
                   std::optional<Sight<Real>>& best) const {
        const Sector<Real>& sector = sectors[k];
        if (sector.angle < min_sector && !is_pocket(sector)) {
            return;
        }
        Corner c = sector.first;
        for (std::size_t i = 0; i < sector.count; ++i, c = corner_ccw(complex_, c)) {
            if (is_sheet(complex_, c)) {
                look_at_edge(v, sectors, k, c, best);
            }
            if (i + 1 < sector.count) {
                look_at_vertex(v, sectors, k, complex_.vertex(prev(c)), Real(-1), best);
            }
        }
    }

    // A triangle of the film that fronts enclose.
    [[nodiscard]] bool is_pocket(const Sector<Real>& sector) const {
        return sector.count == 1 && is_sheet(complex_, sector.first);
    }

    // 0 where fronts must not meet.
    [[nodiscard]] Real contact(Phase film, Phase other) const {
        const auto rule = rule_of(work_.options, work_.edge_length, film, other);
        return rule.rule != Topology::change ? Real(0)
               : is_wide(rule.contact, work_.edge_length)
                   ? static_cast<Real>(default_contact) * work_.edge_length
                   : rule.contact;
    }

    [[nodiscard]] static bool faces(const Sector<Real>& sector, const Point<Real>& towards) {
        const double angle = angle_between(sector.ray, towards);
        return angle >= min_angle && sector.angle - angle >= min_angle;
    }
    [[nodiscard]] static Point<Real> middle_of(const Sector<Real>& sector) {
        const auto half = static_cast<Real>(sector.angle / 2);
        const Point<Real>& ray = sector.ray;
        return {ray.x() * std::cos(half) - ray.y() * std::sin(half),
                ray.x() * std::sin(half) + ray.y() * std::cos(half)};
    }
    // The phase beyond the side of the sector that a direction in it is nearer to.
    [[nodiscard]] static Phase beyond(const Sectors<Real>& sectors, std::size_t k,
                                      const Point<Real>& towards) {
        return angle_between(sectors[k].ray, towards) < sectors[k].angle / 2
                   ? sectors.before(k).phase
                   : sectors.after(k).phase;
    }

    void look_at_edge(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k, Corner c,
                      std::optional<Sight<Real>>& best) const {
        const Sector<Real>& sector = sectors[k];
        const std::uint32_t a = complex_.vertex(next(c));
        const std::uint32_t b = complex_.vertex(prev(c));
        const Point<Real> way = at(b) - at(a);
        const Real length = way.norm();
        const Real share = (at(v) - at(a)).dot(way) / (length * length);
        if (!(share > 0 && share < 1)) {
            return; // an end is nearer
        }
        const Point<Real> across = at(a) + share * way - at(v);
        const Real gap = across.norm();
        const bool encloses = is_sheet(complex_, next(c)) && is_sheet(complex_, prev(c));
        const Point<Real> towards = across / gap;
        if (best && !(gap < best->gap)) {
            return;
        }
        if (!encloses && !faces(sector, towards)) {
            return;
        }
        const Real near = static_cast<Real>(snap) * work_.edge_length;
        const bool is_first = share < Real(0.5);
        const std::uint32_t end = is_first ? a : b;
        if ((is_first ? share : 1 - share) * length < near && is_inside(sector, end)) {
            look_at_vertex(v, sectors, k, end, gap, best);
            return;
        }
        Sight<Real> sight{.v = v, .edge = c, .share = share, .gap = gap, .film = sector.phase};
        sight.one = beyond(sectors, k, towards);
        sight.other = phase_beyond(complex_, c);
        sight.normal_v = middle_of(sector);
        sight.normal_q = {-way.y() / length, way.x() / length};
        if (closes(sight, towards, encloses)) {
            best = sight;
        }
    }

    // Whether an edge from the sector's vertex to another lies within it.
    [[nodiscard]] bool is_inside(const Sector<Real>& sector, std::uint32_t w) const {
        Corner c = sector.first;
        for (std::size_t i = 0; i + 1 < sector.count; ++i, c = corner_ccw(complex_, c)) {
            if (complex_.vertex(prev(c)) == w) {
                return true;
            }
        }
        return false;
    }

    // `gap`: to a foot near the vertex; negative: to the vertex.
    void look_at_vertex(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k,
                        std::uint32_t q, Real gap, std::optional<Sight<Real>>& best) const {
        const Point<Real> way = at(q) - at(v);
        const Real length = way.norm();
        const Real most = static_cast<Real>(farthest) * work_.edge_length;
        const bool is_at_foot = gap >= 0;
        gap = is_at_foot ? gap : length;
        const Point<Real> towards = way / length;
        if (!(length < Real(1.5) * most) || (best && !(gap < best->gap)) ||
            (!is_at_foot && !faces(sectors[k], towards)) || is_locked(q)) {
            return;
        }
        Sectors<Real> there;
        find_sectors(complex_, Vertex{q}, there);
        if (there.size() < 2 || there.is_on_boundary) {
            return;
        }
        for (std::size_t i = 0; i < there.size(); ++i) {
            const Sector<Real>& sector = there[i];
            const Point<Real> back = -towards;
            if (sector.phase != sectors[k].phase ||
                angle_between(sector.ray, back) >= sector.angle) {
                continue;
            }
            if (sector.angle < min_sector || (!is_at_foot && !faces(sector, back))) {
                return;
            }
            Sight<Real> sight{.v = v, .q = q, .gap = gap, .film = sector.phase};
            sight.one = beyond(sectors, k, towards);
            sight.other = beyond(there, i, back);
            sight.normal_v = middle_of(sectors[k]);
            sight.normal_q = middle_of(sector);
            if (closes(sight, towards, false)) {
                best = sight;
            }
            return;
        }
    }

    // From the end of a front on the domain boundary along it, with the domain on the left, to the
    // end of another.
    void look_along_wall(std::uint32_t v, const Sectors<Real>& sectors,
                         std::optional<Sight<Real>>& best) const {
        if (sectors.size() < 2 || sectors.is_at_corner) {
            return;
        }
        const Phase film = sectors[0].phase;
        Corner edge = prev(sectors[0].first); // leaves v
        Sectors<Real> there;
        for (int i = 0; i < edges_along_wall && is_border(complex_.twin(edge)); ++i) {
            const std::uint32_t q = complex_.vertex(prev(edge));
            find_sectors(complex_, Vertex{q}, there);
            if (!there.is_on_boundary || there.is_at_corner || is_locked(q)) {
                return;
            }
            if (there.size() > 1) {
                const Point<Real> way = at(q) - at(v);
                const Real gap = way.norm();
                Sight<Real> sight{.v = v, .q = q, .gap = gap, .film = film};
                sight.one = sectors[1].phase;
                sight.other = there[there.size() - 2].phase;
                sight.normal_v = way / gap;
                sight.normal_q = -way / gap;
                sight.is_on_boundary = true;
                if (gap < static_cast<Real>(farthest) * work_.edge_length &&
                    closes(sight, Point<Real>(way / gap), false)) {
                    best = sight;
                }
                return;
            }
            const Corner at_q = find_corner(
                complex_, Vertex{q}, [&](Corner c) { return is_border(complex_.twin(prev(c))); });
            if (at_q == no_id) {
                return;
            }
            edge = prev(at_q);
        }
    }

    [[nodiscard]] std::optional<Point<Real>> way_of(std::uint32_t v) const {
        return work_.notes[Vertex{v}].round == round_
                   ? std::optional<Point<Real>>(at(v) - place_before(work_, v))
                   : std::nullopt;
    }
    [[nodiscard]] bool is_blocked(std::uint32_t v) const {
        return (complex_.vertices[v].flags & vertex_contact) != 0;
    }

    // Whether the fronts meet now, or would in another sub-step like the last one; notes their
    // speeds. A pocket closes in any case.
    bool closes(Sight<Real>& sight, const Point<Real>& towards, bool is_enclosed) const {
        const Real reach =
            std::min(contact(sight.film, sight.one), contact(sight.film, sight.other));
        if (!(reach > 0) || !meet_in_points(sight.film, sight.one, sight.other) ||
            sight.one == border_phase || sight.other == border_phase || sight.film == sight.one ||
            sight.film == sight.other) {
            return false;
        }
        std::optional<Point<Real>> other_way;
        bool is_held = is_blocked(sight.v);
        if (sight.q != no_id) {
            other_way = way_of(sight.q);
            is_held = is_held || is_blocked(sight.q);
        } else {
            const std::uint32_t a = complex_.vertex(next(sight.edge));
            const std::uint32_t b = complex_.vertex(prev(sight.edge));
            const auto way_a = way_of(a);
            const auto way_b = way_of(b);
            other_way =
                way_a && way_b
                    ? std::optional<Point<Real>>((1 - sight.share) * *way_a + sight.share * *way_b)
                : way_a ? way_a
                        : way_b;
            is_held = is_held || is_blocked(a) || is_blocked(b);
        }
        const auto own_way = way_of(sight.v);
        const Point<Real> none = Point<Real>::Zero();
        sight.speed_v = own_way.value_or(none).dot(towards);
        sight.speed_q = -other_way.value_or(none).dot(towards);
        const Real closing = sight.speed_v + sight.speed_q;
        const Real way = own_way.value_or(none).norm() + other_way.value_or(none).norm();
        if (is_held) {
            sight.speed_v = sight.speed_q = 1;
        } else if (!is_enclosed && work_.options.opening == Opening::squeezed &&
                   !(own_way && other_way && closing > static_cast<Real>(min_closing) * way)) {
            return false;
        }
        return is_enclosed || sight.gap < std::max(reach, closing);
    }

    // --- edits --------------------------------------------------------------------------------
    [[nodiscard]] bool is_locked(std::uint32_t v) const {
        return (complex_.vertices[v].flags & vertex_locked) != 0;
    }

    // Each front goes on at its speed until both are at one place, which moves along their
    // bisector.
    [[nodiscard]] Point<Real> meeting_place(const Sight<Real>& sight, const Point<Real>& v,
                                            const Point<Real>& q) const {
        Real speed_v = std::max(sight.speed_v, Real(0));
        Real speed_q = std::max(sight.speed_q, Real(0));
        if (!(speed_v + speed_q > 0)) {
            speed_v = speed_q = 1;
        }
        const Point<Real> p = (v * speed_q + q * speed_v) / (speed_v + speed_q);
        Point<Real> across = sight.normal_v - sight.normal_q;
        const Real size = across.norm();
        if (!(size > Real(0.5))) {
            return p; // the fronts do not face each other
        }
        if (sight.is_on_boundary) {
            return orientation<Real>(v, p, q) == 0 ? p : v; // off the line by rounding
        }
        across /= size;
        const Real rate =
            speed_q * across.dot(sight.normal_v) - speed_v * across.dot(sight.normal_q);
        if (!(std::abs(rate) > 0)) {
            return p;
        }
        const Real most = (q - v).norm() / 2;
        const Real along =
            (speed_v * (p - q).dot(sight.normal_q) - speed_q * (p - v).dot(sight.normal_v)) / rate;
        return p + std::clamp(along, -most, most) * across;
    }

    // Returns the vertex that is left; none if triangles are in the way.
    std::uint32_t join(const Sight<Real>& sight) {
        const std::uint32_t v = sight.v;
        const Point<Real> foot =
            sight.edge == no_id
                ? at(sight.q)
                : Point<Real>((1 - sight.share) * at(complex_.vertex(next(sight.edge))) +
                              sight.share * at(complex_.vertex(prev(sight.edge))));
        const Point<double> middle = ((at(v) + foot) / Real(2)).template cast<double>();
        if (!may_open(work_, {.film = sight.film,
                              .sides = {sight.one, sight.other},
                              .x = middle.x(),
                              .y = middle.y(),
                              .thickness = static_cast<double>(sight.gap)})) {
            return no_id;
        }
        std::uint32_t q = sight.q;
        if (q == no_id) {
            const SplitResult split = edge_split(submesh_, sight.edge, foot);
            if (split.verdict != Verdict::legal) {
                return no_id;
            }
            q = split.vertex.id;
        }
        if (sight.is_on_boundary && !clear_wall(v, q)) {
            return no_id;
        }
        const double before = work_.swept;
        const Point<Real> place = meeting_place(sight, at(v), at(q));
        std::uint32_t kept = contract(v, q, place);
        if (kept == no_id && !sight.is_on_boundary) {
            kept = contract(v, q, middle.template cast<Real>());
        }
        if (kept != no_id) {
            tell(sight, kept, work_.swept - before);
        }
        work_.swept = before;
        return kept;
    }

    // One event for what closes from one place outwards.
    void tell(const Sight<Real>& sight, std::uint32_t kept, double area) {
        const bool is_new = !is_beside_seam(kept, sight);
        for (std::size_t i = begun_; i < work_.events.size() && !is_new; ++i) {
            Event& event = work_.events[i];
            if (event.lost == sight.film && std::minmax(event.taken[0], event.taken[1]) ==
                                                std::minmax(sight.one, sight.other)) {
                event.area += area;
                return;
            }
        }
        work_.events.push_back({.kind = is_new ? EventKind::meet : EventKind::widen,
                                .time = work_.time,
                                .x = static_cast<double>(at(kept).x()),
                                .y = static_cast<double>(at(kept).y()),
                                .lost = sight.film,
                                .taken = {sight.one, sight.other},
                                .area = area});
    }

    [[nodiscard]] bool has_phase(std::uint32_t v, Phase phase) const {
        return find_corner(complex_, Vertex{v},
                           [&](Corner c) { return complex_.phase_at(c) == phase; }) != no_id;
    }

    // The vertex belongs to a seam of the same fronts, which begins at it or within a few edges
    // along the film: what is between is a pocket, which closes next.
    [[nodiscard]] bool is_beside_seam(std::uint32_t v, const Sight<Real>& sight) const {
        return has_seam(v, sight.one, sight.other) ||
               find_corner(complex_, Vertex{v}, [&](Corner c) {
                   Corner edge = prev(c); // leaves the vertex
                   if (complex_.phase_at(edge) != sight.film || !is_outline(complex_, edge)) {
                       return false;
                   }
                   for (int i = 0; i < edges_of_pocket; ++i) {
                       const std::uint32_t end = complex_.vertex(prev(edge));
                       if (end != v && has_phase(end, sight.one) && has_phase(end, sight.other)) {
                           return true;
                       }
                       edge = along_outline(complex_, edge);
                   }
                   return false;
               }) != no_id;
    }

    // An edge between the two phases reaches the vertex.
    [[nodiscard]] bool has_seam(std::uint32_t v, Phase one, Phase other) const {
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   const Corner edge = prev(c);
                   return std::minmax(complex_.phase_at(edge), phase_beyond(complex_, edge)) ==
                          std::minmax(one, other);
               }) != no_id;
    }

    [[nodiscard]] std::vector<std::uint32_t> link_of(std::uint32_t v) const {
        std::vector<std::uint32_t> link;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            link.push_back(complex_.vertex(next(c)));
            link.push_back(complex_.vertex(prev(c)));
        });
        std::ranges::sort(link);
        link.erase(std::unique(link.begin(), link.end()), link.end());
        return link;
    }

    // Opposite to the edge between two vertices.
    [[nodiscard]] Corner edge_between(std::uint32_t v, std::uint32_t q) const {
        const Corner c = find_corner(complex_, Vertex{v}, [&](Corner k) {
            return complex_.vertex(next(k)) == q || complex_.vertex(prev(k)) == q;
        });
        return c == no_id ? no_id : complex_.vertex(next(c)) == q ? prev(c) : next(c);
    }

    /// Height over longest edge of the worst triangle.
    struct Worst {
        Real height = 1;
        Corner corner = no_id;
    };
    // Of the star of v with v at a place, without the triangles that have q.
    [[nodiscard]] Worst worst_at(std::uint32_t v, std::uint32_t q, const Point<Real>& place) const {
        Worst worst;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            const std::uint32_t a = complex_.vertex(next(c));
            const std::uint32_t b = complex_.vertex(prev(c));
            if (a == q || b == q) {
                return;
            }
            const Real height = height_over_longest<Real>(place, at(a), at(b));
            if (height < worst.height) {
                worst = {height, c};
            }
        });
        return worst;
    }

    // Flips the edge between two vertices, if it is within a phase.
    bool flip_edge(std::uint32_t v, std::uint32_t w) {
        const Corner c = edge_between(v, w);
        return !is_border(c) && !is_border(complex_.twin(c)) && !is_sheet(complex_, c) &&
               edge_flip(submesh_, c) == Verdict::legal;
    }

    // Takes the worst triangle out of the star by a flip, if that leaves a better one there: where
    // two vertices of the seam are in the star, and the place is on their line.
    bool flip_away(const Worst& worst, const Point<Real>& place) {
        for (const Corner c : {next(worst.corner), prev(worst.corner)}) { // opposite to the edge
            const Corner across = complex_.twin(c);
            if (is_border(across) || is_sheet(complex_, c)) {
                continue;
            }
            const bool is_first = c == next(worst.corner);
            const Point<Real> a = at(complex_.vertex(is_first ? c : across));
            const Point<Real> b = at(complex_.vertex(is_first ? across : c));
            if (height_over_longest<Real>(place, a, b) > worst.height &&
                edge_flip(submesh_, c) == Verdict::legal) {
                return true;
            }
        }
        return false;
    }

    // Removes the vertices of the domain boundary between two, on the way from v to q.
    bool clear_wall(std::uint32_t v, std::uint32_t q) {
        for (int i = 0; i < edges_along_wall; ++i) {
            const Corner c = find_corner(
                complex_, Vertex{v}, [&](Corner k) { return is_border(complex_.twin(prev(k))); });
            if (c == no_id) {
                return false;
            }
            if (complex_.vertex(next(c)) == q) {
                return true;
            }
            if (edge_collapse(submesh_, prev(c), rewire::Vanishing::prev) != Verdict::legal) {
                return false;
            }
        }
        return false;
    }

    // A tip of the film within one phase, whose only two sheets become one, goes to that phase
    // first: it is off the interface from then on.
    void give_tip(Corner apex) {
        if (is_border(apex)) {
            return;
        }
        const Corner one = complex_.twin(next(apex));
        const Corner other = complex_.twin(prev(apex));
        int sheets = 0;
        for_each_corner(complex_, Vertex{complex_.vertex(apex)},
                        [&](Corner c) { sheets += is_sheet(complex_, prev(c)) ? 1 : 0; });
        if (sheets == 2 && !is_border(one) && is_sheet(complex_, one) &&
            complex_.phase_at(one) == complex_.phase_at(other)) {
            give(work_, Triangle{triangle_of(apex)}, complex_.phase_at(one));
        }
    }

    // Makes one vertex of the ends of an edge, at a place.
    std::uint32_t contract(std::uint32_t v, std::uint32_t q, const Point<Real>& place) {
        for (int removed = 0; removed <= max_cleared; ++removed) {
            const Corner edge = edge_between(v, q);
            if (edge == no_id) {
                return no_id;
            }
            std::vector<std::uint32_t> common;
            std::ranges::set_intersection(link_of(v), link_of(q), std::back_inserter(common));
            const bool is_inside = !is_border(edge) && !is_border(complex_.twin(edge));
            if (common.size() !=
                (is_inside ? 2U : 1U)) { // a vertex inside a phase may be in the way
                if (std::ranges::none_of(common,
                                         [&](std::uint32_t x) {
                                             return remove_inside(work_, Vertex{x}, Real(0));
                                         }) &&
                    std::ranges::none_of(common, [&](std::uint32_t x) {
                        return x != complex_.vertex(edge) &&
                               x != complex_.vertex(complex_.twin(edge)) &&
                               (flip_edge(v, x) || flip_edge(q, x));
                    })) {
                    return no_id;
                }
                continue;
            }
            const Worst of_v = worst_at(v, q, place);
            const Worst of_q = worst_at(q, v, place);
            const Worst& worst = of_v.height <= of_q.height ? of_v : of_q;
            if (worst.height < static_cast<Real>(poor_height) && removed < max_cleared) {
                const std::array ends{complex_.vertex(next(worst.corner)),
                                      complex_.vertex(prev(worst.corner))};
                if (remove_inside(work_, Vertex{ends[0]}, Real(0)) ||
                    remove_inside(work_, Vertex{ends[1]}, Real(0)) || flip_away(worst, place)) {
                    continue;
                }
            }
            if (!(worst.height > 0)) {
                return no_id;
            }
            give_tip(edge);
            give_tip(complex_.twin(edge));
            note_sweep(work_, Vertex{v}, Vertex{q}, place);
            note_sweep(work_, Vertex{q}, Vertex{v}, place);
            const auto order = [&](std::uint32_t w) { return std::tuple(at(w).x(), at(w).y()); };
            const std::uint32_t gone = order(v) < order(q) ? q : v;
            const std::uint32_t kept = gone == v ? q : v;
            rewire::collapse(complex_, complex_.journal, edge,
                             complex_.vertex(next(edge)) == gone ? rewire::Vanishing::next
                                                                 : rewire::Vanishing::prev,
                             complex_.ids);
            rewire::move(complex_, complex_.journal, kept, place.x(), place.y(), MoveReason::flow);
            settle(kept);
            if (worst.height < static_cast<Real>(slender)) {
                mend_star(work_, Vertex{kept});
            }
            return kept;
        }
        return no_id;
    }

    // What was in the way of the vertex, or of those around it, no longer is.
    void settle(std::uint32_t kept) {
        complex_.vertices[kept].flags &=
            ~static_cast<std::uint32_t>(vertex_contact | vertex_feature | vertex_on_way);
        Note& note = work_.notes[Vertex{kept}];
        note.what |= noted_seam;
        note.round = 0; // where it was before says nothing about a front
        work_.touched.push_back(Vertex{kept});
        for (const std::uint32_t w : link_of(kept)) {
            complex_.vertices[w].flags &= ~static_cast<std::uint32_t>(vertex_contact);
        }
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    std::span<const std::uint32_t> interface_;
    std::uint32_t round_;
    std::size_t begun_ = 0; ///< the first event of the place from which fronts close
};

} // namespace

template <class Real>
void meet_fronts(TopologyWork<Real>& work, std::span<const std::uint32_t> interface,
                 std::uint32_t round) {
    Meeting<Real>(work, interface, round).run();
}

template void meet_fronts(TopologyWork<double>&, std::span<const std::uint32_t>, std::uint32_t);
template void meet_fronts(TopologyWork<float>&, std::span<const std::uint32_t>, std::uint32_t);

} // namespace dsc

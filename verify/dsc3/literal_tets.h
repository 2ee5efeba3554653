// SPDX-License-Identifier: MIT
// A complex as an unordered list of tets: each question is answered by a search of the whole list.
#pragma once

#include "dsc3/dsc3.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace dsc3::test {

using Ids = std::set<std::uint32_t>;

struct SetTet {
    std::array<std::uint32_t, 4> v; // in an order that has positive orientation
    Phase phase;

    [[nodiscard]] bool has(std::uint32_t vertex) const {
        return std::find(v.begin(), v.end(), vertex) != v.end();
    }
    [[nodiscard]] bool has(const Ids& vertices) const {
        return std::all_of(vertices.begin(), vertices.end(), [&](auto x) { return has(x); });
    }
};
using Tets = std::vector<SetTet>;

inline Tets tets_of(const Complex& complex) {
    Tets tets;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t})) {
            tets.push_back({complex.tets[t].v, complex.phases[t]});
        }
    }
    return tets;
}

inline Tets with(const Tets& tets, const Ids& vertices) {
    Tets found;
    std::copy_if(tets.begin(), tets.end(), std::back_inserter(found),
                 [&](const SetTet& tet) { return tet.has(vertices); });
    return found;
}

// Every face, with the phases of the tets that have it.
inline std::map<Ids, std::vector<Phase>> faces_of(const Tets& tets) {
    std::map<Ids, std::vector<Phase>> faces;
    for (const SetTet& tet : tets) {
        for (const std::uint32_t left_out : tet.v) {
            Ids face(tet.v.begin(), tet.v.end());
            face.erase(left_out);
            faces[face].push_back(tet.phase);
        }
    }
    return faces;
}

// The faces at these vertices between unlike phases, and those on the domain boundary if the
// outside counts as a phase.
inline std::set<Ids> faces_at(const Tets& tets, const Ids& vertices, bool with_outside) {
    std::set<Ids> found;
    for (const auto& [face, phases] : faces_of(with(tets, {*vertices.begin()}))) {
        if ((phases.size() == 2 ? phases[0] != phases[1] : with_outside) &&
            std::includes(face.begin(), face.end(), vertices.begin(), vertices.end())) {
            found.insert(face);
        }
    }
    return found;
}
inline std::set<Ids> interface_at(const Tets& tets, const Ids& vertices) {
    return faces_at(tets, vertices, false);
}
inline std::set<Ids> surface_at(const Tets& tets, const Ids& vertices) {
    return faces_at(tets, vertices, true);
}

// The sides of the domain on which each vertex lies: -1 and 1 for x, -2 and 2 for y, -3 and 3 for
// z.
using Sides = std::map<std::uint32_t, std::set<int>>;
inline Sides sides_of(const Complex& complex) {
    Point low = complex.at(0);
    Point high = low;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        low = complex.is_alive(Vertex{v}) ? Point(low.cwiseMin(complex.at(v))) : low;
        high = complex.is_alive(Vertex{v}) ? Point(high.cwiseMax(complex.at(v))) : high;
    }
    Sides sides;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        for (int k = 0; k < 3; ++k) {
            if (complex.at(v)[k] == low[k]) {
                sides[v].insert(-k - 1);
            }
            if (complex.at(v)[k] == high[k]) {
                sides[v].insert(k + 1);
            }
        }
    }
    return sides;
}
inline std::set<int> common(const Sides& sides, const Ids& vertices) {
    std::set<int> found =
        sides.contains(*vertices.begin()) ? sides.at(*vertices.begin()) : std::set<int>();
    std::erase_if(found, [&](int side) {
        return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
            return !sides.contains(v) || !sides.at(v).contains(side);
        });
    });
    return found;
}
// Whether sheets end at the edge: not two faces meet there, or two sides of the domain.
inline bool is_on_curve(const Tets& tets, const Sides& sides, std::uint32_t v, std::uint32_t x) {
    return surface_at(tets, {v, x}).size() != 2 || common(sides, {v, x}).size() > 1;
}

inline bool is_interface(const Tets& tets, std::uint32_t v) {
    return !interface_at(tets, {v}).empty();
}

inline Ids neighbours_on_surface(const Tets& tets, std::uint32_t v) {
    Ids found;
    for (const Ids& face : surface_at(tets, {v})) {
        found.insert(face.begin(), face.end());
    }
    found.erase(v);
    return found;
}

inline bool is_boundary(const Tets& tets, const Ids& vertices) {
    const auto faces = faces_of(with(tets, {*vertices.begin()}));
    return std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
        return face.second.size() == 1 && std::includes(face.first.begin(), face.first.end(),
                                                        vertices.begin(), vertices.end());
    });
}

// Whether the surface at v is one disc of at least three faces: its link is one closed curve.
inline bool is_sheet(const Tets& tets, const Sides& sides, std::uint32_t v) {
    std::map<std::uint32_t, Ids> link;
    for (Ids face : surface_at(tets, {v})) {
        face.erase(v);
        link[*face.begin()].insert(*face.rbegin());
        link[*face.rbegin()].insert(*face.begin());
    }
    Ids met;
    std::vector<std::uint32_t> open{link.empty() ? v : link.begin()->first};
    while (!open.empty()) {
        const std::uint32_t x = open.back();
        open.pop_back();
        if (met.insert(x).second) {
            open.insert(open.end(), link[x].begin(), link[x].end());
        }
    }
    return link.size() >= 3 && met.size() == link.size() &&
           std::all_of(link.begin(), link.end(), [&](const auto& at) {
               return at.second.size() == 2 && !is_on_curve(tets, sides, v, at.first);
           });
}

// Whether sheets meet at v along two edges, each sheet once along each.
inline bool is_curve(const Tets& tets, const Sides& sides, std::uint32_t v) {
    std::vector<Ids> faces; // without v: edges of the link
    std::map<std::uint32_t, std::size_t> number_at;
    for (Ids face : surface_at(tets, {v})) {
        face.erase(v);
        faces.push_back(face);
        for (const std::uint32_t x : face) {
            ++number_at[x];
        }
    }
    std::vector<std::pair<std::uint32_t, std::size_t>> ends;
    std::copy_if(number_at.begin(), number_at.end(), std::back_inserter(ends),
                 [&](const auto& at) { return is_on_curve(tets, sides, v, at.first); });
    if (ends.size() != 2 || ends[0].second != ends[1].second) {
        return false;
    }
    std::size_t arrived = 0;
    std::size_t used = 0;
    for (std::size_t first = 0; first < faces.size(); ++first) {
        if (!faces[first].contains(ends[0].first)) {
            continue;
        }
        std::uint32_t at = ends[0].first;
        for (std::size_t face = first; face < faces.size();) {
            ++used;
            at = *faces[face].begin() == at ? *faces[face].rbegin() : *faces[face].begin();
            if (is_on_curve(tets, sides, v, at)) {
                arrived += at == ends[1].first ? 1U : 0U;
                break;
            }
            std::size_t next = 0;
            while (next < faces.size() && (next == face || !faces[next].contains(at))) {
                ++next;
            }
            face = next;
        }
    }
    return arrived == ends[0].second && used == faces.size();
}

} // namespace dsc3::test

// SPDX-License-Identifier: MIT
#include "dsc3/complex/complex.h"

#include "dsc3/complex/star.h"
#include "dsc3/geometry/predicates.h"

#include <algorithm>
#include <bit>

namespace dsc3 {

Complex::Complex() {
    tets.push_back({{no_id, no_id, no_id, no_id}, {}});
    phases.push_back(border_phase);
    attributes.resize_triangles(tets.size());
}

std::uint32_t Complex::take_vertex(const Point& position, std::uint32_t flags) {
    std::uint32_t id = vertex_bound();
    if (free_vertices.empty()) {
        vertices.emplace_back();
        attributes.resize_vertices(vertices.size());
    } else {
        id = free_vertices.back();
        free_vertices.pop_back();
    }
    vertices[id] = {position, no_id, flags};
    attributes.reset_vertex(id);
    return id;
}

namespace {

void expect_room(const Complex& complex, std::size_t more) {
    if (complex.tet_bound() + more > dsc::triangle_limit) {
        throw InputError({.what = "the complex is too large",
                          .where = "Complex",
                          .value = std::to_string(complex.tet_bound() + more) + " tets",
                          .allowed = "fewer than 2^30"});
    }
}

} // namespace

std::uint32_t Complex::take_tet() {
    if (!free_tets.empty()) {
        const std::uint32_t id = free_tets.back();
        free_tets.pop_back();
        return id;
    }
    expect_room(*this, 1);
    tets.push_back({{no_id, no_id, no_id, no_id}, {}});
    phases.push_back(exterior_phase);
    attributes.resize_triangles(tets.size());
    return tet_bound() - 1;
}

void Complex::reserve_ids(std::size_t free_vertex_ids, std::size_t free_tet_ids) {
    // Half as many more ids are made than are missing, so that arrays grow seldom. Old ids are used
    // before new ones.
    const auto extend = [](std::vector<std::uint32_t>& free, std::size_t wanted,
                           std::uint32_t bound) {
        const std::size_t more = wanted > free.size() ? (wanted - free.size()) * 3 / 2 + 1 : 0;
        free.insert(free.begin(), more, 0);
        for (std::size_t i = 0; i < more; ++i) {
            free[i] = bound + static_cast<std::uint32_t>(more - 1 - i);
        }
        return more;
    };
    if (free_tets.size() < free_tet_ids) {
        expect_room(*this, 2 * (free_tet_ids - free_tets.size()));
    }
    const std::size_t more_tets = extend(free_tets, free_tet_ids, tet_bound());
    tets.resize(tets.size() + more_tets, {{no_id, no_id, no_id, no_id}, {}});
    phases.resize(tets.size(), exterior_phase);
    attributes.resize_triangles(tets.size());
    vertices.resize(vertices.size() + extend(free_vertices, free_vertex_ids, vertex_bound()));
    attributes.resize_vertices(vertices.size());
}

void Complex::give_vertex(std::uint32_t id) {
    vertices[id].flags = vertex_dead;
    vertices[id].corner = no_id;
    free_vertices.push_back(id);
}

void Complex::give_tet(std::uint32_t id) {
    tets[id] = {{no_id, no_id, no_id, no_id}, {}};
    free_tets.push_back(id);
}

void Complex::set_phase(Tet t, Phase phase) {
    phases[t.id] = phase;
    ++version;
    Star star;
    for (const std::uint32_t v : tets[t.id].v) {
        gather(*this, v, star);
        const bool on_interface =
            std::any_of(star.corners.begin(), star.corners.end(), [&](Corner corner) {
                const auto& others = face_indices[index_of(corner)];
                return std::any_of(others.begin(), others.end(), [&](std::uint32_t i) {
                    const Corner other = twin(corner_of(tet_of(corner), i));
                    return !is_border(other) && phase_at(other) != phase_at(corner);
                });
            });
        vertices[v].flags = (vertices[v].flags & ~static_cast<std::uint32_t>(vertex_interface)) |
                            (on_interface ? vertex_interface : 0U);
    }
}

std::uint32_t Complex::fixed_along(std::uint32_t a, std::uint32_t b) const {
    std::uint32_t fixed = vertices[a].flags & vertices[b].flags & vertex_boundary;
    for (int k = 0; k < 3; ++k) {
        if (at(a)[k] != at(b)[k]) {
            fixed &= ~(vertex_fixed_x << k);
        }
    }
    return fixed;
}

std::uint32_t fixed_at(const Complex& complex, Corner corner) {
    const auto [a, b, c] = complex.face(corner);
    std::uint32_t fixed = 0;
    for (int k = 0; k < 3; ++k) {
        if (complex.at(a)[k] == complex.at(b)[k] && complex.at(a)[k] == complex.at(c)[k]) {
            fixed |= vertex_fixed_x << k;
        }
    }
    return fixed == 0 ? std::uint32_t{vertex_boundary} : fixed;
}

namespace {

struct FaceOfTet {
    std::array<std::uint32_t, 3> key;
    Corner corner;
};

void expect(bool good, const char* what, std::size_t index, const std::string& value,
            const char* allowed) {
    if (!good) {
        throw InputError({.what = what,
                          .where = "make_complex, entry " + std::to_string(index),
                          .value = value,
                          .allowed = allowed});
    }
}

void link(Complex& complex, std::vector<FaceOfTet>& faces) {
    std::sort(faces.begin(), faces.end(), [](const FaceOfTet& a, const FaceOfTet& b) {
        return a.key != b.key ? a.key < b.key : a.corner < b.corner;
    });
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].key == faces[i].key) {
            ++end;
        }
        const Corner one = faces[i].corner;
        expect(end - i <= 2, "a face has more than two tets", tet_of(one) - 1,
               std::to_string(end - i) + " tets", "1 or 2");
        if (end - i == 2) {
            const Corner other = faces[i + 1].corner;
            complex.tets[tet_of(one)].n[index_of(one)] = other;
            complex.tets[tet_of(other)].n[index_of(other)] = one;
        }
        i = end;
    }
}

void mark_vertices(Complex& complex) {
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Corner corner = corner_of(t, i);
            const Corner other = complex.twin(corner);
            complex.vertices[complex.vertex(corner)].corner = corner;
            if (complex.phase_at(other) != complex.phase_at(corner)) {
                const std::uint32_t flag =
                    is_border(other) ? fixed_at(complex, corner) : vertex_interface;
                for (const std::uint32_t v : complex.face(corner)) {
                    complex.vertices[v].flags |= flag;
                }
            }
        }
    }
}

} // namespace

Complex make_complex(std::span<const Point> points,
                     std::span<const std::array<std::uint32_t, 4>> tets,
                     std::span<const Phase> phases) {
    Complex complex;
    for (std::size_t i = 0; i < points.size(); ++i) {
        expect(points[i].allFinite(), "a coordinate is not finite", i, to_text(points[i]),
               "finite coordinates");
        complex.take_vertex(points[i], 0);
    }
    expect(phases.size() == tets.size(), "wrong number of phases", 0, std::to_string(phases.size()),
           "one for each tet");
    std::vector<FaceOfTet> faces;
    faces.reserve(4 * tets.size());
    for (std::size_t i = 0; i < tets.size(); ++i) {
        TetRecord tet{tets[i], {}};
        for (const std::uint32_t v : tet.v) {
            expect(v < points.size(), "no such point", i, std::to_string(v),
                   "below the number of points");
        }
        const int sign =
            orientation(points[tet.v[0]], points[tet.v[1]], points[tet.v[2]], points[tet.v[3]]);
        expect(sign != 0, "a tet has no volume", i, to_text(points[tet.v[0]]),
               "four points that are not coplanar");
        if (sign < 0) {
            std::swap(tet.v[2], tet.v[3]);
        }
        expect(phases[i] != border_phase, "a reserved phase", i, std::to_string(phases[i]),
               "below 4294967295");
        const std::uint32_t t = complex.take_tet();
        complex.tets[t] = tet;
        complex.phases[t] = phases[i];
        for (std::uint32_t k = 0; k < 4; ++k) {
            auto key = complex.face(corner_of(t, k));
            std::sort(key.begin(), key.end());
            faces.push_back({key, corner_of(t, k)});
        }
    }
    link(complex, faces);
    mark_vertices(complex);
    return complex;
}

std::uint64_t mesh_hash(const Complex& complex) {
    const auto mix = [](std::uint64_t h, std::uint64_t value) {
        h = (h ^ value) * 0x9E3779B97F4A7C15ULL;
        return h ^ (h >> 29U);
    };
    std::uint64_t sum = complex.tet_count();
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (!complex.is_alive(Tet{t})) {
            continue;
        }
        std::array<std::uint64_t, 4> of{};
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Point& p = complex.at(complex.tets[t].v[i]);
            for (const Real x : {p.x(), p.y(), p.z()}) {
                of[i] = mix(of[i], std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x));
            }
        }
        std::sort(of.begin(), of.end());
        std::uint64_t hash = complex.phases[t];
        for (const std::uint64_t one : of) {
            hash = mix(hash, one);
        }
        sum += mix(hash, 1);
    }
    return sum;
}

} // namespace dsc3

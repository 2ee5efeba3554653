// SPDX-License-Identifier: MIT
#include "dsc3/complex/rewire.h"

#include <bit>
#include <limits>
#include <utility>

namespace dsc3 {

void FaceTable::clear(std::size_t faces) {
    if (slots_.size() < 2 * faces) {
        const std::size_t size = std::bit_ceil(4 * faces);
        slots_.assign(size, {});
        shift_ = 64 - static_cast<std::uint32_t>(std::countr_zero(size));
        epoch_ = 0;
    }
    if (++epoch_ == 0) {
        slots_.assign(slots_.size(), {});
        epoch_ = 1;
    }
}

namespace {

// The entry of a face whose two tets are both replaced.
constexpr Corner inner = no_id;

std::array<std::uint32_t, 3> face_key(const Complex& complex, Corner corner) {
    auto [a, b, c] = complex.face(corner);
    if (a > b) {
        std::swap(a, b);
    }
    if (b > c) {
        std::swap(b, c);
    }
    if (a > b) {
        std::swap(a, b);
    }
    return {a, b, c};
}

template <class Vertices>
Point centre_of(const Complex& complex, const Vertices& v) {
    return 0.25 * (complex.at(v[0]) + complex.at(v[1]) + complex.at(v[2]) + complex.at(v[3]));
}

// For each new tet, finds the nearest old one of its phase, or of any phase if there is none.
void find_heirs(const Complex& complex, std::vector<std::uint32_t>& heirs,
                std::span<const std::uint32_t> old, std::span<const NewTet> made) {
    heirs.clear();
    for (const NewTet& tet : made) {
        const Point centre = centre_of(complex, tet.v);
        std::pair<bool, Real> best{true, std::numeric_limits<Real>::infinity()};
        std::uint32_t nearest = 0;
        for (std::uint32_t i = 0; i < old.size(); ++i) {
            const Point other = centre_of(complex, complex.tets[old[i]].v);
            const std::pair here{complex.phases[old[i]] != tet.phase,
                                 (other - centre).squaredNorm()};
            if (here < best) {
                best = here;
                nearest = i;
            }
        }
        heirs.push_back(nearest);
    }
}

// New tets reuse the ids of old ones, so the old values are first copied beyond all ids.
void inherit(Complex& complex, std::span<const std::uint32_t> heirs,
             std::span<const std::uint32_t> old, std::span<const std::uint32_t> made) {
    const std::uint32_t bound = complex.tet_bound();
    auto& attributes = complex.attributes;
    attributes.resize_triangles(bound + old.size());
    for (std::uint32_t i = 0; i < old.size(); ++i) {
        attributes.copy_triangle(bound + i, old[i]);
    }
    for (std::size_t k = 0; k < made.size(); ++k) {
        attributes.copy_triangle(made[k], bound + heirs[k]);
    }
    attributes.resize_triangles(bound);
}

} // namespace

void replace(Complex& complex, Rewiring& work, std::span<const std::uint32_t> old,
             std::span<const NewTet> made, std::uint32_t unmatched) {
    FaceTable& faces = work.faces;
    faces.clear(4 * (old.size() + made.size()));
    std::uint32_t open = 0; // outer faces of old and new tets that have no partner
    for (const std::uint32_t t : old) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const auto key = face_key(complex, corner_of(t, i));
            FaceTable::Slot& slot = faces.find(key);
            if (faces.is_used(slot)) {
                slot.corner = inner;
                --open;
            } else {
                faces.set(slot, key, complex.twin(corner_of(t, i)));
                ++open;
            }
        }
    }
    const bool inherits = !complex.attributes.empty(dsc::SimplexKind::triangle);
    if (inherits) {
        find_heirs(complex, work.heirs, old, made);
    }
    const std::size_t first = work.changed.size();
    for (std::size_t k = 0; k < made.size(); ++k) {
        const std::uint32_t t = k < old.size() ? old[k] : complex.take_tet();
        work.changed.push_back(t);
        complex.tets[t].v = made[k].v;
        complex.phases[t] = made[k].phase;
        for (std::uint32_t i = 0; i < 4; ++i) {
            VertexRecord& vertex = complex.vertices[made[k].v[i]];
            vertex.corner = corner_of(t, i);
            vertex.flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
    }
    if (inherits) {
        inherit(complex, work.heirs, old, {work.changed.data() + first, made.size()});
    }
    for (std::size_t k = made.size(); k < old.size(); ++k) {
        complex.give_tet(old[k]);
    }
    for (std::size_t k = first; k < work.changed.size(); ++k) {
        const std::uint32_t t = work.changed[k];
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Corner corner = corner_of(t, i);
            const auto key = face_key(complex, corner);
            FaceTable::Slot& slot = faces.find(key);
            if (faces.is_used(slot) && slot.corner != inner) {
                const Corner other = slot.corner;
                complex.tets[t].n[i] = other;
                if (!is_border(other)) {
                    complex.tets[tet_of(other)].n[index_of(other)] = corner;
                }
                slot.corner = inner;
                --open;
            } else {
                faces.set(slot, key, corner);
                complex.tets[t].n[i] = border_corner;
                ++open;
            }
        }
    }
    ++complex.version;
    if (open != unmatched) {
        throw InvariantError("replace: " + std::to_string(open) + " faces without a partner, not " +
                             std::to_string(unmatched));
    }
}

} // namespace dsc3

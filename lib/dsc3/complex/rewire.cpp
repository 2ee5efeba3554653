// SPDX-License-Identifier: MIT
#include "dsc3/complex/rewire.h"

#include <algorithm>
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

std::uint32_t take_tet(Complex& complex, Rewiring& work) {
    if (work.submesh == nullptr) {
        return complex.take_tet();
    }
    const std::uint32_t id = work.submesh->free_tets.back();
    work.submesh->free_tets.pop_back();
    return id;
}

void give_tet(Complex& complex, Rewiring& work, std::uint32_t id) {
    if (work.submesh == nullptr) {
        complex.give_tet(id);
    } else {
        complex.tets[id] = {{no_id, no_id, no_id, no_id}, {}};
        work.submesh->free_tets.push_back(id);
    }
}

// Each new tet takes the entry of its heir. New tets reuse the ids of old ones, so an entry is
// overwritten only when no other tet waits for its old value; cycles begin with a copy to a spare
// entry.
void inherit(Complex& complex, Rewiring& work, std::span<const std::uint32_t> old,
             std::span<const std::uint32_t> made) {
    const auto& heirs = work.heirs;
    const std::size_t reused = std::min(old.size(), made.size());
    auto& waiting = work.waiting; // for the old value of each reused id; no_id: it is written
    waiting.assign(made.size(), 0);
    for (std::size_t k = 0; k < made.size(); ++k) {
        if (heirs[k] < reused && heirs[k] != k) {
            ++waiting[heirs[k]];
        }
    }
    const auto copy = [&](std::uint32_t to, std::uint32_t from) {
        complex.attributes.copy_triangle(to, from);
    };
    for (std::uint32_t first = 0; first < made.size(); ++first) {
        for (std::uint32_t k = first; k < made.size() && waiting[k] == 0;) {
            waiting[k] = no_id;
            if (heirs[k] == k) {
                break;
            }
            copy(made[k], old[heirs[k]]);
            k = heirs[k] < reused && --waiting[heirs[k]] == 0 ? heirs[k] : no_id;
        }
    }
    const std::uint32_t spare =
        work.submesh != nullptr ? work.submesh->spare_entry : complex.tet_bound();
    if (work.submesh == nullptr) {
        complex.attributes.resize_triangles(spare + 1);
    }
    for (std::uint32_t first = 0; first < reused; ++first) {
        if (waiting[first] == no_id || heirs[first] == first) {
            continue;
        }
        copy(spare, old[first]);
        std::uint32_t k = first;
        for (; heirs[k] != first; k = heirs[k]) {
            copy(made[k], old[heirs[k]]);
            waiting[k] = no_id;
        }
        copy(made[k], spare);
        waiting[k] = no_id;
    }
    if (work.submesh == nullptr) {
        complex.attributes.resize_triangles(spare);
    }
}

} // namespace

std::uint32_t take_vertex(Complex& complex, Rewiring& work, const Point& position,
                          std::uint32_t flags) {
    std::uint32_t id = 0;
    if (work.submesh == nullptr) {
        id = complex.take_vertex(position, flags);
    } else {
        id = work.submesh->free_vertices.back();
        work.submesh->free_vertices.pop_back();
        complex.vertices[id] = {position, no_id, flags};
        complex.attributes.reset_vertex(id);
    }
    if (work.ownership != nullptr) {
        auto& labels = work.ownership->labels;
        if (id >= labels.size()) {
            labels.resize(complex.vertex_bound());
        }
        labels[id] = work.ownership->label_at(position);
        if (work.submesh != nullptr) { // wherever it is, its star belongs to the submesh
            const std::uint32_t shift = 8 * work.submesh->colour;
            labels[id] = (labels[id] & ~(Label{255} << shift)) | (work.submesh->index << shift);
        }
    }
    return id;
}

void give_vertex(Complex& complex, Rewiring& work, std::uint32_t id) {
    if (work.submesh == nullptr) {
        complex.give_vertex(id);
    } else {
        complex.vertices[id].flags = vertex_dead;
        complex.vertices[id].corner = no_id;
        work.submesh->free_vertices.push_back(id);
    }
}

void replace(Complex& complex, Rewiring& work, std::span<const std::uint32_t> old,
             std::span<const NewTet> made, std::uint32_t unmatched) {
    FaceTable& faces = work.faces;
    faces.clear(4 * (old.size() + made.size()));
    std::uint32_t open = 0; // outer faces of old and new tets that have no partner
    for (const std::uint32_t t : old) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            work.stars.forget(complex.tets[t].v[i]);
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
        const std::uint32_t t = k < old.size() ? old[k] : take_tet(complex, work);
        work.changed.push_back(t);
        complex.tets[t].v = made[k].v;
        complex.phases[t] = made[k].phase;
        for (std::uint32_t i = 0; i < 4; ++i) {
            VertexRecord& vertex = complex.vertices[made[k].v[i]];
            vertex.corner = corner_of(t, i);
            vertex.flags &= ~static_cast<std::uint32_t>(vertex_settled);
        }
        if (work.ownership != nullptr) {
            work.ownership->note(complex.tets[t]);
        }
    }
    if (inherits) {
        inherit(complex, work, old, {work.changed.data() + first, made.size()});
    }
    for (std::size_t k = made.size(); k < old.size(); ++k) {
        give_tet(complex, work, old[k]);
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
    note_edit(complex, work);
    if (open != unmatched) {
        throw InvariantError("replace: " + std::to_string(open) + " faces without a partner, not " +
                             std::to_string(unmatched));
    }
}

} // namespace dsc3

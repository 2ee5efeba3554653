// SPDX-License-Identifier: MIT
// The only place where connectivity and phases change. An operation lists the old tets and the new
// ones that replace them; faces are matched by their vertices.
#pragma once

#include "dsc3/complex/complex.h"
#include "dsc3/complex/ownership.h"
#include "dsc3/complex/star.h"

#include <array>
#include <span>
#include <vector>

namespace dsc3 {

/// A tet to be made.
struct NewTet {
    std::array<std::uint32_t, 4> v; ///< positively oriented
    Phase phase;
};

/// Faces by their vertices: a hash table that is emptied in O(1).
class FaceTable {
public:
    struct Slot {
        std::array<std::uint32_t, 3> key{};
        Corner corner = 0;
        std::uint32_t epoch = 0;
    };
    /// Removes all faces, and reserves room for this number.
    void clear(std::size_t faces);
    /// The slot of a face: its own, or a free one. O(1).
    Slot& find(const std::array<std::uint32_t, 3>& key) {
        std::uint64_t hash = key[0] * 0x9E3779B97F4A7C15ULL;
        hash = (hash ^ (hash >> 32U) ^ key[1]) * 0xD6E8FEB86659FD93ULL;
        hash = (hash ^ (hash >> 32U) ^ key[2]) * 0x9E3779B97F4A7C15ULL;
        auto place = static_cast<std::size_t>(hash >> shift_);
        while (slots_[place].epoch == epoch_ && slots_[place].key != key) {
            place = (place + 1) & (slots_.size() - 1);
        }
        return slots_[place];
    }
    [[nodiscard]] bool is_used(const Slot& slot) const { return slot.epoch == epoch_; }
    /// Fills a slot.
    void set(Slot& slot, const std::array<std::uint32_t, 3>& key, Corner corner) const {
        slot = {key, corner, epoch_};
    }

private:
    std::vector<Slot> slots_ = std::vector<Slot>(1024);
    std::uint32_t shift_ = 54;
    std::uint32_t epoch_ = 1;
};

/// The arrays and results of `replace`, of one thread.
struct Rewiring {
    Ownership* ownership = nullptr; ///< kept up to date, if there are submeshes
    Submesh* submesh = nullptr;     ///< the one that is edited; none: the whole complex may be
    FaceTable faces;
    StarCache stars;
    std::vector<std::uint32_t> old;       ///< tets to be removed, as listed by an operation
    std::vector<NewTet> made;             ///< tets to be made, as listed by an operation
    std::vector<std::uint32_t> changed;   ///< ids of tets that were written; the caller empties it
    std::vector<std::uint32_t> interface; ///< new vertices of the interface; the caller empties it
    std::vector<std::uint32_t> heirs;     ///< for each new tet, the old one whose data it inherits
    std::vector<std::uint32_t> waiting;   ///< scratch
};

/// Whether the star of a vertex may be searched and edited. O(1).
[[nodiscard]] inline bool owns(const Rewiring& work, std::uint32_t vertex) {
    return work.submesh == nullptr ||
           byte_of(work.ownership->labels[vertex], work.submesh->colour) == work.submesh->index;
}
/// Notes that the complex was edited. Submeshes do not: their threads would write to one counter.
inline void note_edit(Complex& complex, const Rewiring& work) {
    if (work.submesh == nullptr) {
        ++complex.version;
    }
}
/// `Complex::take_vertex`, or from the free ids of the submesh, which must have one.
std::uint32_t take_vertex(Complex& complex, Rewiring& work, const Point& position,
                          std::uint32_t flags);
/// `Complex::give_vertex`, or to the free ids of the submesh.
void give_vertex(Complex& complex, Rewiring& work, std::uint32_t id);

/// Replaces tets that fill a region by others that fill the same region. Old and new faces on the
/// domain boundary that differ have no partner: `unmatched` is their number. Throws InvariantError
/// if old and new tets do not have the same outer faces. O(tets).
void replace(Complex& complex, Rewiring& work, std::span<const std::uint32_t> old,
             std::span<const NewTet> made, std::uint32_t unmatched = 0);

} // namespace dsc3

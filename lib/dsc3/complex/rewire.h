// SPDX-License-Identifier: MIT
// The one door: connectivity and phases change here and nowhere else. An operation names the tets
// that vanish and those that take their place; faces are matched by their vertices.
#pragma once

#include "dsc3/complex/complex.h"

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
    /// Forgets all faces, and makes room for so many.
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

/// The arrays of the door, and what it tells.
struct Rewiring {
    FaceTable faces;
    std::vector<std::uint32_t> old;       ///< tets that vanish, as operations list them
    std::vector<NewTet> made;             ///< tets to be made, as operations list them
    std::vector<std::uint32_t> changed;   ///< ids of tets that were written; the caller empties it
    std::vector<std::uint32_t> interface; ///< new vertices of the interface; the caller empties it
    std::vector<std::uint32_t> heirs;     ///< for each new tet, which old one it inherits from
};

/// Replaces tets that fill a region by others that fill it. A face of the boundary that changes has
/// no partner: `unmatched` says how many such faces, old and new, there are. Throws InvariantError
/// if the two do not have the same faces on the outside. O(tets).
void replace(Complex& complex, Rewiring& work, std::span<const std::uint32_t> old,
             std::span<const NewTet> made, std::uint32_t unmatched = 0);

} // namespace dsc3

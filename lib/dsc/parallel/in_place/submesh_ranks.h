// SPDX-License-Identifier: MIT
// Ranks that share the work of the submeshes: each holds the whole mesh and runs the submeshes of
// its share; after each section they tell each other what these did, so that all hold the same
// again. What is serial runs on all of them alike.
#pragma once

#include "dsc/parallel/in_place/submesh_part.h"
#include "dsc/parallel/ranks/share_out.h"

#include <deque>

namespace dsc {

/// Of one rank.
template <class Real>
struct SubmeshExecutor<Real>::Shared {
    explicit Shared(Ranks& all) : ranks(all) {}

    /// The flags of a vertex before a section: what passes do to them is not in the log.
    struct Flags {
        std::uint32_t vertex;
        std::uint32_t flags;
    };
    /// What one submesh had before a section.
    struct Before {
        std::vector<std::uint32_t> interface;
        std::vector<std::uint32_t> free_vertices;
        std::vector<std::uint32_t> free_triangles;
        std::vector<Flags> flags;
        std::size_t records = 0; ///< in its log
    };
    /// The tasks of one colour.
    struct OfColour {
        std::vector<ShareOfRank> shares; ///< by rank, in numbers of parts
        Schedule own;                    ///< this rank's share
    };

    [[nodiscard]] const ShareOfRank& share(std::size_t colour) const {
        return colours[colour].shares[ranks.rank()];
    }

    Ranks& ranks;
    std::deque<OfColour> colours;        // a schedule stays where it is
    std::vector<Before> before;          ///< of this rank's share of the section
    std::vector<std::uint32_t> valuable; ///< scratch: vertices whose values have to be told
    EditLog silent;                      ///< of edits that nobody listens to
};

} // namespace dsc

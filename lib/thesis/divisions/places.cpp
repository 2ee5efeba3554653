// SPDX-License-Identifier: MIT
#include "thesis/divisions/places.h"

#include "dsc/base/error.h"

#include <utility>

namespace dsc {

namespace {

std::uint32_t call_place(const void* context, double x, double y) {
    return static_cast<const PlaceColour*>(context)->number_of(x, y);
}

} // namespace

template <class Real>
PlacePartitioner<Real>::PlacePartitioner(PlaceFunction<Real> function, std::uint32_t recut)
    : function_(std::move(function)), recut_(recut) {
    if (function_ == nullptr) {
        throw InputError({.what = "null function",
                          .where = "PlacePartitioner",
                          .value = "null",
                          .allowed = "a function that returns the colours"});
    }
    require(recut >= 1, "recut", recut, "1 step or more");
}

template <class Real>
Recut PlacePartitioner<Real>::is_due(const PartitionStatus& status) const {
    return status.steps_since_all >= recut_ ? Recut::all : Recut::none;
}

template <class Real>
void PlacePartitioner<Real>::divide(const PartitionInput<Real>& input, Recut /*recut*/,
                                    Partition& partition) {
    std::vector<PlaceColour> colours = function_(input);
    require(!colours.empty(), "colours", 0, "1 or more");
    for (const PlaceColour& colour : colours) {
        require(colour.submeshes >= 1, "submeshes of a colour", colour.submeshes, "1 or more");
        if (!colour.number_of) {
            throw InputError({.what = "null function",
                              .where = "PlaceColour::number_of",
                              .value = "null",
                              .allowed = "a function that returns the submesh of a place"});
        }
    }
    colours_ = std::move(colours);
    partition.colours.assign(colours_.size(), {});
    for (std::size_t c = 0; c < colours_.size(); ++c) {
        if (colours_[c].submeshes == 1) {
            partition.colours[c].regions.emplace_back(); // the whole mesh
            continue;
        }
        for (std::uint32_t i = 0; i < colours_[c].submeshes; ++i) {
            Region region;
            region.kind = Region::Kind::places;
            region.place = &call_place;
            region.context = &colours_[c];
            region.label = i;
            partition.colours[c].regions.push_back(region);
        }
    }
}

template class PlacePartitioner<double>;
template class PlacePartitioner<float>;

} // namespace dsc

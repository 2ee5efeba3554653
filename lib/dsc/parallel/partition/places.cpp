// SPDX-License-Identifier: MIT
#include "dsc/parallel/partition/partition.h"

#include "dsc/base/error.h"

#include <string>
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
    if (!function_ || recut < 1) {
        throw InputError({.what = "not a partition",
                          .where = "PlacePartitioner",
                          .value = !function_ ? "no function" : "0",
                          .allowed = "a function, and 1 step or more between two divisions"});
    }
}

template <class Real>
Recut PlacePartitioner<Real>::is_due(const PartitionStatus& status) const {
    return status.steps_since_all >= recut_ ? Recut::all : Recut::none;
}

template <class Real>
void PlacePartitioner<Real>::divide(const PartitionInput<Real>& input, Recut /*recut*/,
                                    Partition& partition) {
    std::vector<PlaceColour> colours = function_(input);
    for (const PlaceColour& colour : colours) {
        if (!colour.number_of || colour.submeshes < 1) {
            throw InputError({.what = "not a colour",
                              .where = "PlacePartitioner",
                              .value = std::to_string(colour.submeshes) + " submeshes",
                              .allowed = "a function and 1 submesh or more"});
        }
    }
    if (colours.empty()) {
        throw InputError({.what = "no colour",
                          .where = "PlacePartitioner",
                          .value = "0",
                          .allowed = "1 colour or more"});
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

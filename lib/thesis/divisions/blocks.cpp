// SPDX-License-Identifier: MIT
#include "thesis/divisions/blocks.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "dsc/passes/algorithm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

namespace {

constexpr std::uint32_t colour_count = 3;

// Cuts of one direction and colour, of equal widths over [low, high], shifted by thirds.
std::vector<double> cuts_of(double low, double high, std::uint32_t blocks, std::uint32_t colour) {
    std::vector<double> cuts{-Region::infinity};
    const double width = (high - low) / blocks;
    for (std::uint32_t i = colour == 0 ? 1 : 0; i < blocks; ++i) {
        cuts.push_back(low + (i + static_cast<double>(colour) / colour_count) * width);
    }
    cuts.push_back(Region::infinity);
    return cuts;
}

} // namespace

template <class Real>
BlockPartitioner<Real>::BlockPartitioner(const BlockOptions& options) : options_(options) {
    require(options.submeshes >= 1 && options.submeshes <= 65536, "submeshes", options.submeshes,
            "1 to 65536");
    require(options.min_width >= 2, "min_width", options.min_width, "2 edge lengths or more");
    require(options.recut >= 1, "recut", options.recut, "1 step or more");
}

template <class Real>
Recut BlockPartitioner<Real>::is_due(const PartitionStatus& status) const {
    return status.steps_since_all >= options_.recut ? Recut::all : Recut::none;
}

template <class Real>
void BlockPartitioner<Real>::divide(const PartitionInput<Real>& input, Recut /*recut*/,
                                    Partition& partition) {
    partition.colours.assign(1, {});
    if (input.interface.empty()) {
        partition.colours.front().regions.emplace_back();
        return;
    }
    // Only around the interface: there is no work elsewhere.
    std::array<double, 2> low{Region::infinity, Region::infinity};
    std::array<double, 2> high{-Region::infinity, -Region::infinity};
    for (const std::uint32_t v : input.interface) {
        const auto& record = input.complex.vertices[v];
        const std::array<double, 2> p{static_cast<double>(record.x), static_cast<double>(record.y)};
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    std::array<std::uint32_t, 2> blocks{};
    const auto wanted = static_cast<std::uint32_t>(std::sqrt(options_.submeshes));
    for (std::size_t k = 0; k < 2; ++k) {
        const double max = (high[k] - low[k]) / (options_.min_width * input.edge_length);
        blocks[k] = std::max(1U, std::min(wanted, static_cast<std::uint32_t>(max)));
    }
    if (blocks[0] * blocks[1] < 2) {
        partition.colours.front().regions.emplace_back();
        return;
    }
    partition.colours.assign(colour_count, {});
    for (std::uint32_t colour = 0; colour < colour_count; ++colour) {
        const auto across = cuts_of(low[0], high[0], blocks[0], colour);
        const auto up = cuts_of(low[1], high[1], blocks[1], colour);
        Region region;
        region.kind = Region::Kind::box;
        for (std::size_t j = 0; j + 1 < up.size(); ++j) {
            for (std::size_t i = 0; i + 1 < across.size(); ++i) {
                region.low = across[i];
                region.high = across[i + 1];
                region.side_low = up[j];
                region.side_high = up[j + 1];
                partition.colours[colour].regions.push_back(region);
            }
        }
    }
}

template class BlockPartitioner<double>;
template class BlockPartitioner<float>;

namespace {

template <class Real>
std::unique_ptr<Executor<Real>> blocks(Complex<Real>& complex, const Options<Real>& options,
                                       const Parallel& parallel, Algorithm<Real> algorithm) {
    return make_executor<Real>(
        complex, options, parallel,
        std::make_unique<BlockPartitioner<Real>>(BlockOptions{.submeshes = submeshes_of(parallel)}),
        std::move(algorithm));
}

} // namespace

constinit const Division blocks_division{"blocks",
                                         "cut in two directions, three colours (thesis, section 6)",
                                         BlockOptions{}.submeshes, blocks<double>, blocks<float>};

} // namespace dsc

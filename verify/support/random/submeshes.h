// SPDX-License-Identifier: MIT
// Random divisions of a complex into submeshes. Everything is drawn before the number of threads is
// known, so the same seed gives the same division for any number of threads.
#pragma once

#include "../enum_values.h"
#include "scene.h"

#include "dsc/base/names.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/partition/partition.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"
#include "thesis/divisions/voronoi.h"

#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace dsc::test {

/// A family of partitions: one partitioner, or one of its ways to choose the cuts.
enum class PartitionFamily : std::uint8_t { fixed, counting, active, blocks, cells, voronoi };

inline constexpr std::array partition_families{
    Named{PartitionFamily::fixed, "fixed"},   Named{PartitionFamily::counting, "counting"},
    Named{PartitionFamily::active, "active"}, Named{PartitionFamily::blocks, "blocks"},
    Named{PartitionFamily::cells, "cells"},   Named{PartitionFamily::voronoi, "voronoi"},
};
inline constexpr std::array all_partition_families = values_in(partition_families);

[[nodiscard]] constexpr std::string_view to_string(PartitionFamily family) {
    return name_in(partition_families, family);
}

inline std::uint32_t number_in(Dice& dice, int low, int high) {
    return static_cast<std::uint32_t>(dice.in(low, high));
}

/// A partitioner of this family, with small minimum widths, so that small scenes have many
/// submeshes, and with a new division after a few steps.
template <class Real>
std::unique_ptr<Partitioner<Real>> random_partitioner(Dice& dice, PartitionFamily family) {
    const double min_width = dice.in(2.0, 8.0);
    const std::uint32_t recut = number_in(dice, 1, 8);
    switch (family) {
    case PartitionFamily::fixed:
    case PartitionFamily::counting:
    case PartitionFamily::active: {
        SlabOptions slabs;
        slabs.slabbing = family == PartitionFamily::fixed      ? Slabbing::fixed
                         : family == PartitionFamily::counting ? Slabbing::counting
                                                               : Slabbing::active;
        slabs.submeshes = number_in(dice, 1, 9);
        // Sometimes a multiple of 90 degrees, because slabs along an axis have code of their own.
        slabs.degrees = dice.chance(0.3) ? 90 * dice.in(0, 3) : dice.in(-400.0, 400.0);
        slabs.follow_shape = dice.chance(0.25);
        slabs.min_width = min_width;
        slabs.recut = recut;
        return std::make_unique<SlabPartitioner<Real>>(slabs);
    }
    case PartitionFamily::blocks: {
        BlockOptions blocks;
        blocks.submeshes = number_in(dice, 1, 36);
        blocks.min_width = min_width;
        blocks.recut = recut;
        return std::make_unique<BlockPartitioner<Real>>(blocks);
    }
    case PartitionFamily::cells: {
        CellOptions cells;
        cells.submeshes = dice.chance(0.3) ? 0 : number_in(dice, 2, 12);
        cells.min_vertices = number_in(dice, 3, 12);
        cells.band = dice.in(0.0, 5.0);
        cells.min_width = min_width;
        cells.recut = recut;
        cells.recut_later = number_in(dice, 1, 4);
        return std::make_unique<CellPartitioner<Real>>(cells);
    }
    case PartitionFamily::voronoi: {
        const std::uint32_t submeshes = number_in(dice, 1, 10);
        const int rounds = dice.in(0, 8);
        return std::make_unique<PlacePartitioner<Real>>(
            [=](const PartitionInput<Real>& input) {
                return voronoi_colours(input, submeshes, rounds);
            },
            recut);
    }
    }
    return nullptr;
}

/// An executor with a random division, which always uses all threads, even for little work.
template <class Real>
std::unique_ptr<SubmeshExecutor<Real>> random_executor(Dice& dice, Complex<Real>& complex,
                                                       const Options<Real>& options,
                                                       std::uint32_t threads) {
    auto partitioner = random_partitioner<Real>(dice, dice.one_of(partition_families));
    const Parallel parallel{.threads = threads,
                            .always_all_threads = true,
                            .assignment = dice.one_of(assignment_names)};
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                   std::move(partitioner), parallel);
}

/// A complex and the view of it for a partitioner.
struct Divided {
    Divided(Complex<double> mesh, double edge_length)
        : complex(std::move(mesh)), h(edge_length), interface(collect_interface(complex)),
          work(interface.size(), 1.0F) {}

    void divide(Partitioner<double>& partitioner, Recut recut = Recut::all) {
        partitioner.divide({complex, interface, work, h}, recut, partition);
    }
    [[nodiscard]] Point<double> position(std::size_t i) const {
        return complex.position(Vertex{interface[i]});
    }
    [[nodiscard]] const std::vector<Region>& regions(std::size_t colour) const {
        return partition.colours.at(colour).regions;
    }

    Complex<double> complex;
    double h;
    std::vector<std::uint32_t> interface;
    std::vector<float> work;
    Partition partition;
};

inline Divided random_divided(Dice& dice, bool patches) {
    const double h = dice.in(0.015, 0.04);
    Divided divided(patches ? random_patches<double>(dice, h, 12) : random_shapes<double>(dice, h),
                    h);
    if (dice.chance(0.5)) {
        for (float& work : divided.work) {
            work = static_cast<float>(dice.in(1.0, 9.0));
        }
    }
    return divided;
}

/// The fraction of the weight in each region of a colour.
inline std::vector<double> shares_of(const Divided& divided, std::size_t colour) {
    std::vector<double> shares(divided.regions(colour).size(), 0);
    double total = 0;
    for (std::size_t i = 0; i < divided.interface.size(); ++i) {
        const Point<double> p = divided.position(i);
        const auto work = static_cast<double>(divided.work[i]);
        shares.at(divided.partition.colours[colour].locate(no_id, p.x(), p.y())) += work;
        total += work;
    }
    for (double& share : shares) {
        share /= total;
    }
    return shares;
}

} // namespace dsc::test

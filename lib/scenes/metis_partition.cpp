// SPDX-License-Identifier: MIT
#include "scenes/metis_partition.h"

#include "dsc/base/error.h"

#include <metis.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace dsc::scenes {

namespace {

/// A grid of squares, each with a label; places outside belong to the nearest square.
struct Grid {
    double x = 0;
    double y = 0;
    double side = 1;
    idx_t columns = 1;
    idx_t rows = 1;
    std::vector<idx_t> labels;

    [[nodiscard]] idx_t square(double px, double py) const {
        const auto clamp = [this](double offset, idx_t count) {
            const double at =
                std::clamp(std::floor(offset / side), 0.0, static_cast<double>(count - 1));
            return static_cast<idx_t>(at);
        };
        return clamp(py - y, rows) * columns + clamp(px - x, columns);
    }
};

template <class Real>
Grid grid_about(const PartitionInput<Real>& input) {
    constexpr double squares_side = 6; // edge lengths: room for a star on either side of a cut
    constexpr double most = 256;
    double low_x = Region::infinity;
    double low_y = Region::infinity;
    double high_x = -Region::infinity;
    double high_y = -Region::infinity;
    for (const std::uint32_t v : input.interface) {
        const Point<double> p = input.complex.position(Vertex{v}).template cast<double>();
        low_x = std::min(low_x, p.x());
        low_y = std::min(low_y, p.y());
        high_x = std::max(high_x, p.x());
        high_y = std::max(high_y, p.y());
    }
    Grid grid;
    grid.x = low_x;
    grid.y = low_y;
    const double extent = std::max(high_x - low_x, high_y - low_y);
    grid.side = std::max(squares_side * input.edge_length, extent / most);
    grid.columns = static_cast<idx_t>((high_x - low_x) / grid.side) + 1;
    grid.rows = static_cast<idx_t>((high_y - low_y) / grid.side) + 1;
    return grid;
}

// Labels of the squares; `avoid`: those of another colour; cuts where it has cuts cost more.
std::vector<idx_t> partition(const Grid& grid, const std::vector<idx_t>& load,
                             std::uint32_t submeshes, const std::vector<idx_t>* avoid) {
    constexpr idx_t price_of_same_cut = 64;
    std::vector<idx_t> begin{0};
    std::vector<idx_t> neighbours;
    std::vector<idx_t> prices;
    std::vector<idx_t> weights;
    for (idx_t row = 0; row < grid.rows; ++row) {
        for (idx_t column = 0; column < grid.columns; ++column) {
            const idx_t square = row * grid.columns + column;
            const auto at = [](idx_t i) { return static_cast<std::size_t>(i); };
            const auto add = [&](bool exists, idx_t other) {
                if (exists) {
                    const bool was_cut =
                        avoid != nullptr && (*avoid)[at(square)] != (*avoid)[at(other)];
                    neighbours.push_back(other);
                    prices.push_back((1 + load[at(square)] + load[at(other)]) *
                                     (was_cut ? price_of_same_cut : 1));
                }
            };
            add(column > 0, square - 1);
            add(column + 1 < grid.columns, square + 1);
            add(row > 0, square - grid.columns);
            add(row + 1 < grid.rows, square + grid.columns);
            begin.push_back(static_cast<idx_t>(neighbours.size()));
            weights.push_back(load[at(square)]);
        }
    }
    idx_t squares = grid.columns * grid.rows;
    idx_t constraints = 1;
    auto parts = static_cast<idx_t>(submeshes);
    idx_t cut = 0;
    std::vector<idx_t> options(METIS_NOPTIONS);
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = 1; // the same partition for the same interface
    std::vector<idx_t> labels(static_cast<std::size_t>(squares), 0);
    const int result = METIS_PartGraphKway(&squares, &constraints, begin.data(), neighbours.data(),
                                           weights.data(), nullptr, prices.data(), &parts, nullptr,
                                           nullptr, options.data(), &cut, labels.data());
    if (result != METIS_OK) {
        throw InvariantError("METIS failed with code " + std::to_string(result));
    }
    return labels;
}

PlaceColour colour_of(Grid grid, std::uint32_t submeshes) {
    const auto shared = std::make_shared<const Grid>(std::move(grid));
    return {[shared](double x, double y) {
                return static_cast<std::uint32_t>(
                    shared->labels[static_cast<std::size_t>(shared->square(x, y))]);
            },
            submeshes};
}

} // namespace

template <class Real>
std::vector<PlaceColour> metis_colours(const PartitionInput<Real>& input, std::uint32_t submeshes) {
    Grid grid;
    if (!input.interface.empty()) {
        grid = grid_about(input);
    }
    const auto squares =
        static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
    if (submeshes < 2 || squares < 2 * static_cast<std::size_t>(submeshes)) {
        return {{[](double, double) { return 0U; }, 1}};
    }
    std::vector<idx_t> load(squares, 0);
    for (const std::uint32_t v : input.interface) {
        const Point<double> p = input.complex.position(Vertex{v}).template cast<double>();
        ++load[static_cast<std::size_t>(grid.square(p.x(), p.y()))];
    }
    Grid second = grid;
    grid.labels = partition(grid, load, submeshes, nullptr);
    second.labels = partition(grid, load, submeshes, &grid.labels);
    return {colour_of(std::move(grid), submeshes), colour_of(std::move(second), submeshes)};
}

template std::vector<PlaceColour> metis_colours(const PartitionInput<double>&, std::uint32_t);
template std::vector<PlaceColour> metis_colours(const PartitionInput<float>&, std::uint32_t);

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "dsc/initial/input/label_regions.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace dsc::initial {

namespace {

// Pixels that belong together (R. E. Tarjan, "Efficiency of a good but not linear set union
// algorithm", 1975); the smallest number stands for all.
class Union {
public:
    explicit Union(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(std::uint32_t i, std::uint32_t j) {
        const auto [first, second] = std::minmax({root(i), root(j)});
        parent_[second] = first;
    }

private:
    std::vector<std::uint32_t> parent_;
};

// A grain's extent, and the borders with its neighbours.
struct Extent {
    std::size_t left = std::numeric_limits<std::size_t>::max();
    std::size_t right = 0;
    std::size_t top = std::numeric_limits<std::size_t>::max();
    std::size_t bottom = 0;
    bool is_small = false;
    std::map<std::uint32_t, std::size_t> borders{}; // borders of small grains: in sides of pixels
};

// One round: merges small grains into neighbours that are not merged themselves in this round.
bool drop_once(LabelImage& image, const Point<double>& pixel, double min_size,
               InputReport& report) {
    const Grains grains = grains_of(image);
    std::vector<Extent> extents(grains.pixels.size());
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        Extent& extent = extents[grains.of_pixel[i]];
        const std::size_t row = i / image.columns;
        const std::size_t column = i % image.columns;
        extent.left = std::min(extent.left, column);
        extent.right = std::max(extent.right, column);
        extent.top = std::min(extent.top, row);
        extent.bottom = std::max(extent.bottom, row);
    }
    std::vector<std::uint32_t> small;
    for (std::uint32_t g = 0; g < extents.size(); ++g) {
        Extent& extent = extents[g];
        const Point<double> size(static_cast<double>(extent.right - extent.left + 1),
                                 static_cast<double>(extent.bottom - extent.top + 1));
        extent.is_small =
            grains.pixels[g] < image.min_pixels || size.cwiseProduct(pixel).norm() < min_size;
        if (extent.is_small) {
            small.push_back(g);
        }
    }
    const auto count = [&](std::size_t i, std::size_t j) {
        const std::uint32_t one = grains.of_pixel[i];
        const std::uint32_t other = grains.of_pixel[j];
        if (one != other && extents[one].is_small) {
            ++extents[one].borders[other];
        }
        if (one != other && extents[other].is_small) {
            ++extents[other].borders[one];
        }
    };
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        if ((i + 1) % image.columns != 0) {
            count(i, i + 1);
        }
        if (i + image.columns < image.labels.size()) {
            count(i, i + image.columns);
        }
    }
    std::ranges::stable_sort(small, {}, [&](std::uint32_t g) { return grains.pixels[g]; });
    constexpr std::uint32_t stays = no_id;
    std::vector<std::uint32_t> goes_to(extents.size(), stays);
    std::vector<std::uint8_t> is_taken(extents.size(), 0); // whether a grain is merged into it
    bool any = false;
    for (const std::uint32_t g : small) {
        const auto& borders = extents[g].borders;
        const auto longest =
            std::ranges::max_element(borders, {}, [](const auto& border) { return border.second; });
        if (longest == borders.end() || is_taken[g] != 0 || goes_to[longest->first] != stays) {
            continue;
        }
        goes_to[g] = longest->first;
        is_taken[longest->first] = 1;
        any = true;
        ++report.dropped;
        report.area_dropped += static_cast<double>(grains.pixels[g]) * pixel.prod();
    }
    std::vector<Phase> phases(extents.size());
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        phases[grains.of_pixel[i]] = image.labels[i];
    }
    for (std::size_t i = 0; i < image.labels.size(); ++i) {
        if (const std::uint32_t to = goes_to[grains.of_pixel[i]]; to != stays) {
            image.labels[i] = phases[to];
        }
    }
    return any;
}

} // namespace

Grains grains_of(const LabelImage& image) {
    const auto columns = static_cast<std::uint32_t>(image.columns);
    const auto count = static_cast<std::uint32_t>(image.labels.size());
    Union pixels(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((i + 1) % columns != 0 && image.labels[i] == image.labels[i + 1]) {
            pixels.join(i, i + 1);
        }
        if (i + columns < count && image.labels[i] == image.labels[i + columns]) {
            pixels.join(i, i + columns);
        }
    }
    Grains grains;
    grains.of_pixel.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t root = pixels.root(i);
        if (root == i) {
            grains.of_pixel[i] = static_cast<std::uint32_t>(grains.pixels.size());
            grains.pixels.push_back(0);
        } else {
            grains.of_pixel[i] = grains.of_pixel[root];
        }
        ++grains.pixels[grains.of_pixel[i]];
    }
    return grains;
}

void drop_small_grains(LabelImage& image, const Point<double>& pixel, double min_size,
                       InputReport& report) {
    // Each round reduces the number of sets of pixels joined by sides.
    while (drop_once(image, pixel, min_size, report)) {
    }
}

} // namespace dsc::initial

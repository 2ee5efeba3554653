// SPDX-License-Identifier: MIT
// A submesh owns a star if it owns all of its vertices, for every kind of region.
// parallel/partition_test.cpp shows that each place has one owner. That submeshes do not touch what
// they do not own follows from equal results for any number of threads, without a race.
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"

#include "support/random/scene.h"

#include "dsc/parallel/partition/partition.h"
#include "thesis/divisions/voronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dsc::submesh_test {
namespace {

using test::Dice;

// A complex with free ids, such as the pools of submeshes hold.
Complex<double> divided(Dice& dice, bool patches) {
    constexpr double h = 0.03;
    auto complex =
        patches ? test::random_patches<double>(dice, h, 8) : test::random_shapes<double>(dice, h);
    for (int i = 0; i < 200; ++i) {
        complex.vertices[complex.take_vertex(complex.ids)].flags = vertex_dead;
    }
    return complex;
}

struct DrawnRegion {
    Region region;
    PlaceColour places;                ///< data to which the region points
    std::vector<std::uint32_t> labels; ///< the same
};

enum class Form : std::uint8_t { slab, turned, block, round, turned_round, places, labels };
constexpr std::array forms{Form::slab,         Form::turned, Form::block, Form::round,
                           Form::turned_round, Form::places, Form::labels};

void draw_region(Dice& dice, Form form, const Complex<double>& complex, DrawnRegion& drawn) {
    Region& region = drawn.region;
    region.kind = Region::Kind::box;
    if (form == Form::turned || form == Form::turned_round) {
        const double angle = dice.in(0.0, 6.3);
        region.normal_x = std::cos(angle);
        region.normal_y = std::sin(angle);
    }
    const double middle = region.along(0.5, 0.5);
    region.low = middle - dice.in(0.05, 0.3);
    region.high = middle + dice.in(0.05, 0.3);
    switch (form) {
    case Form::slab:
    case Form::turned: break;
    case Form::block:
        region.side_low = dice.in(0.1, 0.4);
        region.side_high = dice.in(0.6, 0.9);
        break;
    case Form::round:
    case Form::turned_round: std::swap(region.low, region.high); break;
    case Form::places: {
        std::vector<Point<double>> sites;
        for (int i = 0; i < 6; ++i) {
            sites.push_back(dice.point(0, 1));
        }
        sites[0] = {0.5, 0.4};
        drawn.places = voronoi_colour(sites);
        region.kind = Region::Kind::places;
        region.context = &drawn.places;
        region.place = [](const void* context, double x, double y) {
            return static_cast<const PlaceColour*>(context)->number_of(x, y);
        };
        break;
    }
    case Form::labels:
        // The submesh owns a disc, and the free ids in its pool.
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            const bool inside =
                (complex.position(Vertex{v}) - Point<double>(0.5, 0.5)).norm() < 0.3;
            drawn.labels.push_back(!complex.is_alive(Vertex{v}) || inside ? 7 : 3);
        }
        region.kind = Region::Kind::labels;
        region.labels = drawn.labels.data();
        region.label = 7;
        break;
    }
}

// The submesh must own the centre and the whole link of the star, whichever function tests it; a
// vertex exactly on a cut belongs only to the submesh above.
TEST(Submesh, OwnsAStarIfItOwnsAllItsVertices) {
    std::array<std::size_t, 2> stars{};
    for (const Form form : forms) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            SCOPED_TRACE("form " + std::to_string(static_cast<int>(form)) + ", seed " +
                         std::to_string(seed));
            Dice dice(seed);
            const Complex<double> complex = divided(dice, seed % 2 == 0);
            DrawnRegion drawn;
            draw_region(dice, form, complex, drawn);
            if (form == Form::slab || form == Form::block) {
                const auto place_of_one = [&] {
                    std::uint32_t v = 0;
                    do {
                        v = static_cast<std::uint32_t>(
                            dice.in(0, static_cast<int>(complex.vertex_bound()) - 1));
                    } while (!complex.is_alive(Vertex{v}));
                    return complex.position(Vertex{v});
                };
                drawn.region.low = place_of_one().x();
                drawn.region.high = std::max(place_of_one().x(), drawn.region.low);
                drawn.region.side_low = place_of_one().y();
                drawn.region.side_high = std::max(place_of_one().y(), drawn.region.side_low);
            }
            const Region simplest = drawn.region.simplest();
            EXPECT_EQ(simplest.kind == Region::Kind::upright,
                      form == Form::slab || form == Form::block);
            Star<double> star;
            for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
                if (!complex.is_alive(Vertex{v})) {
                    continue;
                }
                ASSERT_TRUE(gather(complex, Region{}, v, star));
                bool expected = owns(complex, drawn.region, v);
                for (std::uint32_t i = 0; i < star.link_size(); ++i) {
                    expected = expected && owns(complex, drawn.region, star.link[i]);
                }
                (void)gather(complex, drawn.region, v, star);
                ASSERT_EQ(star.owned, expected) << "vertex " << v;
                (void)gather(complex, simplest, v, star);
                ASSERT_EQ(star.owned, expected) << "vertex " << v;
                ++stars.at(expected ? 1 : 0);
            }
        }
    }
    EXPECT_GT(stars[0], 1000U);
    EXPECT_GT(stars[1], 1000U);
}

} // namespace
} // namespace dsc::submesh_test

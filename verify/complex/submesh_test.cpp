// SPDX-License-Identifier: MIT
// A submesh does not change what it does not own, whatever its region is like; and places exactly
// on a cut have one owner.
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"

#include "support/random/scene.h"

#include "dsc/parallel/partition/partition.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/interface/list.h"
#include "dsc/queries/validate.h"
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
using test::RandomFlow;
using test::Wildness;

// Everything known of a vertex except the scratch data of the active set.
struct Seen {
    double x, y;
    std::uint32_t flags;
    friend bool operator==(const Seen&, const Seen&) = default;
};

// A complex, and one submesh of it with ids of its own and all interface vertices to move.
class OneOfSeveral {
public:
    OneOfSeveral(Dice& dice, bool patches)
        : complex(patches ? test::random_patches<double>(dice, h, 8)
                          : test::random_shapes<double>(dice, h)) {
        options.edge_length = h;
        constexpr int spare = 200;
        for (int i = 0; i < spare; ++i) {
            const std::uint32_t v = complex.take_vertex(complex.ids);
            complex.vertices[v].flags = vertex_dead;
            pool.vertices.push_back(v);
            for (int k = 0; k < 2; ++k) {
                const std::uint32_t t = complex.take_triangle(complex.ids);
                complex.triangles[t].v = {no_id, no_id, no_id};
                pool.triangles.push_back(t);
            }
        }
        pool.may_grow = false;
    }

    // Upkeep and motion in the region; what it does not own must stay the same bit for bit, and so
    // must the triangles that are not wholly in it, except for their links.
    void run(const Region& region, const RandomFlow& flow) {
        Work<double> work(complex, options);
        work.submesh.region = region;
        work.submesh.pool = &pool;
        work.epoch = 1;
        work.interface = collect_interface(complex);
        std::vector<Point<double>> positions;
        for (const std::uint32_t v : work.interface) {
            positions.push_back(complex.position(Vertex{v}));
        }
        std::vector<Point<double>> velocities(positions.size());
        flow.velocity<double>()(positions, 0, velocities);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> target = positions[i] + 0.5 * h * velocities[i];
            work.movers.push_back({work.interface[i], target.x(), target.y()});
        }
        const std::size_t listed = work.movers.size();
        const auto vertices = complex.vertices;
        const auto triangles = complex.triangles;
        const auto owned = [&](std::uint32_t v) {
            return region.owns(v, vertices[v].x, vertices[v].y);
        };
        const auto algorithm = default_algorithm<double>();
        for (const auto* passes : {&algorithm.upkeep, &algorithm.motion}) {
            for (const auto& pass : *passes) {
                pass.run(work);
            }
        }
        moved += work.log.counts.moves;
        const auto movers = static_cast<std::size_t>(std::ranges::count(
            work.deferred.entries, DeferredKind::mover, &Deferred<double>::kind));
        put_off += movers;
        // Every vertex is accounted for: arrived, on the way, or put off; only deleted ones are
        // not.
        EXPECT_LE(movers + work.movers.size(), listed);
        for (std::uint32_t v = 0; v < vertices.size(); ++v) {
            const auto& now = complex.vertices[v];
            if ((vertices[v].flags & vertex_dead) == 0 && !owned(v)) {
                ++foreign_vertices;
                ASSERT_EQ((Seen{now.x, now.y, now.flags}),
                          (Seen{vertices[v].x, vertices[v].y, vertices[v].flags}))
                    << "vertex " << v;
            } else if ((now.flags & vertex_dead) == 0) {
                ASSERT_TRUE(region.owns(v, now.x, now.y))
                    << "vertex " << v << " went, or was made, where another submesh works";
            }
        }
        for (std::uint32_t t = 1; t < triangles.size(); ++t) {
            const auto& v = triangles[t].v;
            if (v[0] != no_id && !(owned(v[0]) && owned(v[1]) && owned(v[2]))) {
                ++foreign_triangles;
                ASSERT_EQ(complex.triangles[t].v, v) << "triangle " << t;
                ASSERT_EQ(complex.triangles[t].phase, triangles[t].phase) << "triangle " << t;
            }
        }
        complex.lent_vertices = static_cast<std::uint32_t>(pool.vertices.size());
        complex.lent_triangles = static_cast<std::uint32_t>(pool.triangles.size());
        ASSERT_EQ(validate(complex).problem, "");
    }

    static constexpr double h = 0.03;
    Complex<double> complex;
    Options<double> options;
    IdPool pool;
    std::uint64_t moved = 0;
    std::size_t put_off = 0;
    int foreign_vertices = 0;
    int foreign_triangles = 0;
};

struct DrawnRegion {
    Region region;
    PlaceColour places;                ///< what the region points to
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
        // A disc; free ids in its pool are its own.
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

TEST(Submesh, LeavesAloneWhatItDoesNotOwn) {
    for (const Form form : forms) {
        std::uint64_t moved = 0;
        std::size_t put_off = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            SCOPED_TRACE("form " + std::to_string(static_cast<int>(form)) + ", seed " +
                         std::to_string(seed));
            Dice dice(seed);
            OneOfSeveral submesh(dice, seed % 2 == 0);
            const RandomFlow flow(dice, 1, Wildness::none);
            DrawnRegion drawn;
            draw_region(dice, form, submesh.complex, drawn);
            submesh.run(seed % 3 == 0 ? drawn.region : drawn.region.simplest(), flow);
            if (HasFatalFailure()) {
                return;
            }
            moved += submesh.moved;
            put_off += submesh.put_off;
            EXPECT_GT(submesh.foreign_vertices, 50);
            EXPECT_GT(submesh.foreign_triangles, 100);
        }
        EXPECT_GT(moved, 100U) << "form " << static_cast<int>(form);
        EXPECT_GT(put_off, 100U) << "form " << static_cast<int>(form);
    }
}

// A star is owned if its centre and all of its link are, whichever way it is tested; also where
// vertices lie exactly on a cut, which belongs to the submesh above it alone.
TEST(Submesh, OwnsAStarIfItOwnsAllItsVertices) {
    std::array<std::size_t, 2> stars{};
    for (const Form form : forms) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            SCOPED_TRACE("form " + std::to_string(static_cast<int>(form)) + ", seed " +
                         std::to_string(seed));
            Dice dice(seed);
            const OneOfSeveral submesh(dice, seed % 2 == 0);
            const Complex<double>& complex = submesh.complex;
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
            Ring<double> ring;
            for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
                if (!complex.is_alive(Vertex{v})) {
                    continue;
                }
                ASSERT_TRUE(gather(complex, Region{}, v, ring));
                bool expected = owns(complex, drawn.region, v);
                for (std::uint32_t i = 0; i < ring.link_size(); ++i) {
                    expected = expected && owns(complex, drawn.region, ring.link[i]);
                }
                (void)gather(complex, drawn.region, v, ring);
                ASSERT_EQ(ring.owned, expected) << "vertex " << v;
                (void)gather(complex, simplest, v, ring);
                ASSERT_EQ(ring.owned, expected) << "vertex " << v;
                ++stars.at(expected ? 1 : 0);
            }
        }
    }
    EXPECT_GT(stars[0], 1000U);
    EXPECT_GT(stars[1], 1000U);
}

// Three by three boxes of side 1, the outer ones without an outer bound.
std::vector<Region> nine_boxes() {
    constexpr std::array cuts{-Region::infinity, 1.0, 2.0, Region::infinity};
    std::vector<Region> regions;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            Region region;
            region.kind = Region::Kind::box;
            region.low = cuts[i];
            region.high = cuts[i + 1];
            region.side_low = cuts[j];
            region.side_high = cuts[j + 1];
            regions.push_back(region);
        }
    }
    return regions;
}

TEST(Submesh, OwnsPlacesOnACutAlone) {
    const std::vector<Region> regions = nine_boxes();
    for (const double x : {0.5, 1.0, 1.5, 2.0, 3.0}) {
        for (const double y : {-7.0, 1.0, 2.0, 2.5}) {
            EXPECT_EQ(std::ranges::count_if(
                          regions, [&](const Region& region) { return region.owns(0, x, y); }),
                      1)
                << x << ", " << y;
        }
    }
}

} // namespace
} // namespace dsc::submesh_test

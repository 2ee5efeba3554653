// SPDX-License-Identifier: MIT
// A submesh leaves what it does not own alone, whatever its region is like; what one of them throws
// comes out, and the simulation goes on.
#include "dsc/parallel/submesh_executor.h"

#include "random_scene.h"
#include "random_submeshes.h"

#include "dsc/algorithm/driver.h"
#include "dsc/algorithm/interface_upkeep.h"
#include "dsc/base/error.h"
#include "dsc/complex/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using test::Dice;
using test::RandomFlow;
using test::Wildness;

// --- ownership ----------------------------------------------------------------------------------

// All that is known of a vertex but the scratch of the active set.
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

    // Upkeep and motion in the region; what it does not own must stay bit for bit, and so must the
    // triangles that are not wholly in it, but for their links.
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
        moved += work.counts.moves;
        put_off += work.put_off_movers.size();
        // Everyone is accounted for: arrived, on the way, or put off; only the dead are not.
        EXPECT_LE(work.put_off_movers.size() + work.movers.size(), listed);
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
            sites.emplace_back(dice.in(0.0, 1.0), dice.in(0.0, 1.0));
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
        // A disc; free ids, which its pool has, are its own.
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
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            SCOPED_TRACE("form " + std::to_string(static_cast<int>(form)) + ", seed " +
                         std::to_string(seed));
            Dice dice(seed);
            OneOfSeveral submesh(dice, seed % 2 == 0);
            const RandomFlow flow(dice, 1, Wildness::none);
            DrawnRegion drawn;
            draw_region(dice, form, submesh.complex, drawn);
            submesh.run(drawn.region, flow);
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

// --- failures -----------------------------------------------------------------------------------

struct Fault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Velocity<double> everywhere(double x, double y) {
    return [=](std::span<const Point<double>>, double, std::span<Point<double>> velocities) {
        std::ranges::fill(velocities, Point<double>(x, y));
    };
}

// A disc that grows, in submeshes of a partitioner; `seen` is where the partition is.
struct Growing {
    static constexpr double h = 0.02;

    explicit Growing(std::unique_ptr<Partitioner<double>> partitioner, std::uint32_t threads,
                     Algorithm<double> algorithm = default_algorithm<double>())
        : complex(test::disc_complex<double>(h)) {
        options.edge_length = h;
        auto made = std::make_unique<SubmeshExecutor<double>>(
            complex, options, std::move(algorithm), std::move(partitioner),
            SubmeshOptions{.threads = threads, .vertices_per_thread = 1});
        seen = made.get();
        simulation = std::make_unique<Simulation<double>>(complex, options, std::move(made));
    }

    void expect_good() {
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(test::interface_fault(complex, simulation->interface()), "");
    }
    // What was on its way when a step was lost must not arrive in a later one.
    void expect_to_go_on() {
        expect_good();
        EXPECT_EQ(simulation->step(everywhere(0, 0), 0, 1).operations.moves, 0U);
        for (int step = 0; step < 6; ++step) {
            EXPECT_EQ(simulation->step(grow, 0, h).unreached, 0U);
            expect_good();
        }
    }

    Velocity<double> grow = [](std::span<const Point<double>> positions, double,
                               std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = (positions[i] - Point<double>(0.5, 0.5)).normalized();
        }
    };
    Complex<double> complex;
    Options<double> options;
    const SubmeshExecutor<double>* seen = nullptr;
    std::unique_ptr<Simulation<double>> simulation;
};

struct Way {
    const char* name;
    std::function<std::unique_ptr<Partitioner<double>>()> make;
};

// Small, and divided anew while all this happens.
std::vector<Way> ways_to_divide() {
    return {
        {"slabs",
         [] {
             return std::make_unique<SlabPartitioner<double>>(
                 SlabOptions{.slabbing = Slabbing::active,
                             .submeshes = 4,
                             .degrees = 20,
                             .least_width = 3,
                             .recut = 3});
         }},
        {"blocks",
         [] {
             return std::make_unique<BlockPartitioner<double>>(
                 BlockOptions{.submeshes = 9, .least_width = 4, .recut = 3});
         }},
        {"cells",
         [] {
             return std::make_unique<CellPartitioner<double>>(
                 CellOptions{.submeshes = 4, .least_vertices = 8, .recut = 3, .recut_later = 1});
         }},
        {"Voronoi regions",
         [] {
             return std::make_unique<PlacePartitioner<double>>(
                 [](const PartitionInput<double>& input) { return voronoi_colours(input, 5); }, 3);
         }},
    };
}

TEST(SubmeshExecutor, PassesOnWhatAVelocityThrows) {
    for (const Way& way : ways_to_divide()) {
        for (const std::uint32_t threads : {1U, 2U, 4U}) {
            for (const int good_steps : {0, 2}) { // before; two: it is just about to divide anew
                SCOPED_TRACE(std::string(way.name) + ", threads " + std::to_string(threads));
                Growing disc(way.make(), threads);
                for (int step = 0; step < good_steps; ++step) {
                    (void)disc.simulation->step(disc.grow, 0, Growing::h);
                }
                const Velocity<double> faulty = [&](std::span<const Point<double>> positions,
                                                    double, std::span<Point<double>> velocities) {
                    disc.grow(positions, 0, velocities);
                    for (const auto& p : positions) {
                        if (p.x() > 0.7) {
                            throw Fault("no velocity here");
                        }
                    }
                };
                EXPECT_THROW((void)disc.simulation->step(faulty, 0, Growing::h), Fault);
                EXPECT_GE(disc.seen->partition().colours.front().regions.size(), 3U);
                disc.expect_to_go_on();
            }
        }
    }
}

bool is_same(const Region& a, const Region& b) {
    return a.kind == b.kind && a.low == b.low && a.high == b.high && a.side_low == b.side_low &&
           a.side_high == b.side_high && a.place == b.place && a.context == b.context &&
           a.label == b.label;
}

// A pass of the application throws in one submesh of some colour, or in the serial clean-up, before
// or after the other passes ran there, in a step that is not the first. The step is lost, the
// simulation is not.
TEST(SubmeshExecutor, GoesOnAfterAPassThrew) {
    constexpr std::size_t clean_up = 99;
    int serial_faults = 0;
    for (const Way& way : ways_to_divide()) {
        for (const bool in_upkeep : {true, false}) {
            for (const bool before : {true, false}) {
                for (const std::size_t colour : {std::size_t{0}, std::size_t{1}, clean_up}) {
                    SCOPED_TRACE(std::string(way.name) + (in_upkeep ? ", upkeep" : ", motion") +
                                 (before ? ", first" : ", last") + ", colour " +
                                 std::to_string(colour));
                    std::atomic<bool> is_armed{false};
                    std::atomic<bool> has_thrown{false};
                    const SubmeshExecutor<double>* seen = nullptr;
                    const auto is_meant = [&](const Region& region) {
                        if (colour == clean_up) {
                            return region.is_whole();
                        }
                        // Any but the first of them.
                        const auto& regions = seen->partition().colours.at(colour).regions;
                        return std::any_of(regions.begin() + 1, regions.end(),
                                           [&](const auto& r) { return is_same(r, region); });
                    };
                    const Pass<double> fault{"fault", [&](Work<double>& work) {
                                                 if (is_armed && is_meant(work.submesh.region)) {
                                                     has_thrown = true;
                                                     throw Fault("as seeded");
                                                 }
                                             }};
                    auto algorithm = default_algorithm<double>();
                    auto& passes = in_upkeep ? algorithm.upkeep : algorithm.motion;
                    passes.insert(before ? passes.begin() : passes.end(), fault);
                    Growing disc(way.make(), 3, algorithm);
                    seen = disc.seen;
                    (void)disc.simulation->step(disc.grow, 0, Growing::h);
                    disc.expect_good();
                    is_armed = true;
                    bool came_out = false;
                    for (int step = 0; step < 4 && !came_out; ++step) {
                        try {
                            (void)disc.simulation->step(disc.grow, 0, Growing::h);
                        } catch (const Fault&) {
                            came_out = true;
                        }
                    }
                    EXPECT_EQ(came_out, has_thrown);
                    if (colour != clean_up) {
                        EXPECT_TRUE(has_thrown) << "nothing ran there";
                    }
                    serial_faults += colour == clean_up && has_thrown ? 1 : 0;
                    is_armed = false;
                    disc.expect_to_go_on();
                }
            }
        }
    }
    EXPECT_GE(serial_faults, 2) << "nothing was ever left for the serial clean-up";
}

// A partition of the application that does not cover the plane, or that throws.
TEST(SubmeshExecutor, PassesOnWhatIsWrongWithAPartition) {
    bool is_faulty = false;
    Growing disc(std::make_unique<PlacePartitioner<double>>(
                     [&](const PartitionInput<double>& input) {
                         if (is_faulty) {
                             throw Fault("no partition");
                         }
                         return voronoi_colours(input, 4);
                     },
                     2),
                 2);
    for (int step = 0; step < 5; ++step) {
        is_faulty = step == 2;
        if (is_faulty) {
            EXPECT_THROW((void)disc.simulation->step(disc.grow, 0, Growing::h), Fault);
        } else {
            EXPECT_EQ(disc.simulation->step(disc.grow, 0, Growing::h).unreached, 0U);
        }
        disc.expect_good();
    }
    Growing gap(std::make_unique<PlacePartitioner<double>>([](const PartitionInput<double>&) {
                    return std::vector<PlaceColour>{
                        {[](double x, double) { return x < 0.5 ? 0U : 2U; }, 2}};
                }),
                2);
    EXPECT_THROW((void)gap.simulation->step(gap.grow, 0, Growing::h), InvariantError);
    EXPECT_EQ(validate(gap.complex).problem, "");
}

// --- options ------------------------------------------------------------------------------------

TEST(SubmeshExecutor, RefusesOptionsThatMakeNoSense) {
    auto complex = test::disc_complex<double>(0.05);
    Options<double> options;
    options.edge_length = 0.05;
    const auto make = [&](bool with_partitioner, const SubmeshOptions& submeshes) {
        std::unique_ptr<Partitioner<double>> partitioner;
        if (with_partitioner) {
            partitioner = std::make_unique<SlabPartitioner<double>>(SlabOptions{});
        }
        const SubmeshExecutor<double> executor(complex, options, default_algorithm<double>(),
                                               std::move(partitioner), submeshes);
    };
    make(true, {});
    EXPECT_THROW(make(false, {}), InputError);
    struct Seeded {
        const char* where;
        SubmeshOptions options;
    };
    for (const Seeded& fault :
         {Seeded{"threads", {.threads = 0}}, Seeded{"threads", {.threads = 5000}},
          Seeded{"vertices_per_thread", {.vertices_per_thread = 0}}}) {
        try {
            make(true, fault.options);
            ADD_FAILURE() << "accepted: " << fault.where;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), fault.where);
        }
    }
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc

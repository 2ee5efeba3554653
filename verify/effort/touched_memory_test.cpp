// SPDX-License-Identifier: MIT
// A step visits the interface and what changes around it, never the whole mesh: in a large mesh
// with a small disc, steps touch a small part of the memory. Linux marks the pages that a process
// uses, which are counted.
#include "support/pointwise.h"
#include "support/random/scene.h"
#include "support/topology/changing.h"
#include "support/ways.h"

#include "dsc/algorithm/simulation.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace dsc::touched_memory_test {
namespace {

using test::Way;

constexpr double h = 0.02;
constexpr int steps = 6;

// The memory touched that is no file's, in kB; -1 if the kernel does not report it. Pages of files,
// such as libraries, are shared: other processes touch them, too.
long referenced_memory() {
    std::ifstream maps("/proc/self/smaps");
    long sum = -1;
    bool is_of_file = false;
    for (std::string line; std::getline(maps, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first == "Referenced:") {
            long kilobytes = 0;
            words >> kilobytes;
            sum = std::max(sum, 0L) + (is_of_file ? 0 : kilobytes);
        } else if (!first.ends_with(':')) { // a mapping: addresses, rights, offset, device, inode
            std::string inode;
            words >> inode >> inode >> inode >> inode;
            is_of_file = inode != "0";
        }
    }
    return sum;
}

// Pages that are still in the TLB would not be marked when they are used again. Unmapping many
// pages empties the TLB.
bool empty_tlb() {
    constexpr std::size_t size = 1 << 20; // far more pages than Linux drops one by one, 33
    void* const pages = mmap(nullptr, size, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    return pages != MAP_FAILED && munmap(pages, size) == 0;
}

bool forget_references() {
    std::ofstream file("/proc/self/clear_refs");
    file << '1' << std::flush;
    return file.good() && empty_tlb();
}

struct Touched {
    long kilobytes = 0;
    long mesh = 0; ///< size of all vertices and triangles, in kB
    std::uint64_t moves = 0;
    std::uint32_t triangles = 0;
};

// A disc of diameter 0.5 in the middle of the domain, which moves to and fro.
Touched touched_by_steps(const test::ChangingOptions<double>& options, Way way) {
    constexpr double side = 8;
    const Point<double> centre(side / 2, side / 2);
    const std::vector<Shape> shapes{{test::circle_points(centre, 0.25, 79), 1}};
    auto complex = initial_complex<double>({{0, 0}, {side, side}}, shapes, {.edge_length = h});
    Simulation<double> simulation(complex, options, test::executor_of(way, complex, options));
    if (options.topology.changes()) {
        simulation.add_stage(std::make_shared<TopologyStage<double>>(options.topology));
    }
    double speed = 1;
    const auto shear = test::pointwise(
        [&](const Point<double>& p) { return Point<double>(speed, speed * (p.x() - centre.x())); });
    const auto step = [&] {
        speed = -speed;
        return simulation.step(shear, 0, h / 2).operations.moves;
    };
    for (int warm = 0; warm < 4; ++warm) {
        (void)step();
    }
    Touched touched{.triangles = complex.triangle_count()};
    touched.mesh = static_cast<long>(complex.vertices.size() * sizeof(VertexRecord<double>) +
                                     complex.triangles.size() * sizeof(TriangleRecord)) /
                   1024;
    EXPECT_TRUE(forget_references());
    for (int i = 0; i < steps; ++i) {
        touched.moves += step();
    }
    touched.kilobytes = referenced_memory();
    return touched;
}

void expect_small_part(const test::ChangingOptions<double>& options, Way way) {
    const Touched touched = touched_by_steps(options, way);
    SCOPED_TRACE(test::name_of(way) + ": " + std::to_string(touched.kilobytes) + " kB of " +
                 std::to_string(touched.mesh));
    EXPECT_GT(touched.moves, 100U) << "hardly anything moved";
    EXPECT_GT(touched.triangles, 300'000U);
    // A single loop over all vertices would touch a third of the mesh.
    EXPECT_LT(touched.kilobytes, touched.mesh / 8);
}

class TouchedMemory : public testing::Test {
protected:
    void SetUp() override {
        // With large pages, one access would count as a whole large page.
        if (prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0) != 0 || referenced_memory() < 0 ||
            !forget_references()) {
            GTEST_SKIP() << "this kernel does not count references";
        }
    }
};

test::ChangingOptions<double> default_options() {
    test::ChangingOptions<double> options;
    options.edge_length = h;
    return options;
}

TEST_F(TouchedMemory, IsThatOfTheInterface) {
    expect_small_part(default_options(), nullptr);
    for (const Way way : in_place_divisions) {
        expect_small_part(default_options(), way);
    }
}

TEST_F(TouchedMemory, IsThatOfTheInterfaceWhereTheTopologyMayChange) {
    auto options = default_options();
    options.topology.rule = Topology::change;
    options.topology.contact = 2 * h;
    expect_small_part(options, nullptr);
}

} // namespace
} // namespace dsc::touched_memory_test

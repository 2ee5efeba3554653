// SPDX-License-Identifier: MIT
// The first step costs as much as the others: the work that grows with the size of the mesh
// (dividing it, making room for ids, starting threads) is done at construction.
#include "support/submesh_executor_testing.h"
#include "thesis/voronoi.h"

#include <filesystem>
#include <iterator>
#include <thread>

namespace dsc::first_step_test {
namespace {

using test::Growing;
using test::NamedPartitioner;
using test::ways_to_divide;

// The addresses of all arrays that grow with the mesh.
std::vector<const void*> storage_of(Complex<double>& complex) {
    return {complex.vertices.data(), complex.triangles.data(),
            complex.attributes.get<Vertex, double>("at vertices").data().data(),
            complex.attributes.get<Edge, double>("at edges").data().data(),
            complex.attributes.get<Triangle, double>("at triangles").data().data()};
}

// Attributes of all kinds must exist before the executor is made: room is made for them too.
void add_attributes(Complex<double>& complex) {
    complex.attributes.add<Vertex, double>("at vertices");
    complex.attributes.add<Edge, double>("at edges");
    complex.attributes.add<Triangle, double>("at triangles");
}

TEST(FirstStep, CopiesNoArrayOfTheMesh) {
    for (const NamedPartitioner& way : ways_to_divide(8)) {
        SCOPED_TRACE(way.name);
        Growing disc(way.make(), 1, default_algorithm<double>(), &add_attributes);
        const auto before = storage_of(disc.complex);
        const auto vertices = disc.complex.vertex_bound();
        const auto triangles = disc.complex.triangle_bound();
        const StepReport report = disc.simulation->step(disc.grow, 0, Growing::h);
        EXPECT_GT(report.operations.interface_splits, 0U) << "nobody asked for an id";
        EXPECT_EQ(storage_of(disc.complex), before);
        // Submeshes have theirs; the serial clean-up takes a few more for what is left.
        EXPECT_LT(disc.complex.vertex_bound(), vertices + 32) << "ids were lent in the step";
        EXPECT_LT(disc.complex.triangle_bound(), triangles + 64) << "ids were lent in the step";
        disc.expect_good();
    }
}

TEST(FirstStep, CopiesNoArrayOfTheMeshWithoutSubmeshesEither) {
    auto complex = test::disc_complex<double>(Growing::h);
    add_attributes(complex);
    Options<double> options;
    options.edge_length = Growing::h;
    Simulation<double> simulation(complex, options);
    const auto before = storage_of(complex);
    const StepReport report = simulation.step(
        [](std::span<const Point<double>> positions, double, std::span<Point<double>> velocities) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                velocities[i] = positions[i] - Point<double>(0.5, 0.5);
            }
        },
        0, 0.2);
    EXPECT_GT(report.operations.interface_splits, 0U);
    EXPECT_EQ(storage_of(complex), before);
}

TEST(FirstStep, FindsTheMeshDividedAndCounted) {
    int divided = 0;
    Growing disc(std::make_unique<PlacePartitioner<double>>(
                     [&](const PartitionInput<double>& input) {
                         ++divided;
                         return voronoi_colours(input, 5);
                     },
                     8),
                 1);
    EXPECT_EQ(divided, 1);
    EXPECT_GT(disc.complex.lent_vertices, 0U);
    disc.expect_good(); // lent ids are not vertices, before the first step as after it
    (void)disc.simulation->step(disc.grow, 0, Growing::h);
    EXPECT_EQ(divided, 1);
}

TEST(FirstStep, LendsIdsThatComeBack) {
    auto complex = test::disc_complex<double>(Growing::h);
    const auto vertices = complex.vertex_count();
    const auto triangles = complex.triangle_count();
    Options<double> options;
    options.edge_length = Growing::h;
    {
        const SubmeshExecutor<double> executor(complex, options, default_algorithm<double>(),
                                               ways_to_divide(8).front().make(), {});
        EXPECT_EQ(complex.vertex_count(), vertices);
        EXPECT_EQ(complex.triangle_count(), triangles);
    }
    EXPECT_EQ(complex.lent_vertices, 0U);
    EXPECT_EQ(complex.vertex_count(), vertices);
    EXPECT_EQ(complex.triangle_count(), triangles);
    EXPECT_EQ(validate(complex).problem, "");
}

#ifdef __linux__
std::ptrdiff_t living_threads() {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return std::distance(begin(tasks), end(tasks));
}

// Threads belong to the thread that started them: a new thread has none yet.
TEST(FirstStep, FindsItsThreadsStarted) {
    std::thread([] {
        const auto at_first = living_threads();
        Growing disc(ways_to_divide(8).front().make(), 3);
        const auto constructed = living_threads();
        (void)disc.simulation->step(disc.grow, 0, Growing::h);
        EXPECT_EQ(disc.seen->view().threads_used, 3U);
        EXPECT_EQ(living_threads(), constructed) << "at first " << at_first;
    }).join();
}
#endif

} // namespace
} // namespace dsc::first_step_test

// SPDX-License-Identifier: MIT
// Parallel DSC with one submesh is the sequential method, bit for bit, whatever divides the mesh.
#include "dsc/parallel/in_place/submesh_executor.h"

#include "support/parallel_outcome.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

namespace dsc::one_submesh_test {
namespace {

using namespace test;

template <class Real>
struct OneSubmesh {
    const char* name;
    std::function<std::unique_ptr<Partitioner<Real>>()> make;
};

template <class Real>
std::vector<OneSubmesh<Real>> ways_to_have_one_submesh() {
    return {
        {"one slab",
         [] { return std::make_unique<SlabPartitioner<Real>>(SlabOptions{.submeshes = 1}); }},
        {"slabs too thin",
         [] {
             return std::make_unique<SlabPartitioner<Real>>(
                 SlabOptions{.slabbing = Slabbing::active, .submeshes = 8, .least_width = 1000});
         }},
        {"one block",
         [] { return std::make_unique<BlockPartitioner<Real>>(BlockOptions{.submeshes = 1}); }},
        {"cells too poor in vertices",
         [] {
             return std::make_unique<CellPartitioner<Real>>(
                 CellOptions{.submeshes = 6, .least_vertices = 5000});
         }},
        {"one place",
         [] {
             return std::make_unique<PlacePartitioner<Real>>([](const PartitionInput<Real>&) {
                 return std::vector<PlaceColour>{
                     {[](double, double) { return std::uint32_t{0}; }, 1}};
             });
         }},
    };
}

template <class Real>
void expect_the_sequential_method() {
    for (const std::uint64_t seed : tame_seeds) {
        Scene scene{.seed = seed};
        scene.data = true;
        const Outcome sequential = simulate<Real>(scene, {});
        for (const auto& way : ways_to_have_one_submesh<Real>()) {
            const Outcome one =
                simulate<Real>(scene, [&](Complex<Real>& complex, const Options<Real>& options,
                                          std::ostream& words) {
                    words << ", " << way.name;
                    return std::make_unique<SubmeshExecutor<Real>>(
                        complex, options, default_algorithm<Real>(), way.make(),
                        SubmeshOptions{.threads = 3, .vertices_per_thread = 1});
                });
            SCOPED_TRACE(one.words);
            EXPECT_EQ(one.most_submeshes, 1U);
            EXPECT_EQ(one.most_threads, 1U);
            EXPECT_EQ(one.hashes, sequential.hashes);
            EXPECT_EQ(one.id_hashes, sequential.id_hashes);
            EXPECT_EQ(one.data_hashes, sequential.data_hashes);
            EXPECT_EQ(one.interfaces, sequential.interfaces);
            EXPECT_EQ(one.unreached, sequential.unreached);
            EXPECT_EQ(counts_of(one.counts), counts_of(sequential.counts));
            EXPECT_EQ(one.passes, sequential.passes);
        }
    }
}

TEST(OneSubmesh, IsTheSequentialMethodBitForBit) {
    expect_the_sequential_method<double>();
    expect_the_sequential_method<float>();
}

} // namespace
} // namespace dsc::one_submesh_test

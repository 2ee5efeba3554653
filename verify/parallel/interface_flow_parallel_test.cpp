// SPDX-License-Identifier: MIT
// Flows that see the interface, in submeshes and in copies: the whole interface is visible from
// each of them, whichever thread runs it.
#include "support/interface_view_testing.h"
#include "support/random/scene.h"
#include "support/submesh_executor_testing.h"

#include "dsc/queries/validate.h"
#include "thesis/copy_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

namespace dsc::interface_flow_parallel_test {
namespace {

using MakeExecutor = std::function<std::unique_ptr<Executor<double>>(
    Complex<double>&, const Options<double>&, std::uint32_t threads)>;
struct Strategy {
    std::string name;
    MakeExecutor make;
};

std::vector<Strategy> strategies() {
    std::vector<Strategy> list;
    for (const test::NamedPartitioner& way : test::ways_to_divide(4)) {
        list.push_back({way.name, [way](auto& complex, const auto& options, auto threads) {
                            return std::make_unique<SubmeshExecutor<double>>(
                                complex, options, default_algorithm<double>(), way.make(),
                                SubmeshOptions{.threads = threads, .vertices_per_thread = 1});
                        }});
    }
    list.push_back({"copies", [](auto& complex, const auto& options, auto threads) {
                        return std::make_unique<CopyExecutor<double>>(
                            complex, options, default_algorithm<double>(),
                            CopyOptions{.submeshes = 4, .threads = threads});
                    }});
    return list;
}

// For any phases: junctions, holes, the domain boundary.
TEST(InterfaceFlowParallel, EverySubmeshSeesTheWholeInterface) {
    for (std::uint64_t seed = 1; seed <= test::seeds_or_fewer(6); ++seed) {
        for (const Strategy& strategy : strategies()) {
            for (const auto coarsening : {Coarsening::deviation, Coarsening::length}) {
                SCOPED_TRACE(strategy.name + ", seed " + std::to_string(seed));
                test::Dice dice(seed);
                Complex<double> complex = seed % 2 == 0
                                              ? test::random_shapes<double>(dice, 0.04)
                                              : test::random_patches<double>(dice, 0.05, 6);
                const auto velocity =
                    test::RandomFlow(dice, 0.4, test::Wildness::none).velocity<double>();
                Options<double> options;
                options.edge_length = 0.04;
                options.interface.coarsening = coarsening;
                Simulation<double> simulation(complex, options, strategy.make(complex, options, 2));
                std::atomic<int> looks = 0;
                const InterfaceFlow<double> flow = [&](const auto& view, std::size_t begin,
                                                       std::size_t end, double time,
                                                       auto velocities) {
                    if (begin == 0) {
                        EXPECT_EQ(test::view_fault(view), "");
                        ++looks;
                    }
                    velocity(view.positions.subspan(begin, end - begin), time,
                             velocities.subspan(begin, end - begin));
                };
                for (int step = 0; step < 8; ++step) {
                    (void)simulation.step(flow, 0.03 * step, 0.03);
                    ASSERT_EQ(validate(complex).problem, "");
                    ASSERT_EQ(test::interface_fault(complex, simulation.interface()), "");
                }
                EXPECT_GE(looks, 8);
            }
        }
    }
}

} // namespace
} // namespace dsc::interface_flow_parallel_test

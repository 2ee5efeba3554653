// SPDX-License-Identifier: MIT
// A new partitioner: left and right at the same time, then below and above for the work near the
// first cut.
#include "dsc/engine.h"
#include "replay/mesh_hash.h"
#include "support/random/scene.h"

#include <gtest/gtest.h>

using namespace dsc;

class Halves final : public Partitioner<double> {
    [[nodiscard]] Recut is_due(const PartitionStatus& status) const override {
        return status.step == 0 ? Recut::all : Recut::none;
    }
    void divide(const PartitionInput<double>&, Recut, Partition& partition) override {
        constexpr auto box = Region::Kind::box;
        partition.colours = {{{{.kind = box, .high = 0.5}, {.kind = box, .low = 0.5}}},
                             {{{.kind = box, .side_high = 0.5}, {.kind = box, .side_low = 0.5}}}};
    }
};

static std::uint64_t hash_after_ten_steps(std::uint32_t threads) {
    auto complex = test::disc_complex<double>(0.03);
    const Options<double> options{.edge_length = 0.03};
    Simulation<double> simulation(complex, options,
                                  make_executor(complex, options, Parallel{.threads = threads},
                                                std::make_unique<Halves>())); // the line
    for (int step = 0; step < 10; ++step) {
        simulation.step([](auto p, double, auto v) { std::ranges::copy(p, v.begin()); },
                        0.01 * step, 0.01); // everything grows away from the origin
    }
    EXPECT_TRUE(validate(complex).problem.empty());
    return mesh_hash(complex);
}

TEST(Recipe, APartitionerIsHandedToTheExecutor) {
    EXPECT_EQ(hash_after_ten_steps(1), hash_after_ten_steps(2));
}

// SPDX-License-Identifier: MIT
// The weights that a partitioner gets: vertices with more work around them count for more, and the
// cuts follow.
#include "dsc/passes/algorithm.h"
#include "support/submesh_executor_testing.h"
#include "thesis/divisions/slabs.h"

#include <memory>
#include <utility>
#include <vector>

namespace dsc::work_shares_test {
namespace {

constexpr double h = 0.02;

// Divides into left and right, anew after each step, and records the weights it gets.
class Listening final : public Partitioner<double> {
public:
    explicit Listening(std::vector<std::pair<double, double>>& told) : told_(told) {}
    [[nodiscard]] Recut is_due(const PartitionStatus& /*status*/) const override {
        return Recut::all;
    }
    void divide(const PartitionInput<double>& input, Recut /*recut*/,
                Partition& partition) override {
        told_.clear();
        for (std::size_t i = 0; i < input.interface.size(); ++i) {
            told_.emplace_back(input.complex.position(Vertex{input.interface[i]}).x(),
                               static_cast<double>(input.work[i]));
        }
        constexpr std::array cuts{-Region::infinity, 0.5, Region::infinity};
        partition.colours = {slab_colour(cuts, 1, 0, false), slab_colour(cuts, 0, 1, false)};
    }

private:
    std::vector<std::pair<double, double>>& told_;
};

TEST(Work, IsCountedWhereItIsDone) {
    auto complex = test::disc_complex<double>(h);
    const Options<double> options{.edge_length = h};
    std::vector<std::pair<double, double>> told;
    Simulation<double> simulation(complex, options,
                                  std::make_unique<SubmeshExecutor<double>>(
                                      complex, options, default_algorithm<double>(),
                                      std::make_unique<Listening>(told), Parallel{.threads = 1}));
    // The right half is stretched; the left one stands still.
    const auto flow = test::pointwise(
        [](const Point<double>& p) { return Point<double>(0.4 * std::max(p.x() - 0.55, 0.0), 0); });
    for (int step = 0; step < 12; ++step) {
        simulation.step(flow, 0, h);
    }
    double left = 0;
    double right = 0;
    double on_left = 0;
    double on_right = 0;
    for (const auto& [x, work] : told) {
        (x < 0.5 ? left : right) += work;
        (x < 0.5 ? on_left : on_right) += 1;
    }
    ASSERT_GT(on_left, 10);
    ASSERT_GT(on_right, 10);
    EXPECT_GT(right / on_right, 2 * left / on_left);
}

} // namespace
} // namespace dsc::work_shares_test

// SPDX-License-Identifier: MIT
// METIS as a partition that the application supplies: a whole run, the same for any number of
// threads, in submeshes whose boundaries are not straight.
#include "scenes/metis_partition.h"

#include "scenes/catalogue/catalogue.h"
#include "scenes/run/start.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/passes/interface/list.h"

#include <gtest/gtest.h>

namespace dsc::metis_test {
namespace {

TEST(Metis, SharesTheInterface) {
    const auto& scene = scenes::find_scene("swirl");
    auto parameters = scene.defaults;
    parameters.h = 0.005;
    const auto setup = scene.prepare(parameters);
    const auto complex = scenes::first_complex<double>(setup, parameters);
    const auto interface = collect_interface(complex);
    const std::vector<float> work(interface.size(), 1.0F);
    const auto colours = scenes::metis_colours<double>({complex, interface, work, 0.005}, 4);
    ASSERT_EQ(colours.size(), 2U);
    for (const PlaceColour& colour : colours) {
        std::vector<std::size_t> held(colour.submeshes, 0);
        for (const std::uint32_t v : interface) {
            const auto p = complex.position(Vertex{v});
            const std::uint32_t label = colour.number_of(p.x(), p.y());
            ASSERT_LT(label, colour.submeshes);
            ++held[label];
        }
        for (const std::size_t count : held) {
            EXPECT_GT(count, interface.size() / 10);
        }
        // Places far away belong to a submesh as well.
        EXPECT_LT(colour.number_of(1e9, -1e9), colour.submeshes);
    }
}

} // namespace
} // namespace dsc::metis_test

// SPDX-License-Identifier: MIT
// Meshes that start from Voronoi diagrams: hundreds of curves and junctions, in general position.
#include "shapes/voronoi.h"
#include "support/curve_testing.h"

#include <numbers>
#include <ostream>

namespace dsc::scenes::voronoi_meshes_test {
namespace {

using test::CurveScenery;

using Sites = std::vector<Point<double>>;
using Place = std::pair<double, double>;

using std::numbers::pi;

// The smallest angle in degrees between curves that meet, or between a curve and a side.
double smallest_angle_between(const CurveScenery& scenery) {
    std::map<Place, std::vector<double>> directions;
    const auto add = [&](const Point<double>& from, const Point<double>& d) {
        directions[{from.x(), from.y()}].push_back(std::atan2(d.y(), d.x()) * 180 / pi);
    };
    for (const Curve& curve : scenery.curves) {
        for (const bool back : {false, true}) {
            const Point<double>& p = curve.points[back ? 1 : 0];
            add(p, curve.points[back ? 0 : 1] - p);
        }
    }
    double smallest = 360;
    for (auto& [p, angles] : directions) {
        const auto& domain = scenery.domain;
        if (p.first == domain.low.x() || p.first == domain.high.x()) {
            angles.insert(angles.end(), {90, -90});
        }
        if (p.second == domain.low.y() || p.second == domain.high.y()) {
            angles.insert(angles.end(), {0, 180});
        }
        std::sort(angles.begin(), angles.end());
        for (std::size_t k = 0; k < angles.size(); ++k) {
            smallest = std::min(smallest, k > 0 ? angles[k] - angles[k - 1]
                                                : angles[k] - angles.back() + 360);
        }
    }
    return smallest;
}

struct Grains {
    std::size_t count;
    int rounds; // of relaxation
    std::uint64_t seed;
    double h;
};

void PrintTo(const Grains& grains, std::ostream* out) { *out << grains.count << " cells"; }

class VoronoiMeshes : public ::testing::TestWithParam<Grains> {
protected:
    static Sites sites() {
        const Grains& g = GetParam();
        return relaxed_sites({}, random_sites({}, g.count, g.seed), g.rounds);
    }

    template <class Real>
    static Complex<Real> expect_good(const CurveScenery& scenery) {
        const auto complex = test::complex_of<Real>(scenery);
        test::expect_sound(complex, scenery);
        const double input = smallest_angle_between(scenery);
        const double found = test::smallest_angle(complex);
        RecordProperty("smallest_angle_of_the_input_deg", std::to_string(input));
        RecordProperty("smallest_angle_deg", std::to_string(found));
        EXPECT_GE(found, std::min(17.0, 0.9 * input)) << "the input has " << input << " degrees";
        return complex;
    }
};

TEST_P(VoronoiMeshes, HaveTheCellsAsPhases) {
    const double h = GetParam().h;
    const VoronoiOptions options{.shortest = 0.3 * h};
    const auto complex =
        expect_good<double>({voronoi_curves({}, sites(), options), h, Rectangle{}});
    const auto cells = voronoi_cells({}, sites(), options);
    const auto areas = test::areas_by_phase(complex);
    ASSERT_EQ(areas.size(), cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        EXPECT_NEAR(areas.at(static_cast<Phase>(i + 1)), signed_area(cells[i]), 1e-15);
    }
}

// Enough of these to see that they do not depend on the scalar, nor break on needles.
class SmallVoronoiMeshes : public VoronoiMeshes {};

TEST_P(SmallVoronoiMeshes, AreAsGoodAsFloat) {
    const double h = GetParam().h;
    expect_good<float>({voronoi_curves({}, sites(), {.shortest = 0.3 * h}), h, Rectangle{}});
}

// Short edges and all: needles there, but a valid mesh.
TEST_P(SmallVoronoiMeshes, AreSoundWithShortEdges) {
    const CurveScenery scenery{voronoi_curves({}, sites()), GetParam().h};
    const auto complex = test::complex_of<double>(scenery);
    test::expect_sound(complex, scenery, 2.2);
}

std::string name_of(const ::testing::TestParamInfo<Grains>& test) {
    return std::to_string(test.param.count) + "_relaxed_" + std::to_string(test.param.rounds);
}

INSTANTIATE_TEST_SUITE_P(Cells, VoronoiMeshes,
                         ::testing::Values(Grains{100, 0, 1, 0.02}, Grains{100, 3, 2, 0.02},
                                           Grains{1000, 0, 2, 0.006}, Grains{1000, 3, 1, 0.006}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Cells, SmallVoronoiMeshes,
                         ::testing::Values(Grains{100, 0, 1, 0.02}, Grains{100, 3, 2, 0.02}),
                         name_of);

} // namespace

} // namespace dsc::scenes::voronoi_meshes_test

// SPDX-License-Identifier: MIT
// Initial shapes: known distance functions, and closed surfaces of triangles.
#include "dsc3/dsc3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

namespace dsc3::test::shapes_test {
namespace {

using std::numbers::pi;

// A box of 12 triangles.
TriangleSurface box_surface(const Point& low, const Point& high) {
    TriangleSurface surface;
    for (int i = 0; i < 8; ++i) {
        surface.points.emplace_back((i & 1) != 0 ? high.x() : low.x(),
                                    (i & 2) != 0 ? high.y() : low.y(),
                                    (i & 4) != 0 ? high.z() : low.z());
    }
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

template <class Make>
std::string refusal_of(Make make) {
    try {
        (void)make();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

double volume_of(const Distance& shape, double h) {
    const Complex complex = initial_complex({}, {{shape, 1}}, {.edge_length = h});
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_GE(mesh_quality(complex).min_dihedral, 9);
    return phase_volume(complex, 1);
}

TEST(Shapes3, HaveTheirVolumes) {
    const Point middle(0.5, 0.5, 0.5);
    EXPECT_NEAR(volume_of(box({{0.3, 0.3, 0.2}, {0.7, 0.6, 0.7}}), 0.05), 0.06, 0.03 * 0.06);
    const double egg = 4.0 / 3 * pi * 0.3 * 0.2 * 0.15;
    EXPECT_NEAR(volume_of(ellipsoid(middle, {0.3, 0.2, 0.15}), 0.05), egg, 0.02 * egg);
    const double ring = 2 * pi * pi * 0.25 * 0.1 * 0.1;
    const Complex complex =
        initial_complex({}, {{torus(middle, {1, 2, 2}, 0.25, 0.1), 1}}, {.edge_length = 0.04});
    EXPECT_NEAR(phase_volume(complex, 1), ring, 0.03 * ring);
    EXPECT_EQ(validate(complex).surfaces.back().euler_characteristic, 0);
    EXPECT_THROW((void)torus(middle, {0, 0, 0}, 0.25, 0.1), InputError);
}

TEST(Shapes3, TooManyTetsAreRefusedBeforeTheyAreMade) {
    const std::vector<Shape> shapes{{ball({0.5, 0.5, 0.5}, 0.3), 1}};
    EXPECT_THROW((void)initial_complex({}, shapes, {.edge_length = 1.0 / 2000}), InputError);
    const std::uint32_t tets = initial_complex({}, shapes, {.edge_length = 0.06}).tet_count();
    EXPECT_NO_THROW(
        (void)initial_complex({}, shapes, {.edge_length = 0.06, .max_tets = 2.0 * tets}));
    EXPECT_THROW((void)initial_complex({}, shapes, {.edge_length = 0.06, .max_tets = 0.5 * tets}),
                 InputError);
}

TEST(Shapes3, DistancesToASurfaceAreThoseOfItsShape) {
    const Point low(0.25, 0.3, 0.35);
    const Point high(0.75, 0.6, 0.7);
    TriangleSurface surface = box_surface(low, high);
    std::swap(surface.triangles[3][0], surface.triangles[3][1]); // oriented anyhow
    const Distance exact = box({low, high});
    const Distance found = closed_surface(surface);
    for (auto& triangle : surface.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    const Distance inside_out = closed_surface(surface);
    for (int i = 0; i < 1331; ++i) {
        const Point p(0.1 * (i % 11), 0.1 * (i / 11 % 11), 0.1 * (i / 121));
        EXPECT_NEAR(found(p), exact(p), 1e-15) << to_text(p);
        EXPECT_NEAR(inside_out(p), exact(p), 1e-15) << to_text(p);
    }
}

TEST(Shapes3, PartsInPartsAreHollowsHoweverTheyAreOriented) {
    const std::vector<Box> boxes{{{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}},
                                 {{0.2, 0.2, 0.2}, {0.7, 0.8, 0.8}},
                                 {{0.3, 0.3, 0.3}, {0.6, 0.7, 0.7}},
                                 {{0.75, 0.2, 0.2}, {0.85, 0.8, 0.8}},
                                 {{1.2, 0.2, 0.2}, {1.4, 0.4, 0.4}}};
    for (unsigned turned = 0; turned < 32; ++turned) { // each set of parts inside out
        TriangleSurface surface;
        for (unsigned part = 0; part < boxes.size(); ++part) {
            TriangleSurface one = box_surface(boxes[part].low, boxes[part].high);
            const auto first = static_cast<std::uint32_t>(surface.points.size());
            for (auto& [a, b, c] : one.triangles) {
                if ((turned >> part & 1U) != 0) {
                    std::swap(a, b);
                }
                surface.triangles.push_back({first + a, first + b, first + c});
            }
            surface.points.insert(surface.points.end(), one.points.begin(), one.points.end());
        }
        SurfaceFigures figures;
        const Distance distance = closed_surface(surface, &figures);
        EXPECT_LT(distance({0.15, 0.5, 0.5}), 0);
        EXPECT_GT(distance({0.25, 0.5, 0.5}), 0);
        EXPECT_LT(distance({0.5, 0.5, 0.5}), 0);
        EXPECT_GT(distance({0.8, 0.5, 0.5}), 0);
        EXPECT_GT(distance({1.1, 0.5, 0.5}), 0);
        EXPECT_LT(distance({1.3, 0.3, 0.3}), 0);
        EXPECT_NEAR(figures.volume, 0.512 - 0.18 + 0.048 - 0.036 + 0.008, 1e-15);
        EXPECT_EQ(figures.euler_characteristic, 10);
    }
}

TEST(Shapes3, SurfacesThatEncloseNothingAreRefusedWithThePlace) {
    const auto refusal = [](const TriangleSurface& surface) {
        return refusal_of([&] { return closed_surface(surface); });
    };
    const TriangleSurface good = box_surface({0, 0, 0}, {1, 2, 4});
    EXPECT_EQ(refusal(good), "");
    TriangleSurface bad = good;
    bad.triangles.pop_back();
    EXPECT_NE(refusal(bad).find("not closed"), std::string::npos) << refusal(bad);
    EXPECT_NE(refusal(bad).find("(1, 0, 2)"), std::string::npos) << refusal(bad);
    bad = good;
    bad.points[7] = {0.5, 1, -1}; // the far corner, pulled out through the bottom
    EXPECT_NE(refusal(bad).find("crosses itself"), std::string::npos) << refusal(bad);
    bad = good;
    bad.points[3].x() = std::nan("");
    EXPECT_NE(refusal(bad).find("finite"), std::string::npos);
    bad = good;
    bad.triangles[2][1] = 8;
    EXPECT_NE(refusal(bad).find("no such point"), std::string::npos);
    bad.triangles.clear();
    EXPECT_NE(refusal(bad).find("has no triangles"), std::string::npos);
    bad = good; // two boxes that cross
    const TriangleSurface other = box_surface({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
    bad.points.insert(bad.points.end(), other.points.begin(), other.points.end());
    for (auto [a, b, c] : other.triangles) {
        bad.triangles.push_back({a + 8, b + 8, c + 8});
    }
    EXPECT_NE(refusal(bad).find("crosses itself"), std::string::npos);
}

TEST(Shapes3, AWrittenSurfaceHasTheVolumeAndFacesOutward) {
    const Complex complex =
        initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.3), 1}}, {.edge_length = 0.1});
    const std::string path = testing::TempDir() + "ball.stl";
    write_stl(complex, path);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const auto faces = interface_faces(complex).size();
    ASSERT_EQ(bytes.size(), 84 + 50 * faces);
    TriangleSurface surface;
    double volume = 0;
    for (std::size_t i = 0; i < faces; ++i) {
        std::array<float, 12> f{};
        bytes.copy(reinterpret_cast<char*>(f.data()), sizeof f, 84 + 50 * i);
        const Eigen::Map<const Eigen::Matrix<float, 3, 4>> m(f.data());
        EXPECT_NEAR(m.col(0).norm(), 1, 1e-6);
        EXPECT_GT(m.col(0).dot(m.col(1) - Eigen::Vector3f(0.5, 0.5, 0.5)), 0);
        volume += m.col(1).cross(m.col(2)).dot(m.col(3)) / 6;
    }
    EXPECT_NEAR(volume, phase_volume(complex, 1), 1e-6);
    std::remove(path.c_str());
}

} // namespace
} // namespace dsc3::test::shapes_test

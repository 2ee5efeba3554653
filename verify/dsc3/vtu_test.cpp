// SPDX-License-Identifier: MIT
// The contents of VTU files of tets, and of VTU and PLY files of the interface.
#include "dsc3/dsc3.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace dsc3::test::vtu_test {
namespace {

std::string written(void (*write)(const Complex&, const std::string&), const Complex& complex) {
    const std::string path = testing::TempDir() + "dsc3_vtu_test.vtu";
    write(complex, path);
    std::stringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    std::filesystem::remove(path);
    return text.str();
}

// The numbers of an array.
template <class Number>
std::vector<Number> numbers(const std::string& file, const std::string& name) {
    const std::size_t tag = file.find("Name=\"" + name + '"');
    const std::size_t at = file.find("offset=\"", tag) + 8;
    const char* data = file.data() + file.find("\n_") + 2 + std::stoul(file.substr(at, 20));
    std::uint64_t size = 0;
    std::memcpy(&size, data, sizeof size);
    std::vector<Number> result(size / sizeof(Number));
    std::memcpy(result.data(), data + sizeof size, size);
    return result;
}

TEST(Vtu3, HoldsTetsAndFaces) {
    Complex complex = initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.2), 3}}, {.edge_length = 0.1});
    auto& place = complex.attributes.add<Vertex>("place & time", Point(0, 0, 0));
    auto& number = complex.attributes.add<Tet>("number", std::uint32_t{0});
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        place[Vertex{v}] = complex.at(v);
    }
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        number[Tet{t}] = complex.phases[t];
    }
    const std::string tets = written(write_vtu, complex);
    const auto points = numbers<double>(tets, "Points");
    const auto corners = numbers<std::int64_t>(tets, "connectivity");
    const auto phases = numbers<Phase>(tets, "phase");
    ASSERT_EQ(points.size(), 3 * complex.vertex_count());
    ASSERT_EQ(corners.size(), 4 * complex.tet_count());
    ASSERT_EQ(phases.size(), complex.tet_count());
    EXPECT_EQ(numbers<double>(tets, "place &amp; time"), points);
    EXPECT_EQ(numbers<std::uint32_t>(tets, "number"), phases);
    EXPECT_EQ(numbers<std::uint8_t>(tets, "types").back(), 10);
    EXPECT_EQ(numbers<std::int64_t>(tets, "offsets").back(), std::int64_t(corners.size()));
    const auto point = [&](std::size_t corner) {
        const auto k = static_cast<std::size_t>(3 * corners[corner]);
        return Point(points[k], points[k + 1], points[k + 2]);
    };
    double sum = 0;
    for (std::size_t t = 0; t < phases.size(); ++t) {
        if (phases[t] == 3) {
            sum += volume(point(4 * t), point(4 * t + 1), point(4 * t + 2), point(4 * t + 3));
        }
    }
    EXPECT_NEAR(sum, phase_volume(complex, 3), 1e-12);
    const std::string faces = written(write_interface_vtu, complex);
    EXPECT_EQ(numbers<std::int64_t>(faces, "connectivity").size(),
              3 * interface_faces(complex).size());
    EXPECT_EQ(numbers<Phase>(faces, "inside").front(), 3U);
    EXPECT_EQ(numbers<Phase>(faces, "outside").front(), 0U);
    const std::string surface = written(write_ply, complex);
    const std::size_t vertices = std::stoul(surface.substr(surface.find("vertex ") + 7));
    const std::size_t faces_of_surface = std::stoul(surface.substr(surface.find("face ") + 5));
    EXPECT_EQ(vertices, numbers<double>(faces, "Points").size() / 3);
    EXPECT_EQ(faces_of_surface, interface_faces(complex).size());
    EXPECT_EQ(vertices - 3 * faces_of_surface / 2 + faces_of_surface, 2U);
    EXPECT_EQ(surface.size() - surface.find("end_header\n") - 11,
              24 * vertices + 13 * faces_of_surface);
    EXPECT_THROW(write_vtu(complex, "no/such/folder/x.vtu"), FileError);
}

} // namespace
} // namespace dsc3::test::vtu_test

// SPDX-License-Identifier: MIT
// Surfaces read from files that this library writes, and from files as other programs write them.
#include "dsc3/dsc3.h"
#include "surface_files/surface_files.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace dsc3::test::surface_files_test {
namespace {

class SurfaceFiles3 : public testing::Test {
protected:
    std::string path(const std::string& name) {
        files_.push_back(testing::TempDir() + name);
        return files_.back();
    }
    std::string written(const std::string& name, const std::string& text) {
        const std::string place = path(name);
        std::ofstream(place) << text;
        return place;
    }
    void TearDown() override {
        for (const std::string& file : files_) {
            std::remove(file.c_str());
        }
    }

private:
    std::vector<std::string> files_;
};

double volume_of(const std::string& path, double h) {
    const Complex complex =
        initial_complex({}, {{closed_surface(read_surface(path)), 1}}, {.edge_length = h});
    EXPECT_EQ(validate(complex).problem, "");
    return phase_volume(complex, 1);
}

// A box of six quadrilaterals whose corners are counter-clockwise seen from outside; without its
// lid if `has_lid` is false.
std::string box_as_obj(bool has_lid) {
    return std::string("# a box\no box\n") +
           "v 0.2 0.2 0.3\nv 0.8 0.2 0.3\nv 0.8 0.8 0.3\nv 0.2 0.8 0.3\n"
           "v 0.2 0.2 0.7\nv 0.8 0.2 0.7\nv 0.8 0.8 0.7\nv 0.2 0.8 0.7\n"
           "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n" +
           (has_lid ? "f 5 6 7 8\n" : "");
}

TEST_F(SurfaceFiles3, OursAreReadBack) {
    const Complex complex =
        initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.3), 1}}, {.edge_length = 0.08});
    const std::size_t faces = interface_faces(complex).size();
    write_ply(complex, path("ball.ply"));
    write_stl(complex, path("ball.stl"));
    for (const char* name : {"ball.ply", "ball.stl"}) {
        const TriangleSurface surface = read_surface(testing::TempDir() + name);
        EXPECT_EQ(surface.triangles.size(), faces) << name;
        EXPECT_EQ(surface.points.size(), faces / 2 + 2) << name; // a sphere
        EXPECT_NEAR(volume_of(testing::TempDir() + name, 0.08), phase_volume(complex, 1), 1e-3);
    }
}

TEST_F(SurfaceFiles3, OneWithFourCornersAFace) {
    EXPECT_NEAR(volume_of(written("box.obj", box_as_obj(true)), 0.05), 0.144, 0.002);
}

TEST_F(SurfaceFiles3, WhatIsNoSurfaceIsRefused) {
    EXPECT_THROW((void)read_surface("/nowhere/at/all.stl"), FileError);
    EXPECT_THROW((void)read_surface(written("empty.obj", "v 0 0 0\n")), FileError);
    EXPECT_THROW((void)read_surface(written("text.stl", "this is no surface")), FileError);
    const std::string open = written("open.obj", box_as_obj(false));
    try {
        (void)closed_surface(read_surface(open));
        FAIL() << "an open box was taken";
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("not closed"), std::string::npos) << text;
        EXPECT_NE(text.find(open + ", at ("), std::string::npos) << text;
        EXPECT_NE(text.find(", 0.69999"), std::string::npos) << text; // the rim
    }
}

} // namespace
} // namespace dsc3::test::surface_files_test

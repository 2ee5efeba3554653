// SPDX-License-Identifier: MIT
// The data structure in three dimensions, exact signs, measures, and what the validator finds.
#include "dsc/complex/numbering.h"
#include "dsc3/random_mesh.h"

#include <numeric>

namespace dsc3::test::complex_test {
namespace {

TEST(Geometry3, OrientationIsExact) {
    const Point a(0, 0, 0);
    const Point b(1, 0, 0);
    const Point c(0, 1, 0);
    EXPECT_EQ(orientation(a, b, c, {0, 0, 1}), 1);
    EXPECT_EQ(orientation(a, c, b, {0, 0, 1}), -1);
    EXPECT_EQ(orientation(a, b, c, {0.25, 0.25, 0}), 0);
    EXPECT_EQ(orientation(a, b, c, {0, 0, std::nan("")}), 0);
    EXPECT_EQ(orientation(a, b, c, {0.1, 0.7, 1e-300}), 1);
    // Far from the origin: a point on the plane x + y + z = 3 u, moved to either side by one unit
    // in the last place.
    const double u = 1e6 / 3;
    const Point p(u + 1, u - 1, u);
    const Point q(u, u + 1, u - 1);
    const Point r(u - 1, u, u + 1);
    const double next = std::nextafter(u, 1e9);
    const int above = orientation(p, q, r, {next, u, u});
    const int below = orientation(p, q, r, {std::nextafter(u, 0), u, u});
    EXPECT_EQ(above * below, -1);
    EXPECT_EQ(orientation(q, p, r, {next, u, u}), -above);
}

// Angles are found only for tets that may have the most extreme ones.
TEST(Geometry3, ExtremeAnglesAreThoseOfAllTets) {
    Random random(1);
    for (const double most : {0.02, 0.1, 0.2, 0.3, 0.5}) { // in the last meshes tets are inverted
        Complex complex = initial::lattice({{0, 0, 0}, {4, 4, 4}});
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            const Point by(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
            complex.set_position(Vertex{v}, complex.at(v) + 2 * most * by);
        }
        for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
            complex.set_phase(Tet{t}, static_cast<Phase>(3 * random.unit()));
        }
        DihedralAngles all;
        for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
            const DihedralAngles here = dihedral_angles(complex.positions_of(Tet{t}));
            all.smallest = std::min(all.smallest, here.smallest);
            all.largest = std::max(all.largest, here.largest);
        }
        Real face = 180;
        for (const auto& [v, inside, outside] : interface_faces(complex)) {
            face = std::min(
                face, min_angle_degrees(complex.at(v[0]), complex.at(v[1]), complex.at(v[2])));
        }
        const MeshQuality found = mesh_quality(complex);
        EXPECT_EQ(found.min_dihedral, all.smallest) << most;
        EXPECT_EQ(found.max_dihedral, all.largest) << most;
        EXPECT_EQ(found.min_face_angle, face) << most;
    }
}

TEST(Geometry3, MeasuresOfTheRegularTet) {
    const std::array<Point, 4> p{Point(1, 1, 1), Point(-1, 1, -1), Point(1, -1, -1),
                                 Point(-1, -1, 1)};
    EXPECT_NEAR(quality(p[0], p[1], p[2], p[3]), 1, 1e-15);
    EXPECT_NEAR(quality(p[1], p[0], p[2], p[3]), -1, 1e-15);
    EXPECT_NEAR(volume(p[0], p[1], p[2], p[3]), 8.0 / 3, 1e-14);
    const DihedralAngles angles = dihedral_angles(p);
    EXPECT_NEAR(angles.smallest, 70.528779365509, 1e-10);
    EXPECT_NEAR(angles.largest, 70.528779365509, 1e-10);
    const DihedralAngles corner =
        dihedral_angles({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)});
    EXPECT_NEAR(corner.smallest, 54.735610317245, 1e-10);
    EXPECT_NEAR(corner.largest, 90, 1e-10);
}

TEST(Complex3, LatticeIsABall) {
    const Complex lattice = initial::lattice({{0, 0, 0}, {4, 4, 8}});
    const ValidationReport report = validate(lattice);
    ASSERT_TRUE(report.ok()) << report.problem;
    EXPECT_EQ(report.tets, 4U * 4 * 8 * 6);
    EXPECT_EQ(report.vertices, 5U * 5 * 9);
    EXPECT_EQ(report.euler_characteristic, 1);
    ASSERT_EQ(report.surfaces.size(), 1U);
    EXPECT_EQ(report.surfaces[0].euler_characteristic, 2);
    EXPECT_NEAR(phase_volume(lattice, 0), 128, 1e-11);
}

// With free ids.
Complex worn_mesh(std::uint64_t seed) {
    Complex complex = random_mesh(seed);
    Workspace work;
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
        const std::uint32_t t = 1 + random.below(complex.tet_bound() - 1);
        if (complex.is_alive(Tet{t})) {
            edge_collapse(complex, work, Vertex{complex.tets[t].v[0]},
                          Vertex{complex.tets[t].v[1]});
        }
    }
    return complex;
}

TEST(Complex3, RenumberingKeepsTheMesh) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Complex complex = worn_mesh(seed);
        const std::uint64_t hash = mesh_hash(complex);
        const std::uint32_t count = complex.tet_count();
        renumber(complex);
        EXPECT_EQ(mesh_hash(complex), hash);
        EXPECT_EQ(complex.tet_bound(), count + 1);
        EXPECT_TRUE(validate(complex).ok()) << validate(complex).problem;
    }
}

TEST(Complex3, RenumberingOfTetsKeepsTheVertices) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Complex complex = worn_mesh(seed);
        auto& number = complex.attributes.add<Tet>("number", no_id);
        for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
            number[Tet{t}] = t;
        }
        const Complex old = complex;
        const std::vector<std::uint32_t> ids = renumber_tets(complex);
        EXPECT_TRUE(validate(complex).ok()) << validate(complex).problem;
        EXPECT_EQ(mesh_hash(complex), mesh_hash(old));
        EXPECT_EQ(complex.tet_bound(), old.tet_count() + 1);
        EXPECT_EQ(complex.free_vertices, old.free_vertices);
        ASSERT_EQ(ids.size(), old.tet_bound());
        for (std::uint32_t t = 1; t < old.tet_bound(); ++t) {
            ASSERT_EQ(ids[t] != no_id, old.is_alive(Tet{t}));
            if (ids[t] != no_id) {
                ASSERT_EQ(complex.tets[ids[t]].v, old.tets[t].v);
                ASSERT_EQ(complex.phases[ids[t]], old.phases[t]);
                ASSERT_EQ(number[Tet{ids[t]}], t);
            }
        }
    }
}

TEST(Complex3, TheFingerprintNoticesPlacesAndPhases) {
    Complex complex = random_mesh(1);
    const std::uint64_t hash = mesh_hash(complex);
    const Phase phase = complex.phase(Tet{1});
    complex.set_phase(Tet{1}, phase + 1);
    EXPECT_NE(mesh_hash(complex), hash);
    complex.set_phase(Tet{1}, phase);
    EXPECT_EQ(mesh_hash(complex), hash);
    EXPECT_TRUE(validate(complex).ok());
    Point p = complex.at(0);
    p.x() = std::nextafter(p.x(), 1);
    complex.set_position(Vertex{0}, p);
    EXPECT_NE(mesh_hash(complex), hash);
}

TEST(Complex3, ArraysThatMakeNoComplexAreRefused) {
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},           {0, 0, 1},
                                    {1, 1, 1}, {2, 2, 3}, {0, 0, std::nan("")}};
    using Tets = std::vector<std::array<std::uint32_t, 4>>;
    const auto make = [&](const Tets& tets, std::size_t count, Phase phase) {
        return make_complex(std::span(points).first(count), tets,
                            std::vector<Phase>(tets.size(), phase));
    };
    EXPECT_EQ(make({{0, 1, 2, 3}, {1, 2, 4, 3}}, 5, 0).tet_count(), 2U);
    EXPECT_THROW(make({{0, 1, 2, 9}}, 5, 0), InputError);
    EXPECT_THROW(make({{0, 1, 2, 2}}, 5, 0), InputError);
    EXPECT_THROW(make({{0, 1, 2, 3}}, 7, 0), InputError);
    EXPECT_THROW(make({{0, 1, 2, 3}}, 5, border_phase), InputError);
    EXPECT_THROW(make({{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}}, 6, 0), InputError);
}

// Each fault is of another kind and fails only one check, except one fault that fails several.
TEST(Validate3, NoticesEveryKindOfFault) {
    const Complex good = random_mesh(3);
    ASSERT_TRUE(validate(good).ok());
    const auto problem = [&](auto fault) {
        Complex complex = good;
        fault(complex);
        return validate(complex).problem;
    };
    std::uint32_t inner = 0;
    while (good.is_boundary(Vertex{inner})) {
        ++inner;
    }
    const std::string inverted = "is inverted or has no volume";
    EXPECT_NE(problem([](Complex& c) { c.phases[0] = 0; }), "");
    EXPECT_NE(problem([&](Complex& c) { c.vertices[inner].position.x() = std::nan(""); }), "");
    EXPECT_NE(problem([&](Complex& c) { c.vertices[inner].corner = 4; }), "");
    EXPECT_NE(
        problem([&](Complex& c) { c.vertices[inner].position.setConstant(9); }).find(inverted),
        std::string::npos);
    EXPECT_NE(problem([](Complex& c) { std::swap(c.tets[5].v[0], c.tets[5].v[1]); }), "");
    EXPECT_NE(problem([](Complex& c) { std::swap(c.tets[5].n[0], c.tets[5].n[1]); }), "");
    EXPECT_NE(problem([](Complex& c) { c.phases[5] = border_phase; }), "");
    EXPECT_NE(problem([](Complex& c) { c.free_tets.push_back(5); }), "");
    EXPECT_NE(problem([&](Complex& c) { c.vertices[inner].flags ^= vertex_interface; }), "");
    EXPECT_NE(problem([&](Complex& c) { c.vertices[inner].flags ^= vertex_boundary; }), "");
    // A removed tet leaves a hole.
    EXPECT_NE(problem([](Complex& c) {
                  const auto n = c.tets[5].n;
                  for (const Corner other : n) {
                      if (!is_border(other)) {
                          c.tets[tet_of(other)].n[index_of(other)] = border_corner;
                      }
                  }
                  c.give_tet(5);
              }),
              "");
    // A boundary vertex off its side, as if it were not on it, and where it is not on one.
    std::uint32_t below = 0;
    while ((good.vertices[below].flags & vertex_boundary) != vertex_fixed_z ||
           good.at(below).z() != 0) {
        ++below;
    }
    EXPECT_NE(problem([&](Complex& c) { c.vertices[below].position.z() = -0.1; }), "");
    EXPECT_NE(problem([&](Complex& c) { c.vertices[below].flags ^= vertex_fixed_x; }), "");
    std::vector<Point> points;
    for (std::uint32_t v = 0; v < good.vertex_bound(); ++v) {
        points.push_back(good.at(v));
    }
    points[below].z() = -0.1;
    std::vector<std::array<std::uint32_t, 4>> tets;
    for (std::uint32_t t = 1; t < good.tet_bound(); ++t) {
        tets.push_back(good.tets[t].v);
    }
    const auto p = validate(make_complex(points, tets, std::vector<Phase>(tets.size(), 0))).problem;
    EXPECT_NE(p.find("does not lie on a side"), std::string::npos) << p;
}

TEST(Validate3, NoticesTetsThatShareOnlyAVertex) {
    std::vector<Point> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                              {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
    const std::vector<std::array<std::uint32_t, 4>> tets{{0, 1, 2, 3}, {0, 4, 5, 6}};
    const Complex complex = make_complex(points, tets, std::vector<Phase>(2, 0));
    EXPECT_EQ(validate(complex).problem, "vertex 0: its star is not connected");
}

TEST(Validate3, CountsTheEulerNumbersOfSurfaces) {
    Complex lattice = initial::lattice({{0, 0, 0}, {4, 4, 4}});
    for (std::uint32_t t = 1; t < lattice.tet_bound(); ++t) { // a ring of cubes, and one beside it
        const auto q = lattice.positions_of(Tet{t});
        const Point p = 0.25 * (q[0] + q[1] + q[2] + q[3]);
        const bool in_block = p.x() < 3 && p.y() < 3 && p.z() > 0 && p.z() < 1;
        const bool in_hole = p.x() > 1 && p.x() < 2 && p.y() > 1 && p.y() < 2;
        if (in_block && !in_hole) {
            lattice.set_phase(Tet{t}, 1);
        } else if (p.z() > 3) {
            lattice.set_phase(Tet{t}, 2);
        }
    }
    const ValidationReport report = validate(lattice);
    ASSERT_TRUE(report.ok()) << report.problem;
    ASSERT_EQ(report.surfaces.size(), 3U);
    EXPECT_EQ(report.surfaces[1].euler_characteristic, 0); // a torus
    EXPECT_EQ(report.surfaces[2].euler_characteristic, 2);
}

} // namespace
} // namespace dsc3::test::complex_test

// SPDX-License-Identifier: MIT
// CreateSubmeshes and MergeSubmeshes (thesis, algorithms 6.1 and 6.2) by themselves: dividing and
// merging changes nothing but the ids, whatever data are attached to the simplices.
#include "thesis/copies/copied_submeshes.h"

#include "support/random/scene.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace dsc::copied_submeshes_test {
namespace {

using test::Dice;

Complex<double> random_mesh(std::uint64_t seed, double h) {
    Dice dice(seed);
    return seed == 0       ? test::grid<double>(1) // of two triangles
           : seed % 3 == 0 ? test::random_patches<double>(dice, h, 12)
                           : test::random_shapes<double>(dice, h);
}

// Data and locks that depend on the position, so that tests can see where each simplex went.
double datum(const Complex<double>& mesh, Vertex v) {
    return mesh.vertices[v.id].x + 2 * mesh.vertices[v.id].y;
}

std::string datum(const Complex<double>& mesh, Corner c) {
    const double sum =
        datum(mesh, Vertex{mesh.vertex(next(c))}) + datum(mesh, Vertex{mesh.vertex(prev(c))});
    return "edge " + std::to_string(sum);
}

float datum(const Complex<double>& mesh, Triangle t) {
    const auto v = mesh.vertices_of(t);
    return static_cast<float>(datum(mesh, v[0]) * datum(mesh, v[1]) * datum(mesh, v[2]));
}

bool is_locked(const Complex<double>& mesh, Vertex v) { return datum(mesh, v) < 1; }

struct Data {
    explicit Data(Complex<double>& mesh)
        : of_vertices(mesh.attributes.add<Vertex, double>("by vertex")),
          of_edges(mesh.attributes.add<Edge, std::string>("by edge")),
          of_triangles(mesh.attributes.add<Triangle, float>("by triangle")) {
        for (std::uint32_t v = 0; v < mesh.vertex_bound(); ++v) {
            of_vertices[Vertex{v}] = datum(mesh, Vertex{v});
            mesh.set_locked(Vertex{v}, is_locked(mesh, Vertex{v}));
        }
        for (const Triangle t : triangles(mesh)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                of_triangles[t] = datum(mesh, t);
                of_edges.data()[corner_of(t.id, i)] = datum(mesh, corner_of(t.id, i));
            }
        }
    }

    void expect_in_place(const Complex<double>& mesh) {
        for (std::uint32_t v = 0; v < mesh.vertex_bound(); ++v) {
            ASSERT_EQ(of_vertices[Vertex{v}], datum(mesh, Vertex{v}));
            ASSERT_EQ(mesh.is_locked(Vertex{v}), is_locked(mesh, Vertex{v}));
        }
        for (std::uint32_t t = 1; t < mesh.triangle_bound(); ++t) {
            ASSERT_EQ(of_triangles[Triangle{t}], datum(mesh, Triangle{t}));
            for (std::uint32_t i = 0; i < 3; ++i) {
                ASSERT_EQ(of_edges.at_corner(corner_of(t, i)), datum(mesh, corner_of(t, i)));
            }
        }
    }

    VertexAttribute<double>& of_vertices;
    EdgeAttribute<std::string>& of_edges;
    TriangleAttribute<float>& of_triangles;
};

TEST(CopiedSubmeshes, MergeIntoTheMeshThatWasDivided) {
    CopiedSubmeshes<double> submeshes; // reused, as by the executor
    for (std::uint64_t seed = 0; seed <= 9; ++seed) {
        auto mesh = random_mesh(seed, 0.04);
        Data data(mesh);
        const std::uint64_t hash = mesh_hash(mesh);
        const ValidationReport before = validate(mesh);
        for (const RedBlack colour : {RedBlack::red, RedBlack::black}) {
            for (const std::uint32_t n : {1U, 2U, 3U, 8U, 60U}) {
                SCOPED_TRACE("seed " + std::to_string(seed) + ", submeshes " + std::to_string(n));
                create_submeshes(mesh, {n, 0.6, 0.8, colour}, submeshes);
                for (const auto& submesh : submeshes.list) {
                    lend_ids(*submesh, 7); // these ids must not appear in the mesh
                }
                merge_submeshes(submeshes, mesh);
                EXPECT_EQ(mesh_hash(mesh), hash);
                const ValidationReport report = validate(mesh);
                EXPECT_EQ(report.problem, "");
                EXPECT_EQ(report.vertices, before.vertices - before.unused_vertices);
                EXPECT_EQ(report.triangles, before.triangles);
                EXPECT_EQ(report.edges, before.edges) << "seams are open";
                EXPECT_EQ(mesh.vertex_bound(), report.vertices) << "free ids after a merge";
                EXPECT_EQ(mesh.triangle_bound(), report.triangles + 1);
                data.expect_in_place(mesh);
                submeshes.list.resize(1); // another number of submeshes next
            }
        }
    }
}

TEST(CopiedSubmeshes, HaveEqualSharesInTheOrderOfTheNormal) {
    const auto mesh = random_mesh(2, 0.03);
    const std::uint32_t n = 7;
    const std::size_t share = mesh.triangle_count() / n;
    ASSERT_NE(mesh.triangle_count() % n, 0U) << "choose a mesh that has triangles over";
    CopiedSubmeshes<double> red;
    create_submeshes(mesh, {n, 0, 1, RedBlack::red}, red);
    double highest = -1;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::size_t more = i < mesh.triangle_count() % n ? 1 : 0;
        EXPECT_EQ(red.list[i]->complex.triangle_count(), share + more) << "submesh " << i;
        double low = 4;
        double high = -1;
        for (std::uint32_t t = 1; t < mesh.triangle_bound(); ++t) {
            if (red.number[t] == i) {
                double y = 0;
                for (const Vertex v : mesh.vertices_of(Triangle{t})) {
                    y += mesh.vertices[v.id].y;
                }
                low = std::min(low, y);
                high = std::max(high, y);
            }
        }
        EXPECT_LE(highest, low + 1e-12) << "submesh " << i;
        highest = high;
    }
    // The black submeshes: the two ends form one submesh (thesis, section 8.5), and the vertices
    // that the red ones locked are free.
    CopiedSubmeshes<double> black;
    create_submeshes(mesh, {n, 0, 1, RedBlack::black}, black);
    ASSERT_EQ(black.list.size(), n);
    std::uint32_t sum = 0;
    for (const auto& submesh : black.list) {
        EXPECT_NEAR(submesh->complex.triangle_count(), static_cast<double>(share), 1);
        sum += submesh->complex.triangle_count();
    }
    EXPECT_EQ(sum, mesh.triangle_count());
    EXPECT_EQ(validate(black.list[0]->complex).components, 2U) << "bottom and top of the mesh";
    for (std::uint32_t v = 0; v < mesh.vertex_bound(); ++v) {
        EXPECT_FALSE(red.owner[v] == CopiedSubmeshes<double>::several &&
                     black.owner[v] == CopiedSubmeshes<double>::several)
            << "vertex " << v << " is locked for both colours";
    }
}

// The mesh may have had no attribute before; the number of entries of a new one is then known only
// from the set of attributes.
TEST(CopiedSubmeshes, KnowHowLongNewAttributesAre) {
    auto mesh = test::disc_complex<double>(0.1);
    mesh.attributes.add<Vertex, double>("heat").set_field(true, OnInterface::advected);
    for (const auto colour : {RedBlack::red, RedBlack::black}) {
        CopiedSubmeshes<double> submeshes;
        create_submeshes(mesh, {3, 1, 0, colour}, submeshes);
        for (const auto& submesh : submeshes.list) {
            auto& copy = submesh->complex;
            EXPECT_EQ((copy.attributes.add<Vertex>("new", 0).size()), copy.vertices.size());
            EXPECT_EQ(copy.attributes.list().front()->on_interface(), OnInterface::advected);
            EXPECT_TRUE(copy.attributes.has_fields());
            copy.attributes.remove("new");
        }
        merge_submeshes(submeshes, mesh);
        EXPECT_EQ((mesh.attributes.add<Vertex>("v", 0).size()), mesh.vertices.size());
        EXPECT_EQ((mesh.attributes.add<Triangle>("t", 0).size()), mesh.triangles.size());
        mesh.attributes.remove("v");
        mesh.attributes.remove("t");
    }
}

TEST(CopiedSubmeshes, AreRefusedWithoutNumberOrDirection) {
    CopiedSubmeshes<double> submeshes;
    for (const CountingDivision& bad :
         {CountingDivision{.submeshes = 0}, CountingDivision{.submeshes = 2, .normal_x = 2},
          CountingDivision{.submeshes = 2, .normal_x = 0, .normal_y = 0}}) {
        EXPECT_THROW(create_submeshes(test::grid<double>(4), bad, submeshes), InputError);
    }
}

} // namespace
} // namespace dsc::copied_submeshes_test

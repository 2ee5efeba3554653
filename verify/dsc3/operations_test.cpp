// SPDX-License-Identifier: MIT
// Operations in three dimensions on random complexes: a refused operation changes nothing; a legal
// one leaves a valid complex whose phases keep their topology, and also their volumes unless the
// operation changes the interface.
#include "dsc/base/verdict.h"
#include "dsc3/random_mesh.h"
#include "support/environment.h"

namespace dsc3::test::operations_test {
namespace {

// Few under sanitizers.
const std::uint64_t seeds = dsc::test::are_asked_for("few") ? 3 : 24;
constexpr int tries = 60;

// Random elements of a complex.
struct Pick {
    const Complex& complex;
    Random random;
    Star star = {};

    Tet tet() {
        for (;;) {
            const Tet t{1 + random.below(complex.tet_bound() - 1)};
            if (complex.is_alive(t)) {
                return t;
            }
        }
    }
    EdgeAt edge() {
        const std::uint32_t t = tet().id;
        const std::uint32_t i = random.below(4);
        const std::uint32_t j = (i + 1 + random.below(3)) % 4;
        return {t, complex.tets[t].v[i], complex.tets[t].v[j]};
    }
};

// Runs an operation with random arguments many times on many complexes. Returns how often it was
// legal.
template <class Operation>
std::uint64_t run(Operation operation) {
    std::uint64_t done = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Complex complex = random_mesh(seed);
        Workspace work;
        Watch watch(complex);
        EXPECT_TRUE(watch.report().ok()) << watch.report().problem;
        Pick pick{complex, Random(seed)};
        for (int i = 0; i < tries && !testing::Test::HasFatalFailure(); ++i) {
            const Change change = operation(complex, work, pick);
            watch.expect(change, "seed");
            done += change != Change::nothing ? 1U : 0U;
        }
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << "seed " << seed;
            break;
        }
    }
    return done;
}

Change if_legal(Verdict verdict, Change change) {
    return verdict == Verdict::legal ? change : Change::nothing;
}

TEST(Operations3, SplitsKeepPhases) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const EdgeAt edge = pick.edge();
        const double share = pick.random.unit();
        const Point place = complex.at(edge.a) + share * (complex.at(edge.b) - complex.at(edge.a));
        const std::uint32_t vertices = complex.vertex_count();
        EXPECT_TRUE(gather(complex, edge, work.ring));
        if (work.ring.closed) {
            EXPECT_FALSE(edge_split(complex, work, edge, place + Point(10, 0, 0)).is_valid());
        }
        const Vertex v = edge_split(complex, work, edge, place);
        EXPECT_EQ(complex.vertex_count(), vertices + (v.is_valid() ? 1 : 0));
        return v.is_valid() ? Change::mesh : Change::nothing;
    });
    EXPECT_GT(done, seeds * tries / 2);
}

TEST(Operations3, ImprovingSplitsRaiseTheWorstQuality) {
    std::map<Verdict, int> verdicts;
    run([&](Complex& complex, Workspace& work, Pick& pick) {
        const EdgeAt edge = pick.edge();
        Ring ring;
        EXPECT_TRUE(gather(complex, edge, ring));
        const double before = worst_quality(complex, ring);
        const std::uint32_t vertices = complex.vertex_count();
        work.rewiring.changed.clear();
        constexpr double gain = 1.05;
        const Verdict verdict = improving_split(complex, work, edge, gain);
        ++verdicts[verdict];
        EXPECT_EQ(complex.vertex_count(), vertices + (verdict == Verdict::legal ? 1 : 0));
        EXPECT_EQ(work.rewiring.changed.size(), verdict == Verdict::legal ? 2 * ring.size : 0);
        for (const std::uint32_t t : work.rewiring.changed) {
            EXPECT_GT(quality_of(complex, t), gain * before);
        }
        return if_legal(verdict, Change::mesh);
    });
    for (const Verdict verdict :
         {Verdict::legal, Verdict::no_gain, Verdict::on_boundary, Verdict::on_interface}) {
        EXPECT_TRUE(verdicts[verdict] > 0 || seeds < 24) << dsc::to_string(verdict);
    }
}

TEST(Operations3, CollapsesKeepTopology) {
    std::map<Verdict, int> verdicts;
    run([&](Complex& complex, Workspace& work, Pick& pick) {
        const EdgeAt edge = pick.edge();
        const bool on_interface = complex.is_interface(Vertex{edge.a});
        const CollapseRules rules{.floor = 1e-6, .enough = 0, .min_cos = -1};
        const Verdict verdict = edge_collapse(complex, work, Vertex{edge.a}, Vertex{edge.b}, rules);
        EXPECT_EQ(complex.is_alive(Vertex{edge.a}), verdict != Verdict::legal);
        ++verdicts[verdict];
        return if_legal(verdict, on_interface ? Change::interface : Change::mesh);
    });
    for (const Verdict verdict : {Verdict::legal, Verdict::on_boundary, Verdict::on_interface,
                                  Verdict::changes_topology, Verdict::inverts}) {
        EXPECT_TRUE(verdicts[verdict] > 0 || seeds < 24) << dsc::to_string(verdict);
    }
}

TEST(Operations3, ACollapseStaysWithinItsDeviation) {
    // A ball whose vertices all lie well off the chords between their neighbours.
    Complex complex = initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.2), 1}}, {.edge_length = 0.1});
    Workspace work;
    const std::uint64_t hash = mesh_hash(complex);
    int by_deviation = 0;
    for (const InterfaceFace& face : interface_faces(complex)) {
        const CollapseRules exact{.enough = 0, .min_cos = -1, .deviation = 1e-6};
        const Verdict verdict =
            edge_collapse(complex, work, Vertex{face.v[0]}, Vertex{face.v[1]}, exact);
        by_deviation += verdict == Verdict::no_gain ? 1 : 0;
        const CollapseRules flat{.enough = 0, .min_cos = 0.99999};
        EXPECT_NE(edge_collapse(complex, work, Vertex{face.v[0]}, Vertex{face.v[1]}, flat),
                  Verdict::legal)
            << "its faces turn";
    }
    EXPECT_EQ(mesh_hash(complex), hash);
    EXPECT_GT(by_deviation, 10);
}

TEST(Operations3, EdgeRemovalsRaiseTheWorstQuality) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const EdgeAt edge = pick.edge();
        Ring ring;
        EXPECT_TRUE(gather(complex, edge, ring));
        const double before = worst_quality(complex, ring);
        const Verdict guard = edge_removal_guard(complex, work, edge);
        const Verdict verdict = edge_removal(complex, work, edge);
        EXPECT_EQ(guard, verdict);
        for (const std::uint32_t t : work.rewiring.changed) {
            EXPECT_GT(quality_of(complex, t), before);
        }
        work.rewiring.changed.clear();
        if (verdict == Verdict::legal) {
            EXPECT_FALSE(find_edge(complex, edge.a, edge.b, pick.star).is_valid());
        }
        return if_legal(verdict, Change::mesh);
    });
    EXPECT_GE(done, seeds / 2);
}

TEST(Operations3, FaceFlipsRaiseTheWorstQuality) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const Corner corner = corner_of(pick.tet().id, pick.random.below(4));
        return if_legal(face_flip(complex, work, corner), Change::mesh);
    });
    EXPECT_TRUE(done > 0 || seeds < 24);
}

TEST(Operations3, InterfaceFlipsKeepTopology) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const FlipRules rules{.floor = 1e-6, .min_cos = -0.5, .slack = 0};
        return if_legal(interface_flip(complex, work, pick.edge(), rules), Change::interface);
    });
    EXPECT_GE(done, seeds / 3);
}

TEST(Operations3, SliversChangePhaseOnlyWithTheirEdge) {
    run([](Complex& complex, Workspace& work, Pick& pick) {
        return if_legal(reassign_sliver(complex, work, pick.edge()), Change::interface);
    });
}

TEST(Operations3, SmoothingRaisesTheWorstQuality) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const std::uint32_t v = complex.tets[pick.tet().id].v[pick.random.below(4)];
        gather(complex, v, pick.star);
        const auto worst = [&] {
            double quality = 1;
            for (const Corner corner : pick.star.corners) {
                quality = std::min(quality, quality_of(complex, tet_of(corner)));
            }
            return quality;
        };
        const double before = worst();
        const Verdict verdict = smooth(complex, work, Vertex{v});
        if (verdict == Verdict::legal) {
            EXPECT_GT(worst(), before);
            EXPECT_EQ(work.rewiring.changed.size(), pick.star.corners.size())
                << "its tets are listed, since some of them got worse";
        }
        work.rewiring.changed.clear();
        EXPECT_NE(smooth(complex, work, Vertex{v}), Verdict::legal) << "it has settled";
        return if_legal(verdict, Change::mesh);
    });
    EXPECT_GE(done, seeds / 2);
}

TEST(Operations3, SmoothingAlongTheInterfaceRaisesTheWorstQuality) {
    const auto done = run([](Complex& complex, Workspace& work, Pick& pick) {
        const std::uint32_t v = complex.tets[pick.tet().id].v[pick.random.below(4)];
        const Point from = complex.at(v);
        gather(complex, v, pick.star);
        const auto worst = [&] {
            double quality = 1;
            for (const Corner corner : pick.star.corners) {
                quality = std::min(quality, quality_of(complex, tet_of(corner)));
            }
            return quality;
        };
        const double before = worst();
        InterfaceStar interface_star;
        gather(complex, pick.star, interface_star);
        const bool is_off_sheet = !is_sheet(interface_star);
        const Verdict verdict = smooth_along_interface(
            complex, work, Vertex{v}, {.enough = 1, .farthest = 0.3, .deviation = 0.02});
        if (verdict == Verdict::legal) {
            EXPECT_FALSE(is_off_sheet);
            EXPECT_TRUE(complex.is_interface(Vertex{v}));
            EXPECT_GT(worst(), 1.2 * before);
            EXPECT_LE((complex.at(v) - from).norm(), 0.6);
        } else {
            EXPECT_EQ(complex.at(v), from);
        }
        return if_legal(verdict, Change::interface);
    });
    EXPECT_GE(done, seeds / 3);
}

} // namespace
} // namespace dsc3::test::operations_test

// SPDX-License-Identifier: MIT
// At submesh boundaries no split is left undone and no vertex is missed.
#include "support/submesh_executor_testing.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <vector>

namespace dsc::submesh_boundaries_test {
namespace {

using test::Growing;
using test::NamedPartitioner;
using test::ways_to_divide;

// The cuts stay in place while the disc grows: splits deferred by one colour are done by the other.
TEST(SubmeshExecutor, LeavesNoLongEdgesOfTheInterfaceAtTheBoundaries) {
    constexpr std::uint32_t never = 1000;
    for (const NamedPartitioner& way : ways_to_divide(never)) {
        Growing disc(way.make(), 2);
        double longest = 0; // in edge lengths
        for (int step = 0; step < 9; ++step) {
            EXPECT_EQ(disc.simulation->step(disc.grow, 0, Growing::h).unreached, 0U);
            for (const Edge e : edges(disc.complex)) {
                if (is_interface(disc.complex, e)) {
                    longest = std::max(longest, length(disc.complex, e) / Growing::h);
                }
            }
        }
        // Remeshing splits edges longer than 1.4; afterwards the disc still grows a little.
        EXPECT_LT(longest, 1.45) << way.name;
    }
}

// The vertices that a submesh deferred and that no other submesh has visited yet.
class Waiting {
public:
    void add(DeferredKind kind, const Work<double>& by) {
        for (const auto& one : by.deferred.entries) {
            if (one.kind == kind) {
                waiting_[one.vertex] = &by;
                ++added_;
            }
        }
    }
    void look_at(const std::vector<std::uint32_t>& vertices, const Work<double>& by) {
        for (const std::uint32_t v : vertices) {
            const auto at = waiting_.find(v);
            if (at != waiting_.end() && at->second != &by) {
                waiting_.erase(at);
            }
        }
    }
    [[nodiscard]] std::size_t added() const { return added_; }
    // Returns the number of vertices still waiting, and clears the list.
    std::size_t take_forgotten(const Complex<double>& complex) {
        const auto count = std::ranges::count_if(
            waiting_, [&](const auto& one) { return complex.is_alive(Vertex{one.first}); });
        waiting_.clear();
        return static_cast<std::size_t>(count);
    }

private:
    std::map<std::uint32_t, const Work<double>*> waiting_;
    std::size_t added_ = 0;
};

TEST(SubmeshExecutor, ForgetsNobodyWhomASubmeshPutOff) {
    for (const NamedPartitioner& way : ways_to_divide(4)) {
        SCOPED_TRACE(way.name);
        Waiting stars;
        Waiting moving_vertices;
        Waiting remeshing;
        auto algorithm = default_algorithm<double>();
        auto& first = algorithm.remeshing;
        first.insert(first.begin(), {"before", [&](Work<double>& work) {
                                         remeshing.look_at(work.interface, work);
                                     }});
        first.push_back(
            {"after", [&](Work<double>& work) { remeshing.add(DeferredKind::remeshing, work); }});
        auto& motion = algorithm.motion;
        motion.insert(motion.begin(), {"first", [&](Work<double>& work) {
                                           std::vector<std::uint32_t> on_their_way;
                                           for (const auto& moving_vertex : work.moving_vertices) {
                                               on_their_way.push_back(moving_vertex.vertex);
                                           }
                                           moving_vertices.look_at(on_their_way, work);
                                       }});
        motion.insert(motion.end() - 1,
                      {"before", [&](Work<double>& work) { stars.look_at(work.active, work); }});
        motion.push_back({"after", [&](Work<double>& work) {
                              stars.add(DeferredKind::star, work);
                              moving_vertices.add(DeferredKind::moving_vertex, work);
                          }});
        Growing disc(way.make(), 1, algorithm); // one thread: passes write to shared data
        for (int step = 0; step < 12; ++step) {
            const StepReport report = disc.simulation->step(disc.grow, 0, 0.5 * Growing::h);
            ASSERT_EQ(report.sub_steps, 1U) << "the next one would hide what this one forgot";
            EXPECT_EQ(report.unreached, 0U);
            EXPECT_EQ(stars.take_forgotten(disc.complex), 0U) << "step " << step;
            EXPECT_EQ(moving_vertices.take_forgotten(disc.complex), 0U) << "step " << step;
            EXPECT_EQ(remeshing.take_forgotten(disc.complex), 0U) << "step " << step;
        }
        EXPECT_GT(stars.added(), 100U);
        EXPECT_GT(moving_vertices.added(), 5U);
        EXPECT_GT(remeshing.added(), 5U);
    }
}

// Counts the vertices that a submesh is about to visit but does not own: it would write to their
// stamps at the same time as their owner.
Pass<double> counting_strangers(std::atomic<int>& strangers) {
    return {"counting", [&strangers](Work<double>& work) {
                for (const auto* list : {&work.active, &work.resized}) {
                    for (const std::uint32_t v : *list) {
                        strangers += owns(work.complex, work.submesh.region, v) ? 0 : 1;
                    }
                }
            }};
}

// Merges vertices inside the phases, as far as the submesh allows it: often into one that has
// neighbours in another submesh.
void thin_out(Work<double>& work) {
    Complex<double>& complex = work.complex;
    for (const std::uint32_t v : std::vector<std::uint32_t>(work.interface)) {
        if (!gather(complex, work.submesh.region, v, work.star)) {
            continue;
        }
        for (std::uint32_t i = 0; i < work.star.size; ++i) {
            const Corner incident_edge = prev(work.star.corner[i]);
            if (edge_collapse(work.submesh, incident_edge, rewire::Vanishing::prev) ==
                Verdict::legal) {
                break;
            }
        }
    }
}

// A collapse by a pass of the application may affect neighbours that another submesh visits.
TEST(SubmeshExecutor, LooksAtItsOwnVerticesAfterCollapsesOfTheApplication) {
    for (const NamedPartitioner& way : ways_to_divide(4)) {
        SCOPED_TRACE(way.name);
        std::vector<std::uint64_t> hashes;
        for (const std::uint32_t threads : {1U, 2U, 3U}) {
            std::atomic<int> strangers = 0;
            auto algorithm = default_algorithm<double>();
            algorithm.remeshing.push_back({"thinning out", &thin_out});
            algorithm.motion.insert(algorithm.motion.begin(), counting_strangers(strangers));
            Growing disc(way.make(), threads, algorithm);
            std::uint64_t collapses = 0;
            for (int step = 0; step < test::steps_or_fewer(6); ++step) {
                const auto report = disc.simulation->step(disc.grow, 0, 0.5 * Growing::h);
                collapses += report.operations.collapses;
            }
            disc.expect_good();
            EXPECT_GT(collapses, 50U);
            EXPECT_EQ(strangers, 0);
            hashes.push_back(mesh_hash(disc.complex));
        }
        EXPECT_EQ(hashes[0], hashes[1]);
        EXPECT_EQ(hashes[0], hashes[2]);
    }
}

// Changes the phase of interface triangles and changes it back, as far as the submesh owns them.
// The mesh stays the same, but the changes are logged, also for vertices that are in no list of the
// submesh.
void relabel_twice(Work<double>& work) {
    Complex<double>& complex = work.complex;
    for (const std::uint32_t v : std::vector<std::uint32_t>(work.interface)) {
        // Only a third of the vertices: a changed vertex is listed anew by its position at the end
        // of the sub-step.
        if (v % 3 != 0 || !gather(complex, work.submesh.region, v, work.star) || !work.star.owned) {
            continue;
        }
        for (std::uint32_t i = 0; i < work.star.size; ++i) {
            const Triangle t{triangle_of(work.star.corner[i])};
            const Phase phase = complex.phase(t);
            rewire::relabel(complex, work.log, t, static_cast<Phase>(phase + 1));
            rewire::relabel(complex, work.log, t, phase);
        }
    }
}

// A vertex that has left a submesh is deferred by it, and may already be in the list of its new
// submesh.
TEST(SubmeshExecutor, ListsAVertexOnceThatAPassOfItsNewSubmeshChanges) {
    for (const NamedPartitioner& way : ways_to_divide(1000)) {
        SCOPED_TRACE(way.name);
        std::ptrdiff_t deferred = 0;
        auto algorithm = default_algorithm<double>();
        algorithm.remeshing.push_back({"relabelling", &relabel_twice});
        algorithm.remeshing.push_back({"counting", [&](Work<double>& work) {
                                           deferred += std::ranges::count(work.deferred.entries,
                                                                          DeferredKind::listing,
                                                                          &Deferred<double>::kind);
                                       }});
        Growing disc(way.make(), 1, algorithm);
        int seen_twice = 0;
        const InterfaceFlow<double> turn = [&](const InterfaceView<double>& view, std::size_t begin,
                                               std::size_t end, double, auto values) {
            std::vector<Vertex> vertices(view.vertices.begin(), view.vertices.end());
            std::ranges::sort(vertices, {}, &Vertex::id);
            seen_twice += std::ranges::adjacent_find(vertices) != vertices.end() ? 1 : 0;
            for (std::size_t i = begin; i < end; ++i) {
                values[i] = {0.5 - view.positions[i].y(), view.positions[i].x() - 0.5};
            }
        };
        for (int step = 0; step < 60; ++step) {
            EXPECT_EQ(disc.simulation->step(turn, 0, 2 * Growing::h).unreached, 0U);
        }
        EXPECT_GT(deferred, 5);
        EXPECT_EQ(seen_twice, 0);
    }
}

} // namespace
} // namespace dsc::submesh_boundaries_test

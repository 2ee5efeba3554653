// SPDX-License-Identifier: MIT
// A random scene, run by the sequential method or by submeshes, and all that can be seen of how it
// ends: positions, ids, data, interface, counts.
#pragma once

#include "support/random/scene.h"
#include "support/random/submeshes.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/passes/interface/list.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/validate.h"
#include "scenes/integrator_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace dsc::test {

inline auto counts_of(const OperationCounts& c) {
    return std::tuple(c.moves, c.flips, c.interface_splits, c.interface_collapses, c.splits,
                      c.collapses, c.smoothed, c.subdivisions, c.retriangulations, c.examined);
}

class Hash {
public:
    void add(std::uint64_t value) { sum_ = (sum_ ^ value) * 0x100000001b3U + (sum_ >> 47U); }
    template <class Real>
    void add_real(Real value) {
        add(std::bit_cast<std::uint64_t>(static_cast<double>(value)));
    }
    [[nodiscard]] std::uint64_t value() const { return sum_; }

private:
    std::uint64_t sum_ = 0xcbf29ce484222325U;
};

// The state by id: positions, triangles and their links, and which ids are free.
template <class Real>
std::uint64_t id_hash(const Complex<Real>& complex) {
    Hash hash;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const auto& record = complex.vertices[v];
        hash.add(record.flags);
        if (complex.is_alive(Vertex{v})) {
            hash.add_real(record.x);
            hash.add_real(record.y);
            hash.add(record.corner);
        }
    }
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        hash.add(complex.is_alive(Triangle{t}) ? 1 : 0);
        for (std::size_t i = 0; i < 3 && complex.is_alive(Triangle{t}); ++i) {
            hash.add(complex.triangles[t].v[i]);
            hash.add(complex.triangles[t].n[i]);
            hash.add(complex.triangles[t].phase);
        }
    }
    return hash.value();
}

// Data on all three kinds of simplices, set by place, so that no two are the same.
template <class Real>
class Data {
public:
    explicit Data(Complex<Real>& complex)
        : complex_(complex),
          of_vertices_(complex.attributes.template add<Vertex, double>("vertex", -1)),
          of_edges_(complex.attributes.template add<Edge, double>("edge", -2)),
          of_triangles_(complex.attributes.template add<Triangle, double>("triangle", -3)) {
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            of_vertices_[Vertex{v}] = place_of(v);
        }
        for (const Triangle t : triangles(complex)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t.id, i);
                of_edges_.set(complex, complex.edge(c),
                              place_of(complex.vertex(next(c))) +
                                  place_of(complex.vertex(prev(c))));
                of_triangles_[t] = 3 * place_of(complex.vertex(c));
            }
        }
    }

    [[nodiscard]] std::uint64_t hash() const {
        Hash hash;
        for (const Vertex v : vertices(complex_)) {
            hash.add_real(of_vertices_[v]);
        }
        for (const Triangle t : triangles(complex_)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                hash.add_real(of_edges_.at_corner(corner_of(t.id, i)));
                hash.add_real(of_triangles_[t]);
            }
        }
        return hash.value();
    }

private:
    [[nodiscard]] double place_of(std::uint32_t v) const {
        const auto& record = complex_.vertices[v];
        return static_cast<double>(record.x) + 17 * static_cast<double>(record.y);
    }

    Complex<Real>& complex_;
    VertexAttribute<double>& of_vertices_;
    EdgeAttribute<double>& of_edges_;
    TriangleAttribute<double>& of_triangles_;
};

struct Outcome {
    // After each step.
    std::vector<std::uint64_t> hashes;
    std::vector<std::uint64_t> id_hashes;
    std::vector<std::uint64_t> data_hashes;
    std::vector<std::uint64_t> unreached;
    std::vector<std::vector<std::uint32_t>> interfaces;
    // In total.
    OperationCounts counts;
    std::uint64_t passes = 0;
    std::map<Phase, double> areas;
    std::size_t most_submeshes = 0; ///< of the first colour
    std::uint32_t most_threads = 0;
    std::string words;
};

inline void expect_same(const Outcome& one, const Outcome& other) {
    SCOPED_TRACE(one.words + "\nagainst" + other.words);
    EXPECT_EQ(other.hashes, one.hashes);
    EXPECT_EQ(other.id_hashes, one.id_hashes) << "ids differ";
    EXPECT_EQ(other.data_hashes, one.data_hashes) << "attributes differ";
    EXPECT_EQ(other.unreached, one.unreached);
    EXPECT_EQ(other.interfaces, one.interfaces) << "ids or order differ";
    EXPECT_EQ(counts_of(other.counts), counts_of(one.counts));
    EXPECT_EQ(other.passes, one.passes);
    EXPECT_EQ(other.most_submeshes, one.most_submeshes);
}

// What is run, apart from the number of threads and the time measurements.
struct Scene {
    std::uint64_t seed;
    double h = 0.025;
    int steps = steps_or_fewer(10);
    Wildness wildness = Wildness::none;
    bool patches = false;
    bool data = false;
    double dt = 0.4;                                          ///< in edge lengths at a speed of one
    std::function<void(InterfaceThresholds&)> interface = {}; ///< changes them
    scenes::IntegratorChoice integrator = scenes::IntegratorChoice::rk4;
};

template <class Real>
using MakeExecutor = std::function<std::unique_ptr<SubmeshExecutor<Real>>(
    Complex<Real>&, const Options<Real>&, std::ostream&)>;

// No `make`: sequential.
template <class Real>
Outcome simulate(const Scene& scene, const MakeExecutor<Real>& make) {
    Dice dice(scene.seed);
    auto complex = scene.patches ? test::random_patches<Real>(dice, scene.h, 12)
                                 : test::random_shapes<Real>(dice, scene.h);
    const RandomFlow flow(dice, 1, scene.wildness);
    const Velocity<Real> velocity = flow.velocity<Real>();
    Options<Real> options;
    options.edge_length = static_cast<Real>(scene.h);
    scenes::choose_integrator(options, scene.integrator);
    if (scene.interface) {
        scene.interface(options.interface);
    }
    std::unique_ptr<Data<Real>> data;
    if (scene.data) {
        data = std::make_unique<Data<Real>>(complex);
    }
    std::ostringstream words;
    words << " seed " << scene.seed << ", wildness " << static_cast<int>(scene.wildness);
    std::unique_ptr<SubmeshExecutor<Real>> executor;
    if (make) {
        executor = make(complex, options, words);
    }
    const SubmeshExecutor<Real>* seen = executor.get();
    Simulation<Real> simulation(complex, options, std::move(executor));
    Outcome outcome;
    outcome.words = words.str();
    const double dt = scene.dt * scene.h;
    for (int step = 0; step < scene.steps; ++step) {
        const auto report =
            simulation.step(velocity, static_cast<Real>(step * dt), static_cast<Real>(dt));
        outcome.counts += report.operations;
        outcome.passes += report.passes;
        outcome.unreached.push_back(report.unreached);
        outcome.hashes.push_back(mesh_hash(complex));
        outcome.id_hashes.push_back(id_hash(complex));
        outcome.data_hashes.push_back(data ? data->hash() : 0);
        outcome.interfaces.push_back(simulation.interface());
        EXPECT_EQ(report.interface_vertices, outcome.interfaces.back().size());
        const std::string problem = validate(complex).problem;
        EXPECT_EQ(problem, "") << outcome.words << ", step " << step;
        if (!problem.empty()) {
            return outcome;
        }
        EXPECT_EQ(test::interface_fault(complex, outcome.interfaces.back()), "")
            << outcome.words << ", step " << step;
        if (seen != nullptr) {
            outcome.most_submeshes = std::max(
                outcome.most_submeshes, seen->view().partition.colours.front().regions.size());
            outcome.most_threads = std::max(outcome.most_threads, seen->view().threads_used);
        }
    }
    for (const Triangle t : triangles(complex)) {
        outcome.areas[complex.phase(t)] += static_cast<double>(area(complex, t));
    }
    return outcome;
}

template <class Real>
Outcome run_division(const Scene& scene, PartitionFamily family, std::uint32_t threads,
                     bool profile = false) {
    return simulate<Real>(
        scene, [&](Complex<Real>& complex, const Options<Real>& options, std::ostream& words) {
            Dice dice(1000 * scene.seed + static_cast<std::uint64_t>(family));
            return test::random_executor(dice, family, complex, options, threads, words, profile);
        });
}

/// Scenes that the sequential method ends without a blocked vertex.
constexpr std::array<std::uint64_t, 6> tame_seeds{48, 49, 76, 80, 86, 90};

} // namespace dsc::test

// SPDX-License-Identifier: MIT
// The cost of one operation (thesis, chapter 7), including its guard. An iteration applies it to a
// batch of simplices whose surroundings do not overlap, so the operations are independent;
// restoring the complex is not timed. `kernel/...` are functions of the whole mesh, per triangle.
// The time is CPU time, because nothing here waits or uses threads, and other programs disturb it
// less than wall time.
#include "steps/refusal.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/operations/edge_split.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/clock.h"
#include "scenes/run/run.h"
#include "scenes/run/start.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/smoothing.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace dsc::bench {

namespace {

constexpr int ground_triangles = 28000;
constexpr const char* label = "CPU time of a batch"; ///< instead of wall time
constexpr double jitter = 0.2; ///< in edge lengths: all triangles differ, none is inverted

bool star_is_positive(const Complex<double>& complex, std::uint32_t v) {
    bool positive = true;
    turn(complex, v, [&](Corner c) {
        const auto corners = complex.vertices_of(Triangle{triangle_of(c)});
        positive = positive &&
                   orientation<double>(complex.position(corners[0]), complex.position(corners[1]),
                                       complex.position(corners[2])) > 0;
    });
    return positive;
}

Complex<double> make_ground() {
    const scenes::Scene& scene = scenes::find_scene("speedup-scaling");
    scenes::Parameters parameters = scene.defaults;
    parameters.h = std::sqrt(4 / (std::sqrt(3.0) * ground_triangles));
    auto complex = scenes::first_complex<double>(scene.prepare(parameters), parameters);
    std::mt19937_64 random(1);
    const auto offset = [&] {
        const double unit = static_cast<double>(random() >> 11U) * 0x1p-53;
        return (2 * unit - 1) * jitter * parameters.h;
    };
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        const double dx = offset();
        const double dy = offset();
        const StarSummary summary = inspect(complex, Region{}, v);
        if (!summary.on_boundary && summary.interface_edges == 0) {
            const Point<double> before = complex.position(Vertex{v});
            complex.set_position(Vertex{v}, before + Point<double>(dx, dy));
            if (!star_is_positive(complex, v)) {
                complex.set_position(Vertex{v}, before);
            }
        }
    }
    validate_or_throw(complex);
    return complex;
}

/// The complex from which all benchmarks start.
const Complex<double>& ground() {
    static const Complex<double> complex = make_ground();
    return complex;
}

/// The verdict of an operation, and the increase of the number of triangles that it reports.
struct Done {
    Verdict verdict;
    int triangles;
};

using Surroundings = std::vector<std::uint32_t>; ///< triangles, duplicates allowed

void add_star(const Complex<double>& complex, Vertex v, Surroundings& out) {
    turn(complex, v.id, [&](Corner c) { out.push_back(triangle_of(c)); });
}

struct EdgeFlip {
    using Simplex = Edge;
    static void surroundings(const Complex<double>& k, Edge e, Surroundings& out) {
        out = {triangle_of(e.id), triangle_of(k.twin(e.id))};
    }
    static Done apply(Complex<double>& k, Edge e) { return {edge_flip(k, e), 0}; }
};

struct EdgeSplit {
    using Simplex = Edge;
    static void surroundings(const Complex<double>& k, Edge e, Surroundings& out) {
        out = {triangle_of(e.id), triangle_of(k.twin(e.id))};
    }
    static Done apply(Complex<double>& k, Edge e) { return {edge_split(k, e).verdict, 2}; }
};

struct EdgeCollapse {
    using Simplex = Edge;
    static void surroundings(const Complex<double>& k, Edge e, Surroundings& out) {
        for (const Vertex v : k.vertices_of(e)) {
            add_star(k, v, out);
        }
    }
    static Done apply(Complex<double>& k, Edge e) { return {edge_collapse(k, e), -2}; }
};

struct LoopSubdivision {
    using Simplex = Triangle;
    static void surroundings(const Complex<double>& k, Triangle t, Surroundings& out) {
        out = {t.id};
        for (std::uint32_t i = 0; i < 3; ++i) {
            out.push_back(triangle_of(k.twin(corner_of(t.id, i))));
        }
    }
    static Done apply(Complex<double>& k, Triangle t) {
        return {loop_subdivision(k, t).verdict, 6};
    }
};

struct LocalRetriangulation {
    using Simplex = Triangle;
    static void surroundings(const Complex<double>& k, Triangle t, Surroundings& out) {
        for (const Vertex v : k.vertices_of(t)) {
            add_star(k, v, out);
        }
    }
    static Done apply(Complex<double>& k, Triangle t) {
        const RetriangulationResult result = local_retriangulation(k, t);
        return {result.verdict, -static_cast<int>(result.triangles_removed)};
    }
};

struct LaplacianSmoothing {
    using Simplex = Vertex;
    static void surroundings(const Complex<double>& k, Vertex v, Surroundings& out) {
        add_star(k, v, out);
    }
    static Done apply(Complex<double>& k, Vertex v) { return {laplacian_smoothing(k, v), 0}; }
};

// Visits every simplex of the ground, except edges of the domain boundary.
template <class Visit>
void for_each(const Complex<double>& k, Edge, Visit visit) {
    for (Corner c = 4; c < 4 * k.triangle_bound(); ++c) {
        if (k.is_alive(Edge{c}) && !is_border(k.twin(c))) {
            visit(Edge{c});
        }
    }
}
template <class Visit>
void for_each(const Complex<double>& k, Triangle, Visit visit) {
    for (const Triangle t : triangles(k)) {
        visit(t);
    }
}
template <class Visit>
void for_each(const Complex<double>& k, Vertex, Visit visit) {
    for (const Vertex v : vertices(k)) {
        visit(v);
    }
}

/// The simplices of a batch by ascending id, and the resulting mesh.
template <class Simplex>
struct Batch {
    std::vector<Simplex> simplices;
    std::uint64_t hash = 0;
};

/// Chooses simplices where the operation is legal and whose surroundings do not overlap. Throws
/// InvariantError if the complex is not valid afterwards, or its growth differs from that reported
/// by the operations.
template <class Operation>
Batch<typename Operation::Simplex> make_batch() {
    Batch<typename Operation::Simplex> batch;
    const Complex<double>& before = ground();
    Complex<double> after = before;
    std::vector<std::uint8_t> taken(before.triangle_bound(), 0);
    std::int64_t triangles = before.triangle_count();
    Surroundings around;
    for_each(before, typename Operation::Simplex{}, [&](auto simplex) {
        around.clear();
        Operation::surroundings(before, simplex, around);
        for (const std::uint32_t t : around) {
            if (t == border_triangle || taken[t] != 0) {
                return;
            }
        }
        const Done done = Operation::apply(after, simplex);
        if (done.verdict == Verdict::legal) {
            for (const std::uint32_t t : around) {
                taken[t] = 1;
            }
            triangles += done.triangles;
            batch.simplices.push_back(simplex);
        }
    });
    validate_or_throw(after);
    if (after.triangle_count() != triangles || batch.simplices.size() < 100) {
        throw InvariantError(std::to_string(batch.simplices.size()) + " operations left " +
                             std::to_string(after.triangle_count()) + " triangles, where " +
                             std::to_string(triangles) + " are expected");
    }
    batch.hash = mesh_hash(after);
    if (batch.hash == mesh_hash(before)) {
        throw InvariantError("the operations changed nothing");
    }
    return batch;
}

template <class Operation>
void measure_operation(benchmark::State& state) {
    static const Batch<typename Operation::Simplex> batch = make_batch<Operation>();
    Complex<double> complex = ground();
    complex.reserve(2 * complex.vertices.size(), 2 * complex.triangles.size());
    for (auto _ : state) {
        complex = ground();
        std::size_t legal = 0;
        const scenes::Stopwatch watch;
        for (const auto simplex : batch.simplices) {
            legal += Operation::apply(complex, simplex).verdict == Verdict::legal ? 1U : 0U;
        }
        state.SetIterationTime(watch.cpu());
        if (legal != batch.simplices.size()) {
            throw InvariantError(std::to_string(legal) + " operations of " +
                                 std::to_string(batch.simplices.size()) + " were legal");
        }
    }
    if (mesh_hash(complex) != batch.hash) {
        throw InvariantError("the mesh is not the one that was checked");
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch.simplices.size()));
    state.SetLabel(label);
    state.counters["batch"] = static_cast<double>(batch.simplices.size());
}

/// Times `run(copy of the ground)`; `check` checks the complex and the return value.
template <class Run, class Check>
void measure_kernel(benchmark::State& state, Run run, Check check) {
    Complex<double> complex = ground();
    for (auto _ : state) {
        complex = ground();
        const scenes::Stopwatch watch;
        // Constant, because GCC may lose the value of a variable passed to DoNotOptimize.
        const auto result = run(complex);
        benchmark::DoNotOptimize(result);
        state.SetIterationTime(watch.cpu());
        if (!check(complex, result)) {
            throw InvariantError("the timed function returns a wrong result");
        }
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(ground().triangle_count()));
    state.SetLabel(label);
}

// Gathers every star once: three corners for each triangle.
std::uint64_t gather_all(const Complex<double>& complex) {
    static Star<double> star;
    std::uint64_t corners = 0;
    for (const Vertex v : vertices(complex)) {
        if (gather(complex, Region{}, v.id, star)) {
            corners += star.size;
        }
    }
    return corners;
}

template <class Body>
void add(const std::string& name, Body body) {
    add_row(name + "/triangles:" + std::to_string(ground_triangles), body)
        ->Unit(benchmark::kMicrosecond);
}

} // namespace

void register_operations() {
    add("operation/edge_flip", measure_operation<EdgeFlip>);
    add("operation/edge_split", measure_operation<EdgeSplit>);
    add("operation/edge_collapse", measure_operation<EdgeCollapse>);
    add("operation/loop_subdivision", measure_operation<LoopSubdivision>);
    add("operation/local_retriangulation", measure_operation<LocalRetriangulation>);
    add("operation/laplacian_smoothing", measure_operation<LaplacianSmoothing>);
}

void register_kernels() {
    add("kernel/gather_star", [](benchmark::State& state) {
        measure_kernel(state, gather_all, [](const auto& complex, std::uint64_t corners) {
            return corners == 3 * std::uint64_t{complex.triangle_count()};
        });
    });
    add("kernel/mesh_hash", [](benchmark::State& state) {
        Complex<double> shuffled = ground();
        renumber(shuffled);
        const std::uint64_t expected = mesh_hash(shuffled);
        measure_kernel(
            state, [](const auto& complex) { return mesh_hash(complex); },
            [&](const auto&, std::uint64_t hash) { return hash == expected; });
    });
    add("kernel/validate", [](benchmark::State& state) {
        measure_kernel(
            state, [](const auto& complex) { return validate(complex); },
            [](const auto& complex, const ValidationReport& report) {
                return report.ok() && report.triangles == complex.triangle_count();
            });
    });
    add("kernel/renumber", [](benchmark::State& state) {
        const std::uint64_t expected = mesh_hash(ground());
        measure_kernel(
            state, [](auto& complex) { return renumber(complex).vertices.size(); },
            [&](const auto& complex, std::size_t) { return mesh_hash(complex) == expected; });
    });
}

} // namespace dsc::bench

// SPDX-License-Identifier: MIT
// Runs a random scene for a few steps, with any strategy and random options: each step ends with a
// valid complex and an exact list of interface vertices, and replaying the log gives the same
// complex. Results are the same, id by id, with three threads and with one, or in one submesh and
// without submeshes.
#include "fuzz/steps.h"
#include "fuzz/target.h"
#include "support/random/options.h"
#include "support/random/scene.h"
#include "support/random/submeshes.h"
#include "support/topology/changing.h"
#include "support/ways.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/motion/interface_flow.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"
#include "replay/replay.h"
#include "thesis/divisions/slabs.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc::fuzz {

namespace {

using test::Dice;

constexpr int steps = 6;
constexpr std::size_t enough_edits = 10'000; // discontinuous flows make interfaces of any length

template <class Real>
Complex<Real> draw_complex(Dice& dice, double h) {
    return dice.chance(0.4) ? test::random_patches<Real>(dice, h, dice.in(2, 60))
                            : test::random_shapes<Real>(dice, h);
}

template <class Real>
void draw_sizes(Dice& dice, double h, SizeOptions<Real>& sizes) {
    if (!dice.chance(0.4)) {
        return;
    }
    sizes.growth = dice.in(1.05, 2.0);
    sizes.longest = static_cast<Real>(dice.chance(0.5) ? 0.0 : dice.in(1.0, 6.0) * h);
    const auto slope = static_cast<Real>(dice.in(-3.0, 3.0));
    const auto length = static_cast<Real>(h);
    const Real smallest = length / 1000;
    if (dice.chance(0.3)) {
        sizes.by_place = [=](const Point<Real>& p, Real time, Phase phase) {
            return std::max(length * (1 + static_cast<Real>(phase) + slope * (p.x() + time)),
                            smallest);
        };
    }
    if (dice.chance(0.3)) {
        sizes.on_interface = [=](const Point<Real>& p, Real) {
            return std::max(length * (1 + slope * p.y()), smallest);
        };
    }
    if (dice.chance(0.3)) {
        sizes.by_distance = [=](Real distance) {
            return std::max(length + slope * distance, smallest);
        };
    }
    sizes.changes_in_time = (sizes.by_place || sizes.on_interface) && dice.chance(0.5);
}

template <class Real>
test::ChangingOptions<Real> draw_all_options(Dice& dice, double h) {
    test::ChangingOptions<Real> options{test::draw_options<Real>(dice, h)};
    options.max_sub_steps = 20;
    test::draw_topology(dice, h, options.topology);
    if (dice.chance(0.2)) {
        // A large contact distance; if a phase is too small for it, the stage refuses.
        options.topology.contact *= static_cast<Real>(dice.in(2.0, 12.0));
    }
    if (dice.chance(0.2)) {
        options.topology.energy = [](Phase one, Phase other) { return 1.0 + 0.3 * (one + other); };
    }
    draw_sizes(dice, h, options.sizes);
    if (dice.chance(0.15)) {
        options.advected_phases.push_back(static_cast<Phase>(dice.in(0, 3)));
    }
    return options;
}

// The division is drawn without using the number of threads: the same dice give the same division.
template <class Real>
std::unique_ptr<Executor<Real>> draw_executor(Dice dice, Complex<Real>& complex,
                                              const Options<Real>& options, std::uint32_t threads) {
    if (dice.chance(0.6)) {
        return test::random_executor(dice, complex, options, threads);
    }
    const auto which =
        static_cast<std::size_t>(dice.in(0, static_cast<int>(all_divisions.size()) - 1));
    return make_executor(complex, options,
                         Parallel{.threads = threads,
                                  .division = all_divisions[which],
                                  .submeshes = test::number_in(dice, 0, 9),
                                  .always_all_threads = true});
}

template <class Real>
using Stepper = std::function<StepReport(Simulation<Real>& simulation, Real time, Real dt)>;

template <class Flow, class Real>
Stepper<Real> stepper(Flow flow) {
    return [flow](Simulation<Real>& simulation, Real time, Real dt) {
        return simulation.step(flow, time, dt);
    };
}

// A velocity by position, an InterfaceFlow, or curvature flow.
template <class Real>
Stepper<Real> draw_flow(Dice& dice, bool is_velocity) {
    const auto wildness =
        dice.chance(0.5) ? test::Wildness::none : dice.one_of(test::wildness_names);
    const test::RandomFlow flow(dice, 1, wildness);
    if (is_velocity || dice.chance(0.6)) {
        return stepper<Velocity<Real>, Real>(flow.velocity<Real>());
    }
    if (dice.chance(0.5)) {
        const auto speed = static_cast<Real>(dice.in(-1.0, 1.0));
        return stepper<InterfaceFlow<Real>, Real>(
            vertex_flow<Real>([=](const auto& view, std::size_t i, Real) -> Point<Real> {
                return speed * normal(view, i);
            }));
    }
    return stepper<InterfaceMotion<Real>, Real>(
        curvature_flow<Real>({.tension = dice.in(0.0, 1.0), .mobility = dice.in(0.01, 0.3)}));
}

template <class Real>
void check(const Complex<Real>& complex, const Simulation<Real>& simulation,
           const Options<Real>& options, const StepReport& report, bool is_copied) {
    std::string problem = validate(complex).problem;
    if (problem.empty() && options.advected_phases.empty()) {
        problem = test::interface_fault(complex, simulation.interface());
    }
    expect(problem.empty(), problem);
    expect(report.sub_steps <= static_cast<std::uint32_t>(options.max_sub_steps),
           "more sub-steps than allowed");
    // Create and merge makes a round of passes for each colour.
    expect(is_copied ||
               report.passes <= report.sub_steps * static_cast<std::uint32_t>(options.max_passes),
           "more passes than allowed");
    expect(report.held <= report.unreached, "more vertices held than unreached");
}

// Attributes of all three kinds of simplices, with distinct values that depend on the position.
template <class Real>
class Data {
public:
    explicit Data(Complex<Real>& complex)
        : complex_(complex),
          of_vertices_(complex.attributes.template add<Vertex, double>("vertex", -1)),
          of_edges_(complex.attributes.template add<Edge, double>("edge", -2)),
          of_triangles_(complex.attributes.template add<Triangle, double>("triangle", -3)) {
        for (const Triangle t : triangles(complex)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t.id, i);
                const Vertex v{complex.vertex(c)};
                of_vertices_[v] = place_of(v);
                of_edges_.set(complex, complex.edge(c),
                              place_of(Vertex{complex.vertex(next(c))}) +
                                  place_of(Vertex{complex.vertex(prev(c))}));
                of_triangles_[t] = 3 * place_of(v);
            }
        }
    }

    [[nodiscard]] std::vector<double> values() const {
        std::vector<double> all;
        for (const Triangle t : triangles(complex_)) {
            all.push_back(of_triangles_[t]);
            for (std::uint32_t i = 0; i < 3; ++i) {
                const Corner c = corner_of(t.id, i);
                all.push_back(of_edges_.at_corner(c));
                all.push_back(of_vertices_[Vertex{complex_.vertex(c)}]);
            }
        }
        return all;
    }

private:
    [[nodiscard]] double place_of(Vertex v) const {
        const Point<double> p = complex_.position(v).template cast<double>();
        return p.x() + 17 * p.y();
    }

    Complex<Real>& complex_;
    VertexAttribute<double>& of_vertices_;
    EdgeAttribute<double>& of_edges_;
    TriangleAttribute<double>& of_triangles_;
};

bool same(const Edit& a, const Edit& b) {
    return a.kind == b.kind && a.reason == b.reason && a.on_interface == b.on_interface &&
           a.corner == b.corner && a.vertex == b.vertex && a.ends == b.ends &&
           a.apexes == b.apexes && a.made == b.made && a.x == b.x && a.y == b.y;
}

template <class Real>
using MakeExecutor =
    std::function<std::unique_ptr<Executor<Real>>(Complex<Real>&, const Options<Real>&)>;

template <class Real>
struct Scene {
    Complex<Real> complex;
    test::ChangingOptions<Real> options;
    Stepper<Real> step;
    double dt;
    bool has_data;
};

/// All that can be seen of how a run ends.
struct Outcome {
    std::vector<Edit> edits;
    std::vector<std::uint32_t> interface;
    std::vector<double> data;
    std::uint64_t hash = 0;
    std::uint64_t unreached = 0;
    std::size_t submeshes = 0;
    std::uint32_t threads = 0;
};

template <class Real>
Outcome run(const Scene<Real>& scene, const MakeExecutor<Real>& make) {
    Complex<Real> complex = scene.complex;
    std::optional<Data<Real>> data;
    if (scene.has_data) {
        data.emplace(complex);
    }
    std::unique_ptr<Executor<Real>> executor;
    if (make) {
        executor = make(complex, scene.options);
    }
    const auto* seen = dynamic_cast<const SubmeshExecutor<Real>*>(executor.get());
    const bool is_copied = executor != nullptr && seen == nullptr;
    test::ChangingSimulation<Real> simulation(complex, scene.options, std::move(executor));
    Outcome outcome;
    std::atomic<bool> is_enough = false;
    simulation.interrupt_by(&is_enough);
    simulation.add_listener([&](std::span<const Edit> some) {
        outcome.edits.insert(outcome.edits.end(), some.begin(), some.end());
        is_enough = outcome.edits.size() > enough_edits;
    });
    std::uint64_t examined = 0;
    for (int i = 0; i < steps && !is_enough && examined < enough_edits; ++i) {
        const StepReport report =
            scene.step(simulation, static_cast<Real>(i * scene.dt), static_cast<Real>(scene.dt));
        check(complex, simulation, scene.options, report, is_copied);
        examined += report.operations.examined;
        outcome.unreached += report.unreached;
        if (seen != nullptr && !seen->view().partition.colours.empty()) {
            outcome.submeshes =
                std::max(outcome.submeshes, seen->view().partition.colours.front().regions.size());
            outcome.threads = std::max(outcome.threads, seen->view().threads_used);
        }
    }
    outcome.hash = mesh_hash(complex);
    outcome.interface = simulation.interface();
    if (data) {
        outcome.data = data->values();
    }
    // Create and merge does not log its edits.
    if (std::ranges::find(outcome.edits, EditKind::rebuild, &Edit::kind) == outcome.edits.end()) {
        Complex<Real> again = scene.complex;
        expect(replay<Real>(again, outcome.edits).skipped == 0,
               "the log does not fit the first complex");
        expect(mesh_hash(again) == outcome.hash, "the log replayed gives another complex");
    }
    return outcome;
}

void expect_same(const Outcome& one, const Outcome& other, const std::string& words) {
    expect(one.hash == other.hash, words + " the mesh is another one");
    expect(std::ranges::equal(one.edits, other.edits, same), words + " other edits are made");
    expect(one.interface == other.interface, words + " the interface is listed otherwise");
    expect(one.data == other.data, words + " attributes differ");
    expect(one.unreached == other.unreached, words + " others are unreached");
}

template <class Real>
Steps run_scene(Dice& dice) {
    const double h = dice.in(0.05, 0.14);
    Complex<Real> complex = draw_complex<Real>(dice, h);
    auto options = draw_all_options<Real>(dice, h);
    const bool is_velocity = !options.advected_phases.empty();
    const Stepper<Real> step = draw_flow<Real>(dice, is_velocity);
    const double dt = h * std::pow(10.0, dice.in(-2.0, 0.7));
    const bool is_sequential = dice.chance(0.3);
    const bool has_data = dice.chance(0.3);
    const Scene<Real> scene{std::move(complex), std::move(options), step, dt, has_data};
    try {
        Complex<Real> copy = scene.complex;
        const test::ChangingSimulation<Real> simulation(copy, scene.options);
    } catch (const InputError&) {
        return {}; // options that contradict each other, or do not fit this complex
    }
    const auto in_threads = [&](std::uint32_t threads) {
        return run<Real>(scene, [&](Complex<Real>& mesh, const Options<Real>& all) {
            return draw_executor(dice, mesh, all, threads);
        });
    };
    if (is_sequential) {
        const Outcome none = run<Real>(scene, {});
        const Outcome one = run<Real>(scene, [](Complex<Real>& mesh, const Options<Real>& all) {
            return std::make_unique<SubmeshExecutor<Real>>(
                mesh, all, default_algorithm<Real>(),
                std::make_unique<SlabPartitioner<Real>>(SlabOptions{.submeshes = 1}),
                Parallel{.threads = 3, .always_all_threads = true});
        });
        expect_same(none, one, "in one submesh");
        return {none.edits.size(), one.submeshes, one.threads};
    }
    const Outcome one = in_threads(1);
    const Outcome three = in_threads(3);
    expect_same(one, three, "with three threads");
    return {three.edits.size(), three.submeshes, three.threads};
}

} // namespace

Steps try_steps(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) {
        return {};
    }
    Dice dice(bytes.subspan(1));
    return bytes[0] % 4 == 3 ? run_scene<float>(dice) : run_scene<double>(dice);
}

std::uint64_t run_steps(std::span<const std::uint8_t> bytes) { return try_steps(bytes).edits; }

} // namespace dsc::fuzz

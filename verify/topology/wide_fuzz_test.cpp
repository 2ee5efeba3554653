// SPDX-License-Identifier: MIT
// Random shapes and patches in random flows, with contact distances of one to eight edge lengths:
// every step ends with a valid complex, and what happens is the same for any number of threads.
// DSC_FUZZ_SEEDS=N runs N scenes, and DSC_FUZZ_FIRST says where to begin.
#include "support/environment.h"
#include "support/random/submeshes.h"
#include "support/topology/wide_contact.h"
#include "support/ways.h"

#include "dsc/base/error.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/validate.h"

#include <atomic>
#include <string>

namespace dsc::wide_fuzz_test {
namespace {

using test::Dice;
using test::from_environment;

template <class Real>
struct Scene {
    Complex<Real> complex;
    test::ChangingOptions<Real> options;
    Velocity<Real> velocity;
    Real dt;
};

// The contact distance is halved until no phase is too small for it.
template <class Real>
void make_allowed(const Complex<Real>& complex, test::ChangingOptions<Real>& options) {
    const auto is_refused = [&] {
        try {
            Complex<Real> copy = complex;
            test::ChangingSimulation<Real> simulation(copy, options);
            return false;
        } catch (const InputError&) {
            return true;
        }
    };
    while (is_refused()) {
        options.topology.contact /= 2;
        for (auto& pair : options.topology.pairs) {
            pair.contact /= 2;
        }
    }
}

template <class Real>
Scene<Real> draw(std::uint64_t seed) {
    Dice dice(seed);
    const double h = dice.in(0.03, 0.07);
    auto complex = dice.chance(0.4) ? test::random_patches<Real>(dice, h, dice.in(2, 60))
                                    : test::random_shapes<Real>(dice, h);
    test::ChangingOptions<Real> options;
    options.edge_length = static_cast<Real>(h);
    options.max_sub_steps = 60;
    options.topology.rule = Topology::change;
    options.topology.opening = dice.one_of(opening_names);
    options.topology.contact = static_cast<Real>(dice.in(0.8, 8.0) * h);
    if (dice.chance(0.3)) {
        options.topology.pairs.push_back({.one = 1,
                                          .other = dice.chance(0.5) ? exterior_phase : 2U,
                                          .rule = dice.one_of(topology_names),
                                          .contact = static_cast<Real>(dice.in(0.1, 3.0) * h)});
    }
    make_allowed(complex, options);
    const auto wildness =
        dice.chance(0.3) ? dice.one_of(test::wildness_names) : test::Wildness::none;
    const test::RandomFlow flow(dice, 1, wildness);
    const double dt = h * std::pow(10.0, dice.in(-1.0, 0.5));
    return {std::move(complex), options, flow.velocity<Real>(), static_cast<Real>(dt)};
}

struct Outcome {
    std::uint64_t hash = 0;
    std::size_t events = 0;
};

template <class Real>
Outcome survive(std::uint64_t seed, std::uint32_t threads, Division division) {
    Scene<Real> scene = draw<Real>(seed);
    test::ChangingSimulation<Real> simulation(
        scene.complex, scene.options,
        Parallel{.threads = threads, .division = division, .always_all_threads = true});
    Outcome outcome;
    for (int step = 0; step < 10; ++step) {
        const test::ChangingReport report =
            simulation.step(scene.velocity, static_cast<Real>(step) * scene.dt, scene.dt);
        outcome.events += report.events.size();
        const std::string problem = validate(scene.complex).problem;
        EXPECT_EQ(problem, "") << "seed " << seed << ", step " << step;
        EXPECT_EQ(test::interface_fault(scene.complex, simulation.interface()), "")
            << "seed " << seed << ", step " << step;
        if (testing::Test::HasFailure()) {
            break;
        }
    }
    outcome.hash = mesh_hash(scene.complex);
    return outcome;
}

template <class Real>
std::size_t in_threads(std::uint64_t seed) {
    const auto all = test::all_divisions();
    const Division division = all[seed % all.size()];
    const Outcome one = survive<Real>(seed, 1, division);
    const Outcome three = survive<Real>(seed, 3, division);
    EXPECT_EQ(one.hash, three.hash) << "seed " << seed;
    EXPECT_EQ(one.events, three.events) << "seed " << seed;
    return one.events;
}

TEST(WideFuzz, EveryStepEndsWithAValidComplex) {
    const std::uint64_t first = from_environment("DSC_FUZZ_FIRST", 1);
    const std::uint64_t count = from_environment("DSC_FUZZ_SEEDS", 24);
    std::size_t events = 0;
    for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
        events += seed % 4 == 3 ? in_threads<float>(seed) : in_threads<double>(seed);
    }
    EXPECT_GT(events, count) << "hardly anything happened";
}

// Two junctions that stay two after all have lost triangles between them.
TEST(WideFuzz, JunctionsThatStayTwo) { (void)in_threads<double>(274); }

} // namespace
} // namespace dsc::wide_fuzz_test

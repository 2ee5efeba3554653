// SPDX-License-Identifier: MIT
// The mesh of every scene, strategy, precision and number of threads, bit for bit, against a table
// (mesh_hashes.txt). A change of the code that must not change results has to pass this test; one
// that changes results on purpose replaces the entries, and its commit says why.
//
//   DSC_TESTS=long    runs each scene to its end, not only for its first steps
//   DSC_TESTS=few     only the quickest scenes, without the reference: enough to notice that a
//                      build with other flags, or without optimisation, computes something else
//   DSC_TESTS=record  replaces the hashes in the table by those found, in place of comparing them;
//                      "record long" those of whole runs
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>

namespace dsc::scenes::mesh_hashes_test {
namespace {

constexpr int first_steps = 12;

bool is_long() { return test::are_asked_for("long"); }
bool is_short() { return test::are_asked_for("few"); }

std::string hexadecimal(std::uint64_t value) {
    std::ostringstream text;
    text << std::hex << value;
    return text.str();
}

// The first steps of a whole run, with the whole run's time step.
Parameters shortened(const Scene& scene, RealType real) {
    Parameters parameters = scene.defaults;
    parameters.real = real;
    if (!is_long()) {
        const Setup setup = scene.prepare(parameters);
        parameters.dt = setup.dt;
        parameters.steps =
            setup.half_step && scene.defaults.steps > 0 ? first_steps / 2 : first_steps;
    }
    return parameters;
}

std::string run_hash(const Scene& scene, Strategy strategy, RealType real, std::uint32_t threads) {
    RunOptions options;
    options.strategy = strategy;
    options.submeshing.threads = threads;
    options.submeshing.always_all_threads = true;
    options.measure_shape = false;
    return hexadecimal(run_scene(scene, shortened(scene, real), options).mesh_hash);
}

bool runs(const Scene& scene, Strategy strategy, RealType real) {
    // The reference is written for double, velocities and edges of one length, and takes hours to
    // the end of some scenes.
    const Setup setup = scene.prepare(scene.defaults);
    return strategy != Strategy::reference ||
           (real == RealType::double_precision && !is_long() && !is_short() &&
            !setup.sees_interface() && setup.advected.empty() && scene.defaults.grade == 0);
}

// The hashes of a scene and strategy.
using Row = std::array<std::string, 4>;
using Table = std::map<std::pair<std::string, std::string>, Row>;

std::size_t column_of(RealType real) {
    return (real == RealType::double_precision ? 0U : 2U) + (is_long() ? 1U : 0U);
}

Table read_table(const char* path) {
    Table table;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line); // the heading of the columns
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string scene;
        std::string strategy;
        words >> scene >> strategy;
        for (std::string& hash : table[{scene, strategy}]) {
            words >> hash;
        }
    }
    return table;
}

void record(const char* path, const Table& table) {
    std::ofstream file(path);
    file << "# scene strategy: double, first steps; double, whole; float, first steps; float, "
            "whole; - "
            "is not run\n";
    for (const auto& [key, row] : table) {
        file << key.first << ' ' << key.second;
        for (const std::string& hash : row) {
            file << ' ' << (hash.empty() ? "-" : hash);
        }
        file << '\n';
    }
}

class MeshHashes : public testing::TestWithParam<std::string> {};

TEST_P(MeshHashes, AreThoseOfTheTable) {
    const Scene& scene = find_scene(GetParam());
    const bool are_recorded = test::are_asked_for("record");
    Table table = read_table(DSC_HASHES_FILE);
    for (const StrategyEntry& entry : strategies()) {
        const Strategy strategy = entry.strategy;
        for (const RealType real : {RealType::double_precision, RealType::single_precision}) {
            if (!runs(scene, strategy, real)) {
                continue;
            }
            std::string& hash = table[{scene.name, to_string(strategy)}].at(column_of(real));
            if (are_recorded) {
                hash = run_hash(scene, strategy, real, 1);
                continue;
            }
            SCOPED_TRACE(to_string(strategy) + ", column " + std::to_string(column_of(real)));
            // Short runs use two threads; one thread would prove nothing new there.
            if (is_long() || !is_parallel(strategy)) {
                EXPECT_EQ(run_hash(scene, strategy, real, 1), hash) << "1 thread";
            }
            if (is_parallel(strategy)) {
                EXPECT_EQ(run_hash(scene, strategy, real, 2), hash) << "2 threads";
            }
        }
    }
    if (are_recorded) {
        record(DSC_HASHES_FILE, table);
    }
}

std::vector<std::string> scene_names() {
    if (is_short()) {
        return {"translation", "rotation-rectangle", "vortex-square"};
    }
    std::vector<std::string> names;
    for (const Scene& scene : catalogue()) {
        if (!scene.prepare(scene.defaults).fluid) { // which no other strategy changes
            names.push_back(scene.name);
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeshHashes, testing::ValuesIn(scene_names()), [](const auto& one) {
    std::string name = one.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

} // namespace
} // namespace dsc::scenes::mesh_hashes_test

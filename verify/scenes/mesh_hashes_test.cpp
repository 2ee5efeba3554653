// SPDX-License-Identifier: MIT
// The mesh of every scene, strategy, precision and number of threads, to the bit, against a table
// (mesh_hashes.json). A change that is to change no result is held to it; a change that is to
// change one replaces the entries that it changes, and says why.
//
//   DSC_HASHES=long    runs each scene to its end, not only for its first steps
//   DSC_HASHES=few     only the quickest scenes, without the reference: enough to notice that a
//                      build with other flags, or without optimisation, computes something else
//   DSC_RECORD=FILE    writes the hashes found to FILE, in place of comparing them
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace dsc::scenes::mesh_hashes_test {
namespace {

constexpr int first_steps = 12;

bool is_asked_for(const std::string& extent) {
    const char* asked = std::getenv("DSC_HASHES");
    return asked != nullptr && asked == extent;
}

bool is_long() { return is_asked_for("long"); }
bool is_short() { return is_asked_for("few"); }

std::string hexadecimal(std::uint64_t value) {
    std::ostringstream text;
    text << std::hex << value;
    return text.str();
}

// The first steps as they are in a whole run: with the time step that this would have.
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

std::string name_of(const Scene& scene, Strategy strategy, RealType real) {
    return scene.name + '/' + to_string(strategy) + '/' +
           (real == RealType::double_precision ? "double" : "float") +
           (is_long() ? "/whole" : "/first steps");
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
            !setup.sees_interface() && setup.carried.empty() && scene.defaults.grade == 0);
}

nlohmann::json read_table() {
    std::ifstream file(DSC_HASHES_FILE);
    return nlohmann::json::parse(file);
}

void record(const std::string& name, const std::string& hash) {
    const char* path = std::getenv("DSC_RECORD");
    nlohmann::json table = nlohmann::json::object();
    if (std::ifstream file(path); file) {
        table = nlohmann::json::parse(file);
    }
    table[name] = hash;
    std::ofstream(path) << table.dump(1) << '\n';
}

class MeshHashes : public testing::TestWithParam<std::string> {};

TEST_P(MeshHashes, AreThoseOfTheTable) {
    const Scene& scene = find_scene(GetParam());
    const bool records = std::getenv("DSC_RECORD") != nullptr;
    const nlohmann::json table = records ? nlohmann::json{} : read_table();
    for (const Strategy strategy : all_strategies()) {
        for (const RealType real : {RealType::double_precision, RealType::single_precision}) {
            if (!runs(scene, strategy, real)) {
                continue;
            }
            const std::string name = name_of(scene, strategy, real);
            if (records) {
                record(name, run_hash(scene, strategy, real, 1));
                continue;
            }
            ASSERT_TRUE(table.contains(name)) << name;
            const std::string expected = table[name].get<std::string>();
            // Two threads in the short runs as well: there one of them would prove nothing new.
            if (is_long() || !is_parallel(strategy)) {
                EXPECT_EQ(run_hash(scene, strategy, real, 1), expected) << name << ", 1 thread";
            }
            if (is_parallel(strategy)) {
                EXPECT_EQ(run_hash(scene, strategy, real, 2), expected) << name << ", 2 threads";
            }
        }
    }
}

std::vector<std::string> scene_names() {
    if (is_short()) {
        return {"translation", "rotation-rectangle", "vortex-square"};
    }
    std::vector<std::string> names;
    for (const Scene& scene : catalogue()) {
        names.push_back(scene.name);
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

// SPDX-License-Identifier: MIT
// An interrupted and resumed run ends with the same mesh, counts and figures as one without
// interruption; damaged or foreign checkpoints are refused.
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/json.h"
#include "scenes/run/run.h"
#include "scenes/run/start.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/base/error.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

namespace dsc::scenes::checkpoint_test {
namespace {

namespace fs = std::filesystem;

struct Broken {
    std::string scene;
    Strategy strategy;
    std::vector<std::string> settings;
    int stop_after;
};

void PrintTo(const Broken& run, std::ostream* out) {
    *out << run.scene << ", " << to_string(run.strategy) << ", stopped after " << run.stop_after;
    for (const std::string& setting : run.settings) {
        *out << ", " << setting;
    }
}

class Checkpoints : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("dsc_checkpoints_" + std::to_string(getpid()));
        fs::create_directories(folder);
        path = folder / "run.checkpoint";
    }
    void TearDown() override { fs::remove_all(folder); }

    fs::path folder;
    std::string path;
};

Parameters parameters_of(const Broken& run, const Scene& scene) {
    Parameters parameters = scene.defaults;
    for (const std::string& setting : run.settings) {
        apply_setting(parameters, scene.keys, setting);
    }
    return parameters;
}

RunOptions options_of(const Broken& run) {
    RunOptions options;
    options.strategy = run.strategy;
    options.submeshing.always_all_threads = true;
    options.submeshing.threads = is_parallel(run.strategy) ? 2 : 1;
    options.measure_shape = false;
    options.series_every = 4;
    return options;
}

// The result and its rows, without times.
nlohmann::json figures_of(RunResult result) {
    auto json = nlohmann::json::parse(to_json(result));
    for (const char* time :
         {"cpu_s", "wall_s", "run_s", "first_step_us", "step_us_median", "peak_memory_mb",
          "threads", "threads_used", "machine", "commit", "solve_s", "assembly_s", "dsc_s"}) {
        json.erase(time);
    }
    for (SeriesRow& row : result.series) {
        row.wall_s = 0;
    }
    json["series"] = series_to_csv(result.series);
    json["events_told"] = result.events.size();
    return json;
}

void expect_same_when_broken(const Broken& run, const std::string& path) {
    SCOPED_TRACE(testing::PrintToString(run));
    const Scene scene = find_scene(run.scene);
    const Parameters parameters = parameters_of(run, scene);
    const RunResult whole = run_scene(scene, parameters, options_of(run));

    RunOptions first = options_of(run);
    first.stop_after = run.stop_after;
    first.checkpoint.path = path;
    const RunResult begun = run_scene(scene, parameters, first);
    ASSERT_TRUE(begun.interrupted);
    ASSERT_EQ(begun.steps, run.stop_after);

    const Checkpoint checkpoint = read_checkpoint(path);
    RunOptions second = options_of(run);
    second.submeshing.threads = 1; // on which no bit depends
    second.resume = &checkpoint;
    const RunResult resumed = run_scene(scene, parameters, second);
    EXPECT_FALSE(resumed.interrupted);
    EXPECT_EQ(resumed.mesh_hash, whole.mesh_hash);
    EXPECT_EQ(figures_of(resumed), figures_of(whole));
    EXPECT_NE(begun.mesh_hash, whole.mesh_hash) << "nothing happens after the break";
}

// Coarse runs with as few steps as the test needs.
const std::vector<Broken>& quick_runs() {
    using enum Strategy;
    static const std::vector<Broken> runs{
        {"swirl", sequential, {"h=0.04", "steps=14", "integrator=centred", "seed=7"}, 9},
        {"swirl", cells, {"h=0.02", "steps=40"}, 37},
        {"single-vortex",
         active,
         {"h=0.04", "period=0.8", "integrator=adaptive", "tolerance=1e-7"},
         13},
        {"drop-and-pool", cells, {"h=0.03", "steps=40", "grade=1.3"}, 40},
        {"grow-shrink", blocks, {"h=0.03"}, 5},
        {"curvature-circle", copy, {"h=0.05", "steps=12", "real=float"}, 7},
        {"grains", fixed, {"h=0.04", "grains=30", "steps=20"}, 11},
        {"zalesak", counting, {"h=0.03", "steps=12", "real=float"}, 4},
        {"rising-bubble", cells, {"h=0.08", "dt=0.02", "steps=10"}, 6},
    };
    return runs;
}

TEST_F(Checkpoints, ARunThatIsBrokenOffEndsWithTheSameBits) {
    for (const Broken& run : quick_runs()) {
        expect_same_when_broken(run, path);
    }
}

// --- what is refused -----------------------------------------------------------------------------

const Broken small{"drop-and-pool", Strategy::cells, {"h=0.06", "steps=6", "grade=1.3"}, 0};

void run_small(const Broken& run, const std::string& to, const Checkpoint* from) {
    const Scene scene = find_scene(run.scene);
    RunOptions options = options_of(run);
    options.submeshing.threads = 1;
    options.stop_after = run.stop_after;
    options.checkpoint.path = to;
    options.resume = from;
    (void)run_scene(scene, parameters_of(run, scene), options);
}

// The message with which another run refuses a checkpoint of `small`.
std::string refusal(const Broken& other, const std::string& path) {
    run_small(small, path, nullptr);
    const Checkpoint checkpoint = read_checkpoint(path);
    try {
        run_small(other, "", &checkpoint);
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), path);
        return error.what();
    }
    return "nothing was refused";
}

TEST_F(Checkpoints, AnotherRunIsRefused) {
    Broken other = small;
    other.settings[0] = "h=0.05";
    EXPECT_NE(refusal(other, path).find("another run"), std::string::npos);
    other = small;
    other.strategy = Strategy::blocks;
    EXPECT_NE(refusal(other, path).find("strategy=cells"), std::string::npos);
    other = small;
    other.settings.emplace_back("real=float");
    EXPECT_NE(refusal(other, path).find("real=double"), std::string::npos);
}

// The command line is the same, but a file that it names has changed.
TEST_F(Checkpoints, ARunThatBeganWithAnotherMeshIsRefused) {
    run_small(small, path, nullptr);
    const Checkpoint checkpoint = read_checkpoint(path);
    Scene scene = find_scene(small.scene);
    scene.prepare = [usual = scene.prepare](const Parameters& parameters) {
        scenes::Setup setup = usual(parameters);
        for (Point<double>& p : setup.curves.front().points) { // the drop
            p += Point<double>(1e-9, 0);
        }
        return setup;
    };
    RunOptions options = options_of(small);
    options.submeshing.threads = 1;
    options.resume = &checkpoint;
    try {
        (void)run_scene(scene, parameters_of(small, scene), options);
        FAIL() << "nothing was refused";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("began with another mesh"), std::string::npos)
            << error.what();
    }
}

TEST_F(Checkpoints, TheScalarTypeIsTold) {
    const Scene scene = find_scene("swirl");
    Parameters parameters = scene.defaults;
    parameters.h = 0.1;
    const scenes::Setup setup = scene.prepare(parameters);
    auto in_double = first_complex<double>(setup, parameters);
    auto in_float = first_complex<float>(setup, parameters);
    Simulation<double> one(in_double, scene_options<double>(setup, parameters));
    Simulation<float> other(in_float, scene_options<float>(setup, parameters));
    Archive archive;
    one.archive(archive);
    Archive again(archive.bytes(), "here");
    try {
        other.archive(again);
        FAIL() << "nothing was refused";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "here: the complex is of double, not of float");
    }
}

TEST_F(Checkpoints, WhatIsNoComplexIsRefused) {
    const Scene scene = find_scene("swirl");
    Parameters parameters = scene.defaults;
    parameters.h = 0.1;
    const scenes::Setup setup = scene.prepare(parameters);
    const auto read_after = [&](auto damage) -> std::string {
        auto complex = first_complex<double>(setup, parameters);
        auto other = complex;
        Simulation<double> simulation(complex, scene_options<double>(setup, parameters));
        Simulation<double> reader(other, scene_options<double>(setup, parameters));
        damage(complex);
        Archive archive;
        simulation.archive(archive);
        Archive again(archive.bytes(), "here");
        try {
            reader.archive(again);
        } catch (const FileError& error) {
            return error.what();
        }
        return "read";
    };
    EXPECT_EQ(read_after([](auto&) {}), "read");
    for (const std::string& said :
         {read_after([](auto& complex) { complex.triangles[7].v[1] = 1'000'000; }),
          read_after([](auto& complex) { complex.triangles[7].n[2] = 1'000'000; }),
          read_after([](auto& complex) { complex.vertices[9].x = NAN; }),
          read_after([](auto& complex) { complex.ids.vertices.push_back(3); }),
          read_after([](auto& complex) { complex.ids.lend(1).vertices.push_back(3); })}) {
        EXPECT_TRUE(said.starts_with("here: invalid complex: ")) << said;
    }
}

// Damaged content with a valid checksum is either refused or read, without invalid memory accesses.
// Accepted content is measured, so that all of it is used.
TEST_F(Checkpoints, WhatCannotBeTrueIsRefused) {
    run_small(small, path, nullptr);
    const Checkpoint whole = read_checkpoint(path);
    std::mt19937 lot(7);
    int refused = 0;
    const int trials = 100;
    for (int i = 0; i < trials; ++i) {
        Checkpoint damaged = whole;
        std::string& state = damaged.state;
        if (i % 4 == 0) {
            state.resize(lot() % state.size());
        } else {
            const std::size_t at = lot() % (i % 2 == 0 ? 2000 : state.size());
            state[at] = static_cast<char>(state[at] ^ static_cast<char>(1U << (lot() % 8U)));
        }
        try {
            run_small(small, "", &damaged);
        } catch (const FileError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, trials / 4);
    EXPECT_NO_THROW(run_small(small, "", &whole));
}

} // namespace
} // namespace dsc::scenes::checkpoint_test

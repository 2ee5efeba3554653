// SPDX-License-Identifier: MIT
// The runs that the checks look at, each made once, when it is first requested.
#pragma once

#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace dsc::gate {

/// How finely a scene is run.
enum class Size : std::uint8_t {
    full,   ///< as in the catalogue: the limits on accuracy apply to this
    coarse, ///< for comparisons with the reference, which takes seconds a step at full size
    shared, ///< the first steps in a mesh of which all threads get a share, whether that pays or
            ///< not
};

struct Configuration {
    std::string scene; ///< a name of the catalogue or of a scene file
    Size size = Size::full;
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t threads = 1;
    std::vector<std::string> settings = {}; ///< key=value, as on the command line
    bool measure_shape = true;

    [[nodiscard]] auto key() const {
        return std::tie(scene, size, strategy, threads, settings, measure_shape);
    }
    friend bool operator<(const Configuration& a, const Configuration& b) {
        return a.key() < b.key();
    }
};

/// What `run_scene` takes.
struct Prepared {
    scenes::Scene scene;
    scenes::Parameters parameters;
    scenes::RunOptions options;
};

class Runs {
public:
    Runs() = default;
    /// These scenes come before those of the catalogue of the same name.
    explicit Runs(std::vector<scenes::SceneFile> files) : files_(std::move(files)) {}

    /// Throws what the run throws.
    const scenes::RunResult& get(const Configuration& configuration);
    [[nodiscard]] const std::map<Configuration, scenes::RunResult>& all() const { return runs_; }
    [[nodiscard]] const std::vector<scenes::SceneFile>& files() const { return files_; }
    /// The scene of this name. Throws InputError if there is none.
    [[nodiscard]] scenes::SceneFile find(const std::string& scene) const;
    [[nodiscard]] Prepared prepare(const Configuration& configuration) const;

private:
    std::vector<scenes::SceneFile> files_;
    std::map<Configuration, scenes::RunResult> runs_;
};

} // namespace dsc::gate

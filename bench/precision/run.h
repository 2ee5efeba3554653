// SPDX-License-Identifier: MIT
// One run of a method in a flow at an edge length: error and time as a JSON object.
#pragma once

#include "flows.h"
#include "methods.h"
#include "scenes/scene.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace dsc::bench {

/// A point of a plot: what is to be run.
struct Case {
    const Flow* flow = nullptr;
    const Method* method = nullptr;
    double h = 0;
};

/// The cases of the given flows and methods, in their order; `quick` leaves out the fine edge
/// lengths. A method that does not suit a flow has no case there.
[[nodiscard]] std::vector<Case> cases_of(const std::vector<const Flow*>& flows,
                                         const std::vector<const Method*>& methods, bool quick);

/// "FLOW--METHOD--H.json", of letters, digits, hyphens and points.
[[nodiscard]] std::string file_name(const Case& item);

/// The scene's own parameters with what the case sets. Throws InputError for a setting that the
/// scene does not know.
[[nodiscard]] scenes::Parameters parameters_of(const Case& item);

/// Exact shapes: the same for all methods of a flow, and often more expensive than a run.
class ExactShapes {
public:
    /// The scene of a case with its exact shapes from here. This must outlive the scene.
    [[nodiscard]] scenes::Scene scene_of(const Case& item);

private:
    struct Key {
        const Flow* flow;
        double h;       ///< 0 where all edge lengths share the shape
        long long time; ///< in 1e-9 of the duration: the same moment by other time steps
        auto operator<=>(const Key&) const = default;
    };
    std::map<Key, scenes::ExactShape> shapes_;
};

struct CaseResult {
    nlohmann::ordered_json json; ///< as of dsc_scene, with flow and method
    bool holds = true;           ///< nothing inverted, not given up
    std::uint64_t unreached = 0; ///< vertices that did not arrive, summed over steps
};

/// Runs until the CPU time has been taken three times or for 0.3 s in all, and keeps the shortest.
/// Throws InputError before anything runs; InvariantError where two runs differ.
[[nodiscard]] CaseResult run_case(const Case& item, ExactShapes& shapes);

} // namespace dsc::bench

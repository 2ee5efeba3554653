// SPDX-License-Identifier: MIT
// One run of a method in a flow with an edge length: error and time as a JSON object.
#pragma once

#include "flows.h"
#include "methods.h"
#include "scenes/scene.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace dsc::bench {

/// A run, which is a point of a plot.
struct Case {
    const Flow* flow = nullptr;
    const Method* method = nullptr;
    double h = 0;
};

/// The cases of the given flows and methods, in their order; `quick` leaves out the fine edge
/// lengths. Methods that are not applicable to a flow are left out.
[[nodiscard]] std::vector<Case> cases_of(const std::vector<const Flow*>& flows,
                                         const std::vector<const Method*>& methods, bool quick);

/// "FLOW--METHOD--H.json", of letters, digits, hyphens and points.
[[nodiscard]] std::string file_name(const Case& item);

/// The scene's parameters with the settings of the case. Throws InputError for a setting that the
/// scene does not have.
[[nodiscard]] scenes::Parameters parameters_of(const Case& item);

/// A cache of exact shapes, which are the same for all methods of a flow and often more expensive
/// than a run.
class ExactShapes {
public:
    /// The scene of a case, with exact shapes from the cache, which must outlive the scene.
    [[nodiscard]] scenes::Scene scene_of(const Case& item);

private:
    struct Key {
        const Flow* flow;
        double h;       ///< 0 if the shape is the same for all edge lengths
        long long time; ///< in 1e-9 of the duration: equal for different time steps
        auto operator<=>(const Key&) const = default;
    };
    std::map<Key, scenes::ExactShape> shapes_;
};

struct CaseResult {
    nlohmann::ordered_json json; ///< as of dsc_scene, with flow and method
    bool holds = true;           ///< no triangle inverted, and the run did not give up
    std::uint64_t unreached = 0; ///< vertices that did not arrive, summed over steps
};

/// Repeats the run until it has been timed three times or for 0.3 s in total, and keeps the
/// shortest CPU time. Throws InputError before the first run; InvariantError if two runs differ.
[[nodiscard]] CaseResult run_case(const Case& item, ExactShapes& shapes);

} // namespace dsc::bench

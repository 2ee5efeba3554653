// SPDX-License-Identifier: MIT
#include "table.h"

#include "scene.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>

namespace dsc::hard {

namespace {

using Json = nlohmann::ordered_json;

std::string error_text(const HardResult& result) {
    return result.error ? text(*result.error) : "-";
}

// JSON has no NaN.
Json finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

} // namespace

void print_heading(std::ostream& out) {
    out << std::left << std::setw(36) << "case" << std::right << std::setw(9) << "steps"
        << std::setw(10) << "sub-steps" << std::setw(9) << "inverted" << std::setw(10)
        << "unreached" << std::setw(8) << "held" << std::setw(10) << "uncounted" << std::setw(10)
        << "error" << std::setw(8) << "s"
        << "  what happened\n";
}

void print_row(std::ostream& out, const Row& row) {
    const HardResult& r = row.result;
    out << std::left << std::setw(36) << row.one->name << std::right << std::setw(9) << r.steps
        << std::setw(10) << r.most_sub_steps << std::setw(9) << r.inverted << std::setw(10)
        << r.unreached << std::setw(8) << r.held << std::setw(10) << r.uncounted << std::setw(10)
        << error_text(r) << std::setw(8) << text(row.seconds) << "  ";
    if (r.holds()) {
        out << r.happened;
    } else {
        out << "FAIL";
        for (const auto& failure : r.failures) {
            out << "; " << failure;
        }
    }
    out << std::endl;
}

std::string to_json(const std::vector<Row>& rows) {
    Json cases = Json::array();
    for (const Row& row : rows) {
        const HardResult& r = row.result;
        Json values = Json::object();
        for (const Value& value : r.values) {
            values[value.name] = finite(value.value);
        }
        cases.push_back({{"name", row.one->name},
                         {"asked", r.asked},
                         {"holds", r.holds()},
                         {"failures", r.failures},
                         {"what_happened", r.happened},
                         {"steps", r.steps},
                         {"sub_steps", r.sub_steps},
                         {"most_sub_steps", r.most_sub_steps},
                         {"most_passes", r.most_passes},
                         {"inverted", r.inverted},
                         {"unreached", r.unreached},
                         {"held", r.held},
                         {"missed", r.missed},
                         {"uncounted", r.uncounted},
                         {"overcounted", r.overcounted},
                         {"gave_up", r.gave_up},
                         {"error_message", r.error_message},
                         {"error", finite(r.error)},
                         {"error_is", r.error_is},
                         {"values", values},
                         {"seconds", row.seconds}});
    }
    return cases.dump(1) + "\n";
}

} // namespace dsc::hard

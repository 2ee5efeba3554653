// SPDX-License-Identifier: MIT
#include "report.h"

#include "dsc/io/part_file.h"
#include "scenes/output/machine.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>

namespace dsc::gate {

namespace {

using OrderedJson = nlohmann::ordered_json;
using scenes::Histogram;

constexpr int check_width = 36;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string measured_text(const Row& row) { return row.measured ? number(*row.measured) : "-"; }

std::string limit_text(const Row& row) {
    return (row.check->at_least ? ">= " : "<= ") + number(row.limit);
}

// JSON has no NaN.
OrderedJson finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? OrderedJson(*value) : OrderedJson(nullptr);
}

// For XML: no control characters, which are not legal even when escaped.
std::string xml(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 32) {
            c = ' ';
        }
    }
    return escape_xml(text);
}

std::string where_text(const Place& place) {
    return place.at ? place.what + ", at (" + number(place.at->x()) + ", " + number(place.at->y()) +
                          "), time " + number(place.time)
                    : place.what;
}

// A line for each thing that is known.
std::string failure_lines(const Row& row, const Limits& limits) {
    std::string text = "  measured  " + measured_text(row) + ' ' + row.check->unit + " (" +
                       row.check->description + ")\n  limit     " + limit_text(row) + ": " +
                       limits.find(row.check->name, row.scene).note + '\n';
    const auto line = [&](const char* name, const std::string& value) {
        text += value.empty() ? "" : std::string("  ") + name + value + '\n';
    };
    line("failure   ", row.failure);
    line("where     ", where_text(row.place));
    line("picture   ", row.place.picture);
    line("edits     ", row.place.edits);
    line("again     ", row.place.command);
    return text;
}

OrderedJson place_json(const Place& place) {
    OrderedJson json = OrderedJson::object();
    if (place.at) {
        json["at"] = {place.at->x(), place.at->y()};
        json["time"] = place.time;
    }
    for (const auto& [name, value] : {std::pair{"what", place.what},
                                      {"picture", place.picture},
                                      {"edits", place.edits},
                                      {"command", place.command}}) {
        if (!value.empty()) {
            json[name] = value;
        }
    }
    return json;
}

} // namespace

void print_heading(std::ostream& out) {
    out << std::left << std::setw(check_width) << "check" << std::setw(22) << "scene" << std::right
        << std::setw(12) << "measured" << std::setw(14) << "limit"
        << "  verdict\n";
}

void print_row(std::ostream& out, const Row& row) {
    out << std::left << std::setw(check_width) << row.check->name << std::setw(22) << row.scene
        << std::right << std::setw(12) << measured_text(row) << std::setw(14) << limit_text(row)
        << "  " << (row.pass ? "pass" : "FAIL");
    if (!row.failure.empty()) {
        out << ": " << row.failure;
    }
    out << std::endl;
}

void print_failure(std::ostream& out, const Row& row, const Limits& limits) {
    out << '\n' << row.check->name << " of " << row.scene << '\n' << failure_lines(row, limits);
}

void print_bands(std::ostream& out, const std::vector<Band>& bands) {
    const auto columns = [&](const std::string& check, const std::string& median,
                             const std::string& spread, const std::string& limit,
                             const std::string& ratio) {
        out << std::left << std::setw(check_width) << check << std::right << std::setw(12) << median
            << std::setw(12) << spread << std::setw(14) << limit << std::setw(10) << ratio << '\n';
    };
    columns("check", "median", "spread", "limit", "ratio");
    for (const Band& band : bands) {
        columns(band.check, number(band.median), number(band.spread()),
                (band.at_least ? ">= " : "<= ") + number(band.limit),
                std::isfinite(band.ratio()) ? number(band.ratio()) : "-");
    }
}

std::string to_json(const std::vector<Row>& rows, const Limits& limits, const Runs& runs) {
    OrderedJson checks = OrderedJson::array();
    for (const Row& row : rows) {
        OrderedJson entry{{"check", row.check->name},
                          {"description", row.check->description},
                          {"scene", row.scene},
                          {"measured", finite(row.measured)},
                          {"limit", row.limit},
                          {"unit", row.check->unit},
                          {"sense", row.check->at_least ? ">=" : "<="},
                          {"verdict", row.pass ? "pass" : "fail"},
                          {"note", limits.find(row.check->name, row.scene).note}};
        if (!row.failure.empty()) {
            entry["failure"] = row.failure;
        }
        if (!row.pass) {
            entry["place"] = place_json(row.place);
        }
        checks.push_back(std::move(entry));
    }
    OrderedJson not_run = OrderedJson::array();
    for (const Check& check : all_checks()) {
        if (!runs.files().empty()) {
            break; // of scene files, what has a limit is run
        }
        if (std::ranges::none_of(rows, [&](const Row& row) { return row.check == &check; })) {
            not_run.push_back({{"check", check.name},
                               {"description", check.description},
                               {"scenes", check.scenes}});
        }
    }
    // Two runs of one scene are comparable only over the same bins, so each size is a scene.
    OrderedJson histograms = OrderedJson::array();
    for (const auto& [configuration, run] : runs.all()) {
        if (configuration.size == Size::shared) {
            continue; // of the first steps alone, to the same bits by all threads
        }
        const bool is_coarse = configuration.size == Size::coarse;
        const std::pair<const char*, const Histogram*> quantities[]{
            {"area", &run.area_histogram}, {"quality", &run.quality_histogram}};
        for (const auto& [quantity, histogram] : quantities) {
            histograms.push_back({{"scene", run.scene + (is_coarse ? " (coarse)" : "")},
                                  {"strategy", scenes::to_string(run.strategy)},
                                  {"quantity", quantity},
                                  {"edges", histogram->edges},
                                  {"counts", histogram->counts}});
        }
    }
    const OrderedJson json{{"machine", scenes::machine()}, {"commit", scenes::commit()},
                           {"limits", limits.path()},      {"checks", checks},
                           {"not_run", not_run},           {"histograms", histograms}};
    return json.dump(1) + "\n";
}

std::string to_junit(const std::vector<Row>& rows, const Limits& limits) {
    const auto failures =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    double seconds = 0;
    for (const Row& row : rows) {
        seconds += row.seconds;
    }
    const std::string counts = "tests=\"" + std::to_string(rows.size()) + "\" failures=\"" +
                               std::to_string(failures) + "\" time=\"" + number(seconds) + "\"";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                       ">\n<testsuite name=\"dsc_verify\" " + counts + ">\n";
    for (const Row& row : rows) {
        text += "<testcase classname=\"" + xml(row.check->name) + "\" name=\"" + xml(row.scene) +
                "\" time=\"" + number(row.seconds) + "\"";
        if (row.pass) {
            text += "/>\n";
            continue;
        }
        const std::string message =
            row.failure.empty() ? "measured " + measured_text(row) + ", limit " + limit_text(row)
                                : row.failure;
        text += "><failure message=\"" + xml(message) + "\">" +
                escape_xml(failure_lines(row, limits)) + "</failure></testcase>\n";
    }
    return text + "</testsuite>\n</testsuites>\n";
}

} // namespace dsc::gate

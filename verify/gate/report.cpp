// SPDX-License-Identifier: MIT
#include "report.h"

#include "dsc/io/part_file.h"
#include "scenes/output/machine.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace dsc::gate {

namespace {

using OrderedJson = nlohmann::ordered_json;
using scenes::Histogram;

void print_columns(std::ostream& out, const std::string& check, const std::string& scene,
                   std::initializer_list<std::string> numbers) {
    out << std::left << std::setw(36) << check << std::setw(22) << scene << std::right;
    for (const std::string& number : numbers) {
        out << std::setw(13) << number;
    }
}

std::string measured_text(const Row& row) { return row.measured ? few_digits(*row.measured) : "-"; }

std::string limit_text(const Check& check, const Limit& limit) {
    return (check.at_least ? ">= " : "<= ") + few_digits(limit.value);
}
std::string limit_text(const Row& row) { return limit_text(*row.check, row.limit); }

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
    return place.at ? place.what + ", at (" + few_digits(place.at->x()) + ", " +
                          few_digits(place.at->y()) + "), time " + few_digits(place.time)
                    : place.what;
}

// A line for each known fact of the failure.
std::string failure_lines(const Row& row) {
    std::string text = "  measured  " + measured_text(row) +
                       (row.check->unit == "1" ? "" : ' ' + row.check->unit) + " (" +
                       row.check->description + ")\n  limit     " + limit_text(row) + ": " +
                       row.limit.reason() + '\n';
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
    print_columns(out, "check", "scene", {"measured", "limit"});
    out << "  verdict\n";
}

void print_row(std::ostream& out, const Row& row) {
    print_columns(out, row.check->name, row.of->name, {measured_text(row), limit_text(row)});
    out << (row.pass ? "  pass" : "  FAIL");
    if (!row.failure.empty()) {
        out << ": " << row.failure;
    }
    out << std::endl;
}

void print_failure(std::ostream& out, const Row& row) {
    out << '\n' << row.check->name << " of " << row.of->name << '\n' << failure_lines(row);
}

void print_bands(std::ostream& out, const std::vector<Band>& bands) {
    print_columns(out, "check", "scene", {"median", "spread", "limit", "ratio"});
    for (const Band& band : bands) {
        out << '\n';
        print_columns(out, band.check->name, band.of->name,
                      {few_digits(band.median), few_digits(band.max - band.min),
                       limit_text(*band.check, band.limit),
                       band.median == 0 ? "-" : few_digits(band.limit.value / band.median)});
    }
    out << '\n';
}

std::string to_json(const std::vector<Row>& rows, const std::vector<std::string>& suites,
                    const Cases& cases, const Runs& runs) {
    OrderedJson checks = OrderedJson::array();
    for (const Row& row : rows) {
        OrderedJson entry{{"check", row.check->name},
                          {"description", row.check->description},
                          {"group", row.check->group},
                          {"scene", row.of->name},
                          {"measured", finite(row.measured)},
                          {"limit", row.limit.value},
                          {"unit", row.check->unit},
                          {"sense", row.check->at_least ? ">=" : "<="},
                          {"verdict", row.pass ? "pass" : "fail"},
                          {"note", row.limit.reason()}};
        if (row.run) {
            entry["strategy"] = scenes::to_string(row.run->strategy);
        }
        if (!row.failure.empty()) {
            entry["failure"] = row.failure;
        }
        if (!row.pass) {
            entry["place"] = place_json(row.place);
        }
        checks.push_back(std::move(entry));
    }
    OrderedJson not_run = OrderedJson::array();
    for (const auto& check : all_checks()) {
        OrderedJson names = OrderedJson::array();
        for (const auto& c : cases) {
            if (std::ranges::find(c->held, check, &Held::check) != c->held.end()) {
                names.push_back(c->name);
            }
        }
        if (!names.empty() &&
            std::ranges::none_of(rows, [&](const Row& row) { return row.check == check.get(); })) {
            not_run.push_back(
                {{"check", check->name}, {"description", check->description}, {"scenes", names}});
        }
    }
    // Histograms are comparable only with the same bins, so each edge length counts as a scene of
    // its own.
    OrderedJson histograms = OrderedJson::array();
    for (const auto& [key, outcome] : runs.all()) {
        const Configuration& run = outcome.configuration;
        const bool is_other_start = run.of->starts > 1 && run.parameters.h != run.of->parameters.h;
        if (run.is_shared || is_other_start || outcome.error || run.of->space) {
            continue; // shared runs make only the first steps, with the same result by all threads
        }
        const bool is_other_size = run.parameters.h != run.of->file.scene.defaults.h;
        const std::pair<const char*, const Histogram*> quantities[]{
            {"area", &outcome.result.area_histogram},
            {"quality", &outcome.result.quality_histogram}};
        for (const auto& [quantity, histogram] : quantities) {
            histograms.push_back(
                {{"scene",
                  run.of->name +
                      (is_other_size ? " (h = " + few_digits(run.parameters.h) + ")" : "")},
                 {"strategy", scenes::to_string(run.strategy)},
                 {"quantity", quantity},
                 {"edges", histogram->edges},
                 {"counts", histogram->counts}});
        }
    }
    const OrderedJson json{{"machine", scenes::machine()},
                           {"compiler", scenes::compiler()},
                           {"commit", scenes::commit()},
                           {"suites", suites},
                           {"checks", checks},
                           {"not_run", not_run},
                           {"histograms", histograms}};
    return json.dump(1) + "\n";
}

std::string to_junit(const std::vector<Row>& rows) {
    const auto failures =
        std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.pass; });
    double seconds = 0;
    for (const Row& row : rows) {
        seconds += row.seconds;
    }
    const std::string counts = "tests=\"" + std::to_string(rows.size()) + "\" failures=\"" +
                               std::to_string(failures) + "\" time=\"" + few_digits(seconds) + "\"";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                       ">\n<testsuite name=\"dsc_verify\" " + counts + ">\n";
    for (const Row& row : rows) {
        text += "<testcase classname=\"" + xml(row.check->name) + "\" name=\"" + xml(row.of->name) +
                "\" time=\"" + few_digits(row.seconds) + "\"";
        if (row.pass) {
            text += "/>\n";
            continue;
        }
        const std::string message =
            row.failure.empty() ? "measured " + measured_text(row) + ", limit " + limit_text(row)
                                : row.failure;
        text += "><failure message=\"" + xml(message) + "\">" + escape_xml(failure_lines(row)) +
                "</failure></testcase>\n";
    }
    return text + "</testsuite>\n</testsuites>\n";
}

} // namespace dsc::gate

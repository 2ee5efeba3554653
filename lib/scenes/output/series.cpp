// SPDX-License-Identifier: MIT
#include "scenes/output/series.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace dsc::scenes {

namespace {

std::string cell(double value) { return std::isfinite(value) ? to_text(value) : std::string(); }

std::string cell(std::uint64_t value) { return std::to_string(value); }

// The names of all operations in the rows: the row before the first step has none.
std::set<std::string> operations_in(const std::vector<SeriesRow>& rows) {
    std::set<std::string> names;
    for (const SeriesRow& row : rows) {
        for (const auto& [name, count] : row.operations) {
            names.insert(name);
        }
    }
    return names;
}

// The columns of a row, in order.
template <class Put>
void for_each_column(const SeriesRow& row, const std::set<std::string>& operations, Put put) {
    put("step", cell(static_cast<std::uint64_t>(row.step)));
    put("time", cell(row.time));
    put("triangles", cell(row.triangles));
    put("interface_vertices", cell(row.interface_vertices));
    put("phases", cell(row.phases));
    put("interface_length", cell(row.interface_length));
    for (const Figure& figure : row.figures) {
        put(figure.name, cell(number(row.figures, figure.name)));
    }
    for (const std::string& name : operations) {
        const auto found = row.operations.find(name);
        put(name, cell(found != row.operations.end() ? found->second : std::uint64_t{0}));
    }
    put("events", cell(row.events));
    put("unreached", cell(row.unreached));
    put("wall_us", cell(row.wall_s * 1e6));
}

} // namespace

std::vector<Measure> series_measures() {
    static const std::set<std::string> names{"area",   "area_exact",  "sd",
                                             "sd_rel", "min_quality", "min_angle_deg"};
    std::vector<Measure> measures;
    std::ranges::copy_if(default_measures(), std::back_inserter(measures),
                         [](const Measure& one) { return names.contains(one.name); });
    return measures;
}

std::string series_to_csv(const std::vector<SeriesRow>& rows) {
    const std::set<std::string> operations = operations_in(rows);
    std::string header;
    std::string lines;
    for (const SeriesRow& row : rows) {
        std::string names;
        std::string values;
        for_each_column(row, operations, [&](const std::string& name, const std::string& value) {
            names += (names.empty() ? "" : ",") + name;
            values += (values.empty() ? "" : ",") + value;
        });
        header = names + '\n';
        lines += values + '\n';
    }
    return header + lines;
}

} // namespace dsc::scenes

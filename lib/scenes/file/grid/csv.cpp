// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/grid/grid_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace dsc::scenes {

namespace {

/// Of the steps of a grid, and relative to them: coordinates are written with few digits.
constexpr double unequal_steps = 1e-3;

struct GridRow {
    double t = 0;
    double x = 0;
    double y = 0;
    Point<double> velocity{0, 0};
};

class GridCsvReader {
public:
    GridCsvReader(std::string_view text, const std::string& where) : text_(text), where_(where) {}

    GridValues read() {
        read_rows();
        GridValues grid;
        grid.times = different(&GridRow::t);
        const std::vector<double> xs = different(&GridRow::x);
        const std::vector<double> ys = different(&GridRow::y);
        check_steps(xs, "x");
        check_steps(ys, "y");
        grid.box = {{xs.front(), ys.front()}, {xs.back(), ys.back()}};
        grid.columns = xs.size();
        grid.rows = ys.size();
        // Each of the three is at most the number of rows; compared by division against overflow.
        const std::size_t layer = xs.size() * ys.size();
        if (rows_.size() % layer != 0 || rows_.size() / layer != grid.times.size()) {
            refuse("points missing, or there twice", std::to_string(rows_.size()) + " points",
                   std::to_string(grid.times.size()) + " times " + std::to_string(ys.size()) +
                       " times " + std::to_string(xs.size()));
        }
        std::vector<std::uint8_t> is_there(rows_.size(), 0);
        grid.velocities.resize(rows_.size());
        for (const GridRow& row : rows_) {
            const std::size_t at =
                (place(grid.times, row.t) * grid.rows + place(ys, row.y)) * grid.columns +
                place(xs, row.x);
            if (is_there[at] != 0) {
                refuse("a point that is there twice",
                       std::to_string(row.x) + "," + std::to_string(row.y), "each point once");
            }
            is_there[at] = 1;
            grid.velocities[at] = row.velocity;
        }
        return grid;
    }

private:
    [[noreturn]] void refuse(const std::string& what, std::string_view value,
                             const std::string& allowed) const {
        throw InputError({.what = what,
                          .where = line_ > 0 ? where_ + ':' + std::to_string(line_) : where_,
                          .value = quoted_excerpt(value),
                          .allowed = allowed});
    }

    static std::size_t place(const std::vector<double>& sorted, double value) {
        return static_cast<std::size_t>(std::ranges::lower_bound(sorted, value) - sorted.begin());
    }

    void read_rows() {
        std::string_view rest = text_;
        while (!rest.empty()) {
            ++line_;
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view line = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            const std::string_view data = line.substr(0, line.find('#'));
            if (data.find_first_not_of(" \t\r") != std::string_view::npos) {
                read_row(data);
            }
        }
        line_ = 0;
        if (rows_.size() < 4) {
            refuse("grid too small", std::to_string(rows_.size()) + " points",
                   "2 points each way, or more");
        }
    }

    void read_row(std::string_view line) {
        std::vector<double> numbers;
        const char* at = line.data();
        const char* end = at + line.size();
        while (at != end && numbers.size() < 6) {
            if (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r') {
                ++at;
                continue;
            }
            double value = 0;
            const auto [stop, error] = std::from_chars(at, end, value);
            if (error != std::errc{} || !std::isfinite(value)) {
                break;
            }
            at = stop;
            numbers.push_back(value);
        }
        if (at == line.data() + line.find_first_not_of(" \t") && rows_.empty()) {
            return; // names of the columns
        }
        if (at != end || (numbers.size() != 4 && numbers.size() != 5) ||
            (!rows_.empty() && numbers.size() != columns_)) {
            refuse("not a point of the field", line, "x,y,u,v or t,x,y,u,v on every line");
        }
        columns_ = numbers.size();
        const std::size_t first = numbers.size() - 4;
        rows_.push_back({first == 1 ? numbers[0] : 0,
                         numbers[first],
                         numbers[first + 1],
                         {numbers[first + 2], numbers[first + 3]}});
    }

    [[nodiscard]] std::vector<double> different(double GridRow::*coordinate) const {
        std::vector<double> values;
        values.reserve(rows_.size());
        for (const GridRow& row : rows_) {
            values.push_back(row.*coordinate);
        }
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
        return values;
    }

    void check_steps(const std::vector<double>& values, const std::string& name) const {
        const double step =
            (values.back() - values.front()) / static_cast<double>(values.size() - 1);
        for (std::size_t i = 1; i < values.size(); ++i) {
            if (!(std::abs(values[i] - values[i - 1] - step) <= unequal_steps * step)) {
                refuse("unequal steps in " + name, std::to_string(values[i]), "a regular grid");
            }
        }
    }

    std::string_view text_;
    const std::string& where_;
    int line_ = 0;
    std::size_t columns_ = 0;
    std::vector<GridRow> rows_;
};

} // namespace

GridValues read_grid_csv(std::string_view text, const std::string& where) {
    return GridCsvReader(text, where).read();
}

} // namespace dsc::scenes

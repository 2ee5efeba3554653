// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace dsc::scenes {

namespace {

// By the number of edges on the right of the point.
bool holds(const std::vector<Point<double>>& polygon, const Point<double>& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point<double>& a = polygon[i];
        const Point<double>& b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > p.y()) != (b.y() > p.y())) {
            inside ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        }
    }
    return inside;
}

// Reads one coordinate from the front of the line, and what may stand behind it.
bool take_coordinate(std::string_view& line, double& value) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t' || line.front() == ',')) {
        line.remove_prefix(1);
    }
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc{} || !(std::abs(value) <= largest_coordinate)) {
        return false;
    }
    line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
    return true;
}

} // namespace

Piece piece_of(std::vector<Point<double>> points, bool close) {
    const bool comes_back = points.size() > 2 && points.front() == points.back();
    if (comes_back) {
        points.pop_back();
    }
    return {std::move(points), close || comes_back};
}

std::vector<int> nesting(const std::vector<Piece>& pieces) {
    std::vector<int> depths(pieces.size(), 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = 0; j < pieces.size(); ++j) {
            if (i != j && !pieces[i].points.empty()) {
                depths[i] ^= holds(pieces[j].points, pieces[i].points.front()) ? 1 : 0;
            }
        }
    }
    return depths;
}

std::vector<Piece> read_points(std::string_view text, bool close, const std::string& where) {
    std::vector<Piece> pieces;
    std::vector<Point<double>> points;
    const auto end_piece = [&] {
        if (!points.empty()) {
            pieces.push_back(piece_of(std::exchange(points, {}), close));
        }
    };
    std::size_t count = 0;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view whole = line;
        const bool is_comment = line.starts_with('#');
        line = line.substr(0, std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
            if (!is_comment) {
                end_piece();
            }
            continue;
        }
        double x = 0;
        double y = 0;
        if (!take_coordinate(line, x) || !take_coordinate(line, y) ||
            line.find_first_not_of(" \t\r,") != std::string_view::npos || ++count > most_points) {
            throw InputError({.what = count > most_points ? "too many points" : "not a point",
                              .where = where + ':' + std::to_string(number),
                              .value = quoted_excerpt(whole),
                              .allowed = "two numbers x y, at most 1000000 lines of them"});
        }
        points.emplace_back(x, y);
    }
    end_piece();
    return pieces;
}

} // namespace dsc::scenes

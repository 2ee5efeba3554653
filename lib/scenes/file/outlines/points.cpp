// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace dsc::scenes {

namespace {

// Whether the polygon contains the point, by the number of edges to the right of it.
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

std::vector<Piece> read_points(const std::string& text, bool close, const std::string& where) {
    std::vector<Piece> pieces;
    std::vector<Point<double>> points;
    const auto end_piece = [&] {
        if (!points.empty()) {
            pieces.push_back(piece_of(std::exchange(points, {}), close));
        }
    };
    std::size_t count = 0;
    double height = 0; // of the piece's first point
    std::istringstream lines(text);
    std::string whole;
    for (int number = 1; std::getline(lines, whole); ++number) {
        std::string line = whole.substr(0, whole.find('#'));
        std::ranges::replace(line, ',', ' ');
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            if (!whole.starts_with('#')) {
                end_piece();
            }
            continue;
        }
        std::istringstream words(line);
        Point<double> p;
        double z = 0;
        std::string rest;
        const bool is_point = words >> p.x() >> p.y() && ((words >> std::ws).eof() || words >> z) &&
                              !(words >> rest) && p.cwiseAbs().maxCoeff() <= largest_coordinate;
        if (is_point && points.empty()) {
            height = z;
        }
        if (!is_point || z != height || ++count > max_points) {
            throw InputError({.what = !is_point     ? "not a point"
                                      : z != height ? "points at several heights"
                                                    : "too many points",
                              .where = where + ':' + std::to_string(number),
                              .value = quoted_excerpt(whole),
                              .allowed = "two numbers x y, or three with one z for all points of a "
                                         "piece, or a comment after #; at most 1000000 lines"});
        }
        points.push_back(p);
    }
    end_piece();
    if (pieces.empty()) {
        throw InputError({.what = "no points",
                          .where = where,
                          .value = quoted_excerpt(text),
                          .allowed = "lines of two numbers x y, or three"});
    }
    return pieces;
}

} // namespace dsc::scenes

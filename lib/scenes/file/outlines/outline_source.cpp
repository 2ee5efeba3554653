// SPDX-License-Identifier: MIT
#include "scenes/file/outlines/outline_source.h"

#include "dsc/base/error.h"
#include "scenes/file/text_file.h"
#include "shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

/// Largest number of edges of an outline: far more than fit into a mesh.
constexpr double max_edges_of_shape = 1e6;

const std::vector<std::string> source_kinds{"points", "file", "circle", "ellipse", "rectangle"};

OutlineSource always(std::vector<Piece> pieces) {
    return {[pieces = std::move(pieces)](double) { return pieces; }};
}

OutlineSource read_outline_file(const TableReader& reader, bool close) {
    const std::filesystem::path path = reader.file().parent_path() / reader.text("file");
    return always(read_points(read_text_file(path), close, path.string()));
}

// With equal steps of the parameter, no edge is longer than in a circle with the larger radius.
OutlineSource ellipse(const TableReader& reader, const Point<double>& radii, double angle) {
    const Point<double> centre = reader.point("centre");
    const Point<double> axis(std::cos(angle), std::sin(angle));
    const auto at = [=](double turn) {
        const double u = radii.x() * std::cos(turn);
        const double v = radii.y() * std::sin(turn);
        return Point<double>(centre.x() + u * axis.x() - v * axis.y(),
                             centre.y() + u * axis.y() + v * axis.x());
    };
    const double length = 2 * pi * radii.maxCoeff();
    const auto pieces = [=, where = reader.where()](double h) {
        require(length / h <= max_edges_of_shape, where + ": edge length", h,
                "at most 1000000 edges of the shape");
        const int count = std::max(fewest_of_disc, static_cast<int>(std::ceil(length / h)));
        std::vector<Point<double>> points;
        for (int i = 0; i < count; ++i) {
            points.push_back(at(2 * pi * i / count));
        }
        return std::vector<Piece>{{std::move(points), true}};
    };
    return {pieces, ParametricCurve{
                        [=](double s) { return at(2 * pi * s); }, {}, pi * radii.x() * radii.y()}};
}

OutlineSource read_circle(const TableReader& reader) {
    reader.allow({"centre", "radius"});
    const double radius = reader.number("radius", positive_length);
    return ellipse(reader, {radius, radius}, 0);
}

OutlineSource read_ellipse(const TableReader& reader) {
    reader.allow({"centre", "radii", "angle"});
    const Point<double> radii = reader.point("radii");
    if (!(radii.minCoeff() >= positive_length.low)) {
        reader.refuse("radii", "bad value", "two lengths above 0");
    }
    return ellipse(reader, radii, reader.number_or(0, "angle", {-360, 360}) * pi / 180);
}

OutlineSource read_rectangle(const TableReader& reader) {
    reader.allow({"low", "high"});
    const Point<double> low = reader.point("low");
    const Point<double> high = reader.point("high");
    if (!(high.x() > low.x() && high.y() > low.y())) {
        reader.refuse("high", "bad value", "above and to the right of low");
    }
    return always({{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, true}});
}

OutlineSource read_source(const TableReader& reader, bool close) {
    const std::string kind = reader.one_of(source_kinds);
    if (kind == "points") {
        return always({piece_of(reader.points("points"), close)});
    }
    if (kind == "file") {
        return read_outline_file(reader, close);
    }
    const TableReader table = reader.table(kind);
    return kind == "circle"    ? read_circle(table)
           : kind == "ellipse" ? read_ellipse(table)
                               : read_rectangle(table);
}

} // namespace

std::vector<std::string> source_keys() {
    std::vector<std::string> keys = source_kinds;
    keys.insert(keys.end(), {"scale", "move"});
    return keys;
}

OutlineSource read_outline_source(const TableReader& reader, bool close) {
    OutlineSource source = read_source(reader, close);
    const Point<double> scale = reader.point_or({1, 1}, "scale");
    const Point<double> move = reader.point_or({0, 0}, "move");
    if (!(scale.cwiseAbs().minCoeff() > 1e-9)) {
        reader.refuse("scale", "bad value", "two numbers other than 0");
    }
    if (scale != Point<double>(1, 1) || move != Point<double>(0, 0)) {
        source.curve.reset();
        source.pieces = [pieces = std::move(source.pieces), scale, move](double h) {
            std::vector<Piece> moved = pieces(h);
            for (Piece& piece : moved) {
                for (Point<double>& point : piece.points) {
                    point = point.cwiseProduct(scale) + move;
                }
            }
            return moved;
        };
    }
    return source;
}

} // namespace dsc::scenes

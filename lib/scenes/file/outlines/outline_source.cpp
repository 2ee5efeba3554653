// SPDX-License-Identifier: MIT
#include "scenes/file/outlines/outline_source.h"

#include "dsc/base/error.h"
#include "scenes/file/outlines/named_shapes.h"
#include "scenes/file/text_file.h"

#include <algorithm>

namespace dsc::scenes {

namespace {

std::vector<Piece> read_outline_file(const TableReader& reader, bool close) {
    const std::string name = reader.text("file");
    const std::filesystem::path path = reader.file().parent_path() / name;
    const std::string extension = path.extension().string();
    const bool is_json = extension == ".geojson" || extension == ".json";
    if (!is_json && extension != ".txt" && extension != ".csv" && extension != ".dat") {
        reader.refuse("file", "unknown kind of file",
                      "a name that ends in .txt, .csv, .dat, "
                      ".geojson or .json");
    }
    const std::string text = read_text_file(path);
    return is_json ? read_geojson(text, path.string()) : read_points(text, close, path.string());
}

} // namespace

std::vector<std::string> source_keys() {
    std::vector<std::string> keys{"points", "file"};
    std::ranges::copy(shape_names(), std::back_inserter(keys));
    return keys;
}

OutlineSource read_outline_source(const TableReader& reader, bool close) {
    const std::string key = reader.one_of(source_keys());
    const Point<double> scale = reader.point_or({1, 1}, "scale");
    const Point<double> move = reader.point_or({0, 0}, "move");
    if (!(scale.cwiseAbs().minCoeff() > 1e-9)) {
        reader.refuse("scale", "bad value", "two numbers other than 0");
    }
    OutlineSource source;
    if (key == "points" || key == "file") {
        source.pieces =
            [pieces = key == "file" ? read_outline_file(reader, close)
                                    : std::vector<Piece>{piece_of(reader.points("points"), close)}](
                double) { return pieces; };
    } else {
        NamedShape shape = read_named_shape(reader, key);
        source.pieces = [outline = std::move(shape.outline)](double h) {
            return std::vector<Piece>{{outline(h), true}};
        };
        source.curve = std::move(shape.curve);
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

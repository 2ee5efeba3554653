// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace dsc::scenes {

namespace {

using GeoJson = nlohmann::json;

/// Collections within collections.
constexpr int deepest_collection = 8;

/// The array that this is; throws an exception of the JSON library for anything else.
const GeoJson::array_t& array_in(const GeoJson& json) {
    return json.get_ref<const GeoJson::array_t&>();
}

class GeoJsonReader {
public:
    explicit GeoJsonReader(const std::string& where) : where_(where) {}

    void read(const GeoJson& object, int depth = 0) {
        const std::string type = object.at("type").get<std::string>();
        if (depth > deepest_collection) {
            refuse("collections too deep", type, "at most 8 levels");
        }
        if (type == "FeatureCollection") {
            for (const GeoJson& feature : array_in(object.at("features"))) {
                read(feature, depth + 1);
            }
        } else if (type == "Feature") {
            read(object.at("geometry"), depth + 1);
        } else if (type == "GeometryCollection") {
            for (const GeoJson& geometry : array_in(object.at("geometries"))) {
                read(geometry, depth + 1);
            }
        } else if (type == "MultiPolygon") {
            for (const GeoJson& polygon : array_in(object.at("coordinates"))) {
                add_lines(polygon, true);
            }
        } else if (type == "Polygon" || type == "MultiLineString") {
            add_lines(object.at("coordinates"), type == "Polygon");
        } else if (type == "LineString") {
            add_line(object.at("coordinates"), false);
        } else {
            refuse("unknown type of geometry", type,
                   "Polygon, MultiPolygon, LineString, MultiLineString, GeometryCollection, "
                   "Feature, FeatureCollection");
        }
    }

    std::vector<Piece> pieces;

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& value,
                             const std::string& allowed) const {
        throw InputError(
            {.what = what, .where = where_, .value = quoted_excerpt(value), .allowed = allowed});
    }

    void add_lines(const GeoJson& lines, bool is_polygon) {
        for (const GeoJson& line : array_in(lines)) {
            add_line(line, is_polygon);
        }
    }

    void add_line(const GeoJson& positions, bool is_closed) {
        std::vector<Point<double>> points;
        for (const GeoJson& position : array_in(positions)) {
            const Point<double> p(position.at(0).get<double>(), position.at(1).get<double>());
            if (!(p.cwiseAbs().maxCoeff() <= largest_coordinate) || ++count_ > most_points) {
                refuse("bad position", position.dump(),
                       "[x, y] from -1e6 to 1e6, at most 1000000 of them");
            }
            points.push_back(p);
        }
        pieces.push_back(piece_of(std::move(points), is_closed));
    }

    const std::string& where_;
    std::size_t count_ = 0;
};

} // namespace

std::vector<Piece> read_geojson(const std::string& text, const std::string& where) {
    GeoJsonReader reader(where);
    try {
        reader.read(GeoJson::parse(text));
    } catch (const GeoJson::exception& error) {
        throw InputError({.what = "no GeoJSON",
                          .where = where,
                          .value = excerpt(error.what()),
                          .allowed = "geometries as in RFC 7946"});
    }
    return std::move(reader.pieces);
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/outlines/pieces.h"
#include "scenes/file/table_reader.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace dsc::scenes {

namespace {

using GeoJson = nlohmann::json;

/// Collections within collections.
constexpr int deepest_collection = 8;

class GeoJsonReader {
public:
    explicit GeoJsonReader(const std::string& where) : where_(where) {}

    void read(const GeoJson& object, int depth = 0) {
        const std::string type = object.is_object() ? object.value("type", GeoJson()).dump() : "";
        if (depth > deepest_collection) {
            refuse("collections too deep", type, "at most 8 levels");
        }
        if (type == "\"FeatureCollection\"") {
            for (const GeoJson& feature : list(object, "features")) {
                read(feature, depth + 1);
            }
        } else if (type == "\"Feature\"") {
            read(member(object, "geometry"), depth + 1);
        } else if (type == "\"GeometryCollection\"") {
            for (const GeoJson& geometry : list(object, "geometries")) {
                read(geometry, depth + 1);
            }
        } else if (type == "\"MultiPolygon\"") {
            for (const GeoJson& polygon : list(object, "coordinates")) {
                add_lines(polygon, true);
            }
        } else if (type == "\"Polygon\"") {
            add_lines(list(object, "coordinates"), true);
        } else if (type == "\"MultiLineString\"") {
            add_lines(list(object, "coordinates"), false);
        } else if (type == "\"LineString\"") {
            add_line(list(object, "coordinates"), false);
        } else {
            refuse("unknown type of geometry", type.empty() ? "no object" : type,
                   "Polygon, MultiPolygon, LineString, MultiLineString, GeometryCollection, "
                   "Feature, FeatureCollection");
        }
    }

    std::vector<Piece> pieces;

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& value,
                             const std::string& allowed) const {
        throw InputError(
            {.what = what, .where = where_, .value = excerpt(value), .allowed = allowed});
    }

    [[nodiscard]] const GeoJson& member(const GeoJson& object, const char* name) const {
        const auto found = object.find(name);
        if (found == object.end()) {
            refuse("member missing", "none", name);
        }
        return *found;
    }

    [[nodiscard]] const GeoJson& list(const GeoJson& object, const char* name) const {
        const GeoJson& value = member(object, name);
        if (!value.is_array()) {
            refuse("not a list", value.dump(), std::string("a list of ") + name);
        }
        return value;
    }

    void add_lines(const GeoJson& lines, bool is_polygon) {
        if (!lines.is_array()) {
            refuse("not a list of lines", lines.dump(), "a list");
        }
        for (const GeoJson& line : lines) {
            add_line(line, is_polygon);
        }
    }

    void add_line(const GeoJson& positions, bool is_closed) {
        if (!positions.is_array()) {
            refuse("not a list of positions", positions.dump(), "a list");
        }
        std::vector<Point<double>> points;
        for (const GeoJson& position : positions) {
            const bool is_pair = position.is_array() && position.size() >= 2 &&
                                 position[0].is_number() && position[1].is_number();
            const double x = is_pair ? position[0].get<double>() : NAN;
            const double y = is_pair ? position[1].get<double>() : NAN;
            if (!(std::abs(x) <= largest_coordinate) || !(std::abs(y) <= largest_coordinate) ||
                ++count_ > most_points) {
                refuse(count_ > most_points ? "too many positions" : "not a position",
                       position.dump(), "[x, y] from -1e6 to 1e6, at most 1000000 of them");
            }
            points.emplace_back(x, y);
        }
        pieces.push_back(piece_of(std::move(points), is_closed));
    }

    const std::string& where_;
    std::size_t count_ = 0;
};

} // namespace

std::vector<Piece> read_geojson(const std::string& text, const std::string& where) {
    GeoJson json;
    try {
        json = GeoJson::parse(text);
    } catch (const GeoJson::exception& error) {
        throw InputError({.what = "no JSON",
                          .where = where,
                          .value = excerpt(error.what()),
                          .allowed = "GeoJSON"});
    }
    GeoJsonReader reader(where);
    reader.read(json);
    return std::move(reader.pieces);
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
#include "scenes/file/scene_parts.h"

#include "dsc/base/error.h"
#include "flows/exact.h"
#include "measures/symmetric_difference.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/file/outlines/label_file.h"
#include "scenes/file/text_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::scenes {

namespace {

constexpr int max_grains = 20'000;
constexpr double finest_grains = 1e-3;
constexpr std::size_t longest_file_name = 64;
constexpr Bounds multiplier{1e-9, 1e9};
/// Two times closer than this, relative to the period, are equal up to rounding.
constexpr double same_time = 1e-9;

std::vector<std::string> with_source_keys(std::vector<std::string> keys) {
    std::ranges::copy(source_keys(), std::back_inserter(keys));
    return keys;
}

/// A length as a function of position and time, given by a formula in x, y and t.
class FormulaLength {
public:
    FormulaLength(const std::string& formula, const Parameters& p, const std::string& where)
        : flow_({.u = formula,
                 .v = "0",
                 .parameters = {{"h", p.h}, {"period", p.period}},
                 .where_u = where}) {}

    double operator()(const Point<double>& place, double time, Phase = exterior_phase) const {
        Point<double> length;
        flow_({&place, 1}, time, {&length, 1});
        return length.x();
    }
    [[nodiscard]] bool changes_in_time() const { return flow_.uses_time(); }

private:
    FormulaFlow flow_;
};

// A shape as a curve for exact solutions: smooth if its source is smooth.
struct FirstShape {
    ParametricCurve curve;
    bool is_hole = false;
};

// Whether most of a polygon lies in another one; they may share points and edges.
bool lies_in(const Outline& inner, const Outline& outer) {
    const OverlapAreas areas = overlap_areas({.outlines = {&inner, 1}}, {.outlines = {&outer, 1}});
    return areas.both > areas.only_first;
}

// The phase of the smallest outline around one.
Phase phase_around(const Setup& setup, std::size_t i) {
    Phase phase = exterior_phase;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < setup.outlines.size(); ++k) {
        const double area = std::abs(signed_area(setup.outlines[k]));
        if (k != i && area < smallest && lies_in(setup.outlines[i], setup.outlines[k])) {
            phase = setup.phases[k];
            smallest = area;
        }
    }
    return phase;
}

// Those of the measured phase, with shapes of other phases in them as holes; or of the only phase.
std::vector<FirstShape> first_shapes(const std::vector<ShapeSource>& shapes, const Setup& setup) {
    if (shapes.size() == 1 && shapes.front().source.curve &&
        setup.measured.value_or(setup.phases.front()) == setup.phases.front()) {
        return {{*shapes.front().source.curve}};
    }
    std::vector<FirstShape> first;
    Phase phase = exterior_phase;
    for (std::size_t i = 0; !shapes.empty() && i < setup.outlines.size(); ++i) {
        const Outline& outline = setup.outlines[i];
        const bool is_hole = setup.phases[i] != setup.measured.value_or(setup.phases[i]) ||
                             setup.phases[i] == exterior_phase;
        if (is_hole && setup.measured && phase_around(setup, i) != *setup.measured) {
            continue; // beside the measured phase
        }
        if (!is_hole && phase != exterior_phase && setup.phases[i] != phase) {
            throw InputError(
                {.what = "the exact shape of several phases is not supported",
                 .where = shapes.front().where,
                 .value = std::to_string(phase) + " and " + std::to_string(setup.phases[i]),
                 .allowed = "phase = N in [measure], or shapes of one phase and their holes"});
        }
        phase = is_hole ? phase : setup.phases[i];
        first.push_back(
            {polygon_curve(signed_area(outline) < 0 ? reversed(outline) : outline), is_hole});
    }
    if (first.empty() && !shapes.empty()) {
        throw InputError({.what = "no shape has the measured phase",
                          .where = shapes.front().where,
                          .value = std::to_string(setup.measured.value_or(1)),
                          .allowed = "the phase of a shape in [measure]"});
    }
    return first;
}

bool is_file_name(const std::string& name) {
    return !name.empty() && name.size() <= longest_file_name &&
           std::ranges::all_of(name, [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_';
           });
}

} // namespace

std::string read_name(const TableReader& top) {
    if (!top.has("name")) {
        const std::string stem = top.file().stem().string();
        return is_file_name(stem) ? stem : "scene";
    }
    std::string name = top.text("name");
    if (!is_file_name(name)) {
        top.refuse("name", "bad value", "1 to 64 letters, digits, - and _");
    }
    return name;
}

Rectangle read_domain(const TableReader& reader) {
    if (reader.has("mesh")) {
        reader.refuse("mesh",
                      "scene files do not read meshes, because a scene makes its mesh for any h",
                      "an outline; or in Python dsc.from_meshio(meshio.read(FILE))");
    }
    reader.allow({"low", "high", "clamped"});
    const Rectangle domain{reader.point_or({0, 0}, "low"), reader.point_or({1, 1}, "high")};
    const Point<double> size = domain.high - domain.low;
    if (!(size.minCoeff() >= positive_length.low)) {
        reader.refuse("high", "bad value", "above and to the right of low");
    }
    return domain;
}

std::vector<DomainOutline> read_domain_outline(const TableReader& reader) {
    reader.allow({"outline", "clamped"});
    std::vector<DomainOutline> outlines;
    for (const TableReader& outline : reader.tables("outline")) {
        std::vector<std::string> keys = source_keys();
        keys.emplace_back("sides");
        outline.allow(keys);
        DomainOutline& one = outlines.emplace_back(DomainOutline{
            .source = read_outline_source(outline, true), .where = outline.where("sides")});
        if (outline.has("sides")) {
            one.sides = outline.is_text("sides") ? std::vector{outline.text("sides")}
                                                 : outline.texts("sides");
        }
        // Names are parts of the names of columns.
        if (std::ranges::any_of(one.sides, [](const std::string& name) {
                return name.find_first_of(",\"\r\n") != std::string::npos;
            })) {
            outline.refuse("sides", "a name with a comma, a quotation mark or a line break",
                           "names without these");
        }
    }
    return outlines;
}

ShapeSource read_shape(const TableReader& reader) {
    reader.allow(with_source_keys({"phase", "hole_phase"}));
    return {read_outline_source(reader, true), reader.phase_or(1, "phase"),
            reader.phase_or(exterior_phase, "hole_phase"), reader.where()};
}

std::shared_ptr<const LabelImage> read_label_image(const TableReader& reader) {
    reader.allow({"labels", "min_pixels"});
    const std::filesystem::path path = reader.file().parent_path() / reader.text("labels");
    LabelImage image = read_labels(read_text_file(path), path.string());
    if (reader.has("min_pixels")) {
        image.min_pixels = static_cast<std::size_t>(reader.integer("min_pixels", 0, 1'000'000));
    }
    return std::make_shared<const LabelImage>(std::move(image));
}

CurveSource read_curve(const TableReader& reader) {
    reader.allow(with_source_keys({"left", "right"}));
    return {read_outline_source(reader, false), reader.phase_or(1, "left"),
            reader.phase_or(exterior_phase, "right")};
}

CurvatureMotion read_curvature(const TableReader& reader) {
    reader.allow({"pairs", "keeps"});
    CurvatureMotion motion;
    for (const TableReader& pair : reader.tables("pairs")) {
        pair.allow({"one", "other", "tension", "mobility"});
        motion.pairs.push_back({.one = pair.phase("one"),
                                .other = pair.phase("other"),
                                .tension = pair.number_or(1, "tension", multiplier),
                                .mobility = pair.number_or(1, "mobility", multiplier)});
    }
    if (reader.has("keeps")) {
        motion.keeps = reader.phases("keeps", 1);
    }
    return motion;
}

Growth read_growth(const TableReader& reader) {
    reader.allow({"speed", "turns_at"});
    constexpr double never = std::numeric_limits<double>::infinity();
    return {.speed = reader.number_or(1, "speed"),
            .turns_at = reader.number_or(never, "turns_at", {0, never})};
}

std::function<SizeOptions<double>(const Parameters&)> read_sizes(const TableReader& reader) {
    reader.allow(
        {"edges_to_interface", "longest", "shortest", "by_phase", "by_place", "on_interface"});
    const double number = reader.number_or(0, "edges_to_interface", {1, 1e4});
    const double longest = reader.number_or(0, "longest", positive_length);
    const double min_length = reader.number_or(0, "shortest", positive_length);
    const LengthByPhase by_phase{reader.has("by_phase")
                                     ? reader.numbers("by_phase", positive_length)
                                     : std::vector<double>{}};
    if (reader.has("by_phase") && (reader.has("by_place") || by_phase.lengths.empty())) {
        reader.refuse("by_phase", "bad value", "one length or more, and no by_place");
    }
    const auto formula_at = [&](const char* key) {
        return reader.has(key) ? reader.text(key) : std::string();
    };
    return [=, by_place = formula_at("by_place"), on_interface = formula_at("on_interface"),
            where_place = reader.where("by_place"),
            where_interface = reader.where("on_interface")](const Parameters& p) {
        SizeOptions<double> sizes;
        sizes.longest = longest;
        sizes.shortest = min_length;
        if (number > 0) {
            sizes.by_distance = EdgesToInterface{p.h, number};
        }
        if (!by_phase.lengths.empty()) {
            sizes.by_place = by_phase;
        }
        if (!by_place.empty()) {
            const FormulaLength length(by_place, p, where_place);
            sizes.by_place = length;
            sizes.changes_in_time = length.changes_in_time();
        }
        if (!on_interface.empty()) {
            const FormulaLength length(on_interface, p, where_interface);
            sizes.on_interface = length;
            sizes.changes_in_time = sizes.changes_in_time || length.changes_in_time();
        }
        return sizes;
    };
}

ExactSource read_exact(const TableReader& reader) {
    const std::vector<std::string> kinds{"back", "advected"};
    reader.allow(kinds);
    const std::string kind = reader.one_of(kinds);
    if (!reader.flag_or(true, kind)) {
        reader.refuse(kind, "bad value", "true, or no such key");
    }
    return {kind == "advected", reader.where(kind)};
}

void read_options(const TableReader& top, const std::vector<std::string>& keys,
                  Parameters& parameters) {
    if (top.has("options")) {
        const TableReader options = top.table("options");
        options.allow(keys);
        for (const Key& key : parameter_keys()) {
            if (options.has(key.name) && !key.parse(parameters, options.setting(key.name))) {
                options.refuse(key.name, "bad value", key.allowed);
            }
        }
    }
    if (!(parameters.h > 0)) {
        throw InputError({.what = "key missing",
                          .where = top.file().string() + ": [options]",
                          .value = "no h",
                          .allowed = "the length of edges, such as h = 0.02"});
    }
}

void check_grains(const Scene& scene, const Parameters& parameters, const std::string& where) {
    if (std::ranges::find(scene.keys, "grains") == scene.keys.end()) {
        return;
    }
    // By default the number of grains follows from h: see catalogue/networks.cpp.
    if (parameters.grains > max_grains ||
        (parameters.grains == 0 && parameters.h < finest_grains)) {
        throw InputError(
            {.what = "too many grains for a scene file",
             .where = where,
             .value = std::to_string(parameters.grains) + " grains, h = " + to_text(parameters.h),
             .allowed = "at most 20000 grains, or h of at least 0.001"});
    }
}

void add_shapes(const std::vector<ShapeSource>& shapes, double edge_length, Setup& setup) {
    for (const ShapeSource& shape : shapes) {
        const std::vector<Piece> pieces = shape.source.pieces(edge_length);
        const std::vector<int> depths = nesting(pieces);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (pieces[i].points.size() < 3) {
                throw InputError({.what = "a closed line encloses nothing",
                                  .where = shape.where,
                                  .value = std::to_string(pieces[i].points.size()) + " points",
                                  .allowed = "lines of 3 points or more"});
            }
            setup.outlines.push_back(pieces[i].points);
            setup.phases.push_back(depths[i] == 0 ? shape.phase : shape.hole_phase);
        }
    }
}

void add_curves(const std::vector<CurveSource>& curves, double edge_length, Setup& setup) {
    for (const CurveSource& curve : curves) {
        for (Piece& piece : curve.source.pieces(edge_length)) {
            if (piece.is_closed && !piece.points.empty()) {
                const Point<double> first = piece.points.front();
                piece.points.push_back(first);
            }
            setup.curves.push_back({std::move(piece.points), curve.left, curve.right});
        }
    }
}

void set_exact(const ExactSource& exact, const std::vector<ShapeSource>& shapes, double period,
               double edge_length, Setup& setup) {
    if (exact.is_advected ? setup.flow.empty() : !(period > 0)) {
        throw InputError({.what = exact.is_advected
                                      ? "exact shapes can be advected only by a [flow]"
                                      : "the flow has no period",
                          .where = exact.where,
                          .value = "true",
                          .allowed = exact.is_advected ? "with a [flow]"
                                                       : "with a period above 0 in [options]"});
    }
    setup.exact = [first = first_shapes(shapes, setup), flow = setup.flow, period, edge_length,
                   is_advected = exact.is_advected](double time) {
        const bool is_first =
            time == 0 ||
            (period > 0 && std::min(std::abs(time), std::abs(time - period)) <= same_time * period);
        ExactShape all;
        if (!is_first && !is_advected) {
            all.area = std::numeric_limits<double>::quiet_NaN(); // unknown
            return all;
        }
        // Holes run clockwise, and their area is subtracted.
        for (const auto& [curve, is_hole] : first) {
            ExactShape one =
                is_first ? unmoved_shape(curve)
                         : advected_shape(curve, flow, time, markers_for(curve, edge_length));
            all.area += is_hole ? -one.area : one.area;
            all.own_error += one.own_error;
            for (Outline& outline : one.outlines) {
                all.outlines.push_back(is_hole ? reversed(std::move(outline)) : std::move(outline));
            }
        }
        return all;
    };
}

} // namespace dsc::scenes

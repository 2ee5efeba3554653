// SPDX-License-Identifier: MIT
#include "combinations/sense.h"

#include <algorithm>
#include <vector>

namespace dsc::combinations {

namespace {

// Numbers of features, as in `Values`.
enum Number : std::size_t {
    place,
    phases,
    motion,
    told,
    sizes,
    topology,
    integrator,
    insertion,
    coarsening,
    outline,
    way,
    submeshes,
    precision,
    interruption,
    turned,
    inside,
    data,
};

struct Contradiction {
    std::vector<std::size_t> features;
    bool (*is_nonsense)(const Row& row);
    std::string_view why;
};

const std::vector<Contradiction>& rules() {
    static const std::vector<Contradiction> list{
        {{place, motion},
         [](const Row& row) {
             return row.motion == Motion::turn && row.place != Place::square &&
                    row.place != Place::pair && row.place != Place::by_wall;
         },
         "only what lies inside the square turns in it"},
        {{place, motion},
         [](const Row& row) {
             return is_translation(row.motion) &&
                    (row.place == Place::in_corner || row.place == Place::through_corner);
         },
         "what meets a corner of the domain cannot be translated"},
        {{place, motion},
         [](const Row& row) {
             return (row.motion == Motion::up || row.motion == Motion::down) &&
                    row.place == Place::on_wall;
         },
         "what lies on a wall is translated along it alone"},
        {{place, motion},
         [](const Row& row) {
             return (is_normal(row.motion) || is_by_curvature(row.motion)) &&
                    row.place == Place::through_corner;
         },
         "an end that is held in a corner of the domain moves along no normal"},
        {{place, phases},
         [](const Row& row) {
             return row.phases == Phases::nested && row.place == Place::through_corner;
         },
         "two nested diagonals are one"},
        {{place, phases},
         [](const Row& row) { return row.phases == Phases::nested && row.place == Place::pair; },
         "a pair is of one phase or of two"},
        {{place, motion, coarsening},
         [](const Row& row) {
             return row.place == Place::layer && row.coarsening == Coarsening::never &&
                    (row.motion == Motion::left || row.motion == Motion::right);
         },
         "vertices that run into a wall have to go"},
        {{place, phases, motion, coarsening},
         [](const Row& row) {
             return row.phases == Phases::junctions && row.place != Place::pair &&
                    row.coarsening == Coarsening::never &&
                    (row.motion == Motion::shrink || is_by_curvature(row.motion) ||
                     (row.place == Place::layer && is_translation(row.motion)));
         },
         "a junction that moves along a curve meets vertices that have to go"},
        {{place, motion, inside},
         [](const Row& row) {
             return row.place == Place::layer && row.inside == Inside::carried &&
                    is_translation(row.motion);
         },
         "the inside of a phase runs into a wall, or leaves one"},
        {{place, phases},
         [](const Row& row) {
             return row.phases == Phases::many && row.place != Place::square &&
                    row.place != Place::slender;
         },
         "many cells fill the whole domain"},
        {{phases, motion},
         [](const Row& row) {
             return row.phases == Phases::many && row.motion != Motion::rest &&
                    row.motion != Motion::swirl && row.motion != Motion::curvature;
         },
         "cells that fill the domain cannot leave it"},
        {{place, phases, motion},
         [](const Row& row) {
             return row.phases == Phases::junctions && row.place == Place::in_corner &&
                    (is_normal(row.motion) || is_by_curvature(row.motion));
         },
         "a junction that is held in a corner of the domain moves along no normal"},
        {{phases, outline},
         [](const Row& row) { return row.phases == Phases::many && row.outline != Outline::round; },
         "the outlines of Voronoi cells are given"},
        {{place, outline},
         [](const Row& row) {
             return row.outline != Outline::round &&
                    (row.place == Place::layer || row.place == Place::through_corner);
         },
         "a straight line has no corners"},
        {{motion, outline},
         [](const Row& row) {
             return row.outline != Outline::round &&
                    (is_normal(row.motion) || is_by_curvature(row.motion));
         },
         "corners change their shape along normals and by curvature"},
        {{phases, motion},
         [](const Row& row) {
             return row.motion == Motion::vanish && row.phases != Phases::nested;
         },
         "only a piece inside another one vanishes"},
        {{place, motion},
         [](const Row& row) {
             return row.motion == Motion::vanish &&
                    (row.place == Place::layer || row.place == Place::pair);
         },
         "only a round piece inside another one vanishes"},
        {{motion, topology},
         [](const Row& row) {
             return row.motion == Motion::vanish &&
                    (row.topology == Rule::keep || row.topology == Rule::forbidden);
         },
         "nothing vanishes where the topology is kept"},
        {{told, interruption},
         [](const Row& row) {
             return row.interruption == Interruption::pause && row.told == Told::motion;
         },
         "refused: a motion of the whole interface in no time"},
        {{motion, told},
         [](const Row& row) { return is_normal(row.motion) && row.told != Told::seeing; },
         "growth sees the interface"},
        {{motion, told},
         [](const Row& row) { return is_by_curvature(row.motion) && row.told != Told::motion; },
         "curvature flow is a motion of the whole interface"},
        {{told, inside},
         [](const Row& row) {
             return row.inside == Inside::carried && row.told != Told::positions;
         },
         "refused: a flow that sees the interface carries nothing"},
        {{phases, topology},
         [](const Row& row) {
             return (row.topology == Rule::wide || row.topology == Rule::least_area) &&
                    row.phases == Phases::many;
         },
         "cells as narrow as the contact distance, or as small as what vanishes"},
        {{way, submeshes},
         [](const Row& row) {
             return row.way == Way::sequential && row.submeshes != Submeshes::own_choice;
         },
         "the sequential method has no submeshes"},
        {{motion, interruption},
         [](const Row& row) {
             return row.interruption == Interruption::not_a_number && is_by_curvature(row.motion);
         },
         "what is held back at once gets ahead again by its curvature"},
    };
    return list;
}

} // namespace

std::string_view nonsense_in(const Values& values, std::span<const bool> is_set) {
    const Row row = row_of(values);
    for (const Contradiction& rule : rules()) {
        if (std::ranges::all_of(rule.features, [&](std::size_t i) { return is_set[i]; }) &&
            rule.is_nonsense(row)) {
            return rule.why;
        }
    }
    return {};
}

std::string_view nonsense_in(const Values& values) {
    std::array<bool, feature_count> all{};
    all.fill(true);
    return nonsense_in(values, all);
}

Cover cover_features(std::size_t strength, std::uint64_t seed) {
    std::vector<std::size_t> counts;
    for (const Feature& feature : features()) {
        counts.push_back(feature.values.size());
    }
    return cover({.counts = counts,
                  .strength = strength,
                  .seed = seed,
                  .makes_sense = [](std::span<const std::uint8_t> row, std::span<const bool> set) {
                      Values values{};
                      for (std::size_t i = 0; i < feature_count; ++i) {
                          values[i] = set[i] ? row[i] : std::uint8_t{0};
                      }
                      return nonsense_in(values, set).empty();
                  }});
}

std::span<const std::string_view> found_rows() {
    static constexpr std::array<std::string_view, 26> list{
        // A star waited for a vertex that went half of its way in each pass because the star
        // waited.
        "motion=turn integrator=rk4 outline=loose_corners way=cells inside=carried",
        // A junction that moved along a curve was stuck before its next vertex.
        "phases=junctions motion=shrink told=seeing",
        // A vertex one unit of rounding from its target kept others waiting for it.
        "motion=turn outline=corners inside=carried way=fixed",
        // A contact, and a wall vertex that slides into a corner of the domain, waited before a
        // vertex of the wall because the edge beyond that was long.
        "place=layer motion=down sizes=switched_off turned=quarter",
        "place=layer phases=junctions motion=down sizes=graded",
        // The id of a vertex that vanished on its way was used again: another one went there.
        "place=slender motion=right coarsening=never turned=mirrored inside=carried",
        // In a submesh stars waited for vertices that waited for the stars.
        "place=pair motion=turn integrator=centred way=fixed inside=carried",
        // What merges with a wall did not merge all at once; a slit held its end up; the account of
        // areas counted what landing vertices sweep.
        "place=by_wall motion=grow told=seeing topology=given_back coarsening=never data=field "
        "interruption=renumbered",
        "place=by_wall motion=grow told=seeing topology=given_back coarsening=never "
        "integrator=centred",
        // In single precision the area that an event told of was rounded.
        "place=pair motion=grow told=seeing topology=given_back precision=float",
        // Which tasks of a step that threw had run depended on the threads.
        "place=through_corner phases=junctions motion=swirl way=fixed submeshes=two "
        "interruption=thrown sizes=switched_off",
        // Of two phases that merged with a wall at once, the first took what was the other's.
        "place=by_wall phases=junctions motion=grow told=seeing sizes=by_place topology=wide "
        "turned=quarter",
        "place=by_wall phases=junctions motion=grow told=seeing sizes=by_place topology=wide "
        "integrator=centred insertion=cubic way=active precision=float "
        "interruption=tiny_step turned=quarter data=field",
        "place=by_wall phases=junctions motion=grow told=seeing sizes=by_place topology=wide",
        // An end of a curve that had become a vertex of a wall went back and forth along it.
        "place=by_wall motion=grow told=seeing sizes=graded topology=least_area "
        "integrator=centred",
        // Vertices that a wall holds up waited for others, between them and the end of the curve,
        // that it does not.
        "place=by_wall motion=grow told=seeing topology=change integrator=adaptive "
        "coarsening=never",
        "place=by_wall motion=grow told=seeing sizes=in_time topology=wide integrator=midpoint "
        "coarsening=never",
        // A vertex exactly above the end of its curve on the wall did not land.
        "place=by_wall phases=junctions motion=down topology=change coarsening=never",
        // Nor did one above inner vertices of the film, or a long edge of the wall.
        "place=by_wall motion=grow told=seeing topology=change integrator=rk4 way=cells",
        "place=by_wall motion=grow told=seeing sizes=graded topology=change coarsening=never "
        "turned=mirrored",
        // The end of a curve was held up by the next vertices of the curve.
        "place=by_wall motion=grow told=seeing sizes=graded topology=change coarsening=never",
        "place=pair phases=junctions motion=grow told=seeing topology=change turned=mirrored",
        // What a film along a wall had just become was taken for the end of a seam, and changed
        // hands
        // again.
        "place=by_wall phases=junctions motion=down topology=wide integrator=rk4 way=cells",
        // A notch whose sides hold up each other closed beside seams alone.
        "place=by_wall phases=nested motion=grow told=seeing sizes=graded topology=wide "
        "way=counting precision=float turned=three_quarters data=field",
        // At the tip where two discs have met, each step went to the other side.
        "place=pair motion=grow told=seeing topology=change integrator=centred turned=quarter",
        // What a vertex had come to face in the sub-step that held it up was not looked at.
        "place=pair phases=junctions motion=grow told=seeing sizes=switched_off topology=change "
        "way=cells turned=three_quarters",
    };
    return list;
}

std::span<const std::string_view> refused_rows() {
    static constexpr std::array<std::string_view, 3> list{
        "told=seeing inside=carried",
        "told=motion inside=carried",
        "told=motion interruption=pause",
    };
    return list;
}

} // namespace dsc::combinations

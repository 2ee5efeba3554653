// SPDX-License-Identifier: MIT
// A row of the array: one value of each feature. Every pair of values, and many a triple, is run
// together in some row whose answer is known from its parts.
#pragma once

#include "dsc/base/types.h"
#include "dsc/motion/interpolation.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/options.h"
#include "scenes/integrator_choice.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dsc::combinations {

/// Where the interface lies in the domain.
enum class Place : std::uint8_t {
    square,         ///< a disc inside the unit square
    pair,           ///< two discs beside each other, which meet where they grow
    by_wall,        ///< a disc beside a wall, which it meets where it grows or moves there
    slender,        ///< a disc inside a rectangle of 100:1
    on_wall,        ///< half a disc on a wall
    in_corner,      ///< a quarter of a disc in a corner of the domain
    layer,          ///< a straight layer along a wall, that ends on two others
    through_corner, ///< a diagonal from corner to corner
};
inline constexpr std::array place_names{
    Named{Place::square, "square"},   Named{Place::pair, "pair"},
    Named{Place::by_wall, "by_wall"}, Named{Place::slender, "slender"},
    Named{Place::on_wall, "on_wall"}, Named{Place::in_corner, "in_corner"},
    Named{Place::layer, "layer"},     Named{Place::through_corner, "through_corner"},
};

enum class Phases : std::uint8_t {
    one,       ///< a shape of phase 1
    nested,    ///< and one of phase 2 inside it
    junctions, ///< the shape is cut into phases 1 and 2, so that three phases meet; of a pair one
               ///< each
    many,      ///< a hundred Voronoi cells that fill the domain
};
inline constexpr std::array phases_names{
    Named{Phases::one, "one"},
    Named{Phases::nested, "nested"},
    Named{Phases::junctions, "junctions"},
    Named{Phases::many, "many"},
};

enum class Motion : std::uint8_t {
    rest,
    right, ///< a translation; on a wall along it
    left,
    up,
    down,
    turn,  ///< once around the middle of the square
    swirl, ///< there and back
    grow,  ///< along the normals
    shrink,
    curvature,
    vanish, ///< by curvature, until the inner of two nested pieces is gone
};
inline constexpr std::array motion_names{
    Named{Motion::rest, "rest"},     Named{Motion::right, "right"},
    Named{Motion::left, "left"},     Named{Motion::up, "up"},
    Named{Motion::down, "down"},     Named{Motion::turn, "turn"},
    Named{Motion::swirl, "swirl"},   Named{Motion::grow, "grow"},
    Named{Motion::shrink, "shrink"}, Named{Motion::curvature, "curvature"},
    Named{Motion::vanish, "vanish"},
};

[[nodiscard]] constexpr bool is_translation(Motion one) {
    return one == Motion::right || one == Motion::left || one == Motion::up || one == Motion::down;
}
[[nodiscard]] constexpr bool is_by_curvature(Motion one) {
    return one == Motion::curvature || one == Motion::vanish;
}
[[nodiscard]] constexpr bool is_normal(Motion one) {
    return one == Motion::grow || one == Motion::shrink;
}

/// How the flow is handed to the step.
enum class Told : std::uint8_t {
    positions, ///< as a velocity of positions
    seeing,    ///< as a velocity that sees the interface
    motion,    ///< as a motion of the whole interface
};
inline constexpr std::array told_names{
    Named{Told::positions, "positions"},
    Named{Told::seeing, "seeing"},
    Named{Told::motion, "motion"},
};

enum class Sizes : std::uint8_t {
    uniform,
    graded,
    by_place,
    in_time,
    switched_on,  ///< in mid-run
    switched_off, ///< in mid-run
};
inline constexpr std::array sizes_names{
    Named{Sizes::uniform, "uniform"},         Named{Sizes::graded, "graded"},
    Named{Sizes::by_place, "by_place"},       Named{Sizes::in_time, "in_time"},
    Named{Sizes::switched_on, "switched_on"}, Named{Sizes::switched_off, "switched_off"},
};

enum class Rule : std::uint8_t {
    keep,
    change,
    forbidden,  ///< it may change, but the application's predicate says no
    given_back, ///< with the areas given back
    wide,       ///< a contact distance of more than an edge
    least_area, ///< pieces of several edge lengths squared vanish
};
inline constexpr std::array rule_names{
    Named{Rule::keep, "keep"},           Named{Rule::change, "change"},
    Named{Rule::forbidden, "forbidden"}, Named{Rule::given_back, "given_back"},
    Named{Rule::wide, "wide"},           Named{Rule::least_area, "least_area"},
};

enum class Outline : std::uint8_t {
    round,
    corners,       ///< turns of 45 degrees and more, which are kept
    loose_corners, ///< the same, and they are not
};
inline constexpr std::array outline_names{
    Named{Outline::round, "round"},
    Named{Outline::corners, "corners"},
    Named{Outline::loose_corners, "loose_corners"},
};

/// Sequential, or one of the divisions.
enum class Way : std::uint8_t { sequential, cells, fixed, counting, active, blocks, copy };
inline constexpr std::array way_names{
    Named{Way::sequential, "sequential"},
    Named{Way::cells, "cells"},
    Named{Way::fixed, "fixed"},
    Named{Way::counting, "counting"},
    Named{Way::active, "active"},
    Named{Way::blocks, "blocks"},
    Named{Way::copy, "copy"},
};

enum class Submeshes : std::uint8_t { own_choice, two, four, nine };
inline constexpr std::array submeshes_names{
    Named{Submeshes::own_choice, "own_choice"},
    Named{Submeshes::two, "two"},
    Named{Submeshes::four, "four"},
    Named{Submeshes::nine, "nine"},
};

enum class Precision : std::uint8_t { in_double, in_float };
inline constexpr std::array precision_names{
    Named{Precision::in_double, "double"},
    Named{Precision::in_float, "float"},
};

/// What happens in the middle of the run.
enum class Interruption : std::uint8_t {
    none,
    resumed,     ///< archived, and read into another simulation
    set_options, ///< the same ones
    renumbered,
    edited,       ///< by the application
    listened,     ///< edits are listened to, and replayed at the end
    thrown,       ///< the application's function throws, and the step is made again
    pause,        ///< a step of no duration
    tiny_step,    ///< one of nearly none
    not_a_number, ///< in one step and half of the domain
};
inline constexpr std::array interruption_names{
    Named{Interruption::none, "none"},
    Named{Interruption::resumed, "resumed"},
    Named{Interruption::set_options, "set_options"},
    Named{Interruption::renumbered, "renumbered"},
    Named{Interruption::edited, "edited"},
    Named{Interruption::listened, "listened"},
    Named{Interruption::thrown, "thrown"},
    Named{Interruption::pause, "pause"},
    Named{Interruption::tiny_step, "tiny_step"},
    Named{Interruption::not_a_number, "not_a_number"},
};

/// How the whole scene is turned about its domain: the answer turns with it.
enum class Turned : std::uint8_t { not_at_all, quarter, half, three_quarters, mirrored };
inline constexpr std::array turned_names{
    Named{Turned::not_at_all, "not_at_all"},
    Named{Turned::quarter, "quarter"},
    Named{Turned::half, "half"},
    Named{Turned::three_quarters, "three_quarters"},
    Named{Turned::mirrored, "mirrored"},
};

/// Whether the inside of phase 1 moves with the flow as well.
enum class Inside : std::uint8_t { still, carried };
inline constexpr std::array inside_names{
    Named{Inside::still, "still"},
    Named{Inside::carried, "carried"},
};

/// What the application keeps in the mesh.
enum class Data : std::uint8_t {
    none,
    field, ///< of the place: linear, and so exact wherever a vertex is made or moved
};
inline constexpr std::array data_names{
    Named{Data::none, "none"},
    Named{Data::field, "field"},
};

/// One value of each feature; the first of each is the plain one.
struct Row {
    Place place = Place::square;
    Phases phases = Phases::one;
    Motion motion = Motion::rest;
    Told told = Told::positions;
    Sizes sizes = Sizes::uniform;
    Rule topology = Rule::keep;
    scenes::IntegratorChoice integrator = scenes::IntegratorChoice::euler;
    Insertion insertion = Insertion::linear;
    Coarsening coarsening = Coarsening::deviation;
    Outline outline = Outline::round;
    Way way = Way::sequential;
    Submeshes submeshes = Submeshes::own_choice;
    Precision precision = Precision::in_double;
    Interruption interruption = Interruption::none;
    Turned turned = Turned::not_at_all;
    Inside inside = Inside::still;
    Data data = Data::none;
};

/// A row as numbers: for each feature, which of its values.
inline constexpr std::size_t feature_count = 17;
using Values = std::array<std::uint8_t, feature_count>;

struct Feature {
    std::string_view name;
    std::span<const std::string_view> values;
};
/// In the order of `Values`.
[[nodiscard]] std::span<const Feature> features();

[[nodiscard]] Row row_of(const Values& values);

/// "motion=turn way=cells": the features that differ from the plain ones.
[[nodiscard]] std::string words_of(const Values& values);
/// The reverse. Throws InputError for a feature or a value that does not exist.
[[nodiscard]] Values values_of(std::string_view words);

} // namespace dsc::combinations

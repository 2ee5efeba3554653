// SPDX-License-Identifier: MIT
// A row has one value for each feature of a run: place of the interface, motion, options of the
// library, interruptions. The correct result follows from these values.
#pragma once

#include "dsc/base/types.h"
#include "dsc/motion/interpolation.h"
#include "dsc/passes/options.h"
#include "scenes/integrator_choice.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::combinations {

/// The place of the interface in the domain.
enum class Place : std::uint8_t {
    square,      ///< a disc inside the unit square
    pair,        ///< two discs side by side, which meet if they grow
    by_boundary, ///< a disc beside the domain boundary, which it meets if it grows or moves down
    slender,     ///< a disc inside a rectangle of 100:1
    on_boundary, ///< half a disc on the domain boundary
    in_corner,   ///< a quarter of a disc in a corner of the domain
    layer,       ///< a straight layer along a side of the domain, which ends on two other sides
};

enum class Phases : std::uint8_t {
    one,       ///< a shape of phase 1
    nested,    ///< phase 1, with phase 2 inside it
    junctions, ///< phases 1 and 2 side by side, so that three phases meet; one each for a pair
};

enum class Motion : std::uint8_t {
    rest,
    right,     ///< a translation; along the domain boundary for shapes on it
    down,      ///< a translation
    turn,      ///< by three quarters of a turn about the middle of the square
    swirl,     ///< there and back
    grow,      ///< along the normals
    shrink,    ///< along the normals
    curvature, ///< by curvature
    vanish,    ///< by curvature, until the inner of two nested pieces is gone
};

/// The form in which the flow is given to the step.
enum class Told : std::uint8_t {
    positions, ///< as a velocity of positions
    seeing,    ///< as a velocity that depends on the interface
    motion,    ///< as a motion of the whole interface
};

enum class Sizes : std::uint8_t {
    uniform,
    graded,
    by_place,
    in_time,
    switched_on,  ///< in mid-run
    switched_off, ///< in mid-run
};

enum class Rule : std::uint8_t {
    keep,
    change,
    forbidden,  ///< changes are allowed by the options, but refused by the application's predicate
    given_back, ///< with the areas given back
    wide,       ///< a contact distance of more than an edge
    min_area,   ///< pieces of several edge lengths squared vanish
};

enum class Outline : std::uint8_t {
    round,
    corners, ///< turns of 45 degrees and more are kept
};

/// The sequential driver, or one of the divisions.
enum class Way : std::uint8_t { sequential, cells, fixed, counting, active, blocks, copy };

enum class Submeshes : std::uint8_t { own_choice, two, nine };

enum class Precision : std::uint8_t { in_double, in_float };

/// An interruption in the middle of the run.
enum class Interruption : std::uint8_t {
    none,
    set_options, ///< the same ones
    renumbered,
    thrown,    ///< the application's function throws, and the step is repeated
    pause,     ///< a step of no duration
    tiny_step, ///< a step of almost no duration
};

/// The rotation or reflection of the whole scene, which also applies to the result.
enum class Turned : std::uint8_t { not_at_all, quarter, half, three_quarters, mirrored };

/// Whether the inside of phase 1 is advected as well.
enum class Inside : std::uint8_t { still, advected };

/// The first value of each feature is the default.
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
};

[[nodiscard]] constexpr bool is_translation(const Row& row) {
    return row.motion == Motion::right || row.motion == Motion::down;
}
[[nodiscard]] constexpr bool is_by_curvature(const Row& row) {
    return row.motion == Motion::curvature || row.motion == Motion::vanish;
}
[[nodiscard]] constexpr bool is_normal(const Row& row) {
    return row.motion == Motion::grow || row.motion == Motion::shrink;
}
[[nodiscard]] constexpr bool may_change(const Row& row) {
    return row.topology != Rule::keep && row.topology != Rule::forbidden;
}

struct Feature {
    std::string_view name;
    std::vector<std::string_view> values; ///< the enumerators, in order
};
/// All features in the order of the members of Row.
[[nodiscard]] const std::vector<Feature>& features();

/// A row as numbers: for each feature, the index of its value.
using Values = std::array<std::uint8_t, sizeof(Row)>;
[[nodiscard]] Row row_of(const Values& values);

/// "motion=turn way=cells": the features with other values than the default.
[[nodiscard]] std::string words_of(const Values& values);
/// The reverse. Throws InputError for a feature or a value that does not exist.
[[nodiscard]] Values values_of(const std::string& words);

} // namespace dsc::combinations

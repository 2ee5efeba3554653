// SPDX-License-Identifier: MIT
#include "combinations/rows.h"

#include "support/random/scene.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace dsc::combinations {

std::string_view nonsense_in(const Row& row) {
    const bool is_in_square =
        row.place == Place::square || row.place == Place::pair || row.place == Place::by_boundary;
    const bool is_layer = row.place == Place::layer;
    const bool is_cut = row.phases == Phases::junctions && row.place != Place::pair;
    const bool deforms = is_normal(row) || is_by_curvature(row);
    struct Contradiction {
        bool is_there;
        std::string_view why;
    };
    const std::array contradictions{
        Contradiction{row.motion == Motion::turn && !is_in_square,
                      "only what lies inside the square turns in it"},
        Contradiction{row.motion == Motion::swirl && row.place == Place::slender,
                      "the swirl fills the square"},
        Contradiction{is_translation(row) && row.place == Place::in_corner,
                      "what meets a corner of the domain cannot be translated"},
        Contradiction{row.motion == Motion::down && row.place == Place::on_boundary,
                      "what lies on the domain boundary is translated along it alone"},
        Contradiction{deforms && is_cut && row.place == Place::in_corner,
                      "a junction that is held in a corner of the domain moves along no normal"},
        Contradiction{row.phases == Phases::nested && row.place == Place::pair,
                      "a pair is of one phase or of two"},
        Contradiction{is_layer && row.coarsening == Coarsening::never &&
                          row.motion == Motion::right,
                      "vertices that run into the domain boundary have to go"},
        Contradiction{is_cut && row.coarsening == Coarsening::never &&
                          (row.motion == Motion::shrink || is_by_curvature(row) ||
                           (is_layer && is_translation(row))),
                      "a junction that moves along a curve meets vertices that have to go"},
        Contradiction{is_layer && row.inside == Inside::advected && is_translation(row),
                      "the inside of a phase runs into the domain boundary, or leaves one"},
        Contradiction{row.outline == Outline::corners && is_layer,
                      "a straight line has no corners"},
        Contradiction{row.outline == Outline::corners && deforms,
                      "corners change their shape along normals and by curvature"},
        Contradiction{row.motion == Motion::vanish &&
                          (row.phases != Phases::nested || is_layer || row.place == Place::pair),
                      "only a round piece inside another one vanishes"},
        Contradiction{row.motion == Motion::vanish && !may_change(row),
                      "nothing vanishes where the topology is kept"},
        Contradiction{row.interruption == Interruption::pause && row.told == Told::motion,
                      "refused: an InterfaceMotion with dt = 0"},
        Contradiction{is_normal(row) && row.told != Told::seeing, "growth reads the interface"},
        Contradiction{is_by_curvature(row) && row.told != Told::motion,
                      "curvature flow is a motion of the whole interface"},
        Contradiction{row.inside == Inside::advected && row.told != Told::positions,
                      "refused: advected phases need a velocity"},
        Contradiction{row.way == Way::sequential && row.submeshes != Submeshes::own_choice,
                      "the sequential method has no submeshes"},
    };
    const auto first = std::ranges::find(contradictions, true, &Contradiction::is_there);
    return first == contradictions.end() ? std::string_view{} : first->why;
}

namespace {

struct Setting {
    std::size_t feature;
    std::uint8_t value;
};
using Combination = std::vector<Setting>;

// Adds to `all` the combinations of `strength` settings that begin with `chosen` and go on with
// features from `feature` on.
void add_combinations(const Combination& chosen, std::size_t feature, std::size_t strength,
                      std::vector<Combination>& all) {
    if (chosen.size() == strength) {
        all.push_back(chosen);
        return;
    }
    for (; feature < features().size(); ++feature) {
        for (std::uint8_t value = 0; value < features()[feature].values.size(); ++value) {
            Combination more = chosen;
            more.push_back({feature, value});
            add_combinations(more, feature + 1, strength, all);
        }
    }
}

bool stands_in(const Combination& combination, const Values& row) {
    return std::ranges::all_of(combination,
                               [&](const Setting& one) { return row[one.feature] == one.value; });
}

// Draws random meaningful rows with this combination, and returns the one with the most open
// combinations; none if no meaningful row was found.
std::optional<Values> draw_row(const Combination& combination, std::span<const Combination> open,
                               test::Dice& dice) {
    constexpr int candidates = 30;
    constexpr int draws = 20'000; // at worst, one in a few thousand is meaningful
    std::optional<Values> best;
    std::ptrdiff_t largest = 0;
    for (int draw = 0, found = 0; draw < draws && found < candidates; ++draw) {
        Values row;
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<std::uint8_t>(
                dice.in(0, static_cast<int>(features()[i].values.size()) - 1));
        }
        for (const auto& [feature, value] : combination) {
            row[feature] = value;
        }
        if (!nonsense_in(row_of(row)).empty()) {
            continue;
        }
        ++found;
        const auto closed =
            std::ranges::count_if(open, [&](const auto& one) { return stands_in(one, row); });
        if (closed > largest) {
            best = row;
            largest = closed;
        }
    }
    return best;
}

} // namespace

Cover cover_features(std::size_t strength, std::uint64_t seed) {
    Cover cover;
    test::Dice dice(seed);
    std::vector<Combination> open;
    add_combinations({}, 0, strength, open);
    while (!open.empty()) {
        const std::optional<Values> row = draw_row(open.back(), open, dice);
        if (!row) {
            ++cover.senseless;
            open.pop_back();
            continue;
        }
        cover.rows.push_back(*row);
        cover.combinations +=
            std::erase_if(open, [&](const Combination& one) { return stands_in(one, *row); });
    }
    return cover;
}

namespace {

std::vector<Values> read_rows(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw std::runtime_error("cannot read " + path);
    }
    std::vector<Values> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line.front() != '#') {
            rows.push_back(values_of(line));
        }
    }
    return rows;
}

} // namespace

std::vector<Values> found_rows() { return read_rows(DSC_COMBINATIONS "/found.txt"); }
std::vector<Values> open_rows() { return read_rows(DSC_COMBINATIONS "/open.txt"); }

} // namespace dsc::combinations

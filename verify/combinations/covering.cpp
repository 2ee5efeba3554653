// SPDX-License-Identifier: MIT
#include "combinations/covering.h"

#include "support/random/scene.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>

namespace dsc::combinations {

namespace {

using Bits = std::vector<std::uint8_t>;

// A few features, and which combinations of their values are still to come.
struct Group {
    std::vector<std::size_t> features;
    Bits is_open; ///< by the number of the combination
};

class Covering {
public:
    explicit Covering(const CoverTask& task)
        : task_(task), n_(task.counts.size()), dice_(task.seed) {
        add_groups({}, 0);
        groups_with_.resize(n_);
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            for (const std::size_t feature : groups_[g].features) {
                groups_with_[feature].push_back(g);
            }
        }
        row_.resize(n_);
        is_set_ = std::make_unique<bool[]>(n_); // not vector<bool>: a span is handed on
    }

    Cover run() {
        Cover result;
        for (const Group& group : groups_) {
            result.combinations += group.is_open.size();
        }
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            for (std::size_t code = 0; code < groups_[g].is_open.size(); ++code) {
                if (groups_[g].is_open[code] == 0) {
                    continue;
                }
                std::optional<Bits> best = best_with(groups_[g], code);
                if (!best) {
                    groups_[g].is_open[code] = 0;
                    ++result.senseless;
                    continue;
                }
                result.covered += close(*best);
                result.rows.push_back(std::move(*best));
            }
        }
        result.combinations -= result.senseless;
        return result;
    }

private:
    void add_groups(std::vector<std::size_t> chosen, std::size_t from) {
        if (chosen.size() == task_.strength) {
            std::size_t combinations = 1;
            for (const std::size_t feature : chosen) {
                combinations *= task_.counts[feature];
            }
            groups_.push_back({chosen, Bits(combinations, 1)});
            return;
        }
        for (std::size_t feature = from; feature < n_; ++feature) {
            chosen.push_back(feature);
            add_groups(chosen, feature + 1);
            chosen.pop_back();
        }
    }

    std::size_t code_of(const Group& group, const Bits& row) const {
        std::size_t code = 0;
        for (const std::size_t feature : group.features) {
            code = code * task_.counts[feature] + row[feature];
        }
        return code;
    }

    bool makes_sense() const { return task_.makes_sense(row_, {is_set_.get(), n_}); }

    // The best of some rows with this combination; none if it stands in no row.
    std::optional<Bits> best_with(const Group& group, std::size_t code) {
        constexpr int trials = 10;
        constexpr std::size_t first = 4;
        std::optional<Bits> best;
        std::size_t most = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::fill_n(is_set_.get(), n_, false);
            std::size_t rest = code;
            for (std::size_t i = group.features.size(); i-- > 0;) {
                const std::size_t feature = group.features[i];
                row_[feature] = static_cast<std::uint8_t>(rest % task_.counts[feature]);
                rest /= task_.counts[feature];
                is_set_[feature] = true;
            }
            std::vector<std::size_t> order;
            for (std::size_t feature = 0; feature < n_; ++feature) {
                if (!is_set_[feature]) {
                    order.push_back(feature);
                }
            }
            for (std::size_t i = order.size(); i > 1; --i) {
                std::swap(order[i - 1],
                          order[static_cast<std::size_t>(dice_.in(0, static_cast<int>(i) - 1))]);
            }
            // The first features decide which others make sense: a contradiction shows at once.
            std::ranges::stable_partition(order,
                                          [](std::size_t feature) { return feature < first; });
            if (!makes_sense() || !fill(order, 0)) {
                return best; // what comes first is searched completely
            }
            if (const std::size_t gain = open_in(row_); gain > most) {
                most = gain;
                best = row_;
            }
        }
        return best;
    }

    // Gives the features from `at` on their values, those that close most combinations first.
    bool fill(std::span<const std::size_t> order, std::size_t at) {
        if (at == order.size()) {
            return true;
        }
        const std::size_t feature = order[at];
        std::vector<std::pair<std::size_t, std::uint8_t>> ranked;
        is_set_[feature] = true;
        for (std::uint8_t value = 0; value < task_.counts[feature]; ++value) {
            row_[feature] = value;
            if (makes_sense()) {
                ranked.emplace_back(
                    2 * open_with(feature) * 16 + static_cast<std::size_t>(dice_.in(0, 15)), value);
            }
        }
        std::ranges::sort(ranked, std::greater{});
        for (const auto& [gain, value] : ranked) {
            row_[feature] = value;
            if (fill(order, at + 1)) {
                return true;
            }
        }
        is_set_[feature] = false;
        return false;
    }

    // Open combinations of this feature with those that are set.
    std::size_t open_with(std::size_t feature) const {
        std::size_t count = 0;
        for (const std::size_t g : groups_with_[feature]) {
            const Group& group = groups_[g];
            if (std::ranges::all_of(group.features, [&](std::size_t f) { return is_set_[f]; })) {
                count += group.is_open[code_of(group, row_)];
            }
        }
        return count;
    }

    std::size_t open_in(const Bits& row) const {
        return std::accumulate(groups_.begin(), groups_.end(), std::size_t{0},
                               [&](std::size_t sum, const Group& group) {
                                   return sum + group.is_open[code_of(group, row)];
                               });
    }

    std::size_t close(const Bits& row) {
        std::size_t count = 0;
        for (Group& group : groups_) {
            std::uint8_t& one = group.is_open[code_of(group, row)];
            count += one;
            one = 0;
        }
        return count;
    }

    const CoverTask& task_;
    std::size_t n_;
    test::Dice dice_;
    std::vector<Group> groups_;
    std::vector<std::vector<std::size_t>> groups_with_; ///< by feature: their numbers
    Bits row_;
    std::unique_ptr<bool[]> is_set_; // NOLINT: a span of bool
};

} // namespace

Cover cover(const CoverTask& task) { return Covering(task).run(); }

} // namespace dsc::combinations

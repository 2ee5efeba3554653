// SPDX-License-Identifier: MIT
#include "fluid/solve/factors.h"

#include "fluid/solve/dense.h"
#include "fluid/system/share_out.h"

#include <algorithm>
#include <atomic>
#include <iterator>

namespace dsc {

namespace {

// Eliminates part by part.
class Elimination {
public:
    Elimination(const FluidSystem& system, const Dissection& dissection,
                const FluidNumbering& numbers, double pressure_mass, Factors& factors)
        : system_(system), dissection_(dissection), numbers_(numbers),
          pressure_mass_(pressure_mass), factors_(factors), is_good_(dissection.parts.size(), 0) {
        factors_.parts.resize(dissection.parts.size());
    }

    void run(std::uint32_t threads) {
        // Each task eliminates a part of this depth with all its sub-parts; a part above them is
        // eliminated by the thread that finishes its second half.
        std::uint32_t depth = 0;
        while (threads > 1 && 1U << depth < 4 * threads) {
            ++depth;
        }
        const std::vector<MeshPart>& parts = dissection_.parts;
        std::vector<std::size_t> shares;
        std::vector<std::size_t> whole_of(parts.size(), parts.size());
        for (std::size_t p = 0; p < parts.size(); ++p) {
            const bool has_halves = parts[p].halves[0] != no_id;
            if (has_halves && parts[p].depth < depth) {
                whole_of[parts[p].halves[0]] = p;
                whole_of[parts[p].halves[1]] = p;
            } else if (parts[p].depth <= depth) {
                shares.push_back(p);
            }
        }
        const auto has_first_half = std::make_unique<std::atomic<bool>[]>(parts.size());
        share_out(
            shares.size(), threads,
            [&](std::size_t i) {
                Places places;
                std::size_t p = shares[i];
                run_all(p, places);
                for (p = whole_of[p]; p < parts.size() && has_first_half[p].exchange(true);
                     p = whole_of[p]) {
                    run_one(p, places);
                }
            },
            1);
        factors_.has_all_pivots =
            std::ranges::all_of(is_good_, [](std::uint8_t good) { return good != 0; });
    }

private:
    using Places = std::vector<std::uint32_t>; // of unknowns in a leaf of the dissection

    void run_all(std::size_t p, Places& places) {
        for (const std::uint32_t half : dissection_.parts[p].halves) {
            if (half != no_id) {
                run_all(half, places);
            }
        }
        run_one(p, places);
    }
    void run_one(std::size_t p, Places& places) {
        const MeshPart& part = dissection_.parts[p];
        PartFactors& own = factors_.parts[p];
        own.first = numbers_.first_of_part[p];
        own.count = numbers_.first_of_part[p + 1] - own.first;
        const bool has_halves = part.halves[0] != no_id;
        own.border =
            has_halves ? border_of_halves(part, own) : border_of_triangles(part, own, places);
        own.pivots.resize(own.count);
        own.lower.assign(own.height() * own.count, 0);
        const std::size_t border = own.border.size();
        own.left = std::make_unique_for_overwrite<double[]>(border * border);
        for (std::size_t j = 0; j < border;
             ++j) { // begins just above the diagonal, which is read too
            const std::size_t first = j - std::min<std::size_t>(j, 1);
            std::fill_n(own.left.get() + j * border + first, border - first, 0.0);
        }
        if (has_halves) {
            for (const std::uint32_t half : part.halves) {
                add(factors_.parts[half], own);
                factors_.parts[half].left = nullptr;
            }
        } else {
            for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
                add(system_.elements[dissection_.triangles[part.first_triangle + i]], own, places);
            }
        }
        const bool is_good =
            eliminate(own.count, own.height(), own.lower.data(), own.pivots.data(), own.left.get());
        is_good_[p] = is_good ? 1 : 0;
    }

    [[nodiscard]] std::vector<std::uint32_t> border_of_halves(const MeshPart& part,
                                                              const PartFactors& own) const {
        const std::vector<std::uint32_t>& a = factors_.parts[part.halves[0]].border;
        const std::vector<std::uint32_t>& b = factors_.parts[part.halves[1]].border;
        const std::uint32_t end = own.first + own.count;
        std::vector<std::uint32_t> border;
        border.reserve(a.size() + b.size());
        std::set_union(std::ranges::lower_bound(a, end), a.end(), std::ranges::lower_bound(b, end),
                       b.end(), std::back_inserter(border));
        return border;
    }
    // Also sets the places of the unknowns.
    [[nodiscard]] std::vector<std::uint32_t>
    border_of_triangles(const MeshPart& part, const PartFactors& own, Places& places) const {
        places.resize(static_cast<std::size_t>(system_.size));
        for_each_unknown(part, [&](std::uint32_t unknown) { places[unknown] = no_id; });
        for (std::uint32_t i = 0; i < own.count; ++i) {
            places[own.first + i] = i;
        }
        std::vector<std::uint32_t> border;
        for_each_unknown(part, [&](std::uint32_t unknown) {
            if (places[unknown] == no_id) {
                places[unknown] = 0; // temporarily marks it as known
                border.push_back(unknown);
            }
        });
        std::ranges::sort(border);
        for (std::uint32_t place = own.count; const std::uint32_t unknown : border) {
            places[unknown] = place++;
        }
        return border;
    }
    template <class Visit>
    void for_each_unknown(const MeshPart& part, Visit visit) const {
        for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
            const std::uint32_t t = dissection_.triangles[part.first_triangle + i];
            for (const int unknown : system_.elements[t].unknowns) {
                if (unknown != no_unknown) {
                    visit(static_cast<std::uint32_t>(unknown));
                }
            }
        }
    }

    // The begin of column `place` of a part, counted from its first row.
    static double* column(PartFactors& own, std::size_t place) {
        return place < own.count ? own.lower.data() + place * own.height()
                                 : own.left.get() + (place - own.count) * own.border.size();
    }
    void add(const FluidElement& element, PartFactors& own, const Places& places) const {
        std::array<std::pair<std::size_t, Eigen::Index>, 15>
            rows; // positions in the part, and in the element
        std::size_t n = 0;
        for (Eigen::Index i = 0; const int unknown : element.unknowns) {
            if (unknown != no_unknown) {
                rows[n++] = {places[static_cast<std::size_t>(unknown)], i};
            }
            ++i;
        }
        std::sort(rows.begin(), rows.begin() + n);
        for (std::size_t k = 0; k < n; ++k) {
            const auto [place, j] = rows[k];
            const std::size_t above = place < own.count ? 0 : own.count;
            double* const target = column(own, place);
            for (std::size_t m = k; m < n; ++m) {
                target[rows[m].first - above] += element.matrix(rows[m].second, j);
            }
            if (j >= 12) {
                target[place - above] -= pressure_mass_ * element.pressure_scale;
            }
        }
    }
    // Consecutive unknowns of a half that are also consecutive in the part.
    struct Run {
        std::size_t from;  // in the half's border
        std::size_t place; // in the part
        std::size_t count;
    };
    static std::vector<Run> runs_of(const PartFactors& half, const PartFactors& own) {
        std::vector<Run> runs;
        std::size_t place = 0;
        for (std::size_t i = 0; i < half.border.size(); ++i) {
            const std::uint32_t unknown = half.border[i];
            if (unknown < own.first + own.count) {
                place = unknown - own.first;
            } else {
                place = std::max<std::size_t>(place, own.count);
                while (own.border[place - own.count] != unknown) {
                    ++place;
                }
            }
            const bool begins = runs.empty() || place != runs.back().place + runs.back().count ||
                                place == own.count;
            if (begins) {
                runs.push_back({i, place, 0});
            }
            ++runs.back().count;
        }
        return runs;
    }
    static void add(const PartFactors& half, PartFactors& own) {
        const std::vector<Run> runs = runs_of(half, own);
        const std::size_t n = half.border.size();
        for (auto run = runs.begin(); run != runs.end(); ++run) {
            for (std::size_t k = 0; k < run->count; ++k) {
                const std::size_t j = run->from + k;
                const double* const source = half.left.get() + j * n;
                const std::size_t above = run->place < own.count ? 0 : own.count;
                double* const target = column(own, run->place + k);
                add(source + j, target + (run->place + k - above), run->count - k);
                for (auto below = run + 1; below != runs.end(); ++below) {
                    add(source + below->from, target + (below->place - above), below->count);
                }
            }
        }
    }
    static void add(const double* __restrict source, double* __restrict target, std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            target[i] += source[i];
        }
    }

    const FluidSystem& system_;
    const Dissection& dissection_;
    const FluidNumbering& numbers_;
    double pressure_mass_;
    Factors& factors_;
    std::vector<std::uint8_t> is_good_; // by part
};

} // namespace

Factors factorise(const FluidSystem& system, const Dissection& dissection,
                  const FluidNumbering& numbers, double pressure_mass, std::uint32_t threads) {
    Factors factors;
    Elimination(system, dissection, numbers, pressure_mass, factors).run(threads);
    return factors;
}

void solve_in_place(const Factors& factors, Eigen::VectorXd& vector) {
    std::vector<double> values; // of a part
    for (const PartFactors& part : factors.parts) {
        double* const first = vector.data() + part.first;
        values.assign(first, first + part.count);
        values.resize(part.height(), 0);
        substitute_forward(part.count, part.height(), part.lower.data(), values.data());
        std::copy_n(values.begin(), part.count, first);
        for (std::size_t i = part.count; const std::uint32_t unknown : part.border) {
            vector[unknown] += values[i++];
        }
    }
    for (auto part = factors.parts.rbegin(); part != factors.parts.rend(); ++part) {
        double* const first = vector.data() + part->first;
        values.assign(first, first + part->count);
        for (const std::uint32_t unknown : part->border) {
            values.push_back(vector[unknown]);
        }
        substitute_backward(part->count, part->height(), part->lower.data(), part->pivots.data(),
                            values.data());
        std::copy_n(values.begin(), part->count, first);
    }
}

} // namespace dsc

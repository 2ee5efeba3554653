// SPDX-License-Identifier: MIT
#include "thesis/algorithm/selection.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc {

namespace {

template <class Simplex>
struct Rated {
    double quality;
    Simplex simplex;

    friend bool operator<(const Rated& a, const Rated& b) {
        return a.quality != b.quality ? a.quality < b.quality : a.simplex < b.simplex;
    }
};

// NaN would break the order: it is replaced by the worst quality.
template <class Simplex>
Rated<Simplex> rate(Simplex simplex, const QualityFunction<Simplex>& quality) {
    const double value = quality(simplex);
    return {std::isnan(value) ? -std::numeric_limits<double>::infinity() : value, simplex};
}

template <class Simplex>
std::vector<Simplex> in_order(std::vector<Rated<Simplex>>& rated) {
    std::sort(rated.begin(), rated.end());
    std::vector<Simplex> chosen;
    chosen.reserve(rated.size());
    for (const Rated<Simplex>& r : rated) {
        chosen.push_back(r.simplex);
    }
    return chosen;
}

} // namespace

template <class Simplex>
SelectionStrategy<Simplex> below(double threshold) {
    return
        [threshold](std::span<const Simplex> candidates, const QualityFunction<Simplex>& quality) {
            std::vector<Rated<Simplex>> rated;
            for (const Simplex simplex : candidates) {
                const Rated<Simplex> r = rate(simplex, quality);
                if (r.quality < threshold) {
                    rated.push_back(r);
                }
            }
            return in_order(rated);
        };
}

template <class Simplex>
SelectionStrategy<Simplex> n_worst(std::size_t n) {
    return [n](std::span<const Simplex> candidates, const QualityFunction<Simplex>& quality) {
        std::vector<Rated<Simplex>> rated;
        rated.reserve(candidates.size());
        for (const Simplex simplex : candidates) {
            rated.push_back(rate(simplex, quality));
        }
        if (n < rated.size()) {
            const auto end = rated.begin() + static_cast<std::ptrdiff_t>(n);
            std::nth_element(rated.begin(), end, rated.end());
            rated.erase(end, rated.end());
        }
        return in_order(rated);
    };
}

template <class Simplex>
Simplex Selection<Simplex>::get_next() {
    if (!has_next()) {
        throw InvariantError("Selection::get_next: no simplex left; call has_next first");
    }
    return chosen_[next_++];
}

#define DSC_INSTANTIATE(Simplex)                                                                   \
    template SelectionStrategy<Simplex> below(double);                                             \
    template SelectionStrategy<Simplex> n_worst(std::size_t);                                      \
    template class Selection<Simplex>;
DSC_INSTANTIATE(Vertex)
DSC_INSTANTIATE(Edge)
DSC_INSTANTIATE(Triangle)
#undef DSC_INSTANTIATE

} // namespace dsc

// SPDX-License-Identifier: MIT
// Selection strategies (thesis, section 8.8): the choice of the simplices on which a mesh update
// works. A strategy is a function from a quality measure and simplices to the chosen ones, and an
// application may write its own (algorithm 5.2 then calls `has_next` and `get_next`).
//
// "Worst" is the smallest quality. For a measure whose large values are bad (a length, an area),
// give its negative.
#pragma once

#include "thesis/sets/simplex_set.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace dsc {

/// The quality of one simplex; any measure of `measures.h`, or the application's own.
template <class Simplex>
using QualityFunction = std::function<double(Simplex)>;

/// Chooses some of the candidates and orders them, the most urgent first.
template <class Simplex>
using SelectionStrategy = std::function<std::vector<Simplex>(
    std::span<const Simplex> candidates, const QualityFunction<Simplex>& quality)>;

/// The simplices whose quality is below the threshold, worst first, ties by id. NaN counts as
/// worst. O(n + k log k) for k chosen.
template <class Simplex>
[[nodiscard]] SelectionStrategy<Simplex> below(double threshold);

/// The `n` simplices of lowest quality (all, where there are fewer), worst first, ties by id: the
/// result does not depend on the order of the candidates. NaN counts as worst. O(m + n log n) for m
/// candidates.
template <class Simplex>
[[nodiscard]] SelectionStrategy<Simplex> n_worst(std::size_t n);

/// The chosen simplices one by one: `HasNext` and `GetNext` of algorithm 5.2. The choice is made
/// once, at the start; if an operation has since removed a simplex, the guard of the next one
/// refuses it.
template <class Simplex>
class Selection {
public:
    /// Makes the choice, at the cost of the strategy.
    Selection(std::span<const Simplex> candidates, const QualityFunction<Simplex>& quality,
              const SelectionStrategy<Simplex>& strategy)
        : chosen_(strategy(candidates, quality)) {}

    /// Whether there is another one.
    [[nodiscard]] bool has_next() const { return next_ < chosen_.size(); }
    /// \pre has_next(); throws InvariantError otherwise.
    Simplex get_next();
    /// How many were chosen.
    [[nodiscard]] std::size_t size() const { return chosen_.size(); }

private:
    std::vector<Simplex> chosen_;
    std::size_t next_ = 0;
};

extern template class Selection<Vertex>;
extern template class Selection<Edge>;
extern template class Selection<Triangle>;

} // namespace dsc

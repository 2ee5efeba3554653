// SPDX-License-Identifier: MIT
// Selection strategies of the thesis, section 8.8 behind the HasNext and GetNext of algorithm 5.2,
// and MeshUpdate itself. Low quality is bad: measures whose large values are bad have the opposite
// sign.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace dsc::reference {

/// Q(s): a number for a simplex of K.
template <class Simplex>
using Measure = std::function<double(const Simplex&)>;

/// The interface of all selection strategies.
template <class Simplex>
class Selection {
public:
    virtual ~Selection() = default;
    /// Are there more simplices to update?
    virtual bool has_next() = 0;
    /// The next simplex to update; requires has_next().
    virtual Simplex get_next() = 0;
};

/// The simplices with a quality below a threshold, the worst first. Operations change their
/// surroundings, so a simplex is measured again before its update, and skipped if it has vanished
/// or become good.
template <class Simplex>
class BelowThreshold final : public Selection<Simplex> {
public:
    template <class Range>
    BelowThreshold(const Range& sigma, Measure<Simplex> measure, double threshold, const Complex& K)
        : measure_(std::move(measure)), threshold_(threshold), K_(K) {
        for (const Simplex& s : sigma) {
            if (const double q = measure_(s); q < threshold_) {
                chosen_.emplace_back(q, s);
            }
        }
        std::sort(chosen_.begin(), chosen_.end());
    }

    bool has_next() override {
        while (next_ < chosen_.size()) {
            const Simplex& s = chosen_[next_].second;
            if (K_.is_valid_simplex(s) && measure_(s) < threshold_) {
                return true;
            }
            ++next_;
        }
        return false;
    }
    Simplex get_next() override { return chosen_[next_++].second; }

private:
    Measure<Simplex> measure_;
    double threshold_;
    const Complex& K_;
    std::vector<std::pair<double, Simplex>> chosen_;
    std::size_t next_ = 0;
};

/// The n simplices of lowest quality, the worst first; vanished ones are skipped.
template <class Simplex>
class WorstN final : public Selection<Simplex> {
public:
    template <class Range>
    WorstN(const Range& sigma, const Measure<Simplex>& measure, std::size_t n, const Complex& K)
        : K_(K) {
        for (const Simplex& s : sigma) {
            chosen_.emplace_back(measure(s), s);
        }
        n = std::min(n, chosen_.size());
        std::partial_sort(chosen_.begin(), chosen_.begin() + static_cast<std::ptrdiff_t>(n),
                          chosen_.end());
        chosen_.resize(n);
    }

    bool has_next() override {
        while (next_ < chosen_.size() && !K_.is_valid_simplex(chosen_[next_].second)) {
            ++next_;
        }
        return next_ < chosen_.size();
    }
    Simplex get_next() override { return chosen_[next_++].second; }

private:
    const Complex& K_;
    std::vector<std::pair<double, Simplex>> chosen_;
    std::size_t next_ = 0;
};

/// Algorithm 5.2. Returns how many times the operation was legal.
template <class Simplex, class Operation>
std::size_t mesh_update(Selection<Simplex>&& Q, const Operation& op, Complex& K) {
    std::size_t done = 0;
    while (Q.has_next()) {
        const Simplex s = Q.get_next();
        if (op(s, K) == Verdict::legal) {
            ++done;
        }
    }
    return done;
}

} // namespace dsc::reference

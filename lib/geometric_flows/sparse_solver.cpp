// SPDX-License-Identifier: MIT
#include "geometric_flows/sparse_solver.h"

#include <Eigen/OrderingMethods>

#include <algorithm>

namespace dsc {

// Writes values straight to their places in the ordered matrix: to build a matrix and have the
// solver permute it takes as long as the factorisation.
bool SparseSolver::factorise(Eigen::Index size, const Entries& entries) {
    if (!has_known_slots(size, entries)) {
        find_slots(size, entries);
    }
    double* values = ordered_.valuePtr();
    std::fill_n(values, ordered_.nonZeros(), 0.0);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        values[slots_[k].value] += entries[k].value();
    }
    solver_.factorize(ordered_);
    return is_solvable();
}

bool SparseSolver::has_known_slots(Eigen::Index size, const Entries& entries) const {
    return ordered_.cols() == size &&
           std::ranges::equal(entries, slots_, [](const auto& entry, const Slot& slot) {
               return entry.row() == slot.row && entry.col() == slot.column;
           });
}

bool SparseSolver::has_known_pattern(const Matrix& lower) const {
    const Matrix& a = lower;
    const Matrix& b = analysed_;
    return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

void SparseSolver::find_slots(Eigen::Index size, const Entries& entries) {
    Matrix lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    if (!has_known_pattern(lower)) {
        find_order(lower);
        analysed_ = std::move(lower);
    }
    slots_.clear();
    for (const auto& entry : entries) {
        const auto [row, column] =
            std::minmax(order_.indices()[entry.row()], order_.indices()[entry.col()]);
        const int* rows = ordered_.innerIndexPtr();
        const int* begin = rows + ordered_.outerIndexPtr()[column];
        const int* end = rows + ordered_.outerIndexPtr()[column + 1];
        const auto value = static_cast<int>(std::find(begin, end, row) - rows);
        slots_.push_back({entry.row(), entry.col(), value});
    }
}

// Finds an ordering by minimum degree.
void SparseSolver::find_order(const Matrix& lower) {
    const auto whole = lower.selfadjointView<Eigen::Lower>();
    decltype(order_) inverse;
    Eigen::AMDOrdering<int>()(Matrix(whole), inverse);
    order_ = inverse.inverse();
    ordered_.resize(lower.rows(), lower.cols());
    ordered_.selfadjointView<Eigen::Upper>() = whole.twistedBy(order_);
    solver_.analyzePattern(ordered_);
}

} // namespace dsc

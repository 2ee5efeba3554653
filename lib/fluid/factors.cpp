// SPDX-License-Identifier: MIT
#include "fluid/factors.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

// The elimination tree, and how many rows each column of L has below the diagonal. J. W. H. Liu,
// "The role of elimination trees in sparse factorization" (1990).
struct EliminationTree {
    std::vector<std::uint32_t> parent; // no_id: a root
    std::vector<std::uint32_t> rows;
};

// Calls `visit(row, column)` for each entry above the diagonal, row of L by row.
template <class Visit>
void for_each_above(const Sparse& upper, Visit visit) {
    const auto n = static_cast<std::uint32_t>(upper.cols());
    for (std::uint32_t row = 0; row < n; ++row) {
        for (Sparse::InnerIterator entry(upper, row); entry; ++entry) {
            if (const auto column = static_cast<std::uint32_t>(entry.row()); column < row) {
                visit(row, column);
            }
        }
    }
}

EliminationTree elimination_tree(const Sparse& upper) {
    const auto n = static_cast<std::size_t>(upper.cols());
    EliminationTree tree{std::vector<std::uint32_t>(n, no_id), std::vector<std::uint32_t>(n, 0)};
    std::vector<std::uint32_t> seen(n, no_id);
    for_each_above(upper, [&](std::uint32_t row, std::uint32_t column) {
        for (std::uint32_t i = column; i != row && seen[i] != row; i = tree.parent[i]) {
            if (tree.parent[i] == no_id) {
                tree.parent[i] = row;
            }
            ++tree.rows[i];
            seen[i] = row;
        }
    });
    return tree;
}

// A column has the same rows as the next one if it has one more of them, and the next is the first.
std::vector<FrontColumns> cut_into_fronts(const EliminationTree& tree) {
    std::vector<FrontColumns> fronts;
    for (std::uint32_t first = 0; first < tree.parent.size();) {
        std::uint32_t last = first;
        while (tree.parent[last] == last + 1 && tree.rows[last] == tree.rows[last + 1] + 1) {
            ++last;
        }
        fronts.push_back({.first = first, .count = last + 1 - first});
        first = last + 1;
    }
    return fronts;
}

// The rows of each front: those at which the paths up the tree arrive, row by row.
void find_rows(std::vector<FrontColumns>& fronts, const EliminationTree& tree,
               const Sparse& upper) {
    std::vector<std::uint32_t> front_of(tree.parent.size());
    for (std::uint32_t f = 0; f < fronts.size(); ++f) {
        std::fill_n(front_of.begin() + fronts[f].first, fronts[f].count, f);
    }
    std::vector<std::uint32_t> above(fronts.size(), no_id);
    for (std::uint32_t f = 0; f < fronts.size(); ++f) {
        const std::uint32_t parent = tree.parent[fronts[f].first + fronts[f].count - 1];
        if (parent != no_id) {
            above[f] = front_of[parent];
            fronts[above[f]].children.push_back(f);
        }
    }
    std::vector<std::uint32_t> seen(fronts.size(), no_id);
    for_each_above(upper, [&](std::uint32_t row, std::uint32_t column) {
        for (std::uint32_t f = front_of[column]; f != front_of[row] && seen[f] != row;
             f = above[f]) {
            seen[f] = row;
            fronts[f].rows.push_back(row);
        }
    });
}

// target[i] -= a[i] * p + b[i] * q + c[i] * r + d[i] * s, in this order on any processor.
void subtract(double* __restrict target, std::size_t n, const double* __restrict lower,
              std::size_t stride, const std::array<double, 4>& by) {
    const double* __restrict a = lower;
    const double* __restrict b = lower + stride;
    const double* __restrict c = lower + 2 * stride;
    const double* __restrict d = lower + 3 * stride;
    const auto [p, q, r, s] = by;
    for (std::size_t i = 0; i < n; ++i) {
        target[i] -= (a[i] * p + b[i] * q) + (c[i] * r + d[i] * s);
    }
}

void subtract(double* __restrict target, std::size_t n, const double* __restrict column,
              double by) {
    for (std::size_t i = 0; i < n; ++i) {
        target[i] -= column[i] * by;
    }
}

// The sum of all products, in eight sums on any processor.
double product(const double* a, const double* b, std::size_t n) {
    std::array<double, 8> sums{};
    std::size_t i = 0;
    for (; i + 8 <= n; i += 8) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            sums[lane] += a[i + lane] * b[i + lane];
        }
    }
    for (std::size_t lane = 0; i < n; ++i, ++lane) {
        sums[lane] += a[i] * b[i];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) +
           ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

// Eliminates the first columns of a dense symmetric matrix of which the lower triangle is given, by
// column, four at a time. Leaves L in the columns, and in the rest what remains for the next ones.
bool eliminate(std::vector<double>& front, std::size_t height, std::size_t columns,
               std::vector<double>& pivots) {
    const auto column = [&](std::size_t j) { return front.data() + j * height; };
    bool is_good = true;
    pivots.resize(columns);
    for (std::size_t begin = 0; begin < columns; begin += 4) {
        const std::size_t end = std::min(begin + 4, columns);
        for (std::size_t k = begin; k < end; ++k) {
            const double pivot = pivots[k] = column(k)[k];
            is_good = is_good && std::isfinite(pivot) && pivot != 0;
            for (std::size_t j = k + 1; j < end; ++j) {
                subtract(column(j) + j, height - j, column(k) + j, column(k)[j] / pivot);
            }
            for (std::size_t i = k + 1; i < height; ++i) {
                column(k)[i] /= pivot;
            }
        }
        for (std::size_t j = end; j < height; ++j) {
            if (end - begin == 4) {
                subtract(column(j) + j, height - j, column(begin) + j, height,
                         {column(begin)[j] * pivots[begin],
                          column(begin + 1)[j] * pivots[begin + 1],
                          column(begin + 2)[j] * pivots[begin + 2],
                          column(begin + 3)[j] * pivots[begin + 3]});
                continue;
            }
            for (std::size_t k = begin; k < end; ++k) {
                subtract(column(j) + j, height - j, column(k) + j, column(k)[j] * pivots[k]);
            }
        }
    }
    return is_good;
}

// Eliminates front by front; what is left of each is added to the front above it.
class Elimination {
public:
    Elimination(const Sparse& lower, SparseFactors& factors)
        : lower_(lower), factors_(factors), place_(factors.size), left_(factors.fronts.size()) {}

    void run() {
        for (std::size_t f = 0; f < factors_.fronts.size(); ++f) {
            FrontColumns& front = factors_.fronts[f];
            const std::size_t height = front.height();
            gather(front);
            if (!eliminate(dense_, height, front.count, front.pivots)) {
                factors_.has_all_pivots = false;
            }
            front.lower.assign(dense_.data(), dense_.data() + height * front.count);
            left_[f].reserve(front.rows.size() * (front.rows.size() + 1) / 2);
            for (std::size_t j = front.count; j < height; ++j) {
                const double* const column = dense_.data() + j * height;
                left_[f].insert(left_[f].end(), column + j, column + height);
            }
        }
    }

private:
    void gather(const FrontColumns& front) {
        const std::size_t height = front.height();
        dense_.assign(height * height, 0);
        for (std::uint32_t k = 0; k < front.count; ++k) {
            place_[front.first + k] = k;
        }
        for (std::uint32_t k = front.count; const std::uint32_t row : front.rows) {
            place_[row] = k++;
        }
        for (std::uint32_t k = 0; k < front.count; ++k) {
            for (Sparse::InnerIterator entry(lower_, front.first + k); entry; ++entry) {
                dense_[k * height + place_[static_cast<std::size_t>(entry.row())]] = entry.value();
            }
        }
        for (const std::uint32_t child : front.children) {
            add(factors_.fronts[child], left_[child], height);
            left_[child] = {};
        }
    }
    void add(const FrontColumns& child, const std::vector<double>& left, std::size_t height) {
        const double* source = left.data();
        for (std::size_t j = 0; j < child.rows.size(); ++j) {
            double* const target = dense_.data() + place_[child.rows[j]] * height;
            for (std::size_t i = j; i < child.rows.size(); ++i) {
                target[place_[child.rows[i]]] += *source++;
            }
        }
    }

    const Sparse& lower_;
    SparseFactors& factors_;
    std::vector<double> dense_;
    std::vector<std::uint32_t> place_;      // of a row in the front
    std::vector<std::vector<double>> left_; // by front: a lower triangle, until it is added
};

} // namespace

SparseFactors factorise(const Sparse& lower) {
    SparseFactors factors{.size = static_cast<std::uint32_t>(lower.cols())};
    const Sparse upper = lower.transpose();
    const EliminationTree tree = elimination_tree(upper);
    factors.fronts = cut_into_fronts(tree);
    find_rows(factors.fronts, tree, upper);
    Elimination(lower, factors).run();
    return factors;
}

void solve_in_place(const SparseFactors& factors, Eigen::VectorXd& vector) {
    std::vector<double> values; // at the columns and rows of a front
    for (const FrontColumns& front : factors.fronts) {
        const double* const first = vector.data() + front.first;
        values.assign(first, first + front.count);
        values.resize(front.height(), 0);
        for (std::size_t k = 0; k < front.count; ++k) {
            const double* const column = front.lower.data() + k * front.height();
            subtract(values.data() + k + 1, front.height() - k - 1, column + k + 1, values[k]);
        }
        std::copy_n(values.begin(), front.count, vector.data() + front.first);
        for (std::size_t i = front.count; const std::uint32_t row : front.rows) {
            vector[row] += values[i++];
        }
    }
    for (auto front = factors.fronts.rbegin(); front != factors.fronts.rend(); ++front) {
        values.resize(front->height());
        for (std::size_t i = front->count; const std::uint32_t row : front->rows) {
            values[i++] = vector[row];
        }
        for (std::size_t k = front->count; k-- > 0;) {
            const double* const column = front->lower.data() + k * front->height();
            const double value = vector[static_cast<Eigen::Index>(front->first + k)];
            values[k] = value / front->pivots[k] -
                        product(values.data() + k + 1, column + k + 1, front->height() - k - 1);
        }
        std::copy_n(values.begin(), front->count, vector.data() + front->first);
    }
}

} // namespace dsc

// SPDX-License-Identifier: MIT
#include "fluid/solve/dense.h"

#include "fluid/solve/instruction_sets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

namespace {

using Four = std::array<double, 4>;

// Up to four neighbouring columns of L, eliminated together. Missing columns are replaced by the
// last one with a weight of 0.
struct Columns {
    std::array<const double*, 4> at;
    std::size_t count;

    Columns(const double* lower, std::size_t height, std::size_t begin, std::size_t end)
        : at{}, count(end - begin) {
        for (std::size_t k = 0; k < 4; ++k) {
            at[k] = lower + std::min(begin + k, end - 1) * height;
        }
    }
    // D times a row of L; `pivots` are those of these columns.
    [[nodiscard]] Four row(std::size_t row, const double* pivots) const {
        Four entries{};
        for (std::size_t k = 0; k < count; ++k) {
            entries[k] = at[k][row] * pivots[k];
        }
        return entries;
    }
};

// target[i] -= the sum of the columns at `row` + i, each times its weight.
inline void subtract(double* __restrict target, std::size_t n, const Columns& columns,
                     std::size_t row, const Four& weights) {
    const double* __restrict a = columns.at[0] + row;
    const double* __restrict b = columns.at[1] + row;
    const double* __restrict c = columns.at[2] + row;
    const double* __restrict d = columns.at[3] + row;
    const auto [p, q, r, s] = weights;
    for (std::size_t i = 0; i < n; ++i) {
        target[i] -= (a[i] * p + b[i] * q) + (c[i] * r + d[i] * s);
    }
}

// The same for two targets, so that the columns are read only once.
inline void subtract(double* __restrict target, double* __restrict second, std::size_t n,
                     const Columns& columns, std::size_t row, const Four& weights,
                     const Four& second_weights) {
    const double* __restrict a = columns.at[0] + row;
    const double* __restrict b = columns.at[1] + row;
    const double* __restrict c = columns.at[2] + row;
    const double* __restrict d = columns.at[3] + row;
    const auto [p, q, r, s] = weights;
    const auto [t, u, v, w] = second_weights;
    for (std::size_t i = 0; i < n; ++i) {
        target[i] -= (a[i] * p + b[i] * q) + (c[i] * r + d[i] * s);
        second[i] -= (a[i] * t + b[i] * u) + (c[i] * v + d[i] * w);
    }
}

// Subtracts L D L' of the columns from `width` columns of a lower triangle, the first of which
// begins at `target`, on the diagonal, and at row `row` of L.
void subtract_products(double* target, std::size_t stride, std::size_t width, std::size_t rows,
                       const Columns& columns, std::size_t row, const double* pivots) {
    std::size_t j = 0;
    for (; j + 2 <= width; j += 2) {
        double* const column = target + j * stride + j;
        subtract(column, column + stride, rows - j, columns, row + j, columns.row(row + j, pivots),
                 columns.row(row + j + 1, pivots));
    }
    if (j < width) {
        subtract(target + j * stride + j, rows - j, columns, row + j, columns.row(row + j, pivots));
    }
}

// The dot product, as eight partial sums on any processor.
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

// Eliminates neighbouring columns one by one, changing only these columns; `first` is on the
// diagonal.
bool eliminate_each(double* first, std::size_t height, std::size_t count, std::size_t rows,
                    double* pivots) {
    bool is_good = true;
    for (std::size_t k = 0; k < count; ++k) {
        double* const column = first + k * height;
        pivots[k] = column[k];
        const double inverse = 1 / pivots[k];
        is_good = is_good && std::isfinite(inverse) && inverse != 0;
        for (std::size_t j = k + 1; j < count; ++j) {
            double* const target = first + j * height;
            const double by = column[j] * inverse;
            for (std::size_t i = j; i < rows; ++i) {
                target[i] -= column[i] * by;
            }
        }
        for (std::size_t i = k + 1; i < rows; ++i) {
            column[i] *= inverse;
        }
    }
    return is_good;
}

// The same for four columns: first their first four rows, then all other rows, which are read only
// once.
bool eliminate_four(double* first, std::size_t height, std::size_t rows, double* pivots) {
    const bool is_good = eliminate_each(first, height, 4, 4, pivots);
    double* __restrict a = first;
    double* __restrict b = a + height;
    double* __restrict c = b + height;
    double* __restrict d = c + height;
    const double ba = a[1];
    const double ca = a[2];
    const double cb = b[2];
    const double da = a[3];
    const double db = b[3];
    const double dc = c[3];
    const Four inverse{1 / pivots[0], 1 / pivots[1], 1 / pivots[2], 1 / pivots[3]};
    const auto [p, q, r, s] = inverse;
    for (std::size_t i = 4; i < rows; ++i) {
        const double x = a[i];
        const double y = b[i] - x * ba;
        const double z = (c[i] - x * ca) - y * cb;
        const double w = ((d[i] - x * da) - y * db) - z * dc;
        a[i] = x * p;
        b[i] = y * q;
        c[i] = z * r;
        d[i] = w * s;
    }
    return is_good;
}

} // namespace

DSC_EACH_INSTRUCTION_SET
bool eliminate(std::size_t count, std::size_t height, double* lower, double* pivots, double* left) {
    bool is_good = true;
    const std::size_t others = height - count;
    for (std::size_t begin = 0; begin < count; begin += 4) {
        const std::size_t end = std::min(begin + 4, count);
        double* const first = lower + begin * height + begin;
        const bool is_block_good =
            end - begin == 4
                ? eliminate_four(first, height, height - begin, pivots + begin)
                : eliminate_each(first, height, end - begin, height - begin, pivots + begin);
        is_good = is_good && is_block_good;
        subtract_products(lower + end * height + end, height, count - end, height - end,
                          {lower, height, begin, end}, end, pivots + begin);
    }
    for (std::size_t begin = 0; begin < count; begin += 4) {
        const std::size_t end = std::min(begin + 4, count);
        subtract_products(left, others, others, others, {lower, height, begin, end}, count,
                          pivots + begin);
    }
    return is_good;
}

DSC_EACH_INSTRUCTION_SET
void substitute_forward(std::size_t count, std::size_t height, const double* lower,
                        double* values) {
    for (std::size_t begin = 0; begin < count; begin += 4) {
        const std::size_t end = std::min(begin + 4, count);
        for (std::size_t k = begin; k < end; ++k) {
            for (std::size_t j = k + 1; j < end; ++j) {
                values[j] -= lower[k * height + j] * values[k];
            }
        }
        Four weights{};
        std::copy(values + begin, values + end, weights.begin());
        subtract(values + end, height - end, {lower, height, begin, end}, end, weights);
    }
}

DSC_EACH_INSTRUCTION_SET
void substitute_backward(std::size_t count, std::size_t height, const double* lower,
                         const double* pivots, double* values) {
    for (std::size_t k = count; k-- > 0;) {
        values[k] = values[k] / pivots[k] -
                    product(values + k + 1, lower + k * height + k + 1, height - k - 1);
    }
}

} // namespace dsc

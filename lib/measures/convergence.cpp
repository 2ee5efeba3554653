// SPDX-License-Identifier: MIT
#include "measures/convergence.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace dsc::scenes {

namespace {

void check_positive(std::span<const double> values, const std::string& what) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0.0) || !std::isfinite(values[i])) {
            throw InputError({.what = what + " " + std::to_string(i),
                              .where = "fit_order",
                              .value = std::to_string(values[i]),
                              .allowed = "finite and above 0"});
        }
    }
}

} // namespace

Order fit_order(std::span<const double> sizes, std::span<const double> errors) {
    if (sizes.size() != errors.size()) {
        throw InputError({.what = "number of errors",
                          .where = "fit_order",
                          .value = std::to_string(errors.size()),
                          .allowed = std::to_string(sizes.size()) + ", as many as sizes"});
    }
    if (sizes.size() < 2) {
        throw InputError({.what = "number of sizes",
                          .where = "fit_order",
                          .value = std::to_string(sizes.size()),
                          .allowed = "at least 2"});
    }
    check_positive(sizes, "size");
    check_positive(errors, "error");
    std::vector<std::pair<double, double>> logs;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        logs.emplace_back(std::log(sizes[i]), std::log(errors[i]));
    }
    std::sort(logs.begin(), logs.end());
    const auto count = static_cast<double>(logs.size());
    double mean_size = 0.0;
    double mean_error = 0.0;
    for (const auto& [size, error] : logs) {
        mean_size += size / count;
        mean_error += error / count;
    }
    Order result;
    result.smallest = std::numeric_limits<double>::infinity();
    result.largest = -result.smallest;
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        const auto [size, error] = logs[i];
        products += (size - mean_size) * (error - mean_error);
        squares += (size - mean_size) * (size - mean_size);
        if (i > 0) {
            const double step = size - logs[i - 1].first;
            if (!(step > 0.0)) {
                throw InputError({.what = "a size given twice",
                                  .where = "fit_order",
                                  .value = std::to_string(std::exp(size)),
                                  .allowed = "sizes that differ"});
            }
            const double order = (error - logs[i - 1].second) / step;
            result.smallest = std::min(result.smallest, order);
            result.largest = std::max(result.largest, order);
        }
    }
    result.order = products / squares;
    return result;
}

} // namespace dsc::scenes

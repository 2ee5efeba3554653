// SPDX-License-Identifier: MIT
#include "scenes/file/formula/formula_flow.h"

#include "scenes/file/formula/program.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace dsc::scenes {

namespace {

/// Positions at once.
constexpr std::size_t row_length = 128;

template <class Row>
void execute_step(const FormulaStep& step, Row row, std::size_t count) {
    execute(step.op,
            {.a = row(step.of[0]),
             .b = row(step.of[1]),
             .c = row(step.of[2]),
             .result = row(step.result),
             .second_result = row(step.second_result)},
            count);
}

} // namespace

FormulaFlow::FormulaFlow(FormulaTexts texts)
    : texts_(std::make_shared<const FormulaTexts>(std::move(texts))) {
    FormulaGraph graph;
    const FormulaNodeId u = parse_formula(texts_->u, texts_->parameters, texts_->where_u, graph);
    const FormulaNodeId v = parse_formula(texts_->v, texts_->parameters, texts_->where_v, graph);
    program_ = std::make_shared<const FormulaProgram>(compile(graph, u, v, texts_->where_u));
}

bool FormulaFlow::uses_time() const { return program_->time >= 0; }

void FormulaFlow::operator()(std::span<const Point<double>> positions, double time,
                             std::span<Point<double>> velocities) const {
    assert(positions.size() == velocities.size());
    const FormulaProgram& p = *program_;
    std::array<double, std::size_t{2} * most_formula_nodes> numbers;
    std::ranges::copy(p.numbers, numbers.begin());
    const auto number = [&](int i) {
        return i < 0 ? nullptr : &numbers[static_cast<std::size_t>(i)];
    };
    if (p.time >= 0) {
        *number(p.time) = time;
    }
    for (const FormulaStep& step : p.once) {
        execute_step(step, number, 1);
    }

    alignas(64) std::array<double, most_formula_rows * row_length> rows;
    const auto row = [&](int i) {
        return i < 0 ? nullptr : rows.data() + static_cast<std::size_t>(i) * row_length;
    };
    for (const FormulaFill& fill : p.fills) {
        std::fill_n(row(fill.row), std::min(row_length, positions.size()), *number(fill.number));
    }
    for (std::size_t begin = 0; begin < positions.size(); begin += row_length) {
        const std::size_t count = std::min(row_length, positions.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            if (p.x >= 0) {
                row(p.x)[i] = positions[begin + i].x();
            }
            if (p.y >= 0) {
                row(p.y)[i] = positions[begin + i].y();
            }
        }
        for (const FormulaStep& step : p.steps) {
            execute_step(step, row, count);
        }
        const double* u = row(p.u);
        const double* v = row(p.v);
        for (std::size_t i = 0; i < count; ++i) {
            velocities[begin + i] = {u[i], v[i]};
        }
    }
}

} // namespace dsc::scenes

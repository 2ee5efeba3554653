// SPDX-License-Identifier: MIT
#include "scenes/file/formula/formula_flow.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace dsc::scenes {

namespace {

// Evaluates vectors of two or three components at each position.
template <class Vector, std::size_t n>
void evaluate(const FormulaGraph& graph, const std::array<FormulaNodeId, n>& components,
              std::span<const Vector> positions, double time, std::span<Vector> velocities) {
    constexpr std::array variables{FormulaGraph::x, FormulaGraph::y, FormulaGraph::z};
    assert(positions.size() == velocities.size());
    const auto nodes = graph.nodes();
    alignas(64) std::array<double, max_formula_nodes * formula_row_length> rows;
    const auto row = [&](FormulaNodeId id) {
        return id < 0 ? nullptr : rows.data() + static_cast<std::size_t>(id) * formula_row_length;
    };
    const auto compute = [&](bool what_sees_place, std::size_t count) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const FormulaNode& node = nodes[i];
            if (node.operation != nullptr && node.sees_place == what_sees_place) {
                node.operation(row(node.of[0]), row(node.of[1]), row(node.of[2]),
                               row(static_cast<FormulaNodeId>(i)), count);
            }
        }
    };

    // Rows that are the same at all positions are computed once.
    const std::size_t longest = std::min(formula_row_length, positions.size());
    for (std::size_t i = FormulaGraph::t; i < nodes.size(); ++i) {
        if (nodes[i].operation == nullptr && !nodes[i].sees_place) {
            const bool is_time = i == FormulaGraph::t;
            std::fill_n(row(static_cast<FormulaNodeId>(i)), longest,
                        is_time ? time : nodes[i].value);
        }
    }
    compute(false, longest);
    for (std::size_t begin = 0; begin < positions.size(); begin += formula_row_length) {
        const std::size_t count = std::min(formula_row_length, positions.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                row(variables[k])[i] = positions[begin + i][static_cast<Eigen::Index>(k)];
            }
        }
        compute(true, count);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < n; ++k) {
                velocities[begin + i][static_cast<Eigen::Index>(k)] = row(components[k])[i];
            }
        }
    }
}

} // namespace

FormulaFlow::FormulaFlow(const FormulaTexts& texts) {
    const auto program = std::make_shared<Program>();
    program->u = parse_formula(texts.u, texts.parameters, texts.where_u, program->graph);
    program->v = parse_formula(texts.v, texts.parameters, texts.where_v, program->graph);
    program_ = program;
}

bool FormulaFlow::uses_time() const {
    return program_->graph.at(program_->u).sees_time || program_->graph.at(program_->v).sees_time;
}

void FormulaFlow::operator()(std::span<const Point<double>> positions, double time,
                             std::span<Point<double>> velocities) const {
    evaluate(program_->graph, std::array{program_->u, program_->v}, positions, time, velocities);
}

SpaceFormulaFlow::SpaceFormulaFlow(const SpaceFormulaTexts& texts) {
    const auto program = std::make_shared<Program>();
    for (std::size_t k = 0; k < 3; ++k) {
        program->components[k] =
            parse_formula(texts.components[k], texts.parameters, texts.where[k], program->graph);
    }
    program_ = program;
}

void SpaceFormulaFlow::operator()(std::span<const Eigen::Vector3d> positions, double time,
                                  std::span<Eigen::Vector3d> velocities) const {
    evaluate(program_->graph, program_->components, positions, time, velocities);
}

} // namespace dsc::scenes

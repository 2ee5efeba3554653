// SPDX-License-Identifier: MIT
#include "scenes/file/formula/program.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <string>

namespace dsc::scenes {

namespace {

using Op = FormulaOp;

class FormulaCompiler {
public:
    FormulaCompiler(const FormulaGraph& graph, const std::string& where)
        : nodes_(graph.nodes()), where_(where), last_use_(nodes_.size(), -1),
          rows_of_(nodes_.size(), {-1, -1}) {}

    FormulaProgram compile(FormulaNodeId u, FormulaNodeId v) {
        if (nodes_.size() > most_formula_nodes) {
            throw InputError({.what = "formula with too many operations",
                              .where = where_,
                              .value = std::to_string(nodes_.size()),
                              .allowed = "at most " + std::to_string(most_formula_nodes)});
        }
        find_last_uses(u, v);
        for (int id = 0; id < static_cast<int>(nodes_.size()); ++id) {
            if (last_use_[index(id)] >= 0) {
                emit(id);
            }
        }
        program_.u = row_of(u);
        program_.v = row_of(v);
        return std::move(program_);
    }

private:
    static std::size_t index(int id) { return static_cast<std::size_t>(id); }
    [[nodiscard]] const FormulaNode& node(int id) const { return nodes_[index(id)]; }
    // The names of a sine and a cosine stand for the node that computes both.
    [[nodiscard]] bool is_name(int id) const {
        return node(id).op == Op::sine || node(id).op == Op::cosine;
    }
    [[nodiscard]] int computed(int id) const { return is_name(id) ? node(id).of[0] : id; }

    void use(int id, int by) { last_use_[index(id)] = std::max(last_use_[index(id)], by); }

    // From the results backwards: what nobody uses is not computed.
    void find_last_uses(int u, int v) {
        const int end = static_cast<int>(nodes_.size());
        use(computed(u), end);
        use(computed(v), end);
        for (int id = end - 1; id >= 0; --id) {
            if (last_use_[index(id)] < 0) {
                continue;
            }
            for (const int operand : node(id).of) {
                if (operand != no_formula_node) {
                    use(computed(operand), id);
                }
            }
        }
        // A number for all positions stays in its row for the whole batch.
        for (int id = 0; id < end; ++id) {
            if (last_use_[index(id)] >= 0 && !node(id).varies) {
                last_use_[index(id)] = end;
            }
        }
    }

    int unused_row() {
        if (program_.rows == most_formula_rows) {
            throw InputError({.what = "formula with too many values at once",
                              .where = where_,
                              .value = std::to_string(most_formula_rows + 1),
                              .allowed = "at most " + std::to_string(most_formula_rows)});
        }
        return program_.rows++;
    }

    int new_row() {
        if (free_.empty()) {
            return unused_row();
        }
        const int row = free_.back();
        free_.pop_back();
        return row;
    }

    void emit(int id) {
        const FormulaNode& one = node(id);
        if (!one.varies) {
            emit_number(id);
            return;
        }
        auto& [first, second] = rows_of_[index(id)];
        if (one.op == Op::x || one.op == Op::y) {
            first = unused_row(); // written before the first step
            (one.op == Op::x ? program_.x : program_.y) = first;
            return;
        }
        FormulaStep step{.op = one.op};
        for (std::size_t i = 0; i < one.of.size(); ++i) {
            step.of[i] = one.of[i] == no_formula_node ? -1 : row_of(one.of[i]);
        }
        // New rows before the old ones are given back: a sine must not overwrite its argument.
        first = new_row();
        second = one.op == Op::sine_cosine_pi ? new_row() : -1;
        step.result = first;
        step.second_result = second;
        program_.steps.push_back(step);
        for (std::size_t i = 0; i < one.of.size(); ++i) {
            if (one.of[i] != no_formula_node) {
                give_back(computed(one.of[i]), id);
            }
        }
    }

    void give_back(int id, int by) {
        if (last_use_[index(id)] != by) {
            return;
        }
        for (int& row : rows_of_[index(id)]) {
            if (row >= 0) {
                free_.push_back(row);
                row = -1;
            }
        }
    }

    void emit_number(int id) {
        const FormulaNode& one = node(id);
        program_.numbers.resize(2 * nodes_.size());
        if (one.op == Op::constant) {
            program_.numbers[2 * index(id)] = one.value;
        } else if (one.op == Op::t) {
            program_.time = 2 * id;
        } else {
            FormulaStep step{.op = one.op, .result = 2 * id, .second_result = 2 * id + 1};
            for (std::size_t i = 0; i < one.of.size(); ++i) {
                step.of[i] = one.of[i] == no_formula_node ? -1 : number_of(one.of[i]);
            }
            program_.once.push_back(step);
        }
    }

    [[nodiscard]] int number_of(int id) const {
        return 2 * computed(id) + (node(id).op == Op::cosine ? 1 : 0);
    }

    // Numbers get a row when a step first reads them: one that no earlier step writes.
    int row_of(int id) {
        const std::size_t part = node(id).op == Op::cosine ? 1 : 0;
        int& row = rows_of_[index(computed(id))][part];
        if (row < 0) {
            row = unused_row();
            program_.fills.push_back({row, number_of(id)});
        }
        return row;
    }

    const std::vector<FormulaNode>& nodes_;
    const std::string& where_;
    std::vector<int> last_use_; ///< -1: nobody
    std::vector<std::array<int, 2>> rows_of_;
    std::vector<int> free_;
    FormulaProgram program_;
};

} // namespace

FormulaProgram compile(const FormulaGraph& graph, FormulaNodeId u, FormulaNodeId v,
                       const std::string& where) {
    return FormulaCompiler(graph, where).compile(u, v);
}

} // namespace dsc::scenes

// SPDX-License-Identifier: MIT
// The table of what happens: for a terminal and as JSON.
#pragma once

#include "result.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace dsc::hard {

/// A case with what happened, and the seconds that it took.
struct Row {
    const HardCase* one = nullptr;
    HardResult result;
    double seconds = 0;
};

void print_heading(std::ostream& out);
void print_row(std::ostream& out, const Row& row);
/// A list of objects, one for each row; with a trailing newline.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows);

} // namespace dsc::hard

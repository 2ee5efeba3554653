// SPDX-License-Identifier: MIT
// The gate's result as a table for people, JSON for plots, and JUnit XML for continuous
// integration.
#pragma once

#include "judge.h"
#include "propose.h"

#include <ostream>
#include <string>
#include <vector>

namespace dsc::gate {

void print_heading(std::ostream& out);
void print_row(std::ostream& out, const Row& row);
/// Of a limit that is broken: why it stands, where it is broken, and how to see it again.
void print_failure(std::ostream& out, const Row& row);

/// Median and spread of each proposed limit, and the limit over the median: what a run has room
/// for.
void print_bands(std::ostream& out, const std::vector<Band>& bands);

/// `suites` are named in it; `cases` are all of theirs, for what was not run.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows,
                                  const std::vector<std::string>& suites, const Cases& cases,
                                  const Runs& runs);
[[nodiscard]] std::string to_junit(const std::vector<Row>& rows);

} // namespace dsc::gate

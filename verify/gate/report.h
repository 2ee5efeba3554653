// SPDX-License-Identifier: MIT
// The gate's result as a table, as JSON for plots, and as JUnit XML for continuous integration.
#pragma once

#include "judge.h"
#include "propose.h"

#include <ostream>
#include <string>
#include <vector>

namespace dsc::gate {

void print_heading(std::ostream& out);
void print_row(std::ostream& out, const Row& row);
/// Prints the origin of a broken limit, the place, and the command that reproduces it.
void print_failure(std::ostream& out, const Row& row);

/// Prints the median and spread of each proposed limit, and the ratio of limit to median: the
/// margin of a run.
void print_bands(std::ostream& out, const std::vector<Band>& bands);

/// `suites` are the names; `cases` are all their cases, for the list of checks that were not run.
[[nodiscard]] std::string to_json(const std::vector<Row>& rows,
                                  const std::vector<std::string>& suites, const Cases& cases,
                                  const Runs& runs);
[[nodiscard]] std::string to_junit(const std::vector<Row>& rows);

} // namespace dsc::gate

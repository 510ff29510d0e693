// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report {

// A table of equation by driver and variant: "ok 0.85" with the worst error as a fraction of what is allowed,
// "FAIL 3/100" with the inputs outside, the reason of a check that did not run, "-" where none was run. Above
// it the drivers by number, below it for each driver how many checks failed and why, and its worst error.
[[nodiscard]] std::string to_matrix(const std::vector<CheckReport>& reports);

// The same as a Markdown page.
[[nodiscard]] std::string to_matrix_markdown(const std::vector<CheckReport>& reports);

}  // namespace gloam::report

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report {

// A table of equation by driver and variant. A cell is "ok 0.85" with the worst error as a fraction of what
// is allowed, "FAIL 3/100" with the inputs outside, or "not judged". It is the reason of a check that did not
// run, and "-" if no check was run. Above the table are the drivers by number. Below it are, for each driver,
// how many checks failed and why, how many were not judged, and the worst error.
[[nodiscard]] std::string to_matrix(const std::vector<CheckReport>& reports);

// The same as a Markdown page.
[[nodiscard]] std::string to_matrix_markdown(const std::vector<CheckReport>& reports);

}  // namespace gloam::report

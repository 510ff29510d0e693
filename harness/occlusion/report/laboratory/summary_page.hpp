// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "report/laboratory/summary.hpp"
#include "report/laboratory/summary_lines.hpp"

namespace gloam::report {

// For a terminal: a line for each group with its failed checks, at most ten named, and what is new. Of more
// than 40 groups only those with failures are listed.
[[nodiscard]] std::string to_summary_text(const LaboratorySummary& summary, const std::optional<News>& news);

// One HTML page: counts, what is new, a table of groups, the worst first, and a table of all failed checks.
// `rejected`: a line for each file that was no result.
[[nodiscard]] std::string to_summary_page(const LaboratorySummary& summary, const std::optional<News>& news,
                                          const std::vector<std::string>& rejected);

}  // namespace gloam::report

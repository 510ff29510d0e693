// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "report/check_report.hpp"

namespace gloam::report {

// What a summary of many machines keeps of a row of results.
struct ResultRow {
    std::string equation;
    std::string variant;
    std::size_t inputs = 0;
    std::size_t outside = 0;
    double fraction = 0.0;  // the worst error as a fraction of what is allowed; 0 if unknown
    std::string reason;     // why it did not run: "hang"; empty: it ran
    check::Outcome outcome = check::Outcome::ok;
};

// Reads a text of `gloam check --json` (to_json()) and calls `take` for each row. It builds no document:
// its memory does not grow with the text. Throws std::runtime_error
// with the line of invalid JSON, or the name of what is missing; rows before that have been given to `take`.
void read_results(std::string_view text,
                  const std::function<void(const DeviceSummary& device, const ResultRow& row)>& take);

}  // namespace gloam::report

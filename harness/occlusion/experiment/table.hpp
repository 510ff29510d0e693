// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "experiment/database.hpp"
#include "experiment/experiment.hpp"

namespace gloam::experiment {

struct Text {
    std::string text;    // the tables in Markdown; where a table shows one size, one for each size
    std::string report;  // the same, and those that stand in the report alone
    std::map<std::string, std::string> named;  // those with a name alone
    bool missed = false;                       // a cell ends in "missed"
};

// The experiment's tables that have rows. "-" stands for what was not measured. Throws std::runtime_error
// with the place of a SELECT that cannot be executed.
[[nodiscard]] Text to_text(const Experiment& experiment, const Database& database);

// {"gloam", "versions", "experiment", "device", "driver", "frames", "scored", "repeat", "rays", "results":
// [the rows of the table `result`], "passes": [those of `passes`], "visits": [the lines of the record]}. What
// was not measured is null.
[[nodiscard]] std::string to_json(const Database& database, const Record& record,
                                  const std::string& versions);

// The headings and the rows of the table `result`. What was not measured is empty.
[[nodiscard]] std::string to_csv(const Database& database);

}  // namespace gloam::experiment

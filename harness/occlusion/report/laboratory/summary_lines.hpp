// SPDX-License-Identifier: MIT
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "report/laboratory/summary.hpp"

namespace gloam::report {

// JSON lines, one for each check of each group, for databases: {"vendor", "driver", "version", "api",
// "files", "devices", "equation", "variant", "runs", "failed", "not_judged", "inputs", "outside", "worst",
// "reasons"}. "files" and "devices" count those of the group. An infinite "worst" is the string "inf".
[[nodiscard]] std::string to_json_lines(const LaboratorySummary& summary);

// What a later summary compares with: which checks of which groups failed.
struct EarlierSummary {
    std::map<DriverGroup, std::map<CheckName, bool>> failed;
};

// Reads such lines, one at a time: at most 2,000,000 of at most 64 kB. Throws std::runtime_error with the
// number of the line, what was found and what was expected.
[[nodiscard]] EarlierSummary earlier_from_lines(std::istream& lines);

// A check of a group.
struct GroupCheck {
    DriverGroup group;
    CheckName check;
};

// What has changed since an earlier summary.
struct News {
    std::vector<DriverGroup> new_groups;
    std::vector<GroupCheck> newly_failed;  // of groups that both have: passed or unknown before
    std::vector<GroupCheck> mended;        // failed before, passes now
    std::vector<DriverGroup> missing_groups;
};

[[nodiscard]] News news_since(const EarlierSummary& before, const LaboratorySummary& now);

}  // namespace gloam::report

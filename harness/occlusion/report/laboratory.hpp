// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report {

// What the results of many machines are grouped by.
struct DriverGroup {
    std::string vendor;   // "NVIDIA", "AMD", "Mesa", ...; "other" if the names do not tell
    std::string driver;   // the driver's text up to its version: "llvmpipe Mesa"
    std::string version;  // the rest: "22.3.6 (LLVM 15.0.6)"; empty: the text has no number
    std::string api;      // as api_of()

    friend auto operator<=>(const DriverGroup&, const DriverGroup&) = default;
};

[[nodiscard]] DriverGroup group_of(const DeviceSummary& device);

// "llvmpipe Mesa 22.3.6 (LLVM 15.0.6), Vulkan 1.3.230".
[[nodiscard]] std::string name_of(const DriverGroup& group);

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

// Who answered the questions of a report, and what they were asked with.
struct ResultRun {
    DeviceSummary device;
    std::string versions;    // of gloam and of the compilers; empty: unknown
    std::size_t inputs = 0;  // that were asked for; 0: unknown
    std::uint64_t seed = 0;  // 0: unknown
};

using TakeResults = std::function<void(const ResultRun& run, const std::vector<ResultRow>& rows)>;

// Reads a text of `gloam check --json` (to_json()) and calls `take` for each report. It builds no document:
// only the rows of one report are in memory. Throws std::runtime_error with the line of invalid JSON, or the
// name of what is missing; reports before that have been given to `take`.
void read_results(std::string_view text, const TakeResults& take);

// What all machines of a group found for one equation in one variant.
struct CheckTally {
    std::size_t runs = 0;
    std::size_t failed = 0;      // of these
    std::size_t not_judged = 0;  // of all runs
    std::size_t inputs = 0;      // of all runs
    std::size_t outside = 0;     // of these
    double worst = 0.0;          // largest error as a fraction of what is allowed
    std::string reasons{};       // why runs ended early: "crash,hang"
};

using CheckName = std::pair<std::string, std::string>;  // equation and variant

struct GroupSummary {
    std::size_t runs = 0;             // each of a device, versions, inputs and a seed
    std::set<std::string> devices{};  // their names
    std::map<CheckName, CheckTally> checks{};

    [[nodiscard]] std::size_t failing() const;     // checks with a failed run
    [[nodiscard]] std::size_t not_judged() const;  // checks that no run judged
};

// The results of many machines by group: see ResultsDatabase.
using LaboratorySummary = std::map<DriverGroup, GroupSummary>;

// A check of two builds of a driver, or of one build at two times.
struct CheckChange {
    DriverGroup before;
    DriverGroup now;
    CheckName check;
    double worst_before = 0.0;
    double worst_now = 0.0;
};

// What has changed since an earlier summary. A driver in a version that is not in the earlier summary is
// compared with the newest version there that is older, otherwise with the oldest that is newer. An error
// grew or shrank if the larger one exceeds the smaller one by more than a tenth, and by more than a hundredth
// of what is allowed.
struct News {
    std::vector<DriverGroup> new_groups;
    std::vector<std::pair<DriverGroup, DriverGroup>> builds;  // of one driver: before and now
    std::vector<CheckChange> newly_failed;                    // passed or unknown before
    std::vector<CheckChange> mended;                          // failed before, passes now
    std::vector<CheckChange> grew;                            // the worst error; the outcome is as before
    std::vector<CheckChange> shrank;
    std::vector<DriverGroup> missing_groups;
};

[[nodiscard]] News news_since(const LaboratorySummary& before, const LaboratorySummary& now);

// For a terminal: a line for each group with its failed checks, at most ten named, and what is new. Of more
// than 40 groups only those with failures are listed.
[[nodiscard]] std::string to_summary_text(const LaboratorySummary& summary, const std::optional<News>& news);

// One HTML page: counts, what is new, a table of groups, the worst first, and a table of all failed checks.
// `rejected`: a line for each file that was no result.
[[nodiscard]] std::string to_summary_page(const LaboratorySummary& summary, const std::optional<News>& news,
                                          const std::vector<std::string>& rejected);

}  // namespace gloam::report

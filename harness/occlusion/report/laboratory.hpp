// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <istream>
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

// Reads a text of `gloam check --json` (to_json()) and calls `take` for each row. It builds no document:
// its memory does not grow with the text. Throws std::runtime_error
// with the line of invalid JSON, or the name of what is missing; rows before that have been given to `take`.
void read_results(std::string_view text,
                  const std::function<void(const DeviceSummary& device, const ResultRow& row)>& take);

// What all machines of a group found for one equation in one variant.
struct CheckTally {
    std::size_t runs = 0;
    std::size_t failed = 0;           // of these
    std::size_t not_judged = 0;       // of all runs
    std::size_t inputs = 0;           // of all runs
    std::size_t outside = 0;          // of these
    double worst = 0.0;               // largest error as a fraction of what is allowed
    std::set<std::string> reasons{};  // why runs ended early: "hang"
};

using CheckName = std::pair<std::string, std::string>;  // equation and variant

struct GroupSummary {
    std::size_t files = 0;
    std::set<std::string> devices{};  // their names
    std::map<CheckName, CheckTally> checks{};

    [[nodiscard]] std::size_t failing() const;     // checks with a failed run
    [[nodiscard]] std::size_t not_judged() const;  // checks that no run judged
};

// The results of many machines by group. It grows with the number of different drivers, not of files.
class LaboratorySummary {
  public:
    // Adds the results of one file. Throws like read_results(); then nothing of the file is added. Throws
    // std::runtime_error too when there are more than 10,000 groups, 1,000 devices of a group or 2,000,000
    // checks.
    void add_file(std::string_view text);

    void merge(const LaboratorySummary& other);

    [[nodiscard]] const std::map<DriverGroup, GroupSummary>& groups() const { return groups_; }
    [[nodiscard]] std::size_t files() const { return files_; }

  private:
    void require_bounds() const;

    std::map<DriverGroup, GroupSummary> groups_;
    std::size_t files_ = 0;
};

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

// For a terminal: a line for each group with its failed checks, at most ten named, and what is new. Of more
// than 40 groups only those with failures are listed.
[[nodiscard]] std::string to_summary_text(const LaboratorySummary& summary, const std::optional<News>& news);

// One HTML page: counts, what is new, a table of groups, the worst first, and a table of all failed checks.
// `rejected`: a line for each file that was no result.
[[nodiscard]] std::string to_summary_page(const LaboratorySummary& summary, const std::optional<News>& news,
                                          const std::vector<std::string>& rejected);

}  // namespace gloam::report

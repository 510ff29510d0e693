// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "report/laboratory/driver_group.hpp"
#include "report/laboratory/result_stream.hpp"

namespace gloam::report {

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

}  // namespace gloam::report

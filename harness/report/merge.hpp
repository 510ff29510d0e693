// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report {

// A report, and the file that it was read from.
struct ReportFile {
    std::string file;
    CheckReport report;
};

// The reports of one or more files as one: a report for each driver, with each equation in each variant once.
struct MergedReports {
    std::vector<CheckReport> reports;    // drivers in the order of their files; rows sorted by equation
    std::vector<std::string> conflicts;  // a line for each row that two files tell differently
};

// Drivers are the same when all that they say of themselves is: what each file has of one is united, so that
// shards become the whole. Of rows that differ (but in their time) the worse is kept: one that did not run,
// then one with a fault, then the larger share outside, then the larger error.
[[nodiscard]] MergedReports merge(const std::vector<ReportFile>& files);

}  // namespace gloam::report

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

// Reports merged from one or more files: a report for each driver, with each equation in each variant once.
struct MergedReports {
    std::vector<CheckReport> reports;    // drivers in the order of their files; rows sorted by equation
    std::vector<std::string> conflicts;  // a line for each row that differs between two files
};

// Merges files. Two drivers are the same if all their reported properties are; their rows are united, so that
// shards become the whole. Of two rows that differ (except in time) the worse is kept: first one that did not
// run, then one with a fault, then the larger share outside, then the larger error.
[[nodiscard]] MergedReports merge(const std::vector<ReportFile>& files);

}  // namespace gloam::report

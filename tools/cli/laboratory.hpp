// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// The options of `gloam report --summary`.
struct SummaryOptions {
    std::vector<std::string> paths;  // files, and folders of which all *.json files count
    std::filesystem::path database;  // receives the results; empty: none
    std::filesystem::path since;     // such a file of earlier results; empty: none
    std::filesystem::path html;      // file for the page; empty: none
};

// Adds the results of many machines to the database, summarises what it holds, and prints that. Files that
// are no results are named on standard error, and the others count. Returns the exit status: 0; 1 if a check
// failed or a file is no result. Throws std::runtime_error if no file is a result; then the database remains
// as it was.
[[nodiscard]] int run_summary(const SummaryOptions& options);

}  // namespace gloam::cli

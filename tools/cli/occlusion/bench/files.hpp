// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/results.hpp"
#include "experiment/runner.hpp"
#include "experiment/table.hpp"
#include "record/output.hpp"

namespace gloam::cli {

// Files of an experiment. Empty paths are not written.
struct ExperimentPaths {
    std::filesystem::path json;    // every number
    std::filesystem::path csv;     // a line for each candidate of each case
    std::filesystem::path page;    // whose blocks of the tables' names, or the experiment's, are written anew
    std::filesystem::path report;  // a page of its own
    std::filesystem::path out;     // folder for results, pictures and the journal
};

// The results with all that pages say of them.
struct Measured {
    const experiment::Experiment& what;
    const experiment::Record& record;
    const experiment::Database& database;
    const experiment::Text& tables;
};

// What was measured where, in a few lines.
[[nodiscard]] std::string heading_of(const Measured& measured);

// The requested files of one run. The constructor finds out whether they can be written, before the work.
class ExperimentFiles {
  public:
    // Throws std::runtime_error for a file that cannot be written, and std::invalid_argument for a page
    // without the experiment's blocks.
    ExperimentFiles(const ExperimentPaths& paths, const experiment::Experiment& what);

    // In the folder, which then stays; empty: there is none.
    [[nodiscard]] std::filesystem::path journal();

    // Writes a picture into the folder, if there is one. Throws like write().
    void show(const experiment::Picture& picture);
    [[nodiscard]] bool shows_pictures() const { return out_.has_value(); }

    // Writes all files. Throws std::runtime_error for a file that cannot be written.
    void write(const Measured& measured, const std::string& heading, const std::string& versions);

  private:
    ExperimentPaths paths_;
    std::string old_page_;
    record::OutputFile json_;
    record::OutputFile csv_;
    record::OutputFile page_;
    record::OutputFile report_;
    std::optional<record::OutputFolder> out_;
};

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands.hpp"
#include "experiment/experiment.hpp"

namespace gloam::cli {

// What the options of a call change in a description.
struct ExperimentOptions {
    std::filesystem::path file;
    std::vector<std::string> sizes;
    std::optional<int> frames;
    std::optional<int> scored;
    std::optional<int> rounds;
    std::optional<int> rays;
    std::optional<double> depth_thickness;
    std::vector<std::string> cases;
    std::string half;
    std::vector<std::string> methods;
    std::vector<std::string> plain;     // SLICESxSTEPS+BLURS
    std::vector<std::string> single;    // PRESET[,NAME=VALUE...]
    std::vector<std::string> sequence;  // the same
    std::vector<std::string> set;       // NAME=VALUE, of all candidates
    bool no_depth_truth = false;
    std::string inputs = "device";
    std::filesystem::path meshes;
    std::optional<experiment::CandidateQuery> query;  // of a description with such a query
    bool fail_if_missed = false;
    bool fail_if_worse = false;
    bool resume = false;
    std::string budget;                          // "1ms"; empty: not asked
    double error = 0.0;                          // 0: not asked
    std::vector<std::filesystem::path> from;     // results in place of a run
    std::vector<std::filesystem::path> compare;  // two results, or none
    std::string device;
    bool validation = false;
    // Files of the results; those with an empty path are not written.
    std::filesystem::path json;    // every number
    std::filesystem::path csv;     // a line for each candidate of each case
    std::filesystem::path page;    // whose blocks of the tables' names, or the experiment's, are written anew
    std::filesystem::path report;  // a page of its own
    std::filesystem::path out;     // folder for results, pictures and the journal
};

// has_query: of a description with a query of candidates.
[[nodiscard]] std::vector<Option> options_of(ExperimentOptions& options, bool has_query);

// The description of the file, or of `gloam bench` alone, with the options. Throws like read_experiment().
[[nodiscard]] experiment::Experiment described(const ExperimentOptions& options);

// Replaces candidates by those of the options. Throws std::invalid_argument for texts that name none, and if
// no candidate is left.
void choose_candidates(experiment::Experiment& what, const ExperimentOptions& options);

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "audit/mutant.hpp"
#include "base/files.hpp"
#include "base/process.hpp"
#include "record/mutation_report.hpp"

namespace gloam::cli {

// What `gloam mutate` was asked.
struct MutateCommand {
    std::vector<std::string> paths;     // files, and folders of which all shaders count
    std::vector<std::string> includes;  // further include roots; the first is the folder that is copied
    std::vector<std::string> command;
    std::optional<std::size_t> count;  // of faults, one at each place; all without
    std::uint64_t seed = 1;
    std::size_t inputs = 4096;  // for each survivor
    std::optional<double> minutes;
    std::optional<double> patience;  // seconds
    unsigned jobs = 0;
    std::string known;
    std::string json;
};

// The faults of some files, and what becomes of each.
class Trials {
  public:
    // Reads the files and draws the faults. Throws for a file that cannot be read or compiled, and for a list
    // of known faults of another form.
    explicit Trials(const MutateCommand& command);

    // Runs everything that is left, until the time is over: first what the compiler decides. Throws
    // std::runtime_error if the command fails without a fault.
    void run();

    [[nodiscard]] const record::MutationReport& report() const { return report_; }

  private:
    using Clock = std::chrono::steady_clock;

    void read_files();
    void draw();
    void read_known();
    [[nodiscard]] std::string known_reason(const record::MutantRow& row) const;
    [[nodiscard]] bool is_over() const { return Clock::now() > end_; }
    [[nodiscard]] std::vector<std::size_t> left() const;

    void compile(record::MutantRow& row);
    void make_copies();
    // Runs the command on a copy of the folder in which the file has this text.
    [[nodiscard]] base::ProcessResult run_with(std::size_t file, const std::string& text,
                                               std::chrono::milliseconds patience, double& seconds);
    void run_unchanged();
    void try_one(record::MutantRow& row);

    const MutateCommand& command_;
    unsigned jobs_;
    Clock::time_point end_ = Clock::time_point::max();
    std::list<check::MutantFile> files_;
    std::vector<const check::MutantFile*> by_number_;
    std::filesystem::path root_;                      // that is copied
    std::list<base::TemporaryFolder> copies_;         // one for each job
    std::vector<const std::filesystem::path*> free_;  // of these
    record::MutationReport report_;
    std::vector<std::size_t> order_;                 // of the mutants, as drawn
    std::map<std::size_t, double> unchanged_;        // seconds of the command without a fault, by file
    std::vector<std::array<std::string, 3>> known_;  // file, line, reason
    std::mutex mutex_;
};

}  // namespace gloam::cli

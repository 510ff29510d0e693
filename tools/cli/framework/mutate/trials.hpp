// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "audit/mutant.hpp"
#include "base/files.hpp"
#include "record/mutation_report.hpp"

namespace gloam::cli {

// A copy of a folder in which one file at a time has another text.
class Overlay {
  public:
    // Throws std::runtime_error for a folder that is too large to be copied.
    explicit Overlay(std::filesystem::path original);

    // `file`: relative to the folder.
    void change(const std::filesystem::path& file, std::string_view text) const;
    void restore(const std::filesystem::path& file) const;

    // For a program that is to read this copy, see shader::overlaid(); and which file has changed.
    [[nodiscard]] std::vector<std::string> environment(const std::filesystem::path& file) const;

  private:
    std::filesystem::path original_;
    base::TemporaryFolder folder_;
};

// Overlays of one folder, one for each job.
class Overlays {
  public:
    Overlays(const std::filesystem::path& original, unsigned jobs);

    [[nodiscard]] std::unique_ptr<Overlay> take();
    void give_back(std::unique_ptr<Overlay> overlay);

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Overlay>> free_;
};

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
    [[nodiscard]] std::filesystem::path relative(std::size_t file) const;
    [[nodiscard]] std::string known_reason(const record::MutantRow& row) const;
    [[nodiscard]] bool is_over() const { return Clock::now() > end_; }
    [[nodiscard]] std::vector<std::size_t> left() const;

    void compile(record::MutantRow& row);
    void run_unchanged(Overlays& overlays);
    void try_one(record::MutantRow& row, Overlays& overlays);

    const MutateCommand& command_;
    unsigned jobs_;
    Clock::time_point end_ = Clock::time_point::max();
    std::list<check::MutantFile> files_;
    std::vector<const check::MutantFile*> by_number_;
    std::filesystem::path root_;  // that is copied
    record::MutationReport report_;
    std::vector<std::size_t> order_;                 // of the mutants, as drawn
    std::map<std::size_t, double> unchanged_;        // seconds of the command without a fault, by file
    std::vector<std::array<std::string, 3>> known_;  // file, line, reason
    std::mutex mutex_;
};

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "cli/check/task.hpp"
#include "report/check_report.hpp"
#include "report/line_journal.hpp"

namespace gloam::cli {

// The conditions under which results of several runs may be combined.
struct CheckJournalSetup {
    std::string versions;  // of gloam and of the compilers
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool validation = false;
};

// The rows of a check, written to a file as they come, so that --resume can continue a run that was killed.
class CheckJournal {
  public:
    // See report::LineJournal. Also throws std::runtime_error for a line that is not a result, with its
    // number.
    CheckJournal(std::filesystem::path path, const CheckJournalSetup& setup, bool resume);

    // The row of a task on a device from an earlier run. nullopt if that run got no result: a hang or a crash
    // can have other causes than the driver, so the task is tried again.
    [[nodiscard]] std::optional<check::Answer> known(const report::DeviceSummary& device,
                                                     const CheckTask& task) const;

    // Adds a row. Returns true if it was known already; then it is not added. Throws std::runtime_error if it
    // cannot be written.
    bool add(const report::DeviceSummary& device, const check::Answer& row) const;

  private:
    using Key = std::tuple<std::string, std::string, std::string>;  // device, equation, variant

    report::LineJournal file_;
    std::map<Key, check::Answer> known_;
};

}  // namespace gloam::cli

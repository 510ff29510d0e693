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

// Under which circumstances results may be counted together.
struct CheckJournalSetup {
    std::string versions;  // of gloam and of the compilers
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool validation = false;
};

// The rows of a check, kept in a file as they come: a run that was killed leaves them, and --resume goes on
// from there.
class CheckJournal {
  public:
    // See report::LineJournal. Throws std::runtime_error that names the line that is no result, too.
    CheckJournal(std::filesystem::path path, const CheckJournalSetup& setup, bool resume);

    // The row that an earlier run brought for a task on a device. None where that run got no result: a hang
    // or a crash may have had other reasons than the driver, and is tried again.
    [[nodiscard]] std::optional<check::Answer> known(const report::DeviceSummary& device,
                                                     const CheckTask& task) const;

    // Keeps a row, unless it is known: true then. Throws std::runtime_error when it cannot be written.
    bool add(const report::DeviceSummary& device, const check::Answer& row) const;

  private:
    using Key = std::tuple<std::string, std::string, std::string>;  // device, equation, variant

    report::LineJournal file_;
    std::map<Key, check::Answer> known_;
};

}  // namespace gloam::cli

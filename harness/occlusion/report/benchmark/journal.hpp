// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/benchmark/result.hpp"
#include "report/line_journal.hpp"

namespace gloam::report {

// The result of one visit to a configuration.
struct Visit {
    Configuration configuration;
    int round = 0;
    std::optional<Quality> quality;
    std::vector<Reading> readings;
};

// The conditions that must be equal for visits to be combined.
struct JournalSetup {
    std::string device;
    std::string driver;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int frames = 0;
    int scored = 0;
    int rays = 0;

    friend bool operator==(const JournalSetup&, const JournalSetup&) = default;
};

// The visits of a benchmark, written to a file as they come, one a line, so that an interruption does not
// lose them.
class Journal {
  public:
    // An empty path: no file. `resume`: takes over the visits of the file if it exists; a last line without
    // its end was being written, and is dropped. Without `resume` the file starts empty. Throws
    // std::runtime_error for a file that cannot be read or written, that is not a journal, or that has
    // another setup.
    Journal(std::filesystem::path path, const JournalSetup& setup, bool resume);

    [[nodiscard]] bool has(const Configuration& configuration, int round) const;

    // Adds a visit; on return it is in the file. Throws std::runtime_error if it cannot be written.
    void add(Visit visit);

    // The row of a configuration: the quality of its first visit with one, and the readings of all visits.
    [[nodiscard]] Row row_of(const Configuration& configuration) const;

    // Median of the copies of all readings.
    [[nodiscard]] Spread copies() const;

  private:
    LineJournal file_;
    std::map<Configuration, std::map<int, Visit>> visits_;
};

}  // namespace gloam::report

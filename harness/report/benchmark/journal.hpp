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

// What one visit to a configuration brought.
struct Visit {
    Configuration configuration;
    int round = 0;
    std::optional<Quality> quality;
    std::vector<Reading> readings;
};

// Under which circumstances visits may be counted together.
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

// The visits of a benchmark, kept in a file as they come, a line each: what was measured before an
// interruption is not lost.
class Journal {
  public:
    // An empty path keeps nothing. `resume`: the visits of the file are taken over, where there is one; a
    // last line without its end was being written, and is dropped. Otherwise the file starts empty. Throws
    // std::runtime_error for a file that cannot be read or written, that is no journal, or of another setup.
    Journal(std::filesystem::path path, const JournalSetup& setup, bool resume);

    [[nodiscard]] bool has(const Configuration& configuration, int round) const;

    // Keeps a visit; on return it is in the file. Throws std::runtime_error when it cannot be written.
    void add(Visit visit);

    // The row of a configuration: the quality of its first visit that has one, the readings of all.
    [[nodiscard]] Row row_of(const Configuration& configuration) const;

    // Median of the copies of all readings.
    [[nodiscard]] Spread copies() const;

  private:
    LineJournal file_;
    std::map<Configuration, std::map<int, Visit>> visits_;
};

}  // namespace gloam::report

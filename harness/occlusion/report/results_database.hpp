// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "report/laboratory.hpp"

namespace gloam::report {

// Results of many machines in an SQLite file, one row for each question that was put to a device: what it was
// asked, with which inputs and seed, by which versions. A question that was answered twice counts once, and
// of two answers the worse is kept: first one that failed, then one that did not run, then the larger number
// of inputs outside, then the larger error. The order in which files are added makes no difference.
class ResultsDatabase {
  public:
    enum class Access { read, add };

    // Opens such a file, and creates it with `add` if it is missing. An empty path: a temporary file. Throws
    // std::runtime_error with the file's name for a file of another kind, one that cannot be opened, and one
    // to which another process adds for longer than a minute.
    ResultsDatabase(const std::filesystem::path& file, Access access);
    ~ResultsDatabase();
    ResultsDatabase(const ResultsDatabase&) = delete;
    ResultsDatabase& operator=(const ResultsDatabase&) = delete;

    // Adds the results of one text. May be called by several threads. Throws like read_results(); then
    // nothing of the text is added.
    void add(std::string_view text);

    // Keeps what was added. Otherwise the file remains as it was.
    void commit();

    // Throws std::runtime_error for a damaged file, and for more than 10,000 drivers, 1,000 devices of one
    // driver or 2,000,000 checks.
    [[nodiscard]] LaboratorySummary summary() const;

  private:
    struct Store;
    std::unique_ptr<Store> store_;
};

}  // namespace gloam::report

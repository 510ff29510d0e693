// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiment/experiment.hpp"
#include "experiment/results.hpp"

namespace gloam::experiment::internal {

// What a row is about: cases and a candidate, both by number, a pass, and a frame from 1 on.
struct Row {
    std::vector<std::size_t> cases;
    std::size_t candidate = 0;
    std::string pass;
    int frame = 0;
};

// The rows of a table over the results of one or all sizes.
class Rows {
  public:
    Rows(const Experiment& experiment, const std::vector<SizeResult>& results, const Table& table)
        : experiment_(experiment), results_(results), table_(table) {}

    [[nodiscard]] std::vector<Row> of(std::size_t size) const;

    // A row over all cases of the table.
    [[nodiscard]] Row all_cases(std::size_t size) const;

    // Those of the row with these names, and of this half; all where there are none.
    [[nodiscard]] std::vector<const CaseResult*> cases_of(const Row& row, std::size_t size,
                                                          const std::vector<std::string>& names,
                                                          const std::string& half) const;

  private:
    [[nodiscard]] std::vector<std::size_t> kept(const std::vector<const CaseResult*>& cases) const;
    [[nodiscard]] std::vector<std::size_t> best_of(const std::vector<const CaseResult*>& cases,
                                                   const std::vector<std::size_t>& numbers) const;
    void add_rows(std::vector<Row>& rows, const CaseResult& result, std::size_t number) const;
    void add_frames(std::vector<Row>& rows, const CaseResult& result, std::size_t number) const;

    const Experiment& experiment_;
    const std::vector<SizeResult>& results_;
    const Table& table_;
};

}  // namespace gloam::experiment::internal

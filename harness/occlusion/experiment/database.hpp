// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "experiment/results.hpp"

struct sqlite3;

namespace gloam::experiment {

// A number, a text, or nothing.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

struct Rows {
    std::vector<std::string> headings;
    std::vector<std::vector<Value>> all;
};

// The visits of a record as tables of SQLite (docs/experiments.md), in memory.
class Database {
  public:
    // before: a record whose tables are in the schema `before`, or nullptr. without: columns of `result`, and
    // tables, that are left out.
    explicit Database(const Record& record, const Record* before = nullptr,
                      const std::set<std::string>& without = {});

    // The rows of a SELECT, in which `:size` is this size. A description of somebody else's may hold it: it
    // only reads, and takes a bounded number of steps. Throws std::runtime_error with SQLite's message.
    [[nodiscard]] Rows select(const std::string& text, const std::string& size = "") const;

    // The texts in the first column of a SELECT's rows, as text_of() has them.
    [[nodiscard]] std::vector<std::string> texts(const std::string& select,
                                                 const std::string& size = "") const;

  private:
    void load(const Record& record);
    void copy(const Database& before);
    void run(const char* statements);

    std::unique_ptr<sqlite3, int (*)(sqlite3*)> handle_;
};

// As tables and answers show it: "-" for nothing.
[[nodiscard]] std::string text_of(const Value& value);

}  // namespace gloam::experiment

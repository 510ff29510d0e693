// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report::internal {

// JSON has no infinity and no NaN; they become the strings "inf", "-inf" and "nan".
[[nodiscard]] nlohmann::ordered_json number_json(double value);
[[nodiscard]] nlohmann::ordered_json numbers_json(const std::vector<double>& values);

// Reads JSON of a known structure. Every reader throws std::runtime_error with the place in the document,
// what was found and what was expected: "results[3].inputs: expected a count, found "many"".
class JsonReader {
  public:
    JsonReader(const nlohmann::ordered_json& json, std::string where)
        : json_(&json), where_(std::move(where)) {}

    // A member of an object; it must exist.
    [[nodiscard]] JsonReader member(const char* name) const;
    [[nodiscard]] bool has(const char* name) const;
    // The elements of an array, or the values of an object with their names.
    [[nodiscard]] std::vector<JsonReader> elements() const;
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;

    [[nodiscard]] bool is_null() const { return json_->is_null(); }
    [[nodiscard]] bool is_array() const { return json_->is_array(); }
    [[nodiscard]] std::string text() const;
    // A text for tables, titles and messages: one line, or empty.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] double number() const;
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] std::size_t count_up_to(std::size_t most) const;
    [[nodiscard]] bool flag() const;
    [[nodiscard]] std::vector<double> numbers() const;
    [[nodiscard]] std::vector<std::uint32_t> words() const;

    [[noreturn]] void expected(const std::string& what) const;

  private:
    const nlohmann::ordered_json* json_;
    std::string where_;
};

// Parses a text. Throws std::runtime_error with the line and column of invalid JSON, or with the bound of
// base::JsonBounds that the text exceeds.
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view text);

[[nodiscard]] nlohmann::ordered_json answer_json(const check::Answer& answer);
[[nodiscard]] check::Answer read_answer(const JsonReader& json);

}  // namespace gloam::report::internal

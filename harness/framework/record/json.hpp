// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gloam::record {

// JSON has no infinity and no NaN; they become the strings "inf", "-inf" and "nan".
[[nodiscard]] nlohmann::ordered_json number_json(double value);

// A document in lines, with the end of its last. Bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string to_text(const nlohmann::ordered_json& document);

// Reads JSON of a known structure. Every reader throws std::runtime_error with the place in the document,
// what was found and what was expected: "results[3].inputs: expected a count, found "many"".
class JsonReader {
  public:
    JsonReader(const nlohmann::ordered_json& json, std::string where)
        : json_(&json), where_(std::move(where)) {}

    // A member of an object; it must exist.
    [[nodiscard]] JsonReader member(const std::string& name) const;
    [[nodiscard]] bool has(const char* name) const;
    // The elements of an array, or the values of an object with their names.
    [[nodiscard]] std::vector<JsonReader> elements() const;
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;

    [[nodiscard]] const nlohmann::ordered_json& json() const { return *json_; }
    [[nodiscard]] bool is_null() const { return json_->is_null(); }
    [[nodiscard]] bool is_array() const { return json_->is_array(); }
    [[nodiscard]] std::string text() const { return value<std::string>(json_->is_string(), "a text"); }
    // A text for tables, titles and messages: one line, or empty.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] double number() const;
    [[nodiscard]] int integer(int least, int most) const;
    [[nodiscard]] std::size_t count() const {
        return value<std::size_t>(json_->is_number_unsigned(), "a count");
    }
    [[nodiscard]] bool flag() const { return value<bool>(json_->is_boolean(), "true or false"); }

    [[noreturn]] void expected(const std::string& what) const;

  private:
    template <class T>
    [[nodiscard]] T value(bool is_expected, const char* what) const {
        if (!is_expected) expected(what);
        return json_->get<T>();
    }
    [[nodiscard]] std::string path_of(const std::string& member) const;

    const nlohmann::ordered_json* json_;
    std::string where_;
};

// Parses a text. Throws std::runtime_error with the line and column of invalid JSON, or with the bound of
// base::require_bounded_json() that the text exceeds.
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view text);

}  // namespace gloam::record

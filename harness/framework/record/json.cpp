// SPDX-License-Identifier: MIT
#include "record/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/text.hpp"
#include "numeric/numbers.hpp"

namespace gloam::record {
namespace {

using nlohmann::ordered_json;

using numeric::infinity;
constexpr std::size_t longest_quote = 40;
constexpr std::size_t most_elements = 1'000'000;
constexpr std::size_t longest_message = 300;

}  // namespace

ordered_json number_json(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return value;
}

std::string to_text(const ordered_json& document) {
    return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void JsonReader::expected(const std::string& what) const {
    const std::string found =
        base::shortened(json_->dump(-1, ' ', false, ordered_json::error_handler_t::replace), longest_quote);
    throw std::runtime_error((where_.empty() ? "" : where_ + ": ") + "expected " + what + ", found " + found);
}

bool JsonReader::has(const char* name) const {
    return json_->is_object() && json_->contains(name);
}

std::string JsonReader::path_of(const std::string& member) const {
    return where_.empty() ? member : where_ + "." + member;
}

JsonReader JsonReader::member(const std::string& name) const {
    if (!json_->is_object()) expected("an object with \"" + name + "\"");
    const auto found = json_->find(name);
    if (found == json_->end()) throw std::runtime_error(path_of(name) + ": expected this field, found none");
    return {*found, path_of(name)};
}

std::vector<JsonReader> JsonReader::elements() const {
    if (!json_->is_array() || json_->size() > most_elements)
        expected(fmt::format("an array of at most {} elements", most_elements));
    std::vector<JsonReader> all;
    for (const ordered_json& element : *json_)
        all.emplace_back(element, where_ + "[" + std::to_string(all.size()) + "]");
    return all;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    if (!json_->is_object()) expected("an object");
    std::vector<std::pair<std::string, JsonReader>> all;
    for (const auto& [name, value] : json_->items()) all.emplace_back(name, JsonReader(value, path_of(name)));
    return all;
}

std::string JsonReader::name() const {
    const std::string value = text();
    if (!value.empty() && !base::is_name(value)) expected("a text of one line, at most 1000 bytes");
    return value;
}

double JsonReader::number() const {
    if (json_->is_number()) return json_->get<double>();
    if (*json_ == "inf") return infinity;
    if (*json_ == "-inf") return -infinity;
    if (*json_ == "nan") return std::numeric_limits<double>::quiet_NaN();
    expected("a number");
}

int JsonReader::integer(int least, int most) const {
    if (!json_->is_number_integer() || json_->get<double>() < least || json_->get<double>() > most)
        expected(fmt::format("a whole number from {} to {}", least, most));
    return json_->get<int>();
}

ordered_json parse_json(std::string_view text) {
    try {
        base::require_bounded_json(text);
        return ordered_json::parse(text);
    } catch (const ordered_json::exception& error) {
        // Removes the exception's number from "[json.exception.parse_error.101] parse error at line 1, column
        // 2: ...", and shortens the quoted text.
        const std::string message = base::shortened(error.what(), longest_message);
        const std::size_t bracket = message.find("] ");
        throw std::runtime_error("no JSON: " +
                                 (bracket == std::string::npos ? message : message.substr(bracket + 2)));
    }
}

}  // namespace gloam::record

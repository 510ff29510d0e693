// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"

namespace gloam::experiment::internal {

using nlohmann::ordered_json;

// A value of a file in JSON and its place. Every reader throws std::runtime_error with the place, what was
// expected and what was found.
class Value {
  public:
    Value(const ordered_json& json, std::string where) : json_(&json), where_(std::move(where)) {}

    [[noreturn]] void expected(const std::string& what) const {
        const std::string found = json_->dump(-1, ' ', false, ordered_json::error_handler_t::replace);
        throw std::runtime_error(fmt::format("{}{}expected {}, found {}", where_, where_.empty() ? "" : ": ",
                                             what, base::shortened(found, longest_quote_)));
    }

    void read(std::string& text) const {
        if (!json_->is_string() || !base::is_name(json_->get<std::string>()))
            expected("a text of one line, at most 1000 bytes");
        text = json_->get<std::string>();
    }

    void read(bool& flag) const {
        if (!json_->is_boolean()) expected("true or false");
        flag = json_->get<bool>();
    }

    void read(double& number, double least, double most) const {
        if (!json_->is_number() || !(json_->get<double>() >= least) || !(json_->get<double>() <= most))
            expected(fmt::format("a number from {:g} to {:g}", least, most));
        number = json_->get<double>();
    }

    void read(int& count, int least, int most) const {
        if (!json_->is_number_integer() || json_->get<double>() < least || json_->get<double>() > most)
            expected(fmt::format("a whole number from {} to {}", least, most));
        count = json_->get<int>();
    }

    // One of these words.
    void read(std::string& word, const std::vector<std::string>& words) const {
        if (!json_->is_string() || std::ranges::count(words, json_->get<std::string>()) == 0)
            expected(fmt::format("one of {}", fmt::join(words, ", ")));
        word = json_->get<std::string>();
    }

    template <class T, class... Bounds>
    void read(std::optional<T>& value, Bounds... bounds) const {
        read(value.emplace(), bounds...);
    }

    template <class T, class... Bounds>
    void read(std::vector<T>& values, Bounds... bounds) const {
        for (const Value& element : elements()) element.read(values.emplace_back(), bounds...);
    }

    [[nodiscard]] bool is_null() const { return json_->is_null(); }
    [[nodiscard]] bool is_array() const { return json_->is_array(); }

    [[nodiscard]] std::vector<Value> elements() const {
        if (!json_->is_array() || json_->size() > most_elements_)
            expected(fmt::format("an array of at most {} elements", most_elements_));
        std::vector<Value> all;
        for (const ordered_json& element : *json_)
            all.emplace_back(element, fmt::format("{}[{}]", where_, all.size()));
        return all;
    }

    [[nodiscard]] std::vector<std::pair<std::string, Value>> members() const {
        if (!json_->is_object()) expected("an object");
        std::vector<std::pair<std::string, Value>> all;
        for (const auto& [name, value] : json_->items())
            all.emplace_back(name, Value(value, where_.empty() ? name : where_ + "." + name));
        return all;
    }

    // A setting's value as text that effect::set() reads.
    [[nodiscard]] std::string setting() const {
        if (json_->is_boolean()) return json_->get<bool>() ? "on" : "off";
        if (json_->is_string()) return json_->get<std::string>();
        if (!json_->is_number()) expected("a number, a name, true or false");
        return json_->dump();
    }

  private:
    static constexpr std::size_t most_elements_ = 100'000;
    static constexpr std::size_t longest_quote_ = 40;

    const ordered_json* json_;
    std::string where_;
};

// The members of an object. Those that nobody asked for are an error, because a misspelt one would be
// ignored.
class Members {
  public:
    explicit Members(const Value& value) : value_(value), members_(value.members()) {}

    // nullptr: there is none.
    [[nodiscard]] const Value* find(const std::string& name) {
        asked_.insert(name);
        const auto found = std::ranges::find(members_, name, [](const auto& member) { return member.first; });
        return found == members_.end() ? nullptr : &found->second;
    }

    // Reads the member if there is one.
    template <class T, class... Bounds>
    void read(const std::string& name, T& value, Bounds... bounds) {
        if (const Value* member = find(name)) member->read(value, bounds...);
    }

    void require_known() const {
        for (const auto& [name, value] : members_)
            if (!asked_.contains(name)) value.expected(fmt::format("one of {}", fmt::join(asked_, ", ")));
    }

    void require(const std::string& name, bool given) const {
        if (!given) value_.expected("an object with \"" + name + "\"");
    }

  private:
    Value value_;
    std::vector<std::pair<std::string, Value>> members_;
    std::set<std::string> asked_;
};

// The object that a text holds. Throws std::runtime_error otherwise.
inline ordered_json parsed(std::string_view text) {
    base::require_bounded_json(text);
    ordered_json document = ordered_json::parse(text, nullptr, false);
    if (document.is_discarded()) throw std::runtime_error("no JSON");
    if (!document.is_object()) throw std::runtime_error("expected an object");
    return document;
}

}  // namespace gloam::experiment::internal

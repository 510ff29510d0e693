// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "record/json.hpp"

namespace gloam::experiment::internal {

using record::JsonReader;

// Each reads a value within bounds.
inline void read(const JsonReader& value, std::string& text) {
    text = value.name();
    if (text.empty()) value.expected("a text of one line, at most 1000 bytes");
}
inline void read(const JsonReader& value, bool& flag) {
    flag = value.flag();
}
inline void read(const JsonReader& value, double& number, double least, double most) {
    number = value.number(least, most);
}
inline void read(const JsonReader& value, int& count, int least, int most) {
    count = value.integer(least, most);
}
inline void read(const JsonReader& value, std::string& word, const std::vector<std::string>& words) {
    word = value.word_of(words);
}
template <class T, class... Bounds>
void read(const JsonReader& value, std::optional<T>& read_value, Bounds... bounds) {
    read(value, read_value.emplace(), bounds...);
}
template <class T, class... Bounds>
void read(const JsonReader& value, std::vector<T>& values, Bounds... bounds) {
    for (const JsonReader& element : value.elements()) read(element, values.emplace_back(), bounds...);
}

// A setting's value as text that effect::set() reads.
[[nodiscard]] inline std::string setting_of(const JsonReader& value) {
    const nlohmann::ordered_json& json = value.json();
    if (json.is_boolean()) return json.get<bool>() ? "on" : "off";
    if (json.is_string()) return json.get<std::string>();
    if (!json.is_number()) value.expected("a number, a name, true or false");
    return json.dump();
}

// The members of an object. Those that nobody asked for are an error, because a misspelt one would be
// ignored.
class Members {
  public:
    explicit Members(const JsonReader& value) : value_(value), members_(value.members()) {}

    // nullptr: there is none.
    [[nodiscard]] const JsonReader* find(const std::string& name) {
        asked_.insert(name);
        const auto found = std::ranges::find(members_, name, [](const auto& member) { return member.first; });
        return found == members_.end() ? nullptr : &found->second;
    }

    // Reads the member if there is one.
    template <class T, class... Bounds>
    void read(const std::string& name, T& value, Bounds... bounds) {
        if (const JsonReader* member = find(name)) internal::read(*member, value, bounds...);
    }

    void require_known() const {
        for (const auto& [name, value] : members_)
            if (!asked_.contains(name)) value.expected(fmt::format("one of {}", fmt::join(asked_, ", ")));
    }

    void require(const std::string& name, bool given) const {
        if (!given) value_.expected("an object with \"" + name + "\"");
    }

  private:
    JsonReader value_;
    std::vector<std::pair<std::string, JsonReader>> members_;
    std::set<std::string> asked_;
};

}  // namespace gloam::experiment::internal

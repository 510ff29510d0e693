// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "record/json.hpp"

// JSON of a structure, and back. Its members are named once, by a function template members(io, structure)
// beside it: a MemberWriter writes them in this order, a MemberReader reads them. An enumeration has
// name_of(value) and value_from(json, value).
namespace gloam::record {

enum class Present {
    always,
    name,      // always; a text for tables, titles and messages: JsonReader::name()
    later,     // texts of earlier versions lack it
    if_any,    // left out where it is empty
    if_given,  // null where `given` is false
    derived    // it follows from others, and is not read
};

class MemberWriter {
  public:
    nlohmann::ordered_json json = nlohmann::ordered_json::object();

    template <class T>
    void member(const char* name, const T& value, Present present = Present::always, bool given = true) {
        if (present == Present::if_any && is_empty(value)) return;
        json[name] = given ? json_of(value) : nlohmann::ordered_json(nullptr);
    }
    // Reading refuses a structure for which this does not hold.
    void require(bool, const char*) const {}

    // A text, a list, or a count of inputs.
    template <class T>
    [[nodiscard]] static bool is_empty(const T& value) {
        if constexpr (requires { value.empty(); }) return value.empty();
        if constexpr (requires { value.inputs == 0; }) return value.inputs == 0;
        return false;
    }

    [[nodiscard]] static nlohmann::ordered_json json_of(double value) { return number_json(value); }
    template <class T>
    [[nodiscard]] static nlohmann::ordered_json json_of(const T& value) {
        if constexpr (std::is_enum_v<T>) {
            return name_of(value);
        } else if constexpr (requires { typename T::allocator_type; } && !std::is_same_v<T, std::string>) {
            nlohmann::ordered_json all = nlohmann::ordered_json::array();
            for (const auto& one : value) all.push_back(json_of(one));
            return all;
        } else if constexpr (requires { value.has_value(); }) {
            return value ? json_of(*value) : nlohmann::ordered_json(nullptr);
        } else if constexpr (std::is_constructible_v<nlohmann::ordered_json, T>) {
            return value;
        } else {
            MemberWriter writer;
            members(writer, const_cast<T&>(value));  // which only a reader changes
            return std::move(writer.json);
        }
    }
};

class MemberReader {
  public:
    explicit MemberReader(JsonReader json) : json_(std::move(json)) {}

    template <class T>
    void member(const char* name, T&& value, Present present = Present::always, bool = true) const {
        const bool may_lack = present == Present::later || present == Present::if_any;
        if (present == Present::derived || (may_lack && !json_.has(name))) return;
        const JsonReader found = json_.member(name);
        if (present == Present::name) (void)found.name();
        if (present != Present::if_given || !found.is_null()) read(found, value);
    }
    void require(bool holds, const char* expected) const {
        if (!holds) json_.expected(expected);
    }

    static void read(const JsonReader& json, std::string& text) { text = json.text(); }
    static void read(const JsonReader& json, bool& flag) { flag = json.flag(); }
    static void read(const JsonReader& json, double& number) { number = json.number(); }
    static void read(const JsonReader& json, std::size_t& count) { count = json.count(); }
    static void read(const JsonReader& json, std::uint32_t& word) { word = json.word(); }
    static void read(const JsonReader& json, int& count) {
        count = static_cast<int>(json.count_up_to(1U << 24U));
    }
    template <class T>
    static void read(const JsonReader& json, std::vector<T>& values) {
        for (const JsonReader& element : json.elements()) read(element, values.emplace_back());
    }
    template <class T>
    static void read(const JsonReader& json, std::optional<T>& value) {
        if (!json.is_null()) read(json, value.emplace());
    }
    template <class T>
    static void read(const JsonReader& json, T& value) {
        if constexpr (std::is_enum_v<T>) {
            value = value_from(json, value);
        } else {
            MemberReader reader(json);
            members(reader, value);
        }
    }

  private:
    JsonReader json_;
};

// Several members that are always present: a name, a value, and so on.
template <class Io, class T, class... Rest>
void each(Io& io, const char* name, T&& value, Rest&&... rest) {
    io.member(name, value);
    if constexpr (sizeof...(rest) > 0) each(io, rest...);
}

// One line of JSON.
template <class T>
[[nodiscard]] std::string line_of(const T& value) {
    return MemberWriter::json_of(value).dump(-1, ' ', false,
                                             nlohmann::ordered_json::error_handler_t::replace);
}

// Throws like parse_json() and JsonReader.
template <class T>
[[nodiscard]] T from_line(std::string_view text) {
    const nlohmann::ordered_json json = parse_json(text);
    T value{};
    MemberReader::read(JsonReader(json, ""), value);
    return value;
}

}  // namespace gloam::record

// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <type_traits>

#include "record/json.hpp"

// JSON of a structure, and back. Its members are named once, by a function template members(io, structure)
// beside it: a MemberWriter writes them in this order, a MemberReader reads them, and then calls
// complete(json, structure) where there is that. An enumeration has name_of(value) and `names_of`.
namespace gloam::record {

// members() of a structure whose members have their own names in the text.
#define GLOAM_MEMBER(name) io.member(#name, all.name);
#define GLOAM_MEMBERS(Structure, ...)                                        \
    template <class Io>                                                      \
    void members(Io& io, Structure& all) {                                   \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(GLOAM_MEMBER, __VA_ARGS__)) \
    }

// How a structure is written.
enum class Form {
    whole,  // with all members; a number that JSON lacks is a text: number_json()
    sparse  // without empty texts and optional members that there are none of; such a number is null
};
template <class T>
inline constexpr Form form_of = Form::whole;

enum class Present {
    always,
    name,      // always; a text for tables, titles and messages: JsonReader::name()
    later,     // texts of earlier versions lack it
    if_any,    // left out where it is empty
    if_given,  // null where `given` is false
    derived    // it follows from others, and is not read
};

// An enumeration to be read: how many values it has, counted from 0, and what they are.
struct Names {
    std::size_t count = 0;
    const char* expected = nullptr;
};
template <class Enumeration>
inline constexpr Names names_of{};

template <class Enumeration>
[[nodiscard]] Enumeration value_named(const JsonReader& json, std::string_view name) {
    for (std::size_t i = 0; i < names_of<Enumeration>.count; ++i)
        if (name_of(static_cast<Enumeration>(i)) == name) return static_cast<Enumeration>(i);
    json.expected(names_of<Enumeration>.expected);
}

template <class T>
concept Optional = requires(const T& value) { value.has_value(); };
template <class T>
concept Text = std::is_same_v<T, std::string>;

template <Form form>
class MemberWriter {
  public:
    using Json = nlohmann::ordered_json;
    Json json = Json::object();

    template <class T>
    void member(const char* name, const T& value, Present present = Present::always, bool given = true) {
        constexpr bool may_lack = form == Form::sparse && (Optional<T> || Text<T>);
        if ((may_lack || present == Present::if_any) && is_empty(value)) return;
        json[name] = given ? json_of(value) : Json(nullptr);
    }
    // Reading refuses a structure for which this does not hold.
    void require(bool, const char*) const {}

    // A text, a list, what there is none of, or a count of inputs.
    template <class T>
    [[nodiscard]] static bool is_empty(const T& value) {
        if constexpr (Optional<T>) return !value.has_value();
        if constexpr (requires { value.empty(); }) return value.empty();
        if constexpr (requires { value.inputs == 0; }) return value.inputs == 0;
        return false;
    }

    template <class T>
    [[nodiscard]] static Json json_of(const T& value) {
        if constexpr (std::is_same_v<T, double>) {
            return form == Form::sparse ? Json(value) : number_json(value);
        } else if constexpr (std::is_enum_v<T>) {
            return name_of(value);
        } else if constexpr (requires { typename T::allocator_type; } && !Text<T>) {
            Json all = Json::array();
            for (const auto& one : value) all.push_back(json_of(one));
            return all;
        } else if constexpr (Optional<T>) {
            return value ? json_of(*value) : Json(nullptr);
        } else if constexpr (std::is_constructible_v<Json, T>) {
            return value;
        } else {
            MemberWriter writer;
            members(writer, const_cast<T&>(value));  // which only a reader changes
            return std::move(writer.json);
        }
    }
};

template <Form form>
class MemberReader {
  public:
    explicit MemberReader(JsonReader json) : json_(std::move(json)) {}

    template <class T>
    void member(const char* name, T&& value, Present present = Present::always, bool = true) const {
        constexpr bool sparse_text = form == Form::sparse && Text<std::remove_cvref_t<T>>;
        const bool may_lack = sparse_text || (form == Form::sparse && Optional<std::remove_cvref_t<T>>) ||
                              present == Present::later || present == Present::if_any;
        if (present == Present::derived || (may_lack && !json_.has(name))) return;
        const JsonReader found = json_.member(name);
        if (present == Present::name || sparse_text) (void)found.name();
        if (present != Present::if_given || !found.is_null()) read(found, value);
    }
    void require(bool holds, const char* expected) const {
        if (!holds) json_.expected(expected);
    }

    static void read(const JsonReader& json, std::string& text) { text = json.text(); }
    static void read(const JsonReader& json, bool& flag) { flag = json.flag(); }
    static void read(const JsonReader& json, double& number) {
        const bool lacks = form == Form::sparse && json.is_null();
        number = lacks ? std::numeric_limits<double>::quiet_NaN() : json.number();
    }
    static void read(const JsonReader& json, std::size_t& count) { count = json.count(); }
    static void read(const JsonReader& json, std::uint32_t& word) {
        if (json.count() > std::numeric_limits<std::uint32_t>::max()) json.expected("a 32-bit word");
        word = static_cast<std::uint32_t>(json.count());
    }
    static void read(const JsonReader& json, int& count) { count = json.integer(0, 1 << 24); }
    template <class T>
    static void read(const JsonReader& json, std::vector<T>& values) {
        for (const JsonReader& element : json.elements()) read(element, values.emplace_back());
    }
    template <class T>
    static void read(const JsonReader& json, std::optional<T>& value) {
        if (form == Form::sparse || !json.is_null()) read(json, value.emplace());
    }
    template <class T>
    static void read(const JsonReader& json, T& value) {
        if constexpr (std::is_enum_v<T>) {
            value = value_named<T>(json, json.text());
        } else {
            MemberReader reader(json);
            members(reader, value);
            if constexpr (requires { complete(json, value); }) complete(json, value);
        }
    }

  private:
    JsonReader json_;
};

// Several members: a name, a value, and so on.
template <Present present = Present::always, class Io, class T, class... Rest>
void each(Io& io, const char* name, T&& value, Rest&&... rest) {
    io.member(name, value, present);
    if constexpr (sizeof...(rest) > 0) each<present>(io, rest...);
}

template <class T>
[[nodiscard]] nlohmann::ordered_json json_of(const T& value) {
    return MemberWriter<form_of<T>>::json_of(value);
}

// Throws like JsonReader.
template <class T>
[[nodiscard]] T from_json(const JsonReader& json) {
    T value{};
    MemberReader<form_of<T>>::read(json, value);
    return value;
}

// One line of JSON.
template <class T>
[[nodiscard]] std::string line_of(const T& value) {
    return json_of(value).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// Throws like parse_json() and JsonReader.
template <class T>
[[nodiscard]] T from_line(std::string_view text) {
    const nlohmann::ordered_json json = parse_json(text);
    return from_json<T>(JsonReader(json, ""));
}

}  // namespace gloam::record

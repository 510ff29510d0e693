// SPDX-License-Identifier: MIT
#include "cli/check/task.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;

constexpr auto replace = json::error_handler_t::replace;  // of bytes that are no UTF-8

// Parses a line as an object with these members.
json object_from(std::string_view line, std::initializer_list<const char*> members) {
    constexpr std::size_t longest_quote = 200;
    const std::string quote = base::shortened(line, longest_quote);
    base::require_bounded_json(line);
    json object = json::parse(line, nullptr, false);
    if (!object.is_object()) throw std::runtime_error("expected a JSON object, found " + quote);
    for (const char* member : members) {
        if (!object.contains(member))
            throw std::runtime_error("expected the field \"" + std::string(member) + "\" in " + quote);
    }
    return object;
}

// The library converts any number to any type, even out of range.
std::uint64_t count_in(const json& object, const char* member) {
    const json& value = object[member];
    if (!value.is_number_unsigned())
        throw std::runtime_error(std::string("\"") + member + "\": expected a count");
    return value.get<std::uint64_t>();
}

std::string text_in(const json& object, const char* member) {
    const json& value = object[member];
    if (!value.is_string()) throw std::runtime_error(std::string("\"") + member + "\": expected a text");
    return value.get<std::string>();
}

bool flag_in(const json& object, const char* member) {
    const json& value = object[member];
    if (!value.is_boolean())
        throw std::runtime_error(std::string("\"") + member + "\": expected true or false");
    return value.get<bool>();
}

std::vector<std::string> texts_in(const json& object, const char* member) {
    const json& value = object[member];
    const auto is_text = [](const json& element) { return element.is_string(); };
    if (!value.is_array() || !std::ranges::all_of(value, is_text))
        throw std::runtime_error(std::string("\"") + member + "\": expected texts");
    return value.get<std::vector<std::string>>();
}

}  // namespace

std::string to_line(const CheckTask& task) {
    const json object{{"equation", task.equation}, {"variant", task.variant},   {"inputs", task.inputs},
                      {"seed", task.seed},         {"coverage", task.coverage}, {"file", task.file},
                      {"ranges", task.ranges},     {"includes", task.includes}};
    return object.dump(-1, ' ', false, replace);
}

CheckTask task_from(std::string_view line) {
    const json object = object_from(
        line, {"equation", "variant", "inputs", "seed", "coverage", "file", "ranges", "includes"});
    return {.equation = text_in(object, "equation"),
            .variant = text_in(object, "variant"),
            .inputs = count_in(object, "inputs"),
            .seed = count_in(object, "seed"),
            .coverage = flag_in(object, "coverage"),
            .file = text_in(object, "file"),
            .ranges = texts_in(object, "ranges"),
            .includes = texts_in(object, "includes")};
}

std::string to_line(const Greeting& greeting) {
    const json object{{"device", report::to_json(greeting.device)},
                      {"devices", greeting.devices},
                      {"error", greeting.error}};
    return object.dump(-1, ' ', false, replace);
}

Greeting greeting_from(std::string_view line) {
    const json object = object_from(line, {"device", "devices", "error"});
    return {.device = report::device_from_json(text_in(object, "device")),
            .devices = count_in(object, "devices"),
            .error = text_in(object, "error")};
}

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#include "cli/work_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/cached_file.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "cli/arguments.hpp"
#include "cli/names.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t most_items = 1'000'000;
constexpr std::size_t most_arguments = 1000;  // of an item
constexpr std::string_view result_mark = "{result}";
// What the commands themselves replace: `gloam check --compiler`.
constexpr std::array<std::string_view, 5> other_marks{"{each}", "{glsl}", "{in}", "{out}", "{random}"};
// Those that write a result.
constexpr std::array<std::string_view, 6> commands{"audit", "bench", "check", "render", "stress", "tune"};

struct Values {
    std::string mark;  // "{NAME}"
    std::vector<std::string> values;
};

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        if (end > 0) parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

std::vector<std::string> values_of(const std::string& text) {
    if (text.starts_with('@')) return split(read_text(text.substr(1)), '\n');
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return split(text, ',');
    const auto low = base::number_from<std::size_t>(std::string_view(text).substr(0, dots));
    const auto high = base::number_from<std::size_t>(std::string_view(text).substr(dots + 2));
    if (!low || !high || *high < *low || *high - *low >= most_items)
        throw std::invalid_argument(
            fmt::format("expected LOW..HIGH, at most {} whole numbers, found {}", most_items, text));
    std::vector<std::string> values;
    for (std::size_t i = *low; i <= *high; ++i) values.push_back(std::to_string(i));
    return values;
}

bool is_word(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

Values read_each(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    try {
        const std::string mark = "{" + name + "}";
        if (equals == std::string::npos || !is_word(name) || mark == result_mark ||
            std::ranges::find(other_marks, mark) != other_marks.end())
            throw std::invalid_argument(
                fmt::format("expected NAME=VALUES, with a NAME of a-z, 0-9, _ and -, without {}, {}",
                            result_mark, fmt::join(other_marks, ", ")));
        Values each{.mark = mark, .values = values_of(text.substr(equals + 1))};
        if (each.values.empty()) throw std::invalid_argument("expected at least one value");
        return each;
    } catch (const std::exception& error) {
        throw std::invalid_argument(fmt::format("--each {}: {}", text, error.what()));
    }
}

std::size_t count_of(const WorkItem& item, std::string_view mark) {
    std::size_t count = 0;
    for (const std::string& argument : item)
        for (std::size_t at = argument.find(mark); at != std::string::npos; at = argument.find(mark, at + 1))
            ++count;
    return count;
}

void replace(WorkItem& item, std::string_view mark, const std::string& value) {
    for (std::string& argument : item) argument = base::replaced(std::move(argument), mark, value);
}

// Throws std::invalid_argument if this cannot be an item.
void require_item(const WorkItem& item) {
    if (item.empty() || std::ranges::find(commands, item.front()) == commands.end())
        throw std::invalid_argument(
            fmt::format("expected -- and one of the commands {}, found {}", fmt::join(commands, ", "),
                        item.empty() ? "nothing" : base::shortened(item.front(), 40)));
    if (item.size() > most_arguments)
        throw std::invalid_argument(fmt::format("expected at most {} arguments", most_arguments));
    if (count_of(item, result_mark) != 1)
        throw std::invalid_argument(
            "expected {result} once in the arguments, for the file or the folder that they write: --json "
            "{result}");
}

// Throws std::invalid_argument if a {NAME} stands for nothing, or nothing for a value.
void require_marks(const std::vector<Values>& all, const WorkItem& arguments) {
    WorkItem rest = arguments;
    for (const Values& each : all) {
        if (count_of(rest, each.mark) == 0)
            throw std::invalid_argument(fmt::format("--each: no argument holds {}", each.mark));
        replace(rest, each.mark, "");
    }
    replace(rest, result_mark, "");
    for (const std::string_view mark : other_marks) replace(rest, mark, "");
    for (const std::string& argument : rest) {
        const std::size_t begin = argument.find('{');
        const std::size_t end = argument.find('}', std::min(begin, argument.size()));
        if (end != std::string::npos && is_word(argument.substr(begin + 1, end - begin - 1)))
            throw std::invalid_argument(
                fmt::format("{}: no --each names its values", argument.substr(begin, end - begin + 1)));
    }
}

std::string lines_of(const std::vector<WorkItem>& items) {
    std::string lines;
    for (const WorkItem& item : items)
        lines += json(item).dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
    return lines;
}

WorkItem item_from(const std::string& line) {
    const json array = json::parse(line, nullptr, false);
    if (!array.is_array()) throw std::runtime_error("expected a JSON array of texts");
    WorkItem item;
    for (const json& argument : array) {
        if (!argument.is_string()) throw std::runtime_error("expected a JSON array of texts");
        item.push_back(argument.get<std::string>());
    }
    require_item(item);
    return item;
}

// What a list's first line says.
struct Heading {
    std::string versions;
    std::string hash;
};

Heading heading_from(std::string_view line) {
    const json object = json::parse(line, nullptr, false);
    if (!object.is_object() || object.value("work_list", json()) != 1 ||
        !object.value("versions", json()).is_string() || !object.value("hash", json()).is_string())
        throw std::runtime_error("it is not what `gloam work list` prints");
    return {.versions = object["versions"].get<std::string>(), .hash = object["hash"].get<std::string>()};
}

WorkList list_from(std::string_view text) {
    const std::size_t end = text.find('\n');
    base::require_bounded_json(text.substr(0, end));
    const Heading heading = heading_from(text.substr(0, end));
    const std::string_view lines = end == std::string_view::npos ? "" : text.substr(end + 1);
    if (base::to_hex(base::hash_of(lines)) != heading.hash)
        throw std::runtime_error("it was changed after it was made, or its end is missing: make it anew");
    if (heading.versions != versions())
        throw std::runtime_error(fmt::format("it was made by {}; this is {}: make it anew",
                                             base::one_line(heading.versions), versions()));
    WorkList list;
    for (const std::string& line : split(lines, '\n')) {
        base::require_bounded_json(line);
        list.items.push_back(item_from(line));
        if (list.items.size() > most_items)
            throw std::runtime_error(fmt::format("it has more than {} items", most_items));
    }
    return list;
}

}  // namespace

std::string WorkList::key_of(const WorkItem& item) {
    base::Fingerprint key;
    key.add(versions());
    for (const std::string& argument : item) key.add(argument);
    return base::to_hex(key.hash());
}

WorkList work_list_of(const std::vector<std::string>& each, const WorkItem& arguments) {
    std::vector<Values> all;
    for (const std::string& text : each) all.push_back(read_each(text));
    require_item(arguments);
    require_marks(all, arguments);
    WorkList list{.items = {arguments}};
    for (const Values& values : all) {
        if (list.items.size() > most_items / values.values.size())
            throw std::invalid_argument(fmt::format("--each: expected at most {} items", most_items));
        std::vector<WorkItem> more;
        for (const WorkItem& item : list.items) {
            for (const std::string& value : values.values) {
                more.push_back(item);
                replace(more.back(), values.mark, value);
            }
        }
        list.items = std::move(more);
    }
    return list;
}

std::string to_text(const WorkList& list) {
    const std::string lines = lines_of(list.items);
    const ordered_json heading{{"work_list", 1},
                               {"versions", versions()},
                               {"items", list.items.size()},
                               {"hash", base::to_hex(base::hash_of(lines))}};
    return heading.dump() + "\n" + lines;
}

WorkList read_work_list(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    try {
        return list_from(text);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("work list {}: {}", file.string(), error.what()));
    }
}

WorkItem with_result(WorkItem item, const std::string& result) {
    replace(item, result_mark, result);
    return item;
}

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#include "source/lines.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace gloam::source {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

// Where a character stands: quotes end with their line, a block comment does not.
enum class In { code, quotes, line_comment, block_comment };

// What is next of a text: so many characters, of which the code shows this one each.
struct Step {
    std::size_t count = 1;
    char shown = ' ';
};

// The next step, and where the one after it stands.
Step step(std::string_view rest, In& in) {
    if (rest.starts_with("\\\n")) return {2, '\0'};
    if (rest.starts_with("\\\r\n")) return {3, '\0'};
    const char next = rest.front();
    const Step visible{1, next};
    if (next == '\n') return visible;
    if (in == In::code && (rest.starts_with("//") || rest.starts_with("/*"))) {
        in = rest[1] == '/' ? In::line_comment : In::block_comment;
        return {2, ' '};
    }
    if (in == In::code || in == In::quotes) {
        if (next == '"') in = in == In::code ? In::quotes : In::code;
        return visible;
    }
    if (in == In::line_comment || !rest.starts_with("*/")) return {};
    in = In::code;
    return {2, ' '};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<Line> split_lines(std::string_view text) {
    std::vector<Line> lines;
    In in = In::code;
    int number = 1;
    while (!text.empty()) {
        Line line{.text = {}, .code = {}, .number = number, .crosses = in == In::block_comment};
        std::size_t end = 0;
        while (end < text.size() && !line.code.ends_with('\n')) {
            const auto [count, shown] = step(text.substr(end), in);
            if (shown == '\0' && count > 1) ++number;
            line.code.append(count, shown);
            end += count;
        }
        line.text = text.substr(0, end);
        text.remove_prefix(end);
        ++number;
        if (in != In::block_comment) in = In::code;
        line.crosses = line.crosses || in == In::block_comment;
        lines.push_back(std::move(line));
    }
    return lines;
}

ActiveText whole_text(std::string text) {
    ActiveText all;
    TextFile& file = all.files.emplace_back(TextFile{.name = "text", .text = std::move(text), .lines = {}});
    file.lines = split_lines(file.text);
    for (std::size_t i = 0; i < file.lines.size(); ++i) all.lines.push_back({0, i});
    all.given = 1;
    return all;
}

bool is_blank(const Line& line) {
    return std::ranges::all_of(line.code,
                               [](char c) { return c == '\0' || blanks.find(c) != std::string_view::npos; });
}

std::string comments_of(const Line& line) {
    std::string comments(line.text);
    for (std::size_t i = 0; i < comments.size(); ++i)
        if (line.code[i] != '\0' && blanks.find(line.code[i]) == std::string_view::npos) comments[i] = ' ';
    return comments;
}

std::optional<Directive> directive_of(const Line& line) {
    std::string code = line.code;
    std::erase(code, '\0');
    std::string_view rest = trimmed(code);
    if (!rest.starts_with('#')) return std::nullopt;
    rest = trimmed(rest.substr(1));
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    const auto end = std::find_if_not(rest.begin(), rest.end(), is_letter);
    const auto length = static_cast<std::size_t>(end - rest.begin());
    return Directive{std::string(rest.substr(0, length)), std::string(trimmed(rest.substr(length)))};
}

std::optional<IncludeName> include_of(const Line& line) {
    const std::optional<Directive> directive = directive_of(line);
    if (!directive || directive->keyword != "include" || directive->argument.empty()) return std::nullopt;
    const std::string& argument = directive->argument;
    const bool system = argument.front() == '<';
    if (!system && argument.front() != '"') return std::nullopt;
    const auto end = argument.find(system ? '>' : '"', 1);
    if (end == std::string::npos) return std::nullopt;
    return IncludeName{argument.substr(1, end - 1), system};
}

void require_vulkan_version(const Source& source) {
    constexpr std::array accepted{"430",      "440",      "450",      "460",    "430 core",
                                  "440 core", "450 core", "460 core", "310 es", "320 es"};
    const std::vector<Line> lines = split_lines(source.text);
    const auto first = std::ranges::find_if_not(lines, is_blank);
    const int number = first == lines.end() ? 1 : first->number;
    const auto directive = first == lines.end() ? std::nullopt : directive_of(*first);
    std::string version;
    if (directive && directive->keyword == "version") {
        std::istringstream words(directive->argument);
        for (std::string word; words >> word;) version.append(version.empty() ? "" : " ").append(word);
    }
    if (std::ranges::find(accepted, version) != accepted.end()) return;
    throw CompileError(source.name + ":" + std::to_string(number) +
                       ": the text must start with #version 430 to 460 (core), 310 es or 320 es; found " +
                       (directive && directive->keyword == "version" ? version : "none"));
}

}  // namespace gloam::source

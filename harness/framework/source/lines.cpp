// SPDX-License-Identifier: MIT
#include "source/lines.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace gloam::source::internal {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// One pass over the text; a comment or a quoted name lasts from one step to the next.
class Splitter {
  public:
    explicit Splitter(std::string_view text) : text_(text) {}

    std::vector<Line> run() {
        while (at_ < text_.size()) step();
        if (begin_ < text_.size()) finish_line();
        return std::move(lines_);
    }

  private:
    enum class In { code, quotes, line_comment, block_comment };

    bool ahead(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

    void take(std::size_t count, char shown) {
        code_.append(count, shown);
        at_ += count;
    }

    void step() {
        if (ahead("\\\n")) return continue_line(2);
        if (ahead("\\\r\n")) return continue_line(3);
        if (text_[at_] == '\n') {
            take(1, '\n');
            return finish_line();
        }
        if (in_ == In::code) return step_code();
        const bool in_quotes = in_ == In::quotes;
        const bool ends = in_quotes ? text_[at_] == '"' : in_ == In::block_comment && ahead("*/");
        if (ends) in_ = In::code;
        take(ends && !in_quotes ? 2 : 1, in_quotes ? text_[at_] : ' ');
    }

    void step_code() {
        if (ahead("//") || ahead("/*")) {
            in_ = ahead("//") ? In::line_comment : In::block_comment;
            return take(2, ' ');
        }
        if (text_[at_] == '"') in_ = In::quotes;
        take(1, text_[at_]);
    }

    void continue_line(std::size_t count) {
        take(count, '\0');
        ++physical_;
    }

    void finish_line() {
        const bool crosses = entered_in_comment_ || in_ == In::block_comment;
        lines_.push_back({text_.substr(begin_, at_ - begin_), std::move(code_), number_, crosses});
        code_.clear();
        begin_ = at_;
        number_ = ++physical_;
        if (in_ != In::block_comment) in_ = In::code;
        entered_in_comment_ = in_ == In::block_comment;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
    std::string code_;
    In in_ = In::code;
    bool entered_in_comment_ = false;
    int number_ = 1;
    int physical_ = 1;
    std::vector<Line> lines_;
};

}  // namespace

std::vector<Line> split_lines(std::string_view text) {
    return Splitter(text).run();
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

}  // namespace gloam::source::internal

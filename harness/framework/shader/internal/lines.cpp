// SPDX-License-Identifier: MIT
#include "shader/internal/lines.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "shader/pack.hpp"

namespace gloam::shader::internal {
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
        switch (in_) {
            case In::code:
                return step_code();
            case In::quotes:
                if (text_[at_] == '"') in_ = In::code;
                return take(1, text_[at_]);
            case In::line_comment:
                return take(1, ' ');
            case In::block_comment:
                if (!ahead("*/")) return take(1, ' ');
                in_ = In::code;
                return take(2, ' ');
        }
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

bool is_blank(const Line& line) {
    return std::all_of(line.code.begin(), line.code.end(),
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

namespace {

constexpr std::string_view accepted[] = {"430",      "440",      "450",      "460",    "430 core",
                                         "440 core", "450 core", "460 core", "310 es", "320 es"};

std::string with_single_blanks(const std::string& text) {
    std::istringstream words(text);
    std::string joined;
    for (std::string word; words >> word;) joined.append(joined.empty() ? "" : " ").append(word);
    return joined;
}

}  // namespace

void require_vulkan_version(const Source& source) {
    int number = 1;
    std::string found = "none";
    for (const Line& line : split_lines(source.text)) {
        if (is_blank(line)) continue;
        number = line.number;
        const auto directive = directive_of(line);
        if (!directive || directive->keyword != "version") break;
        found = with_single_blanks(directive->argument);
        if (std::find(std::begin(accepted), std::end(accepted), found) != std::end(accepted)) return;
        break;
    }
    throw CompileError(source.name + ":" + std::to_string(number) +
                       ": the text must start with #version 430 to 460 (core), 310 es or 320 es; found " +
                       found);
}

}  // namespace gloam::shader::internal

namespace gloam::shader {

namespace {

bool is_own(std::string_view declaration) {
    const auto begins = [&](std::string_view with) { return declaration.starts_with(with); };
    return begins("layout") || begins("void main(") || begins("#version") || begins("#extension");
}

// How many braces and parentheses a line opens, less those that it closes.
std::ptrdiff_t opened(std::string_view code) {
    const auto of = [&](char c) { return std::ranges::count(code, c); };
    return of('{') + of('(') - of('}') - of(')');
}

}  // namespace

std::size_t code_lines(const std::vector<std::string>& packed) {
    std::set<std::string> counted;
    std::size_t all = 0;
    for (const std::string& text : packed) {
        std::string declaration;
        std::ptrdiff_t open = 0;
        for (const internal::Line& line : internal::split_lines(text)) {
            if (internal::is_blank(line)) continue;
            const std::string code = line.code.substr(0, line.code.find_last_not_of(" \n") + 1);
            declaration += code + '\n';
            open += opened(code);
            const bool ends = code.ends_with(';') || code.ends_with('}') || declaration.starts_with('#');
            if (open > 0 || !ends) continue;
            if (is_own(declaration) || counted.insert(declaration).second)
                all += static_cast<std::size_t>(std::ranges::count(declaration, '\n'));
            declaration.clear();
        }
    }
    return all;
}

}  // namespace gloam::shader

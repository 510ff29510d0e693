// SPDX-License-Identifier: MIT
#include "shader/internal/token_text.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace gloam::shader::internal {
namespace {

constexpr std::array long_operators{"<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^",
                                    "++",  "--",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
constexpr std::string_view digits = "0123456789";

std::size_t number_length(std::string_view text) {
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    std::size_t end = hex ? 2 : 0;
    for (; end < text.size(); ++end) {
        const bool sign = !hex && (text[end] == '+' || text[end] == '-') && end > 0 &&
                          (text[end - 1] == 'e' || text[end - 1] == 'E');
        if (!sign && text[end] != '.' && letters.find(text[end]) == std::string_view::npos) break;
    }
    return end;
}

std::size_t token_length(std::string_view text) {
    const bool fraction = text[0] == '.' && text.size() > 1 && digits.find(text[1]) != std::string_view::npos;
    if (fraction || digits.find(text[0]) != std::string_view::npos) return number_length(text);
    if (is_word(text)) return std::min(text.find_first_not_of(letters), text.size());
    const auto longer =
        std::ranges::find_if(long_operators, [&](const char* one) { return text.starts_with(one); });
    return longer == long_operators.end() ? 1 : std::string_view(*longer).size();
}

}  // namespace

bool is_word(std::string_view token) {
    return letters.find(token.front()) != std::string_view::npos &&
           digits.find(token.front()) == std::string_view::npos;
}

bool is_number(std::string_view token) {
    return digits.find(token.front()) != std::string_view::npos || (token.front() == '.' && token.size() > 1);
}

int line_at(std::string_view text, std::size_t position) {
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, position), '\n'));
}

std::vector<Token> tokens_of(const ActiveText& active) {
    constexpr std::string_view between{" \t\r\n\v\f\0", 7};
    std::vector<Token> tokens;
    for (const ActiveText::Place& place : active.lines) {
        const Line& line = active.at(place);
        if (place.file != 0 || internal::directive_of(line)) continue;
        const auto begin = static_cast<std::size_t>(line.text.data() - active.files[0].text.data());
        const std::string_view code = line.code;
        for (std::size_t at = code.find_first_not_of(between); at != std::string_view::npos;
             at = code.find_first_not_of(between, at)) {
            const std::size_t length = token_length(code.substr(at));
            tokens.push_back({std::string(code.substr(at, length)), begin + at});
            at += length;
        }
    }
    return tokens;
}

std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const char c = tokens[i].text.front();
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && --depth == 0) return i;
    }
    return tokens.size();
}

namespace {

class Regions {
  public:
    explicit Regions(const std::vector<Token>& tokens) : tokens_(tokens) {}

    std::vector<Region> run() {
        for (std::size_t first = 0; first < tokens_.size();) first = statement(first);
        return std::move(found_);
    }

  private:
    // Reads a declaration at file scope. Returns where the next one begins.
    std::size_t statement(std::size_t first) {
        std::optional<std::size_t> value;
        std::string name;
        for (std::size_t i = first; i < tokens_.size(); ++i) {
            const std::string& text = tokens_[i].text;
            if (text == "=" && !value) value = i + 1;
            if (text == ";") {
                const std::string& head = tokens_[first].text;
                if (value && head != "layout" && head != "uniform") found_.push_back({*value, i, ""});
                return i + 1;
            }
            if (text == "(" && i > 0 && is_word(tokens_[i - 1].text)) name = tokens_[i - 1].text;
            if (text == "{" && !value && tokens_[i - 1].text == ")" && name != "layout") {
                const std::size_t end = closing(tokens_, i);
                found_.push_back({i, end, name});
                return end + 1;
            }
            if (text == "(" || text == "{" || text == "[") i = closing(tokens_, i);
        }
        return tokens_.size();
    }

    const std::vector<Token>& tokens_;
    std::vector<Region> found_;
};

}  // namespace

std::vector<Region> regions(const std::vector<Token>& tokens) {
    return Regions(tokens).run();
}

}  // namespace gloam::shader::internal

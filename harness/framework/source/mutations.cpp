// SPDX-License-Identifier: MIT
#include "source/mutations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "source/declarations.hpp"

namespace gloam::source {
namespace {

// Rows of a token and what can stand in its place; "_": nothing.
constexpr std::string_view comparisons = "< <= >, <= < >=, > >= <, >= > <=, == !=, != ==";
constexpr std::string_view operators =
    "+ -, - +, * /, / *, % /, << >>, >> <<, & |, | &, ^ |, && ||, || &&, += -=, -= +=, *= /=, /= *=, |= &=, "
    "&= |=, ^= |=, ++ --, -- ++, ! _, ~ _, <<= >>=, >>= <<=";
constexpr std::string_view functions =
    "min max, max min, sin cos, cos sin, floor ceil, ceil floor, abs _, sqrt _, sign _, any all, all any, "
    "round floor, isnan isinf, isinf isnan, normalize _, roundEven floor, lessThan lessThanEqual, "
    "greaterThan greaterThanEqual";

// Other numbers in the place of one.
std::vector<std::string> other_numbers(const std::string& text) {
    const bool is_unsigned = text.ends_with('u') || text.ends_with('U');
    const std::string suffix = is_unsigned ? "u" : "";
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    if (hex || text.find_first_of(".eE") == std::string::npos) {
        unsigned long value = 0;
        std::from_chars(text.data() + (hex ? 2 : 0), text.data() + text.size(), value, hex ? 16 : 10);
        if (hex) return {fmt::format("{:#x}{}", value ^ 1UL, suffix)};
        std::vector<std::string> others{fmt::format("{}{}", value + 1, suffix)};
        if (value > 0) others.push_back(fmt::format("{}{}", value - 1, suffix));
        return others;
    }
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    if (value == 0.0) return {"1.0"};
    if (value == 1.0) return {"0.0", "2.0"};
    std::vector<std::string> others;
    for (const double other : {2.0 * value, 0.5 * value}) {
        const std::string shown = fmt::format("{}", other);
        if (std::isfinite(other))
            others.push_back(shown.find_first_of(".e") == std::string::npos ? shown + ".0" : shown);
    }
    return others;
}

// The faults of what declarations do: of the body of a function, or the value of a constant.
class Faults {
  public:
    explicit Faults(const std::string& text) : text_(text) {}

    void add(const Declaration& one) {
        tokens_ = one.tokens;
        if (!find_region()) return;
        function_ = in_body_ ? (one.names.empty() ? tokens_[0].text : one.names.front()) : "";
        loop_end_ = 0;
        brackets_ = 0;
        for (at_ = first_; at_ < last_; ++at_) {
            if (here() == "for" || here() == "while") loop_end_ = behind(tokens_, at_ + 1);
            if (here() == "(" || here() == "[") ++brackets_;
            if (here() == ")" || here() == "]") --brackets_;
            add_token();
        }
    }

    [[nodiscard]] std::vector<Mutation> take() { return std::move(found_); }

  private:
    [[nodiscard]] bool find_region() {
        for (std::size_t i = 0; i < tokens_.size(); i = behind(tokens_, i)) {
            in_body_ = tokens_[i] == "{" && before(i) == ")";
            if (!in_body_ && tokens_[i] != "=") continue;
            first_ = in_body_ ? i : i + 1;
            last_ = in_body_ ? behind(tokens_, i) - 1 : tokens_.size() - 1;
            return in_body_ || (tokens_[0] != "layout" && tokens_[0] != "uniform");
        }
        return false;
    }

    [[nodiscard]] const Token& near(std::size_t i) const {
        static const Token end{";"};
        return i < tokens_.size() ? tokens_[i] : end;
    }
    [[nodiscard]] const Token& here() const { return tokens_[at_]; }
    [[nodiscard]] const Token& before(std::size_t i) const {
        return i > 0 ? near(i - 1) : near(tokens_.size());
    }

    // From the token `first` to `last`.
    void found(const std::string& kind, std::size_t first, std::size_t last, std::string after) {
        const std::size_t begin = tokens_[first].begin;
        const std::size_t end = tokens_[last].end();
        found_.push_back({.begin = begin,
                          .end = end,
                          .line = tokens_[first].line,
                          .before = text_.substr(begin, end - begin),
                          .after = std::move(after),
                          .kind = kind,
                          .function = function_});
    }

    void found_others(const std::string& kind, std::string_view table) {
        std::istringstream rows{std::string(table)};
        for (std::string row; std::getline(rows, row, ',');) {
            std::istringstream words(row);
            std::string other;
            words >> other;
            if (here() != other) continue;
            while (words >> other) found(kind, at_, at_, other == "_" ? "" : other);
        }
    }

    void add_token() {
        const bool called = near(at_ + 1) == "(";
        if (here() == "-" && is_sign()) {
            found("operator", at_, at_, "");
        } else if (here() == "true" || here() == "false") {
            found("constant", at_, at_, here() == "true" ? "false" : "true");
        } else if (here().is_number()) {
            for (const std::string& other : other_numbers(here().text)) found("constant", at_, at_, other);
        } else if (here() == "if" && called) {
            const std::size_t last = behind(tokens_, at_ + 1) - 2;
            for (const char* value : {"true", "false"})
                if (at_ + 2 <= last) found("condition", at_ + 2, last, value);
        } else if (here() == "?") {
            for (const char* value : {"true", "false"}) found("condition", condition_begin(), at_ - 1, value);
        } else if (called) {
            found_others("function", functions);
        }
        found_others(at_ < loop_end_ ? "loop bound" : "comparison", comparisons);
        if (here() != "-" || !is_sign()) found_others("operator", operators);
        if (const auto end = statement_end()) found("statement", at_, *end, ";");
    }

    // A '-' or '+' in front of its only operand.
    [[nodiscard]] bool is_sign() const {
        const Token& one = before(at_);
        return one == "return" ||
               (!one.is_word() && !one.is_number() && one != ")" && one != "]" && one != "++" && one != "--");
    }

    // The first token of the condition of the '?' here.
    [[nodiscard]] std::size_t condition_begin() const {
        static const std::set<std::string_view> stops{"=", "return", ",",  ";",  "{",  "}",
                                                      "?", ":",      "+=", "-=", "*=", "/="};
        int depth = 0;
        for (std::size_t i = at_; i-- > first_;) {
            const std::string& text = near(i).text;
            if (text == ")" || text == "]") ++depth;
            if (text == "(" || text == "[") --depth;
            if (depth < 0 || (depth == 0 && stops.contains(text))) return i + 1;
        }
        return first_;
    }

    // The end of an assignment, a call, a continue or a break that begins here.
    [[nodiscard]] std::optional<std::size_t> statement_end() const {
        static const std::set<std::string_view> starts{"{", "}", ";", ")", "else"};
        static const std::set<std::string_view> others{"return", "if",      "for",    "while", "else",   "do",
                                                       "const",  "precise", "switch", "case",  "default"};
        const bool steps = here() == "++" || here() == "--";
        if (!in_body_ || brackets_ > 0 || !starts.contains(before(at_).text) || (!here().is_word() && !steps))
            return std::nullopt;
        if (!steps && (others.contains(here().text) || near(at_ + 1).is_word()))
            return std::nullopt;  // a declaration
        std::size_t end = at_;
        while (end < last_ && near(end) != ";") end = behind(tokens_, end);
        return end < last_ ? std::optional(end) : std::nullopt;
    }

    const std::string& text_;
    std::vector<Mutation> found_;
    Tokens tokens_;  // of the declaration
    std::size_t first_ = 0;
    std::size_t last_ = 0;  // excluded
    bool in_body_ = false;
    std::string function_;
    std::size_t at_ = 0;
    std::size_t loop_end_ = 0;
    int brackets_ = 0;
};

}  // namespace

std::vector<Mutation> mutations(const ActiveText& active) {
    Faults faults(active.files.front().text);
    for (const Declaration& one : source::outline(active).declarations)
        if (one.file == 0) faults.add(one);
    std::vector<Mutation> all = faults.take();
    std::ranges::stable_sort(all, {}, &Mutation::begin);
    return all;
}

std::string mutated(std::string text, const Mutation& mutation) {
    return text.replace(mutation.begin, mutation.end - mutation.begin, mutation.after);
}

}  // namespace gloam::source

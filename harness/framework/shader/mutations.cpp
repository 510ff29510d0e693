// SPDX-License-Identifier: MIT
#include "shader/mutations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "shader/internal/compiler_process.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/syntax_tree.hpp"
#include "shader/internal/token_text.hpp"

namespace gloam::shader {
namespace {

using internal::is_number;
using internal::is_word;
using internal::Region;
using internal::Token;
using internal::TokenText;

// A token and what can stand in its place; "_": nothing.
using Row = const char*;
constexpr std::array comparisons{"< <= >", "<= < >=", "> >= <", ">= > <=", "== !=", "!= =="};
constexpr std::array operators{"+ -",   "- +",   "* /",     "/ *",    "% /",   "<< >>", ">> <<",
                               "& |",   "| &",   "^ |",     "&& ||",  "|| &&", "+= -=", "-= +=",
                               "*= /=", "/= *=", "|= &=",   "&= |=",  "^= |=", "++ --", "-- ++",
                               "! _",   "~ _",   "<<= >>=", ">>= <<="};
constexpr std::array functions{"min max",
                               "max min",
                               "sin cos",
                               "cos sin",
                               "floor ceil",
                               "ceil floor",
                               "abs _",
                               "sqrt _",
                               "sign _",
                               "any all",
                               "all any",
                               "round floor",
                               "isnan isinf",
                               "isinf isnan",
                               "normalize _",
                               "roundEven floor",
                               "lessThan lessThanEqual",
                               "greaterThan greaterThanEqual"};

// Functions whose first two arguments may change places. clamp(x, a, b) is min(max(x, a), b).
const std::set<std::string> commutative{"clamp", "distance", "dot", "equal", "fma", "max", "min", "notEqual"};

// Other numbers in the place of one.
std::vector<std::string> other_numbers(const std::string& text) {
    const bool is_unsigned = text.ends_with('u') || text.ends_with('U');
    const std::string suffix = is_unsigned ? "u" : "";
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    if (hex || text.find_first_of(".eE") == std::string::npos) {
        unsigned long value = 0;
        const std::size_t prefix = hex ? 2 : 0;
        std::from_chars(text.data() + prefix, text.data() + text.size(), value, hex ? 16 : 10);
        if (hex) return {fmt::format("{:#x}{}", value ^ 1UL, suffix)};
        std::vector<std::string> found{fmt::format("{}{}", value + 1, suffix)};
        if (value > 0) found.push_back(fmt::format("{}{}", value - 1, suffix));
        return found;
    }
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    if (value == 0.0) return {"1.0"};
    if (value == 1.0) return {"0.0", "2.0"};
    std::vector<std::string> found;
    for (const double other : {2.0 * value, 0.5 * value}) {
        const std::string shown = fmt::format("{}", other);
        if (std::isfinite(other))
            found.push_back(shown.find_first_of(".e") == std::string::npos ? shown + ".0" : shown);
    }
    return found;
}

// Other components of a vector of this size.
std::vector<std::string> other_components(const std::string& text, std::size_t size) {
    constexpr std::array<std::string_view, 3> sets{"xyzw", "rgba", "stpq"};
    const std::string_view set = *std::ranges::find_if(sets, [&](std::string_view one) {
        return one == sets.back() || one.find(text[0]) != std::string_view::npos;
    });
    std::vector<std::string> found;
    const auto add = [&](const std::string& other) {
        if (other != text && std::ranges::find(found, other) == found.end()) found.push_back(other);
    };
    if (text.size() == 1) {
        for (const char c : set.substr(0, std::min<std::size_t>(size, 2))) add(std::string(1, c));
        return found;
    }
    add({text.rbegin(), text.rend()});
    add(std::string{text[1], text[0]} + text.substr(2));
    add(std::string(text.size(), text[0]));
    return found;
}

// The faults of one region.
class Faults {
  public:
    Faults(const std::string& text, const std::vector<Token>& tokens, const internal::TokenTypes& types,
           std::vector<Mutation>& found)
        : text_(text), tokens_(tokens), types_(types), found_(found) {}

    void add(const Region& region) {
        region_ = region;
        loop_end_ = 0;
        brackets_ = 0;
        for (at_ = region.first; at_ < region.last; ++at_) {
            if (here() == "for" || here() == "while") loop_end_ = internal::closing(tokens_, at_ + 1);
            if (here() == "(" || here() == "[") ++brackets_;
            if (here() == ")" || here() == "]") --brackets_;
            add_token();
        }
    }

  private:
    [[nodiscard]] const std::string& here() const { return tokens_[at_].text; }
    [[nodiscard]] std::string_view near(std::size_t i) const {
        return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view(";");
    }
    [[nodiscard]] std::string_view before() const { return at_ > 0 ? near(at_ - 1) : ";"; }
    [[nodiscard]] std::size_t end_of(std::size_t i) const {
        return tokens_[i].begin + tokens_[i].text.size();
    }
    [[nodiscard]] std::string between(std::size_t first, std::size_t last) const {
        return text_.substr(tokens_[first].begin, end_of(last) - tokens_[first].begin);
    }

    // From the token `first` to `last`.
    void found(const std::string& kind, std::size_t first, std::size_t last, std::string after) {
        const std::size_t begin = tokens_[first].begin;
        found_.push_back({.begin = begin,
                          .end = end_of(last),
                          .line = internal::line_at(text_, begin),
                          .before = between(first, last),
                          .after = std::move(after),
                          .kind = kind,
                          .function = region_.function});
    }

    void found_others(const std::string& kind, std::span<const Row> table) {
        for (const Row row : table) {
            std::istringstream words(row);
            std::string other;
            words >> other;
            if (other != here()) continue;
            while (words >> other) found(kind, at_, at_, other == "_" ? "" : other);
        }
    }

    void add_token() {
        const int line = tokens_[at_].tree_line;
        const bool called = near(at_ + 1) == "(";
        if (before() == "." && !called) {
            add_selected(line);
        } else if (here() == "-" && is_sign()) {
            found("operator", at_, at_, "");
        } else if (here() == "true" || here() == "false") {
            found("constant", at_, at_, here() == "true" ? "false" : "true");
        } else if (is_number(here())) {
            for (const std::string& other : other_numbers(here())) found("constant", at_, at_, other);
        } else if (here() == "if" && called) {
            const std::size_t close = internal::closing(tokens_, at_ + 1);
            for (const char* value : {"true", "false"}) found("condition", at_ + 2, close - 1, value);
        } else if (here() == "?") {
            for (const char* value : {"true", "false"}) found("condition", condition_begin(), at_ - 1, value);
        } else if (here() == ")" && types_.arguments.contains(line)) {
            add_swaps(types_.arguments.at(line));
        } else if (called) {
            found_others("function", functions);
        }
        found_others(at_ < loop_end_ ? "loop bound" : "comparison", comparisons);
        if (here() != "-" || !is_sign()) found_others("operator", operators);
        if (const auto end = statement_end()) found("statement", at_, *end, ";");
    }

    // A '-' or '+' in front of its only operand.
    [[nodiscard]] bool is_sign() const {
        const std::string_view one = before();
        return one == "return" ||
               (!is_word(one) && !is_number(one) && one != ")" && one != "]" && one != "++" && one != "--");
    }

    void add_selected(int line) {
        if (const auto size = types_.components.find(line); size != types_.components.end()) {
            for (const std::string& other : other_components(here(), size->second))
                found("components", at_, at_, other);
        } else if (const auto members = types_.members.find(line); members != types_.members.end()) {
            for (const std::string& other : members->second) found("member", at_, at_, other);
        }
    }

    // Neighbouring arguments of one type change places, but where the order makes no difference.
    void add_swaps(const std::vector<std::string>& types) {
        std::vector<std::pair<std::size_t, std::size_t>> arguments;
        int depth = 0;
        std::size_t last = at_ - 1;
        std::size_t swapped = 0;  // the first pair that changes places
        std::size_t i = at_;
        while (i-- > region_.first) {
            const std::string& text = tokens_[i].text;
            if (text == ")" || text == "]") ++depth;
            const bool opens = depth == 0 && text == "(";
            if (opens || (depth == 0 && text == ",")) {
                if (last <= i) return;  // no arguments
                arguments.insert(arguments.begin(), {i + 1, last});
                last = i - 1;
            }
            if (opens) {
                swapped = i > 0 && commutative.contains(tokens_[i - 1].text) ? 1 : 0;
                break;
            }
            if (text == "(" || text == "[") --depth;
        }
        if (arguments.size() != types.size()) return;
        for (std::size_t k = swapped; k + 1 < arguments.size(); ++k) {
            const auto [first, middle] = arguments[k];
            const auto [next, end] = arguments[k + 1];
            const std::string a = between(first, middle);
            const std::string b = between(next, end);
            if (types[k].empty() || types[k] != types[k + 1] || a == b) continue;
            const std::string comma = text_.substr(end_of(middle), tokens_[next].begin - end_of(middle));
            found("arguments", first, end, b + comma + a);
        }
    }

    // The first token of the condition of the '?' here.
    [[nodiscard]] std::size_t condition_begin() const {
        static const std::set<std::string_view> stops{"=", "return", ",",  ";",  "{",  "}",
                                                      "?", ":",      "+=", "-=", "*=", "/="};
        int depth = 0;
        for (std::size_t i = at_; i-- > region_.first;) {
            const std::string_view text = near(i);
            if (text == ")" || text == "]") ++depth;
            if (text == "(" || text == "[") --depth;
            if (depth < 0 || (depth == 0 && stops.contains(text))) return i + 1;
        }
        return region_.first;
    }

    // The end of an assignment, a call, a continue or a break that begins here.
    [[nodiscard]] std::optional<std::size_t> statement_end() const {
        static const std::set<std::string_view> starts{"{", "}", ";", ")", "else"};
        static const std::set<std::string_view> others{"return", "if",      "for",    "while", "else",   "do",
                                                       "const",  "precise", "switch", "case",  "default"};
        const bool steps = here() == "++" || here() == "--";
        if (region_.function.empty() || brackets_ > 0 || !starts.contains(before()) ||
            (!is_word(here()) && !steps))
            return std::nullopt;
        if (!steps && (others.contains(here()) || is_word(near(at_ + 1))))
            return std::nullopt;  // a declaration
        std::size_t end = at_;
        while (end < region_.last && near(end) != ";") {
            const std::string_view text = near(end);
            end = text == "(" || text == "[" ? internal::closing(tokens_, end) : end + 1;
        }
        return end < region_.last ? std::optional(end) : std::nullopt;
    }

    const std::string& text_;
    const std::vector<Token>& tokens_;
    const internal::TokenTypes& types_;
    std::vector<Mutation>& found_;
    Region region_;
    std::size_t at_ = 0;
    std::size_t loop_end_ = 0;
    int brackets_ = 0;
};

// "own.glsl:12: message" of "0:57: message", where the line of the exploded text is one of the file.
std::string placed(std::string message, const Source& source, const TokenText& text) {
    int line = 0;
    message.erase(std::min(message.find('\n'), message.size()));
    const char* const end = message.data() + message.size();
    if (!message.starts_with("0:")) return message;
    const char* const behind = std::from_chars(message.data() + 2, end, line).ptr;
    line = text.line_of(line, source.text);
    return source.name + (line > 0 ? ":" + std::to_string(line) : "") + std::string(behind, end);
}

// The tree of the first stage and rules by which the text is valid. Throws for the first of them otherwise.
std::string tree_of(const Source& source, const TokenText& text) {
    using internal::Client;
    std::string why;
    for (const Client client : {Client::vulkan, Client::none}) {
        for (const Stage stage : {Stage::compute, Stage::fragment, Stage::vertex}) {
            try {
                return internal::syntax_tree({"0", text.exploded}, stage, client);
            } catch (const CompileError& error) {
                if (why.empty()) why = placed(error.what(), source, text);
            }
        }
    }
    throw CompileError(why);
}

}  // namespace

std::vector<Mutation> internal::mutations_here(const Source& source,
                                               const std::vector<std::filesystem::path>& roots) {
    const internal::ActiveText active =
        internal::active_text({source}, Language::vulkan450, Stage::compute, roots);
    const TokenText text(active);
    const internal::TokenTypes types = internal::token_types(tree_of(source, text));
    std::vector<Mutation> all;
    Faults faults(source.text, text.tokens, types, all);
    for (const Region& region : internal::regions(text.tokens)) faults.add(region);
    std::ranges::stable_sort(all, {}, &Mutation::begin);
    return all;
}

std::string mutated(std::string text, const Mutation& mutation) {
    return text.replace(mutation.begin, mutation.end - mutation.begin, mutation.after);
}

}  // namespace gloam::shader

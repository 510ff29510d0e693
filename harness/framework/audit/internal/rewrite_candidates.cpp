// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <set>
#include <string>

#include "audit/internal/search.hpp"
#include "source/tokens.hpp"

namespace gloam::check::internal {
namespace {

using shader::Token;

constexpr const char* exp_minus_1 =
    "float exp_minus_1(float x) { return abs(x) < 0.5 ? x * (1.0 + x * (0.5 + x * (0.166666667 + x * "
    "(0.0416666667 + x * (0.00833333333 + x * (0.00138888889 + x * 0.000198412698)))))) : exp(x) - 1.0; }\n";
constexpr const char* log_of_1_plus =
    "float log_of_1_plus(float x) { if (abs(x) > 0.3) return log(1.0 + x); float s = x / (2.0 + x); "
    "float q = s * s; return 2.0 * s * (1.0 + q * (0.333333333 + q * (0.2 + q * (0.142857143 + q * "
    "0.111111111)))); }\n";
constexpr const char* scaled_length =
    "float scaled_length(vec2 v) { float m = max(abs(v.x), abs(v.y)); "
    "return m > 0.0 ? m * length(v / m) : 0.0; }\n"
    "float scaled_length(vec3 v) { float m = max(max(abs(v.x), abs(v.y)), abs(v.z)); "
    "return m > 0.0 ? m * length(v / m) : 0.0; }\n";
constexpr const char* within_pi =
    "float within_pi(float x) { float k = round(x / 6.28318531); "
    "return (x - 6.28125 * k) - 0.00193530718 * k; }\n";

constexpr const char* beyond_one = "rounding takes the argument beyond 1, where the function is undefined";
constexpr const char* not_positive = "the function is undefined at 0 and below";
constexpr const char* beyond_pi = "Vulkan states a precision between -pi and pi only";

// What is found, and what may take its place. E, F and G are any expressions, X and Y names, ONE is the
// number 1, N a whole number from 2 to 8; {P} is the product of N times E.
struct Rule {
    const char* from;
    const char* to;
    const char* reason;
    const char* helper = "";
    bool is_summand = false;  // it must stand alone in a sum
};
constexpr std::array rules{
    Rule{"acos(E)", "acos(clamp({E}, -1.0, 1.0))", beyond_one},
    Rule{"acos(dot(E, F))", "(2.0 * atan(length(({E}) - ({F})), length(({E}) + ({F}))))",
         "the cosine hardly changes near 0 and pi; half the angle's tangent does"},
    Rule{"asin(E)", "asin(clamp({E}, -1.0, 1.0))", beyond_one},
    Rule{"sqrt(ONE - X * X)", "sqrt((1.0 - {X}) * (1.0 + {X}))",
         "the square is rounded before the difference cancels"},
    Rule{"sqrt(E)", "sqrt(max({E}, 0.0))", "rounding takes the argument below 0"},
    Rule{"inversesqrt(E)", "inversesqrt(max({E}, 1.17549435e-38))", not_positive},
    Rule{"log(E)", "log(max({E}, 1.17549435e-38))", not_positive},
    Rule{"log(ONE + X)", "log_of_1_plus({X})", "1 + x drops the digits of a small x", log_of_1_plus},
    Rule{"log2(E)", "log2(max({E}, 1.17549435e-38))", not_positive},
    Rule{"pow(E, N)", "({P})", "a product is rounded at each factor; pow is a logarithm and an exponential"},
    Rule{"pow(E, F)", "pow(max({E}, 0.0), {F})", "pow is undefined below 0"},
    Rule{"pow(E, F)", "exp2({F} * log2({E}))", "the definition of pow, without its special cases"},
    Rule{"normalize(E)", "(({E}) * inversesqrt(max(dot({E}, {E}), 1.17549435e-38)))",
         "a zero vector has no direction; this one stays zero"},
    Rule{"length(E)", "scaled_length({E})", "the square of a component overflows or underflows",
         scaled_length},
    Rule{"sin(E)", "sin(within_pi({E}))", beyond_pi, within_pi},
    Rule{"cos(E)", "cos(within_pi({E}))", beyond_pi, within_pi},
    Rule{"smoothstep(E, F, G)", "smoothstep(-({E}), -({F}), -({G}))",
         "smoothstep is undefined unless its first edge is below the second"},
    Rule{"ONE - cos(E)", "(2.0 * sin(0.5 * ({E})) * sin(0.5 * ({E})))",
         "the difference cancels where the cosine is near 1", "", true},
    Rule{"exp(E) - ONE", "exp_minus_1({E})", "the difference cancels near 0", exp_minus_1, true},
    Rule{"X * X - Y * Y", "(({X} - {Y}) * ({X} + {Y}))",
         "the squares are rounded before the difference cancels", "", true}};

// The tokens of a text; a name with its members is one: "light.color".
std::vector<Token> with_members(std::string_view text) {
    std::vector<Token> all;
    for (Token& token : shader::tokens_of(text)) {
        const bool goes_on =
            !all.empty() && token.begin == all.back().end() &&
            ((token == "." && all.back().is_word()) || (token.is_word() && all.back().text.ends_with('.')));
        if (goes_on)
            all.back().text += token.text;
        else
            all.push_back(std::move(token));
    }
    return all;
}

// What stands for the names of a rule.
using Captured = std::map<std::string, std::string, std::less<>>;

class Finder {
  public:
    explicit Finder(std::string_view text) : text_(text), tokens_(with_members(text)) {}

    std::vector<Candidate> all() {
        static const std::vector<std::vector<Token>> patterns = [] {
            std::vector<std::vector<Token>> made;
            for (const Rule& rule : rules) made.push_back(shader::tokens_of(rule.from));
            return made;
        }();
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
            for (std::size_t r = 0; r < rules.size(); ++r) add_rule(rules[r], patterns[r], i);
            add_sum(i);
        }
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string_view token(std::size_t i) const {
        return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view{};
    }
    [[nodiscard]] bool is_name(std::size_t i) const { return i < tokens_.size() && tokens_[i].is_word(); }

    // Whether an expression from `first` to `last` stands alone as a summand.
    [[nodiscard]] bool is_summand(std::size_t first, std::size_t last) const {
        static constexpr std::string_view before = "(,=?:+{;<>&|!";
        static constexpr std::string_view behind = "),;?:+-<>&|=";
        const std::string_view left = first > 0 ? token(first - 1) : ";";
        const std::string_view right = token(last + 1);
        return (left == "return" || before.find(left.back()) != std::string_view::npos) && !right.empty() &&
               behind.find(right.front()) != std::string_view::npos;
    }

    [[nodiscard]] std::string text_of(std::size_t first, std::size_t last) const {
        return std::string(text_.substr(tokens_[first].begin, tokens_[last].end() - tokens_[first].begin));
    }

    // Behind the argument that begins here; here if there is none.
    [[nodiscard]] std::size_t argument_end(std::size_t begin) const {
        constexpr std::size_t most = 200;  // tokens
        int depth = 0;
        for (std::size_t k = begin; k < std::min(tokens_.size(), begin + most); ++k) {
            const std::string_view t = token(k);
            if (depth == 0 && (t == "," || t == ")")) return k;
            depth += t == "(" || t == "[" ? 1 : t == ")" || t == "]" ? -1 : 0;
        }
        return begin;
    }

    // The exponents 2 to 8 as they are written: "5.0", "5.", "5"; 0 for others.
    static std::size_t small_exponent(std::string_view text) {
        const bool is_whole =
            text.size() == 1 || (!text.empty() && (text.substr(1) == "." || text.substr(1) == ".0"));
        return is_whole && text[0] >= '2' && text[0] <= '8' ? static_cast<std::size_t>(text[0] - '0') : 0;
    }

    // Whether a token, or the tokens of an argument, are what the pattern's one stands for; moves behind it.
    bool take(const Token& wanted, std::size_t& at, Captured& captured) const {
        const std::size_t first = at++;
        if (wanted == "E" || wanted == "F" || wanted == "G") {
            at = argument_end(first);
            if (at > first) captured[wanted.text] = text_of(first, at - 1);
            return at > first;
        }
        const std::string_view t = token(first);
        if (wanted == "X" || wanted == "Y")
            return is_name(first) && captured.try_emplace(wanted.text, t).first->second == t;
        if (wanted == "ONE") return t == "1.0" || t == "1." || t == "1.0f";
        if (wanted != "N") return wanted == t;
        const std::vector<std::string> factors(small_exponent(t), "(" + captured["E"] + ")");
        captured["P"] = fmt::format("{}", fmt::join(factors, " * "));
        return !factors.empty();
    }

    void add_rule(const Rule& rule, const std::vector<Token>& pattern, std::size_t i) {
        Captured c;
        std::size_t end = i;
        for (const Token& wanted : pattern)
            if (!take(wanted, end, c)) return;
        const bool declared = pattern[1] == "(" && i > 0 && is_name(i - 1) && token(i - 1) != "return";
        if (declared || (rule.is_summand && !is_summand(i, end - 1))) return;
        add(i, end - 1,
            fmt::format(fmt::runtime(rule.to), fmt::arg("E", c["E"]), fmt::arg("F", c["F"]),
                        fmt::arg("G", c["G"]), fmt::arg("X", c["X"]), fmt::arg("Y", c["Y"]),
                        fmt::arg("P", c["P"])),
            rule.reason, rule.helper);
    }

    void add(std::size_t first, std::size_t last, std::string after, std::string reason, std::string helper) {
        found_.push_back({tokens_[first].begin, tokens_[last].end(), std::move(after), std::move(helper),
                          std::move(reason)});
    }

    // float sum = 0.0; for (...) sum += x;
    void add_sum(std::size_t i) {
        static const std::set<std::string_view> types{"float", "vec2", "vec3", "vec4"};
        static const std::set<std::string_view> loops{"for", "while", "do"};
        if (!types.contains(token(i)) || !is_name(i + 1) || token(i + 2) != "=") return;
        const std::string_view sum = token(i + 1);
        bool looped = false;
        int depth = 0;
        for (std::size_t k = i + 3; k < tokens_.size() && depth >= 0; ++k) {
            depth += token(k) == "{" ? 1 : token(k) == "}" ? -1 : 0;
            looped = looped || loops.contains(token(k));
            if (!looped || token(k) != sum || token(k + 1) != "+=") continue;
            std::size_t last = k + 2;
            while (last + 1 < tokens_.size() && token(last + 1) != ";") ++last;
            add(k, last, fmt::format("{0} = add_with_rest({0}, {1}, {0}_rest)", sum, text_of(k + 2, last)),
                "each addition drops the last digits of what it adds",
                fmt::format(
                    "{0} add_with_rest({0} sum, {0} term, inout {0} rest) {{ precise {0} all = term + rest; "
                    "precise {0} next = sum + all; precise {0} added = next - sum; rest = all - added; "
                    "return next; }}\n",
                    token(i)));
            found_.back().wide = true;
            found_.back().declared_at = tokens_[i].begin;
            found_.back().declaration = fmt::format("{0} {1}_rest = {0}(0.0); ", token(i), sum);
            return;
        }
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::vector<Candidate> found_;
};

}  // namespace

std::vector<Candidate> candidates_of(std::string_view text) {
    return Finder(text).all();
}

}  // namespace gloam::check::internal

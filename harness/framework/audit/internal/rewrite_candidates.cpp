// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "audit/internal/search.hpp"
#include "base/text.hpp"
#include "source/tokens.hpp"

namespace gloam::audit::internal {
namespace {

using source::Token;

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
    for (Token& token : source::tokens_of(text)) {
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

// A text in which rules match.
class Matcher {
  public:
    explicit Matcher(std::string_view text) : text_(text), tokens_(with_members(text)) {}

    void add(const Rule& rule, std::vector<std::pair<std::size_t, AuditRewrite>>& found) {
        const std::vector<Token> pattern = source::tokens_of(rule.from);
        for (std::size_t first = 0; first + 2 < tokens_.size(); ++first) {
            captured_.clear();
            std::size_t end = first;
            const bool matches =
                std::ranges::all_of(pattern, [&](const Token& wanted) { return take(wanted, end); });
            const bool declared = pattern[1] == "(" && first > 0 && tokens_[first - 1].is_word() &&
                                  token(first - 1) != "return";
            if (!matches || declared || (rule.is_summand && !is_summand(first, end))) continue;
            const std::size_t begin = tokens_[first].begin;
            AuditRewrite change{.file = {},
                                .before = std::string(text_.substr(begin, tokens_[end - 1].end() - begin)),
                                .after = rule.to,
                                .helper = rule.helper,
                                .reason = rule.reason,
                                .gain = {}};
            for (const auto& [name, text] : captured_)
                change.after = base::replaced(change.after, "{" + name + "}", text);
            found.emplace_back(begin, std::move(change));
        }
    }

  private:
    [[nodiscard]] std::string_view token(std::size_t i) const {
        return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view{};
    }

    // Whether an expression stands alone as a summand.
    [[nodiscard]] bool is_summand(std::size_t first, std::size_t end) const {
        static constexpr std::string_view before = "(,=?:+{;<>&|!";
        static constexpr std::string_view behind = "),;?:+-<>&|=";
        const std::string_view left = first > 0 ? token(first - 1) : ";";
        const std::string_view right = token(end);
        return (left == "return" || before.find(left.back()) != std::string_view::npos) && !right.empty() &&
               behind.find(right.front()) != std::string_view::npos;
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

    // Whether a token, or the tokens of an argument, are what the pattern's one stands for; moves behind it.
    bool take(const Token& wanted, std::size_t& at) {
        const std::size_t first = at++;
        const std::string_view t = token(first);
        if (wanted == "E" || wanted == "F" || wanted == "G") {
            at = argument_end(first);
            if (at == first) return false;
            const std::size_t begin = tokens_[first].begin;
            captured_[wanted.text] = text_.substr(begin, tokens_[at - 1].end() - begin);
            return true;
        }
        if (wanted == "X" || wanted == "Y")
            return first < tokens_.size() && tokens_[first].is_word() &&
                   captured_.try_emplace(wanted.text, t).first->second == t;
        if (wanted == "ONE") return t == "1.0" || t == "1." || t == "1.0f";
        if (wanted != "N") return wanted == t;
        if (t.empty() || t[0] < '2' || t[0] > '8' ||
            !(t.size() == 1 || t.substr(1) == "." || t.substr(1) == ".0"))
            return false;
        const std::vector<std::string> factors(static_cast<std::size_t>(t[0] - '0'),
                                               "(" + captured_["E"] + ")");
        captured_["P"] = fmt::format("{}", fmt::join(factors, " * "));
        return true;
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::map<std::string, std::string, std::less<>> captured_;  // what stands for the names of a rule
};

}  // namespace

std::vector<std::pair<std::size_t, AuditRewrite>> candidates_of(std::string_view text) {
    Matcher matcher(text);
    std::vector<std::pair<std::size_t, AuditRewrite>> found;
    for (const Rule& rule : rules) matcher.add(rule, found);
    std::ranges::stable_sort(found, {}, [](const auto& one) { return one.first; });
    return found;
}

}  // namespace gloam::audit::internal

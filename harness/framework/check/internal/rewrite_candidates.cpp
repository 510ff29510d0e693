// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "check/internal/rewrites.hpp"
#include "shader/tokens.hpp"

namespace gloam::check::internal {
namespace {

using shader::Token;

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

// A call "name(a, b)": its tokens and its arguments.
struct Call {
    std::size_t first = 0;  // token of the name
    std::size_t last = 0;   // token of the closing parenthesis
    std::vector<std::string> arguments;
};

class Finder {
  public:
    explicit Finder(std::string_view text) : text_(text), tokens_(with_members(text)) {}

    std::vector<Candidate> all() {
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
            if (const auto call = call_at(i)) add_call(*call);
            add_difference(i);
            add_sum(i);
        }
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string_view token(std::size_t i) const {
        return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view{};
    }
    [[nodiscard]] bool is_name(std::size_t i) const { return i < tokens_.size() && tokens_[i].is_word(); }
    [[nodiscard]] bool is_one(std::size_t i) const {
        return token(i) == "1.0" || token(i) == "1." || token(i) == "1.0f";
    }

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

    [[nodiscard]] std::optional<Call> call_at(std::size_t i) const {
        if (!is_name(i) || token(i + 1) != "(") return std::nullopt;
        if (i > 0 && is_name(i - 1) && token(i - 1) != "return") return std::nullopt;  // a declaration
        constexpr std::size_t most = 200;                                              // tokens
        Call call{.first = i, .last = 0, .arguments = {}};
        int depth = 0;
        std::size_t begin = i + 2;
        for (std::size_t k = i + 1; k < std::min(tokens_.size(), i + most); ++k) {
            const std::string_view t = token(k);
            depth += t == "(" || t == "[" ? 1 : t == ")" || t == "]" ? -1 : 0;
            if ((depth == 1 && t == ",") || depth == 0) {
                if (k > begin) call.arguments.push_back(text_of(begin, k - 1));
                begin = k + 1;
            }
            if (depth == 0) {
                call.last = k;
                return call;
            }
        }
        return std::nullopt;
    }

    void add(std::size_t first, std::size_t last, std::string after, std::string reason,
             std::string helper = {}) {
        found_.push_back({tokens_[first].begin, tokens_[last].end(), std::move(after), std::move(helper),
                          std::move(reason)});
    }

    void add_call(const Call& call) {
        using Rule = void (Finder::*)(const Call&);
        static const std::map<std::string_view, Rule> rules{
            {"acos", &Finder::add_arc},      {"asin", &Finder::add_arc},
            {"sqrt", &Finder::add_root},     {"inversesqrt", &Finder::add_positive},
            {"log", &Finder::add_logarithm}, {"log2", &Finder::add_positive},
            {"pow", &Finder::add_power},     {"normalize", &Finder::add_direction},
            {"length", &Finder::add_length}, {"sin", &Finder::add_turn},
            {"cos", &Finder::add_turn},      {"smoothstep", &Finder::add_smoothstep}};
        const auto rule = rules.find(token(call.first));
        if (rule != rules.end() && !call.arguments.empty()) (this->*rule->second)(call);
    }

    void add_arc(const Call& call) {
        const std::string name(token(call.first));
        const std::string& x = call.arguments[0];
        add(call.first, call.last, fmt::format("{}(clamp({}, -1.0, 1.0))", name, x),
            "rounding takes the argument beyond 1, where the function is undefined");
        const auto inner = call_at(call.first + 2);
        if (name == "acos" && inner && token(inner->first) == "dot" && inner->last + 1 == call.last &&
            inner->arguments.size() == 2)
            add(call.first, call.last,
                fmt::format("(2.0 * atan(length(({0}) - ({1})), length(({0}) + ({1}))))", inner->arguments[0],
                            inner->arguments[1]),
                "the cosine hardly changes near 0 and pi; half the angle's tangent does");
    }

    // sqrt(1.0 - x * x)
    void add_root(const Call& call) {
        const std::size_t i = call.first + 2;
        if (is_one(i) && token(i + 1) == "-" && is_name(i + 2) && token(i + 3) == "*" &&
            token(i + 4) == token(i + 2) && i + 5 == call.last)
            add(call.first, call.last, fmt::format("sqrt((1.0 - {0}) * (1.0 + {0}))", token(i + 2)),
                "the square is rounded before the difference cancels");
        add(call.first, call.last, fmt::format("sqrt(max({}, 0.0))", call.arguments[0]),
            "rounding takes the argument below 0");
    }

    void add_positive(const Call& call) {
        add(call.first, call.last,
            fmt::format("{}(max({}, 1.17549435e-38))", token(call.first), call.arguments[0]),
            "the function is undefined at 0 and below");
    }

    // log(1.0 + x)
    void add_logarithm(const Call& call) {
        add_positive(call);
        const std::size_t i = call.first + 2;
        if (!is_one(i) || token(i + 1) != "+" || !is_name(i + 2) || i + 3 != call.last) return;
        add(call.first, call.last, fmt::format("log_of_1_plus({})", token(i + 2)),
            "1 + x drops the digits of a small x",
            "float log_of_1_plus(float x) { if (abs(x) > 0.3) return log(1.0 + x); float s = x / (2.0 + x); "
            "float q = s * s; return 2.0 * s * (1.0 + q * (0.333333333 + q * (0.2 + q * (0.142857143 + q * "
            "0.111111111)))); }\n");
    }

    // The exponents 2 to 8 as they are written: "5.0", "5.", "5"; 0 for others.
    static std::size_t small_exponent(std::string_view text) {
        const bool is_whole = text.size() == 1 || text.substr(1) == "." || text.substr(1) == ".0";
        return is_whole && text[0] >= '2' && text[0] <= '8' ? static_cast<std::size_t>(text[0] - '0') : 0;
    }

    void add_power(const Call& call) {
        if (call.arguments.size() != 2) return;
        const std::string& x = call.arguments[0];
        const std::vector<std::string> factors(small_exponent(call.arguments[1]), "(" + x + ")");
        if (!factors.empty())
            add(call.first, call.last, fmt::format("({})", fmt::join(factors, " * ")),
                "a product is rounded at each factor; pow is a logarithm and an exponential");
        add(call.first, call.last, fmt::format("pow(max({}, 0.0), {})", x, call.arguments[1]),
            "pow is undefined below 0");
        add(call.first, call.last, fmt::format("exp2({1} * log2({0}))", x, call.arguments[1]),
            "the definition of pow, without its special cases");
    }

    void add_direction(const Call& call) {
        const std::string& v = call.arguments[0];
        add(call.first, call.last,
            fmt::format("(({0}) * inversesqrt(max(dot({0}, {0}), 1.17549435e-38)))", v),
            "a zero vector has no direction; this one stays zero");
    }

    void add_length(const Call& call) {
        static const std::string helper =
            "float scaled_length(vec2 v) { float m = max(abs(v.x), abs(v.y)); "
            "return m > 0.0 ? m * length(v / m) : 0.0; }\n"
            "float scaled_length(vec3 v) { float m = max(max(abs(v.x), abs(v.y)), abs(v.z)); "
            "return m > 0.0 ? m * length(v / m) : 0.0; }\n";
        add(call.first, call.last, fmt::format("scaled_length({})", call.arguments[0]),
            "the square of a component overflows or underflows", helper);
    }

    void add_turn(const Call& call) {
        add(call.first, call.last, fmt::format("{}(within_pi({}))", token(call.first), call.arguments[0]),
            "Vulkan states a precision between -pi and pi only",
            "float within_pi(float x) { float k = round(x / 6.28318531); "
            "return (x - 6.28125 * k) - 0.00193530718 * k; }\n");
    }

    void add_smoothstep(const Call& call) {
        if (call.arguments.size() != 3) return;
        add(call.first, call.last,
            fmt::format("smoothstep(-({}), -({}), -({}))", call.arguments[0], call.arguments[1],
                        call.arguments[2]),
            "smoothstep is undefined unless its first edge is below the second");
    }

    // 1.0 - cos(x), exp(x) - 1.0, a * a - b * b
    void add_difference(std::size_t i) {
        if (is_one(i) && token(i + 1) == "-") {
            const auto call = call_at(i + 2);
            if (call && token(i + 2) == "cos" && is_summand(i, call->last))
                add(i, call->last,
                    fmt::format("(2.0 * sin(0.5 * ({0})) * sin(0.5 * ({0})))", call->arguments[0]),
                    "the difference cancels where the cosine is near 1");
        }
        const auto call = token(i) == "exp" ? call_at(i) : std::nullopt;
        if (call && token(call->last + 1) == "-" && is_one(call->last + 2) && is_summand(i, call->last + 2))
            add(i, call->last + 2, fmt::format("exp_minus_1({})", call->arguments[0]),
                "the difference cancels near 0",
                "float exp_minus_1(float x) { return abs(x) < 0.5 ? x * (1.0 + x * (0.5 + x * (0.166666667 + "
                "x * "
                "(0.0416666667 + x * (0.00833333333 + x * (0.00138888889 + x * 0.000198412698)))))) : "
                "exp(x) - 1.0; }\n");
        const bool squares = is_name(i) && token(i + 1) == "*" && token(i + 2) == token(i) &&
                             token(i + 3) == "-" && is_name(i + 4) && token(i + 5) == "*" &&
                             token(i + 6) == token(i + 4);
        if (squares && is_summand(i, i + 6))
            add(i, i + 6, fmt::format("(({0} - {1}) * ({0} + {1}))", token(i), token(i + 4)),
                "the squares are rounded before the difference cancels");
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

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "base/text.hpp"
#include "judge/explain.hpp"

namespace gloam::judge {
namespace {

// Whether SignedZeroInfNanPreserve binds an operation: in each wording of its clause, in newer ones, or in
// none. Vulkan 1.1.95 lists OpFConvert, OpFNegate, OpFAdd, OpFSub and OpFMul; 1.3.296 adds OpFDiv, of which
// the older texts say "Dividing a non-zero by a zero results in the appropriately signed IEEE 754
// infinity"; 1.4.304 adds comparisons, derivatives, and products of vectors and matrices. No wording lists an
// extended instruction.
enum class Specials { bound, newer, unbound };

struct Rule {
    std::string_view operations;  // names as ExplainedStep::operation has them, between blanks
    std::string_view clause;      // a quotation, its formula in ASCII
    std::string_view text = {};   // what it means; empty: as it stands
    Specials specials = Specials::unbound;
    std::array<unsigned, 3> since = {1, 0, 0};  // the first text of Vulkan that has the clause
};

using enum Specials;
constexpr std::string_view rounded = "Correctly rounded.";
constexpr std::string_view correct = "Correct result.";

// For float32: Vulkan specification 1.4.360, "Precision and Operation of SPIR-V Instructions".
constexpr std::array rules{
    Rule{" OpFAdd OpFSub OpFMul OpFConvert ", rounded, "correctly rounded, to either neighbour", bound},
    Rule{" OpVectorTimesScalar OpMatrixTimesScalar OpOuterProduct ", rounded,
         "correctly rounded, to either neighbour", newer},
    Rule{" OpConvertSToF OpConvertUToF Ldexp Round RoundEven Trunc Floor Ceil Fract Modf ModfStruct Step ",
         rounded, "correctly rounded, to either neighbour"},
    Rule{" OpFNegate ", correct, "the correct result", bound},
    Rule{" FAbs FSign FMin FMax FClamp NMin NMax NClamp Frexp FrexpStruct ", correct, "the correct result"},
    Rule{" OpFDiv ", "2.5 ULP for |y| = 0 or |y| in the range [2^-126, 2^126].",
         "2.5 ULP where the magnitude of the divisor is 2^-126 to 2^126; an infinity where it is 0; any "
         "number elsewhere",
         bound},
    Rule{" OpFRem ", "Inherited from x - y * trunc(x/y).", "inherited from x - y * trunc(x / y)"},
    Rule{" OpFMod ", "Inherited from x - y * floor(x/y).", "inherited from x - y * floor(x / y)"},
    Rule{" OpDot OpMatrixTimesVector OpVectorTimesMatrix OpMatrixTimesMatrix ",
         "Inherited from sum x_i * y_i.", "inherited from the sum of products", newer},
    Rule{" Fma ", "Inherited from OpFMul followed by OpFAdd.", "inherited from a product and a sum"},
    Rule{" OpQuantizeToF16 PackHalf2x16 ",
         "Correctly rounded with implementation defined rounding mode.",
         "correctly rounded to 16 bits",
         unbound,
         {1, 3, 290}},
    Rule{" Exp Exp2 ", "3 + 2 * |x| ULP.", "3 + 2 * abs(x) ULP"},
    Rule{" Log Log2 ",
         "3 ULP outside the range [0.5, 2.0]. Absolute error < 2^-21 inside the range [0.5, 2.0].",
         "3 ULP outside of [0.5, 2.0]; inside an absolute error below 2^-21"},
    Rule{" Pow ", "Inherited from exp2(y * log2(x))."},
    Rule{" InverseSqrt ", "2 ULP."},
    Rule{" Sqrt ", "Inherited from 1.0 / inversesqrt().", "inherited from 1.0 / inversesqrt(x)"},
    Rule{" Radians ", "Inherited from x * C, where C is a correctly rounded approximation to pi/180.",
         "x times pi / 180, rounded to either neighbour"},
    Rule{" Degrees ", "Inherited from x * C, where C is a correctly rounded approximation to 180/pi.",
         "x times 180 / pi, rounded to either neighbour"},
    Rule{" Sin Cos ", "Absolute error <= 2^-11 inside the range [-pi, pi].",
         "an absolute error of 2^-11 inside of [-pi, pi]; nothing elsewhere"},
    Rule{" Tan ", "Inherited from sin() / cos().", "inherited from sin(x) / cos(x)"},
    Rule{" Atan Atan2 ", "4096 ULP."},
    Rule{" Asin ", "Inherited from atan2(x, sqrt(1.0 - x * x))."},
    Rule{" Acos ", "Inherited from atan2(sqrt(1.0 - x * x), x)."},
    Rule{" Sinh ", "Inherited from (exp(x) - exp(-x)) * 0.5."},
    Rule{" Cosh ", "Inherited from (exp(x) + exp(-x)) * 0.5."},
    Rule{" Tanh ", "Inherited from sinh() / cosh().", "inherited from sinh(x) / cosh(x)"},
    Rule{" Length ", "Inherited from sqrt(dot(x, x))."},
    Rule{" Distance ", "Inherited from length(x - y)."},
    Rule{" Normalize ", "Inherited from x * inversesqrt(dot(x, x))."},
    Rule{" Cross ", "Inherited from OpFSub(OpFMul, OpFMul).", "inherited from differences of products"},
    Rule{" Reflect ", "Inherited from x - 2.0 * dot(y, x) * y."},
    Rule{" FMix ", "Inherited from x * (1.0 - a) + y * a."},
    Rule{" SmoothStep ",
         "Inherited from t * t * (3.0 - 2.0 * t), where t = clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0)."},
};

std::string text_of(const Rule& rule) {
    if (!rule.text.empty()) return std::string(rule.text);
    return base::lower(std::string(rule.clause.substr(0, 1))) +
           std::string(rule.clause.substr(1, rule.clause.size() - 2));  // without its period
}

// What is said of NaN and infinity.
std::string_view specials_text(Specials specials) {
    switch (specials) {
        case bound:
            return "NaN and infinity: bound by SignedZeroInfNanPreserve";
        case newer:
            return "NaN and infinity: not in the first wordings of SignedZeroInfNanPreserve, so not judged";
        default:
            return "NaN and infinity: not bound by SignedZeroInfNanPreserve, so not judged";
    }
}

// nullptr: there is none for it.
const Rule* rule_of(const std::string& operation) {
    constexpr std::string_view set = "GLSL.std.450 ";
    const std::string name = operation.starts_with(set) ? operation.substr(set.size()) : operation;
    const auto rule = std::ranges::find_if(rules, [&name](const Rule& candidate) {
        return candidate.operations.find(" " + name + " ") != std::string_view::npos;
    });
    return rule == rules.end() ? nullptr : &*rule;
}

}  // namespace

std::string younger_rules(const Explanation& explanation, const std::string& api_version) {
    std::array<unsigned, 3> version{};
    if (std::sscanf(api_version.c_str(), "%u.%u.%u", &version[0], &version[1], &version[2]) != 3) return {};
    std::string text;
    for (const ExplainedStep& step : explanation.steps) {
        const Rule* rule = rule_of(step.operation);
        if (rule == nullptr || rule->since <= version) continue;
        const std::string line = fmt::format(
            "  \"{}\" of {} is a clause of Vulkan {}, and this driver is of {}: it does not bind it\n",
            rule->clause, step.operation, fmt::join(rule->since, "."), api_version);
        if (text.find(line) == std::string::npos) text += line;
    }
    return text;
}

std::vector<std::string> rules_of(const Explanation& explanation) {
    std::vector<std::string> lines;
    for (const ExplainedStep& step : explanation.steps) {
        const Rule* rule = rule_of(step.operation);
        if (rule == nullptr) continue;
        std::string line = fmt::format("{}: {} (\"{}\" {})", step.operation, text_of(*rule), rule->clause,
                                       specials_text(rule->specials));
        if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace gloam::judge

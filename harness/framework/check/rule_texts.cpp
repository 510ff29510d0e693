// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string_view>

#include "check/explain.hpp"

namespace gloam::check {
namespace {

struct Rule {
    std::string_view operations;  // names as ExplainedStep::operation has them, between blanks
    std::string_view text;
};

// For float32: Vulkan specification, "Precision and Operation of SPIR-V Instructions".
constexpr std::array rules{
    Rule{" OpFAdd OpFSub OpFMul OpVectorTimesScalar OpMatrixTimesScalar OpOuterProduct OpConvertSToF "
         "OpConvertUToF "
         "OpFConvert Ldexp Round RoundEven Trunc Floor Ceil Fract Modf ModfStruct Step ",
         "correctly rounded, to either neighbour"},
    Rule{" OpFNegate FAbs FSign FMin FMax FClamp NMin NMax NClamp Frexp FrexpStruct ", "the correct result"},
    Rule{" OpFDiv ", "2.5 ULP where the magnitude of the divisor is 2^-126 to 2^126; any number elsewhere"},
    Rule{" OpFRem ", "inherited from x - y * trunc(x / y)"},
    Rule{" OpFMod ", "inherited from x - y * floor(x / y)"},
    Rule{" OpDot OpMatrixTimesVector OpVectorTimesMatrix OpMatrixTimesMatrix ",
         "inherited from the sum of products"},
    Rule{" Fma ", "inherited from a product and a sum"},
    Rule{" OpQuantizeToF16 PackHalf2x16 ", "correctly rounded to 16 bits"},
    Rule{" Exp Exp2 ", "3 + 2 * abs(x) ULP"},
    Rule{" Log Log2 ", "3 ULP outside of [0.5, 2.0]; inside an absolute error below 2^-21"},
    Rule{" Pow ", "inherited from exp2(y * log2(x))"},
    Rule{" InverseSqrt ", "2 ULP"},
    Rule{" Sqrt ", "inherited from 1.0 / inversesqrt(x)"},
    Rule{" Radians Degrees ", "x times the correctly rounded constant"},
    Rule{" Sin Cos ", "an absolute error of 2^-11 inside of [-pi, pi]; nothing elsewhere"},
    Rule{" Tan ", "inherited from sin(x) / cos(x)"},
    Rule{" Atan Atan2 ", "4096 ULP"},
    Rule{" Asin ", "inherited from atan2(x, sqrt(1.0 - x * x))"},
    Rule{" Acos ", "inherited from atan2(sqrt(1.0 - x * x), x)"},
    Rule{" Sinh Cosh Tanh ", "inherited from sums and quotients of exp(x) and exp(-x)"},
    Rule{" Length ", "inherited from sqrt(dot(x, x))"},
    Rule{" Distance ", "inherited from length(x - y)"},
    Rule{" Normalize ", "inherited from x * inversesqrt(dot(x, x))"},
    Rule{" Cross ", "inherited from differences of products"},
    Rule{" Reflect ", "inherited from x - 2.0 * dot(y, x) * y"},
    Rule{" FMix ", "inherited from x * (1.0 - a) + y * a"},
    Rule{" SmoothStep ",
         "inherited from t * t * (3.0 - 2.0 * t), t = clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0)"},
};

}  // namespace

std::vector<std::string> rules_of(const Explanation& explanation) {
    constexpr std::string_view set = "GLSL.std.450 ";
    std::vector<std::string> lines;
    for (const ExplainedStep& step : explanation.steps) {
        const std::string name =
            step.operation.starts_with(set) ? step.operation.substr(set.size()) : step.operation;
        const auto rule = std::ranges::find_if(rules, [&name](const Rule& candidate) {
            return candidate.operations.find(" " + name + " ") != std::string_view::npos;
        });
        if (rule == rules.end()) continue;
        std::string line = step.operation + ": " + std::string(rule->text);
        if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace gloam::check

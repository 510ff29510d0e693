// SPDX-License-Identifier: MIT
#include "shader/internal/tidy.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <functional>
#include <regex>
#include <set>

namespace gloam::shader::internal {
namespace {

std::string replaced(const std::string& text, const std::regex& pattern,
                     const std::function<std::string(const std::smatch&)>& replacement) {
    std::string result;
    auto rest = text.cbegin();
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
        result.append(rest, (*i)[0].first);
        result += replacement(*i);
        rest = (*i)[0].second;
    }
    return result.append(rest, text.cend());
}

// The shortest text of the float that a decimal number stands for; the number itself if it is no float, or if
// a compiler that reads a double first would find another float.
std::string shortest(const std::string& number) {
    float value = 0.0F;
    const char* const end = number.data() + number.size();
    if (const auto read = std::from_chars(number.data(), end, value);
        read.ptr != end || read.ec != std::errc{})
        return number;
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    std::string text(buffer.data(), written.ptr);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    double wide = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), wide);
    return static_cast<float>(wide) == value ? text : number;
}

// Whether an expression may be calculated where it is not needed.
bool costs_nothing(const std::string& expression) {
    static const std::regex call(R"((\w+)\()");
    static const std::set<std::string> known{"abs",   "all",   "any",   "min",    "max",    "dot",
                                             "bool2", "bool3", "bool4", "float2", "float3", "float4",
                                             "int2",  "int3",  "uint2", "float",  "int",    "uint"};
    for (std::sregex_iterator i(expression.begin(), expression.end(), call), end; i != end; ++i)
        if (!known.contains((*i)[1])) return false;
    return expression.find('[') == std::string::npos;
}

std::string with_short_numbers(const std::string& text) {
    static const std::regex number(R"(\b\d+\.\d+(e[+-]?\d+)?)");
    return replaced(text, number, [](const std::smatch& found) { return shortest(found.str()); });
}

std::string with_logical_operators(const std::string& text, Target target) {
    static const std::regex chosen(
        R"(if \((!?)(_\d+)\)\n *\{\n *(_\d+) = ([^\n]*);\n *\}\n *else\n *\{\n *\3 = \2;\n *\})");
    static const std::regex declared(R"(bool (_\d+);\n *\1 = )");
    const std::string operators = replaced(text, chosen, [target](const std::smatch& found) {
        if (target == Target::hlsl && !costs_nothing(found[4])) return found.str();
        const char* sign = found[1].length() == 0 ? " && (" : " || (";
        return found[3].str() + " = " + found[2].str() + sign + found[4].str() + ");";
    });
    return replaced(operators, declared,
                    [](const std::smatch& found) { return "bool " + found[1].str() + " = "; });
}

std::string with_named_macros(std::string text) {
    static const std::regex constant(R"(static const \w+ (\w+) = (SPIRV_CROSS_CONSTANT_ID_\d+);)");
    std::smatch found;
    while (std::regex_search(text, found, constant)) {
        std::string macro = "GLOAM_" + found[1].str();
        std::ranges::transform(macro, macro.begin(),
                               [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        const std::regex old(found[2].str() + "\\b");
        text = std::regex_replace(text, old, macro);
    }
    return text;
}

// Without the samplers of images that are only fetched from: GLSL has them, other languages need none.
std::string without_idle_samplers(std::string text, Target target) {
    static const std::regex hlsl(R"(SamplerState (\w+) : register\([^)]*\);\n)");
    static const std::regex msl(R"(, sampler (\w+) \[\[sampler\(\d+\)\]\])");
    const std::string all = text;
    const std::regex& declared = target == Target::hlsl ? hlsl : msl;
    for (std::sregex_iterator i(all.begin(), all.end(), declared), end; i != end; ++i) {
        const std::string name = (*i)[1];
        const std::regex used(target == Target::hlsl ? "[(,] ?" + name + "\\b" : "\\.\\w+\\(" + name + "\\b");
        if (std::regex_search(all, used)) continue;
        text.erase(text.find((*i)[0]), static_cast<std::size_t>((*i)[0].length()));
        text = std::regex_replace(text, std::regex(", (sampler )?" + name + "\\b"), "");
    }
    return text;
}

}  // namespace

std::string tidy(const std::string& text, Target target) {
    const std::string numbers = without_idle_samplers(with_short_numbers(text), target);
    if (target == Target::hlsl) {
        static const std::regex component(R"((\d[\w.+-]*f)\.x+\.[xyzw]\b)");  // of a vector of one number
        return with_logical_operators(std::regex_replace(with_named_macros(numbers), component, "$1"),
                                      target);
    }
    static const std::regex linkage(R"(static inline __attribute__\(\(always_inline\)\)\n)");
    return with_logical_operators(std::regex_replace(numbers, linkage, ""), target);
}

}  // namespace gloam::shader::internal

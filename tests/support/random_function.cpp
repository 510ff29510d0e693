// SPDX-License-Identifier: MIT
#include "support/random_function.hpp"

#include <fmt/format.h>
#include <initializer_list>

#include "numeric/random.hpp"

namespace gloam::test {
namespace {

// Writes functions: three variables of each type, an array, a matrix, statements that change them, and
// functions that call each other.
class Writer {
  public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    std::string file(std::uint64_t seed) {
        std::string text;
        for (int f = 0; f < 3; ++f) text += function(f);
        text += fmt::format(
            "// x in [-16, 16], n in [-30, 30].\n"
            "float random_{}(vec3 x, ivec3 n, int bits, out vec2 y, out ivec3 m) {{\n"
            "float f0 = half_of(x.x), f1 = half_of(x.y), f2 = half_of(x.z);\n"
            "int i0 = n.x, i1 = n.y, i2 = n.z ^ bits;\n"
            "float a[4] = float[4](f0, f1, f2, 1.5); vec3 v = vec3(f2, f0, f1);\n"
            "mat2 m2 = mat2(f0, 1.0, f1, -2.0); uint u0 = uint(bits), u1 = 5u;\n",
            seed);
        for (int s = 0; s < 12; ++s) text += statement(3, functions_);
        return "float half_of(float x) { return floor(clamp(x, -64.0, 64.0) * 2.0) * 0.5; }\n" + text +
               "y = vec2(f1, f2 + a[1] + v.y + m2[1][0]);\nm = ivec3(i0, i1 ^ i2, int(u0 + u1));\n"
               "return f0;\n}\n";
    }

  private:
    using Choices = std::initializer_list<const char*>;

    std::string pick(Choices of) { return *(of.begin() + random_.below(of.size())); }
    std::string number() { return fmt::format("{:.1f}", static_cast<double>(random_.below(17)) / 2.0 - 4.0); }

    // A leaf, or a rule with texts for its capitals: X and Y are of its own grammar, W is whole, R real, T
    // true or false, D a divisor, N a number, I an integer.
    std::string grown(int depth, Choices leaves, Choices rules) {
        if (depth == 0) return pick(leaves);
        const std::string x = grown(depth - 1, leaves, rules);
        const std::string y = grown(depth - 1, leaves, rules);
        std::string text;
        for (const char c : pick(rules))
            text += c == 'X'   ? x
                    : c == 'Y' ? y
                    : c == 'W' ? whole(depth - 1)
                    : c == 'R' ? real(depth - 1)
                    : c == 'T' ? truth(depth - 1)
                    : c == 'D' ? pick({"3", "7", "12"})
                    : c == 'N' ? number()
                    : c == 'I' ? std::to_string(static_cast<int>(random_.below(40)) - 20)
                               : std::string(1, c);
        return text;
    }
    std::string real(int depth) {
        return grown(depth, {"f0", "f1", "f2", "v.x", "v.z", "a[2]", "m2[0][1]"},
                     {"(X + Y)", "(X - Y)", "(X * Y)", "min(X, Y)", "max(X, Y)", "abs(X)", "floor(X * 0.5)",
                      "(T ? X : Y)", "float(W)", "clamp(X, -8.0, 8.0)", "a[W & 3]", "v[uint(W) % 3u]",
                      "trunc(X - N)", "N"});
    }
    std::string whole(int depth) {
        return grown(depth, {"i0", "i1", "i2", "int(u0)"},
                     {"(X + Y)", "(X - Y)", "(X * Y)", "(X / (D | 1))", "(X & Y)", "(X ^ Y)",
                      "(X >> (Y & 15))", "(X << (Y & 7))", "(T ? X : Y)", "int(clamp(R, -1000.0, 1000.0))",
                      "bitfieldExtract(X, 2, 11)", "int(uint(X) % 13u)", "I"});
    }
    std::string truth(int depth) {
        switch (random_.below(5)) {
            case 0:
                return fmt::format("{} < {}", real(depth), number());
            case 1:
                return fmt::format("({} > {} && {} != 3)", whole(depth), whole(0), whole(0));
            case 2:
                return fmt::format("{} == {}", whole(0), whole(0));
            case 3:
                return fmt::format("(u0 & {}u) != 0u", 1U << random_.below(8));
            default:
                return fmt::format("any(greaterThan(v, vec3({}, f0, f1)))", number());
        }
    }

    std::string statement(int depth, int callable) {
        switch (random_.below(depth > 0 ? 12U : 6U)) {
            case 0:
                return fmt::format("{} = {};\n", pick({"f0", "f1", "f2"}), held(2));
            case 1:
                return fmt::format("{} = {};\n", pick({"i0", "i1", "i2"}), whole(2));
            case 2:
                return fmt::format("a[{} & 3] = {};\n", whole(1), held(1));
            case 3:
                return fmt::format("v.{} = {};\n", pick({"zx", "xy", "yz"}),
                                   "vec2(" + held(1) + ", " + held(0) + ")");
            case 4:
                return fmt::format(
                    "m2[{}] = m2 * vec2({}, 0.5); m2 = mat2(clamp(floor(m2[0] * 0.25), -64.0, 64.0), "
                    "clamp(floor(m2[1] * 0.25), -64.0, 64.0));\n",
                    random_.below(2), held(0));
            case 5:
                return fmt::format("u0 = u0 * 747796405u + uint({}); u1 ^= u0 >> 7;\n", whole(0));
            case 6:
                return fmt::format("if ({}) {{\n{}}} else {{\n{}}}\n", truth(1),
                                   statement(depth - 1, callable), statement(depth - 1, callable));
            case 7: {
                const int level = level_++;
                return fmt::format(
                    "for (int n{0} = 0; n{0} < {1}; ++n{0}) {{\nif (n{0} == {2}) {3};\n{4}}}\n", level,
                    2 + random_.below(5), random_.below(6), pick({"continue", "break", "i2 += 1"}),
                    statement(depth - 1, callable));
            }
            case 8:
                return fmt::format("switch ({} & 3) {{ case 0: {} break; case 2: {} default: {} }}\n",
                                   whole(1), statement(0, callable), statement(0, callable),
                                   statement(0, callable));
            case 9:
                return fmt::format("if ({}) {{\n{}}}\n", truth(1), statement(depth - 1, callable));
            case 10: {
                const int level = level_++;
                return fmt::format("{{ int w{0} = {1} & 7; while (w{0} > 0) {{ w{0} -= 2;\n{2}}} }}\n", level,
                                   whole(0), statement(depth - 1, callable));
            }
            default:
                if (callable == 0) return "i1 += 3;\n";
                return fmt::format("f1 = call{}({}, i0, v);\n",
                                   random_.below(static_cast<std::uint64_t>(callable)), held(1));
        }
    }
    // A float of bounded size, a multiple of one half: sums and products of such are exact.
    std::string held(int depth) { return fmt::format("half_of({})", real(depth)); }

    std::string function(int f) {
        std::string body = fmt::format(
            "float call{}(float f0, inout int i0, inout vec3 v) {{\n"
            "float f1 = f0 * 0.5, f2 = v.y; int i1 = i0 >> 1, i2 = 3;\n"
            "float a[4] = float[4](f0, f2, v.z, -1.5); mat2 m2 = mat2(f0, f2, 1.0, 2.0); uint u0 = uint(i0), "
            "u1 = 9u;\n",
            f);
        for (int s = 0; s < 4; ++s) body += statement(2, f);
        if (random_.below(2) == 0) body += fmt::format("if ({}) return {};\n", truth(1), held(1));
        functions_ = f + 1;
        return body +
               "v.x = f2;\nreturn floor(clamp(f1 + float(i1 & 7) + a[3] + m2[0][0], -64.0, 64.0));\n}\n";
    }

    numeric::Random random_;
    int level_ = 0;
    int functions_ = 0;
};

}  // namespace

std::string random_function(std::uint64_t seed) {
    return Writer(seed).file(seed);
}

}  // namespace gloam::test

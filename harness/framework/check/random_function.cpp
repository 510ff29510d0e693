// SPDX-License-Identifier: MIT
#include "check/random_function.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <initializer_list>

#include "numeric/random.hpp"

namespace gloam::check {
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
    std::string pick(std::initializer_list<const char*> of) {
        return *(of.begin() + random_.below(of.size()));
    }
    std::string number() { return fmt::format("{:.1f}", static_cast<double>(random_.below(17)) / 2.0 - 4.0); }

    std::string real(int depth) {
        if (depth == 0) return pick({"f0", "f1", "f2", "v.x", "v.z", "a[2]", "m2[0][1]"});
        const std::string x = real(depth - 1);
        const std::string y = real(depth - 1);
        switch (random_.below(14)) {
            case 0:
                return fmt::format("({} + {})", x, y);
            case 1:
                return fmt::format("({} - {})", x, y);
            case 2:
                return fmt::format("({} * {})", x, y);
            case 3:
                return fmt::format("min({}, {})", x, y);
            case 4:
                return fmt::format("max({}, {})", x, y);
            case 5:
                return fmt::format("abs({})", x);
            case 6:
                return fmt::format("floor({} * 0.5)", x);
            case 7:
                return fmt::format("({} ? {} : {})", truth(depth - 1), x, y);
            case 8:
                return fmt::format("float({})", whole(depth - 1));
            case 9:
                return fmt::format("clamp({}, -8.0, 8.0)", x);
            case 10:
                return fmt::format("a[{} & 3]", whole(depth - 1));
            case 11:
                return fmt::format("v[uint({}) % 3u]", whole(depth - 1));
            case 12:
                return fmt::format("trunc({} - {})", x, number());
            default:
                return number();
        }
    }
    std::string whole(int depth) {
        if (depth == 0) return pick({"i0", "i1", "i2", "int(u0)"});
        const std::string x = whole(depth - 1);
        const std::string y = whole(depth - 1);
        switch (random_.below(13)) {
            case 0:
                return fmt::format("({} + {})", x, y);
            case 1:
                return fmt::format("({} - {})", x, y);
            case 2:
                return fmt::format("({} * {})", x, y);
            case 3:
                return fmt::format("({} / ({} | 1))", x, pick({"3", "7", "12"}));
            case 4:
                return fmt::format("({} & {})", x, y);
            case 5:
                return fmt::format("({} ^ {})", x, y);
            case 6:
                return fmt::format("({} >> ({} & 15))", x, y);
            case 7:
                return fmt::format("({} << ({} & 7))", x, y);
            case 8:
                return fmt::format("({} ? {} : {})", truth(depth - 1), x, y);
            case 9:
                return fmt::format("int(clamp({}, -1000.0, 1000.0))", real(depth - 1));
            case 10:
                return fmt::format("bitfieldExtract({}, 2, 11)", x);
            case 11:
                return fmt::format("int(uint({}) % 13u)", x);
            default:
                return fmt::format("{}", static_cast<int>(random_.below(40)) - 20);
        }
    }
    std::string truth(int depth) {
        switch (random_.below(5)) {
            case 0:
                return fmt::format("{} < {}", real(std::max(depth, 0)), number());
            case 1:
                return fmt::format("({} > {} && {} != 3)", whole(std::max(depth, 0)), whole(0), whole(0));
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

}  // namespace gloam::check

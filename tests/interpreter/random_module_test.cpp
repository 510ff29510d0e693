// SPDX-License-Identifier: MIT
// Random shaders of operations with one legal result each: the interpreter and every device at hand must
// agree to the bit. A shader that they do not agree on is printed whole, with its seed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "interpreter/shader_run.hpp"
#include "numeric/random.hpp"
#include "support/devices.hpp"

namespace gloam {
namespace random_module_test {

using test::Word;

constexpr std::size_t input_words = 6;
constexpr std::size_t output_words = 6;

// Writes shaders: three variables of each type, an array, a matrix, statements that change them, and
// functions that call each other. Floats stay small integers and halves, so that no order of rounding matters
// where a compiler might choose one.
class Writer {
  public:
    explicit Writer(std::uint64_t seed) : random_(seed) {}

    std::string shader() {
        std::string functions;
        for (int f = 0; f < 3; ++f) functions += function(f);
        std::string body =
            "float f0 = number(0), f1 = number(1), f2 = number(2);\n"
            "int i0 = int(word(3)), i1 = int(word(4)), i2 = int(word(5));\n"
            "float a[4] = float[4](f0, f1, f2, 1.5); vec3 v = vec3(f2, f0, f1);\n"
            "mat2 m = mat2(f0, 1.0, f1, -2.0); uint u0 = word(3), u1 = 5u;\n";
        for (int s = 0; s < 12; ++s) body += statement(3, functions_);
        body +=
            "put(0u, f0); put(1u, f1); put(2u, f2 + a[1] + v.y + m[1][0]); put(3u, i0); put(4u, i1 ^ i2); "
            "put(5u, u0 + u1);\n";
        return test::row_shader(input_words, output_words, body, functions);
    }

  private:
    std::string pick(std::initializer_list<const char*> of) {
        return *(of.begin() + random_.below(of.size()));
    }
    std::string number() { return fmt::format("{:.1f}", static_cast<double>(random_.below(17)) / 2.0 - 4.0); }

    std::string real(int depth) {
        if (depth == 0) return pick({"f0", "f1", "f2", "v.x", "v.z", "a[2]", "m[0][1]"});
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
                    "m[{}] = m * vec2({}, 0.5); m = mat2(clamp(floor(m[0] * 0.25), -64.0, 64.0), "
                    "clamp(floor(m[1] * 0.25), -64.0, 64.0));\n",
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
    std::string held(int depth) {
        return fmt::format("floor(clamp({}, -64.0, 64.0) * 2.0) * 0.5", real(depth));
    }

    std::string function(int f) {
        std::string body = fmt::format(
            "float call{}(float f0, inout int i0, inout vec3 v) {{\n"
            "float f1 = f0 * 0.5, f2 = v.y; int i1 = i0 >> 1, i2 = 3;\n"
            "float a[4] = float[4](f0, f2, v.z, -1.5); mat2 m = mat2(f0, f2, 1.0, 2.0); uint u0 = uint(i0), "
            "u1 = 9u;\n",
            f);
        for (int s = 0; s < 4; ++s) body += statement(2, f);
        if (random_.below(2) == 0) body += fmt::format("if ({}) return {};\n", truth(1), held(1));
        functions_ = f + 1;
        return body +
               "v.x = f2;\nreturn floor(clamp(f1 + float(i1 & 7) + a[3] + m[0][0], -64.0, 64.0));\n}\n";
    }

    numeric::Random random_;
    int level_ = 0;
    int functions_ = 0;
};

test::Rows rows_of(std::uint64_t seed) {
    numeric::Random random(seed);
    test::Rows rows{.inputs = {}, .input_words = input_words, .output_words = output_words};
    for (int r = 0; r < 64; ++r) {
        for (int k = 0; k < 3; ++k)
            rows.inputs.push_back(
                std::bit_cast<Word>(static_cast<float>(static_cast<int>(random.below(65)) - 32) * 0.5F));
        for (int k = 0; k < 3; ++k)
            rows.inputs.push_back(r % 2 == 0 ? static_cast<Word>(random.below(50)) - 25U
                                             : static_cast<Word>(random.bits()));
    }
    return rows;
}

// Zeros of either sign are one value: a device may lose the sign where nothing keeps it.
std::vector<Word> without_signs_of_zero(std::vector<Word> words) {
    for (std::size_t w = 0; w < words.size(); ++w)
        if (w % output_words < 3 && words[w] == 0x80000000U) words[w] = 0;
    return words;
}

void expect_agreement(const gpu::Device& device, std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        const std::string text = Writer(seed).shader();
        const shader::Spirv module = test::strictly_compiled(text);
        const test::Rows rows = rows_of(seed);
        const auto ours = without_signs_of_zero(test::rounded_correctly(interpreter::Program(module), rows));
        const auto there = without_signs_of_zero(test::on_device(device, module, rows));
        const auto at = std::ranges::mismatch(ours, there).in1 - ours.begin();
        ASSERT_EQ(ours, there) << device.info().name << ", seed " << seed << ", row "
                               << at / static_cast<std::ptrdiff_t>(output_words) << ", word "
                               << at % static_cast<std::ptrdiff_t>(output_words) << "\n"
                               << text;
    }
}

class RandomModule : public testing::TestWithParam<int> {};

TEST_P(RandomModule, MeansTheSameToEveryDevice) {
    for (const gpu::DeviceInfo& info : test::devices_at_hand()) {
        const gpu::Device device(gpu::DeviceOptions{.device = info.name});
        expect_agreement(device, static_cast<std::uint64_t>(GetParam()) * 1000U, 12);
    }
}

// An optimised module means what the module it was made from means.
TEST_P(RandomModule, MeansTheSameWhenItIsOptimised) {
    for (std::uint64_t seed = static_cast<std::uint64_t>(GetParam()) * 1000U; seed % 1000U < 12; ++seed) {
        const std::string text = Writer(seed).shader();
        const test::Rows rows = rows_of(seed);
        const auto plain = test::rounded_correctly(interpreter::Program(test::strictly_compiled(text)), rows);
        for (const char* variant : {"optimized", "small", "round_trip", "hlsl"}) {
            shader::Variant made = shader::variant(variant);
            made.strict = true;
            const shader::Spirv module = shader::compile({.name = "test", .text = text}, {.variant = made});
            EXPECT_EQ(test::rounded_correctly(interpreter::Program(module), rows), plain)
                << variant << ", seed " << seed << "\n"
                << text;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 5));

}  // namespace random_module_test
}  // namespace gloam

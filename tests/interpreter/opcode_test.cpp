// SPDX-License-Identifier: MIT
// Every operation alone: compared with wider arithmetic, and with the device if the result has a single
// value.
#include <fmt/ranges.h>

#include "interpreter/shader_run.hpp"
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/shared_device.hpp"

namespace gloam::opcode_test {

using interpreter::Machine;
using interpreter::Program;

constexpr std::size_t input_words = 8;

// The inputs of a row: four floats x, y, z, w, and four words i, j, k, l.
struct Row {
    std::span<const Word> words;
    [[nodiscard]] double x(std::size_t n) const { return std::bit_cast<float>(words[n]); }
    [[nodiscard]] Word u(std::size_t n) const { return words[4 + n]; }
    [[nodiscard]] std::int32_t i(std::size_t n) const { return static_cast<std::int32_t>(u(n)); }
};

struct Operation {
    std::string expression;                     // of GLSL, with the value of one scalar
    std::function<double(const Row&)> wide;     // a float as a real number; empty: none is stated
    std::function<Word(const Row&)> word = {};  // an integer or bool
    bool one_value = true;  // Vulkan leaves no choice but flushing and NaN: every device has these bits
    double ulps = 0.5;      // that rounding may be off from `wide`
};

Operation real(const std::string& expression, std::function<double(const Row&)> wide, bool one_value = true,
               double ulps = 0.5) {
    return {.expression = expression, .wide = std::move(wide), .one_value = one_value, .ulps = ulps};
}
// Where Vulkan leaves a choice of results.
Operation loose(const std::string& expression, std::function<double(const Row&)> wide) {
    return real(expression, std::move(wide), false);
}
template <class Value>
Operation whole(const std::string& expression, Value value) {
    return {.expression = expression, .wide = {}, .word = [value](const Row& r) {
                return static_cast<Word>(value(r));
            }};
}

const std::vector<Operation> float_operations{
    real("-x", [](const Row& r) { return -r.x(0); }),
    real("x + y", [](const Row& r) { return r.x(0) + r.x(1); }),
    real("x - y", [](const Row& r) { return r.x(0) - r.x(1); }),
    real("x * y", [](const Row& r) { return r.x(0) * r.x(1); }),
    real(
        "x / y", [](const Row& r) { return r.x(0) / r.x(1); }, false, 0.5001),
    real("(vec3(x, y, z) * w).y", [](const Row& r) { return r.x(1) * r.x(3); }),
    real("(mat2(x, y, z, w) * y)[1][0]", [](const Row& r) { return r.x(2) * r.x(1); }),
    real("outerProduct(vec2(x, y), vec3(z, w, x))[1].y", [](const Row& r) { return r.x(1) * r.x(3); }),
    real("transpose(mat3x2(x, y, z, w, x, y))[1].z", [](const Row& r) { return r.x(1); }),
    real("abs(x)", [](const Row& r) { return std::abs(r.x(0)); }),
    real("sign(x)", [](const Row& r) { return r.x(0) > 0 ? 1.0 : (r.x(0) < 0 ? -1.0 : 0.0); }),
    real("floor(x)", [](const Row& r) { return std::floor(r.x(0)); }),
    real("ceil(x)", [](const Row& r) { return std::ceil(r.x(0)); }),
    real("trunc(x)", [](const Row& r) { return std::trunc(r.x(0)); }),
    real("roundEven(x)", [](const Row& r) { return std::nearbyint(r.x(0)); }),
    loose("fract(x)", [](const Row& r) { return r.x(0) - std::floor(r.x(0)); }),
    real("min(x, y)", [](const Row& r) { return std::fmin(r.x(0), r.x(1)); }),
    real("max(x, y)", [](const Row& r) { return std::fmax(r.x(0), r.x(1)); }),
    real("clamp(x, min(y, z), max(y, z))",
         [](const Row& r) {
             return std::fmin(std::fmax(r.x(0), std::fmin(r.x(1), r.x(2))), std::fmax(r.x(1), r.x(2)));
         }),
    real("step(x, y)", [](const Row& r) { return r.x(1) < r.x(0) ? 0.0 : 1.0; }),
    real("ldexp(x, (k & 31) - 10)", [](const Row& r) { return std::ldexp(r.x(0), (r.i(2) & 31) - 10); }),
    loose("sqrt(abs(x))", [](const Row& r) { return std::sqrt(std::abs(r.x(0))); }),
    loose("inversesqrt(abs(x))", [](const Row& r) { return 1.0 / std::sqrt(std::abs(r.x(0))); }),
    loose("exp(x)", [](const Row& r) { return std::exp(r.x(0)); }),
    loose("exp2(x)", [](const Row& r) { return std::exp2(r.x(0)); }),
    loose("log(x)", [](const Row& r) { return std::log(r.x(0)); }),
    loose("log2(x)", [](const Row& r) { return std::log2(r.x(0)); }),
    loose("pow(x, y)", [](const Row& r) { return std::pow(r.x(0), r.x(1)); }),
    loose("sin(x)", [](const Row& r) { return std::sin(r.x(0)); }),
    loose("cos(x)", [](const Row& r) { return std::cos(r.x(0)); }),
    loose("tan(x)", [](const Row& r) { return std::tan(r.x(0)); }),
    loose("asin(x)", [](const Row& r) { return std::asin(r.x(0)); }),
    loose("acos(x)", [](const Row& r) { return std::acos(r.x(0)); }),
    loose("atan(x)", [](const Row& r) { return std::atan(r.x(0)); }),
    loose("atan(x, y)", [](const Row& r) { return std::atan2(r.x(0), r.x(1)); }),
    loose("sinh(x)", [](const Row& r) { return std::sinh(r.x(0)); }),
    loose("cosh(x)", [](const Row& r) { return std::cosh(r.x(0)); }),
    loose("tanh(x)", [](const Row& r) { return std::tanh(r.x(0)); }),
    loose("asinh(x)", [](const Row& r) { return std::asinh(r.x(0)); }),
    loose("acosh(x)", [](const Row& r) { return std::acosh(r.x(0)); }),
    loose("atanh(x)", [](const Row& r) { return std::atanh(r.x(0)); }),
    loose("radians(x)", [](const Row& r) { return r.x(0) * 0.017453292519943295; }),
    loose("degrees(x)", [](const Row& r) { return r.x(0) * 57.29577951308232; }),
    loose("fma(x, y, z)", [](const Row& r) { return std::fma(r.x(0), r.x(1), r.x(2)); }),
    real("float(i)", [](const Row& r) { return r.i(0); }),
    real("float(uint(i))", [](const Row& r) { return r.u(0); }),
    real("vec4(x, y, z, w).wzyx[k & 3]", [](const Row& r) { return r.x(3 - (r.u(2) & 3U)); }),
    real("(i > 0 ? x : y)", [](const Row& r) { return r.x(r.i(0) > 0 ? 0 : 1); }),
    real("mix(vec2(x, y), vec2(z, w), bvec2(i > 0, j > 0)).y",
         [](const Row& r) { return r.x(r.i(1) > 0 ? 3 : 1); }),
    real("frexp_part(x)",
         [](const Row& r) {
             int e = 0;
             return std::frexp(r.x(0), &e);
         }),
    real("modf_part(x)", [](const Row& r) { return std::trunc(r.x(0)); }),
    real("unpackHalf2x16(packHalf2x16(vec2(float((i & 2047) - 999), 0.0))).x",
         [](const Row& r) { return (r.i(0) & 2047) - 999; }),
    loose("unpackUnorm4x8(uint(i)).z", [](const Row& r) { return (r.u(0) >> 16U & 255U) / 255.0; }),
    real(
        "unpackSnorm2x16(uint(i)).y",
        [](const Row& r) { return std::fmax(static_cast<std::int16_t>(r.u(0) >> 16U) / 32767.0, -1.0); },
        false),
};

const std::vector<Operation> word_operations{
    whole("x < y", [](const Row& r) { return r.x(0) < r.x(1); }),
    whole("x <= y", [](const Row& r) { return r.x(0) <= r.x(1); }),
    whole("x > y", [](const Row& r) { return r.x(0) > r.x(1); }),
    whole("x >= y", [](const Row& r) { return r.x(0) >= r.x(1); }),
    whole("x == y", [](const Row& r) { return r.x(0) == r.x(1); }),
    whole("x != y", [](const Row& r) { return r.x(0) != r.x(1); }),
    whole("isinf(x)", [](const Row& r) { return std::isinf(r.x(0)); }),
    whole("any(lessThan(vec3(x, y, z), vec3(y, z, w)))",
          [](const Row& r) { return r.x(0) < r.x(1) || r.x(1) < r.x(2) || r.x(2) < r.x(3); }),
    whole("all(lessThan(vec3(x, y, z), vec3(y, z, w)))",
          [](const Row& r) { return r.x(0) < r.x(1) && r.x(1) < r.x(2) && r.x(2) < r.x(3); }),
    whole("-i", [](const Row& r) { return 0U - r.u(0); }),
    whole("i + j", [](const Row& r) { return r.u(0) + r.u(1); }),
    whole("i - j", [](const Row& r) { return r.u(0) - r.u(1); }),
    whole("i * j", [](const Row& r) { return r.u(0) * r.u(1); }),
    whole("i / (k | 1)", [](const Row& r) { return std::int64_t{r.i(0)} / (r.i(2) | 1); }),
    whole("(i & 255) % (k & 7 | 1)", [](const Row& r) { return (r.u(0) & 255U) % ((r.u(2) & 7U) | 1U); }),
    whole("uint(i) / uint(k | 1)", [](const Row& r) { return r.u(0) / (r.u(2) | 1U); }),
    whole("uint(i) % uint(k | 1)", [](const Row& r) { return r.u(0) % (r.u(2) | 1U); }),
    whole("i << (k & 31)", [](const Row& r) { return r.u(0) << (r.u(2) & 31U); }),
    whole("i >> (k & 31)", [](const Row& r) { return r.i(0) >> (r.u(2) & 31U); }),
    whole("uint(i) >> uint(k & 31)", [](const Row& r) { return r.u(0) >> (r.u(2) & 31U); }),
    whole("i & j", [](const Row& r) { return r.u(0) & r.u(1); }),
    whole("i | j", [](const Row& r) { return r.u(0) | r.u(1); }),
    whole("i ^ j", [](const Row& r) { return r.u(0) ^ r.u(1); }),
    whole("~i", [](const Row& r) { return ~r.u(0); }),
    whole("i == j", [](const Row& r) { return r.u(0) == r.u(1); }),
    whole("i != j", [](const Row& r) { return r.u(0) != r.u(1); }),
    whole("i < j", [](const Row& r) { return r.i(0) < r.i(1); }),
    whole("i <= j", [](const Row& r) { return r.i(0) <= r.i(1); }),
    whole("i > j", [](const Row& r) { return r.i(0) > r.i(1); }),
    whole("i >= j", [](const Row& r) { return r.i(0) >= r.i(1); }),
    whole("uint(i) < uint(j)", [](const Row& r) { return r.u(0) < r.u(1); }),
    whole("uint(i) <= uint(j)", [](const Row& r) { return r.u(0) <= r.u(1); }),
    whole("uint(i) > uint(j)", [](const Row& r) { return r.u(0) > r.u(1); }),
    whole("uint(i) >= uint(j)", [](const Row& r) { return r.u(0) >= r.u(1); }),
    whole("(i > 0) && (j > 0)", [](const Row& r) { return r.i(0) > 0 && r.i(1) > 0; }),
    whole("(i > 0) || (j > 0)", [](const Row& r) { return r.i(0) > 0 || r.i(1) > 0; }),
    whole("(i > 0) ^^ (j > 0)", [](const Row& r) { return (r.i(0) > 0) != (r.i(1) > 0); }),
    whole("(i > 0) == (j > 0)", [](const Row& r) { return (r.i(0) > 0) == (r.i(1) > 0); }),
    whole("!(i > 0)", [](const Row& r) { return r.i(0) <= 0; }),
    whole("abs(i)", [](const Row& r) { return r.i(0) < 0 ? 0U - r.u(0) : r.u(0); }),
    whole("sign(i)", [](const Row& r) { return (r.i(0) > 0) - (r.i(0) < 0); }),
    whole("min(i, j)", [](const Row& r) { return std::min(r.i(0), r.i(1)); }),
    whole("max(i, j)", [](const Row& r) { return std::max(r.i(0), r.i(1)); }),
    whole("min(uint(i), uint(j))", [](const Row& r) { return std::min(r.u(0), r.u(1)); }),
    whole("max(uint(i), uint(j))", [](const Row& r) { return std::max(r.u(0), r.u(1)); }),
    whole("clamp(i, -5, 1000)", [](const Row& r) { return std::clamp(r.i(0), -5, 1000); }),
    whole("clamp(uint(i), 5u, 1000u)", [](const Row& r) { return std::clamp(r.u(0), 5U, 1000U); }),
    whole("bitCount(i)", [](const Row& r) { return std::popcount(r.u(0)); }),
    whole("findLSB(i)", [](const Row& r) { return r.u(0) == 0 ? -1 : std::countr_zero(r.u(0)); }),
    whole("findMSB(i)", [](const Row& r) { return 31 - std::countl_zero(r.i(0) < 0 ? ~r.u(0) : r.u(0)); }),
    whole("findMSB(uint(i))", [](const Row& r) { return 31 - std::countl_zero(r.u(0)); }),
    whole("bitfieldReverse(i)",
          [](const Row& r) {
              Word all = 0;
              for (unsigned b = 0; b < 32; ++b) all |= (r.u(0) >> b & 1U) << (31U - b);
              return all;
          }),
    whole("bitfieldExtract(i, 3, 9)",
          [](const Row& r) { return static_cast<std::int32_t>(r.u(0) << 20U) >> 23U; }),
    whole("bitfieldExtract(uint(i), 3, 9)", [](const Row& r) { return r.u(0) >> 3U & 511U; }),
    whole("bitfieldInsert(i, j, 5, 7)",
          [](const Row& r) { return (r.u(0) & ~(127U << 5U)) | (r.u(1) & 127U) << 5U; }),
    whole("carry_part(uint(i), uint(j))",
          [](const Row& r) { return (std::uint64_t{r.u(0)} + r.u(1)) >> 32U; }),
    whole("borrow_part(uint(i), uint(j))", [](const Row& r) { return r.u(0) < r.u(1); }),
    whole("high_part(uint(i), uint(j))", [](const Row& r) { return std::uint64_t{r.u(0)} * r.u(1) >> 32U; }),
    whole("high_part(i, j)", [](const Row& r) { return std::int64_t{r.i(0)} * r.i(1) >> 32U; }),
    whole("int(float((i & 4095) - 2048) * 0.5)", [](const Row& r) { return ((r.i(0) & 4095) - 2048) / 2; }),
    whole("uint(float(i & 4095) * 0.5)", [](const Row& r) { return (r.u(0) & 4095U) / 2U; }),
    whole("exponent_part(x)",
          [](const Row& r) {
              int e = 0;
              (void)std::frexp(r.x(0), &e);
              return e;
          }),
    whole("switched(k)", [](const Row& r) { return r.u(2) % 5U == 0 ? 7 : (r.u(2) % 5U == 3 ? 11 : 13); }),
    whole("looped(k & 15)",
          [](const Row& r) {
              const Word n = r.u(2) & 15U;
              return n * (n + 1U) / 2U;
          }),
};

const std::string functions = R"(
float frexp_part(float x) { int e; return frexp(x, e); }
int exponent_part(float x) { int e; float f = frexp(x, e); return e; }
float modf_part(float x) { float whole_; float f = modf(x, whole_); return whole_; }
uint carry_part(uint a, uint b) { uint c; uint s = uaddCarry(a, b, c); return c; }
uint borrow_part(uint a, uint b) { uint c; uint s = usubBorrow(a, b, c); return c; }
uint high_part(uint a, uint b) { uint h; uint l; umulExtended(a, b, h, l); return h; }
int high_part(int a, int b) { int h; int l; imulExtended(a, b, h, l); return h; }
int switched(int k) { switch (uint(k) % 5u) { case 0u: return 7; case 3u: return 11; default: break; } return 13; }
int looped(int n) { int s = 0; for (int a = 0; a <= n; ++a) { if (a == 1000) continue; s += a; } return s; }
)";

std::string text_of(const std::vector<Operation>& operations) {
    std::string body =
        "float x = number(0); float y = number(1); float z = number(2); float w = number(3);\n"
        "int i = int(word(4)); int j = int(word(5)); int k = int(word(6));\n";
    for (std::size_t n = 0; n < operations.size(); ++n)
        body += fmt::format("put({}u, {});\n", n, operations[n].expression);
    return test::row_shader(input_words, operations.size(), body, functions);
}

// Usual values, huge and tiny ones, special ones, and small integers.
Rows rows_of(std::size_t outputs) {
    numeric::Random random(7);
    const std::vector<double> specials = numeric::special_values(numeric::float32);
    Rows rows{.inputs = {}, .input_words = input_words, .output_words = outputs};
    constexpr std::size_t count = 2000;
    for (std::size_t r = 0; r < count; ++r) {
        for (std::size_t n = 0; n < 4; ++n) {
            const double scale = r % 4 == 0 ? random.uniform(-100, 100) : random.uniform(-6, 6);
            auto value = static_cast<float>((random.below(2) == 0 ? -1.0 : 1.0) * std::exp2(scale));
            if (r % 8 == 1) value = static_cast<float>(specials[random.below(specials.size())]);
            rows.inputs.push_back(std::bit_cast<Word>(value));
        }
        for (std::size_t n = 0; n < 4; ++n) {
            const auto bits = static_cast<Word>(random());
            rows.inputs.push_back(r % 3 == 0 ? bits % 64U - 32U : bits);
        }
    }
    return rows;
}

bool is_usual(float x) {
    return x == 0.0F || (std::isfinite(x) && std::abs(x) >= 0x1p-126F);
}

void compare_one(const std::vector<Operation>& operations, std::size_t n, const Rows& rows,
                 const std::vector<Word>& ours, const std::vector<Word>& device) {
    const Operation& operation = operations[n];
    std::size_t wrong = 0;
    std::size_t differ = 0;
    std::string first;
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const Row row{std::span(rows.inputs).subspan(r * input_words, input_words)};
        const Word got = ours[r * operations.size() + n];
        const Word there = device[r * operations.size() + n];
        const bool special = !std::ranges::all_of(
            row.words.first(4), [](Word word) { return is_usual(std::bit_cast<float>(word)); });
        bool right = true;
        if (operation.word) {
            right = got == operation.word(row) || special;
        } else {
            const double want = operation.wide(row);
            right = numeric::ulp_error(std::bit_cast<float>(got), want) <= operation.ulps || special;
        }
        const bool value_is_usual = !operation.wide || is_usual(std::bit_cast<float>(got));
        const bool both_zero = operation.wide && (got | there | 0x80000000U) == 0x80000000U;
        const bool same = got == there || both_zero || special || !value_is_usual;
        if (!right) ++wrong;
        if (!same && operation.one_value) ++differ;
        if ((!right || (!same && operation.one_value)) && first.empty())
            first = fmt::format("row {}: {:08x}, on the device {:08x}, from {:08x}", r, got, there,
                                fmt::join(row.words, " "));
    }
    EXPECT_EQ(wrong, 0U) << operation.expression << ": " << first;
    EXPECT_EQ(differ, 0U) << operation.expression << ": " << first;
}

void compare(const std::vector<Operation>& operations) {
    const module::Spirv module = test::strictly_compiled(text_of(operations));
    const Rows rows = rows_of(operations.size());
    const std::vector<Word> device = test::on_device(*test::SharedDevice::get(), module, rows);
    const std::vector<Word> ours = test::rounded_correctly(Program(module), rows);
    for (std::size_t n = 0; n < operations.size(); ++n) compare_one(operations, n, rows, ours, device);
}

TEST(OpcodeTest, FloatsAreRoundedCorrectlyAsTheDeviceRoundsThem) {
    compare(float_operations);
}

TEST(OpcodeTest, IntegersAndBoolsAreTheDevices) {
    compare(word_operations);
}

// On intervals: what the device gives and what correct rounding gives are permitted, whatever the input.
TEST(OpcodeTest, BothAreAmongWhatIsPermitted) {
    std::vector<Operation> operations = float_operations;
    for (const Operation& more : word_operations) operations.push_back(more);
    const module::Spirv module = test::strictly_compiled(text_of(operations));
    const Rows rows = rows_of(operations.size());
    const std::vector<Word> device = test::on_device(*test::SharedDevice::get(), module, rows);
    const std::vector<Word> ours = test::rounded_correctly(Program(module), rows);
    for (std::size_t n = 0; n < operations.size(); ++n) {
        const module::Spirv alone = test::strictly_compiled(text_of({operations[n]}));
        const Program one(alone);
        Machine<numeric::Interval> intervals(one);
        std::size_t outside = 0;
        std::size_t bounded = 0;
        for (std::size_t r = 0; r < rows.count(); r += 7) {
            const auto row = std::span(rows.inputs).subspan(r * input_words, input_words);
            for (const Word got : {device[r * operations.size() + n], ours[r * operations.size() + n]}) {
                bool inside = false;
                const auto outcome = numeric::Paths::explore(numeric::float32, 4096, [&] {
                    const auto value = test::interpreted(intervals, row, 1).front();
                    inside = inside ||
                             (operations[n].wide ? value.number().bounds().contains(std::bit_cast<float>(got))
                                                 : value.bits() == got);
                });
                if (outcome != numeric::Paths::Outcome::complete) continue;
                ++bounded;
                if (!inside) ++outside;
            }
        }
        EXPECT_EQ(outside, 0U) << operations[n].expression << " of " << bounded;
        EXPECT_GT(bounded, 0U) << operations[n].expression;
    }
}

// An argument near a whole number has one way for each number that it may reach.
struct NearWhole {
    const char* expression;  // x = 0.7, whose product with 10 is rounded to 7 or below; y = 0.35, likewise
    std::vector<double> permitted;
    std::vector<double> forbidden;
};

const std::vector<NearWhole> near_whole{
    {"floor(x * 10.0)", {6.0, 7.0}, {6.5, 5.0, 8.0}},
    {"ceil(-x * 10.0)", {-7.0, -6.0}, {-6.5}},
    {"trunc(-x * 10.0)", {-7.0, -6.0}, {-6.5}},
    {"round(y * 10.0)", {3.0, 4.0}, {3.5}},
    {"roundEven(y * 10.0)", {3.0, 4.0}, {3.5}},
    {"sign(x * 10.0 - 7.0)", {-1.0, 0.0}, {-0.5, 1.0}},
    {"fract(x * 10.0)", {0.0, 1.0 - 0x1p-21}, {0.25, 1e-6, 1.0 - 0x1p-20, -1e-8}},
    {"fract(x * 1e-40 - 1e-42)", {0.0}, {0.25, 0.5}},
    {"fract(-x * 1e-30)", {1.0, 1.0 - 0x1p-24}, {0.0, 0.5}},
    {"mod(x, x)", {0.0, 0.7F}, {0.25, 0.35}},
    {"mod(x * 10.0, 1.0)", {0.0, 1.0 - 0x1p-21}, {0.25, 0.5}},
    {"x * 10.0 - floor(x * 10.0)", {0.0, 1.0 - 0x1p-21, 1.0, -0x1p-21}, {0.25, 0.5}},
    {"modf_part(x * 10.0)", {6.0, 7.0}, {6.5}},
    {"float(int(x * 10.0))", {6.0, 7.0}, {6.5}},
    // The same result twice is the same number.
    {"twice(floor(x * 10.0))", {42.0}, {41.0, 43.0, 42.5}},
    {"steep(fract(x * 10.0))", {0.0, 1.0}, {0.5, 1.1, 2.0, 3.0}},
    // With more than a few numbers in reach all between are permitted.
    {"floor(exp(y * 50.0))", {39824784.0, 39824785.0}, {39825784.0}},
};

TEST(NearWholeNumbers, EachThatAnArgumentMayReachIsAWayOfItsOwn) {
    const std::string functions =
        "float modf_part(float x) { float whole; modf(x, whole); return whole; }\n"
        "float twice(float n) { return (n - 6.0) * (7.0 - n) + 42.0; }\n"
        "float steep(float t) { return t * t * (3.0 - 2.0 * t); }\n";
    const std::array<Word, 2> row{std::bit_cast<Word>(0.7F), std::bit_cast<Word>(0.35F)};
    for (const auto& [expression, permitted, forbidden] : near_whole) {
        const std::string body =
            std::string("float x = number(0); float y = number(1); put(0, ") + expression + ");\n";
        const Program program(test::strictly_compiled(test::row_shader(2, 1, body, functions)));
        Machine<numeric::Interval> intervals(program);
        std::vector<numeric::Bounds> ways;
        const auto outcome = numeric::Paths::explore(numeric::float32, 16, [&] {
            ways.push_back(test::interpreted(intervals, row, 1).front().number().bounds());
        });
        EXPECT_EQ(outcome, numeric::Paths::Outcome::complete) << expression;
        const auto has = [&](double x) {
            return std::ranges::any_of(ways, [x](const numeric::Bounds& way) { return way.contains(x); });
        };
        for (const double x : permitted) EXPECT_TRUE(has(x)) << expression << ": " << x;
        for (const double x : forbidden) EXPECT_FALSE(has(x)) << expression << ": " << x;
    }
}

}  // namespace gloam::opcode_test

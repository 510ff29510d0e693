// SPDX-License-Identifier: MIT
// Operations on float16, compared with C++, with the device, and with what the rules permit.
#include <fmt/format.h>

#include "interpreter/shader_run.hpp"
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/shared_device.hpp"

namespace gloam::halves_test {

using interpreter::Machine;
using interpreter::Program;

constexpr std::size_t input_words = 2;
using Row = std::span<const Word>;

constexpr const char* variables =
    "float16_t h = float16_t(float(int(word(0) & 2047u) - 1000) * 0.0625);\n"
    "float16_t g = float16_t(float(int(word(1) & 1023u) + 1) * 0.125);\n";

std::string shader_of(const std::string& statements, std::size_t outputs) {
    std::string text = test::row_shader(input_words, outputs, variables + statements);
    return text.replace(text.find('\n'), 1,
                        "\n#extension GL_EXT_shader_explicit_arithmetic_types : require\n");
}

// A GLSL expression, and its value in C++.
struct Case {
    const char* glsl;
    std::function<double(const Row&)> wanted;
    bool one_value = true;  // the rules leave no choice but rounding, flushing and NaN
};

// Every result is put as the float of its value.
TEST(Halves, AreRoundedToTheirFormat) {
    const auto half = [](double x) {
        const double low = numeric::float16.round_down(x);
        const double high = numeric::float16.round_up(x);
        if (x - low != high - x) return x - low < high - x ? low : high;
        return std::fmod(low / numeric::float16.ulp(low), 2.0) == 0.0 ? low : high;
    };
    const auto h = [half](const Row& r) { return half((int(r[0] & 2047U) - 1000) * 0.0625); };
    const auto g = [half](const Row& r) { return half((int(r[1] & 1023U) + 1) * 0.125); };
    const std::vector<Case> cases{
        {"h + g", [=](const Row& r) { return half(h(r) + g(r)); }},
        {"h * g", [=](const Row& r) { return half(h(r) * g(r)); }},
        {"h / g", [=](const Row& r) { return half(h(r) / g(r)); }, false},
        {"floor(h)", [=](const Row& r) { return std::floor(h(r)); }},
        {"sqrt(g)", [=](const Row& r) { return half(std::sqrt(g(r))); }, false},
        {"max(h, g)", [=](const Row& r) { return std::max(h(r), g(r)); }},
        {"float16_t(float(h) * 1.001)",
         [=](const Row& r) { return half(static_cast<float>(h(r)) * 1.001F); }},
        {"f16vec3(h, g, h).y", [=](const Row& r) { return g(r); }},
        {"unpackFloat2x16(packFloat2x16(f16vec2(h, g))).y", [=](const Row& r) { return g(r); }},
        {"unpackFloat2x16(floatBitsToUint(uintBitsToFloat(packFloat2x16(f16vec2(h, g))))).x",
         [=](const Row& r) { return h(r); }}};
    std::string body;
    for (std::size_t c = 0; c < cases.size(); ++c)
        body += fmt::format("put({}, float(float16_t({})));\n", c, cases[c].glsl);
    const module::Spirv module = test::strictly_compiled(shader_of(body, cases.size()));
    const Program program(module);
    numeric::Random random(5);
    Rows rows{.inputs = {}, .input_words = input_words, .output_words = cases.size()};
    for (std::size_t word = 0; word < 500 * input_words; ++word)
        rows.inputs.push_back(static_cast<Word>(random()));
    const std::vector<Word> ours_of = test::rounded_correctly(program, rows);
    const std::vector<Word> device_of = test::on_device(*test::SharedDevice::get(), module, rows);
    Machine<numeric::Interval> intervals(program);
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const Row row = std::span(rows.inputs).subspan(r * input_words, input_words);
        (void)numeric::Paths::explore(numeric::float32, 1, [&] {
            const auto permitted = test::interpreted(intervals, row, rows.output_words);
            for (std::size_t c = 0; c < cases.size(); ++c) {
                const std::size_t at = r * rows.output_words + c;
                const double ours = std::bit_cast<float>(ours_of[at]);
                const double wanted = cases[c].wanted(row);
                const auto name = fmt::format("{} of {}, {}", cases[c].glsl, h(row), g(row));
                EXPECT_EQ(ours, wanted) << name;
                const numeric::Bounds bounds = permitted[c].number().bounds();
                EXPECT_TRUE(bounds.contains(ours)) << name << ": " << ours;
                EXPECT_TRUE(bounds.contains(std::bit_cast<float>(device_of[at])))
                    << name << ", on the device";
                if (cases[c].one_value && std::isfinite(wanted)) {
                    EXPECT_LE(bounds.high - bounds.low, 2.0 * numeric::float16.ulp(wanted)) << name;
                }
            }
            throw numeric::Paths::Enough{};
        });
    }
}

TEST(Halves, AnotherNumberIsRefused) {
    const module::Spirv module =
        test::strictly_compiled(shader_of("put(0, float(double(word(0)) * 0.1lf));\n", 1));
    EXPECT_THAT([&] { (void)Program(module); },
                testing::ThrowsMessage<interpreter::Error>(
                    HasSubstr("double is not judged: gloam judges float, float16_t, int, uint and bool")));
}

}  // namespace gloam::halves_test

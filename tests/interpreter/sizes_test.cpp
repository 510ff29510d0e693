// SPDX-License-Identifier: MIT
// Operations on doubles, float16 and integers of 8, 16 and 64 bits: compared with C++, with the device, and
// with what the rules permit.
#include <fmt/format.h>

#include "interpreter/shader_run.hpp"
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/shared_device.hpp"

namespace gloam::sizes_test {

using interpreter::Machine;
using interpreter::Program;

constexpr std::size_t input_words = 8;

// Two doubles x, y, and two integers of 64 bits i, j, from which the shaders make other numbers.
struct Row {
    std::span<const Word> words;
    [[nodiscard]] std::uint64_t bits(std::size_t n) const {
        return std::uint64_t{words[2 * n + 1]} << 32U | words[2 * n];
    }
    [[nodiscard]] double x() const { return std::bit_cast<double>(bits(0)); }
    [[nodiscard]] double y() const { return std::bit_cast<double>(bits(1)); }
    [[nodiscard]] std::uint64_t i() const { return bits(2); }
    [[nodiscard]] std::uint64_t j() const { return bits(3); }
};

constexpr const char* variables =
    "double x = packDouble2x32(uvec2(word(0), word(1)));\n"
    "double y = packDouble2x32(uvec2(word(2), word(3)));\n"
    "uint64_t i = packUint2x32(uvec2(word(4), word(5)));\n"
    "uint64_t j = packUint2x32(uvec2(word(6), word(7)));\n"
    "float16_t h = float16_t(float(int(word(4) & 2047u) - 1000) * 0.0625);\n"
    "float16_t g = float16_t(float(int(word(6) & 1023u) + 1) * 0.125);\n";

std::string shader_of(const std::string& statements, std::size_t outputs) {
    std::string text = test::row_shader(input_words, outputs, variables + statements);
    return text.replace(text.find('\n'), 1,
                        "\n#extension GL_EXT_shader_explicit_arithmetic_types : require\n");
}

// A GLSL expression, and its value in C++.
template <class T>
struct Case {
    const char* glsl;
    std::function<T(const Row&)> wanted;
    bool one_value = true;  // the rules leave no choice but rounding, flushing and NaN
};

// Edge values of each type, then random ones.
Rows rows_of(std::size_t outputs) {
    numeric::Random random(5);
    Rows rows{.inputs = {}, .input_words = input_words, .output_words = outputs};
    const std::vector<double> specials = numeric::special_values(numeric::float64);
    const std::array<std::uint64_t, 6> edges{0,
                                             1,
                                             ~std::uint64_t{0},
                                             std::uint64_t{1} << 63U,
                                             (std::uint64_t{1} << 63U) - 1,
                                             std::uint64_t{1} << 31U};
    const auto add = [&rows](std::uint64_t bits) {
        rows.inputs.push_back(static_cast<Word>(bits));
        rows.inputs.push_back(static_cast<Word>(bits >> 32U));
    };
    for (std::size_t r = 0; r < 500; ++r) {
        for (int n = 0; n < 2; ++n) {
            const double sign = random.below(2) == 0 ? -1.0 : 1.0;
            const double usual = sign * std::exp2(random.uniform(-8, 8));
            add(std::bit_cast<std::uint64_t>(r % 4 == 0 ? specials[random.below(specials.size())] : usual));
        }
        for (int n = 0; n < 2; ++n)
            add(r % 4 == 1 ? edges[random.below(edges.size())] : random.bits() >> random.below(64));
    }
    return rows;
}

struct Outcome {
    std::vector<Word> ours;
    std::vector<Word> device;
};

// Whether the device has what the module needs is asked by running it: lavapipe has all.
Outcome run(const Program& program, const shader::Spirv& module, const Rows& rows) {
    return {test::rounded_correctly(program, rows),
            test::on_device(*test::SharedDevice::get(), module, rows)};
}

std::uint64_t joined(std::span<const Word> words, std::size_t at) {
    return std::uint64_t{words[at + 1]} << 32U | words[at];
}

TEST(Sizes, DoublesAreThoseOfTheProcessorAndOfTheRules) {
    const std::vector<Case<double>> cases{
        {"x + y", [](const Row& r) { return r.x() + r.y(); }},
        {"x - y", [](const Row& r) { return r.x() - r.y(); }},
        {"x * y", [](const Row& r) { return r.x() * r.y(); }},
        {"x / y", [](const Row& r) { return r.x() / r.y(); }, false},
        {"-x", [](const Row& r) { return -r.x(); }},
        {"abs(x)", [](const Row& r) { return std::abs(r.x()); }},
        {"floor(x)", [](const Row& r) { return std::floor(r.x()); }},
        {"ceil(x)", [](const Row& r) { return std::ceil(r.x()); }},
        {"roundEven(x)", [](const Row& r) { return std::nearbyint(r.x()); }},
        {"sqrt(abs(x))", [](const Row& r) { return std::sqrt(std::abs(r.x())); }, false},
        {"min(x, y)", [](const Row& r) { return std::fmin(r.x(), r.y()); }},
        {"x < y ? x : y", [](const Row& r) { return r.x() < r.y() ? r.x() : r.y(); }},
        {"double(int64_t(i))",
         [](const Row& r) { return static_cast<double>(static_cast<std::int64_t>(r.i())); }},
        {"double(i)", [](const Row& r) { return static_cast<double>(r.i()); }},
        {"double(int(word(4)))",
         [](const Row& r) { return static_cast<double>(static_cast<std::int32_t>(r.words[4])); }},
        {"double(float(double(word(4)) + 0.5lf))",
         [](const Row& r) { return double{static_cast<float>(r.words[4] + 0.5)}; }, false},
        {"dot(dvec2(x, 3.0lf), dvec2(2.0lf, y))", [](const Row& r) { return r.x() * 2.0 + 3.0 * r.y(); },
         false},
        {"(dmat2(1.0lf, 2.0lf, x, y) * dvec2(0.0lf, 1.0lf)).y",
         [](const Row& r) { return 0.0 * 2.0 + r.y(); }, false},
        {"uint64BitsToDouble(i >> 2)", [](const Row& r) { return std::bit_cast<double>(r.i() >> 2U); }},
        {"ldexp(y, int(word(4) & 15u))",
         [](const Row& r) { return std::ldexp(r.y(), static_cast<int>(r.words[4] & 15U)); }}};
    std::string body;
    for (std::size_t c = 0; c < cases.size(); ++c)
        body += fmt::format("{{ uvec2 w = unpackDouble2x32({}); put({}, w.x); put({}, w.y); }}\n",
                            cases[c].glsl, 2 * c, 2 * c + 1);
    const shader::Spirv module = test::strictly_compiled(shader_of(body, 2 * cases.size()));
    const Program program(module);
    const Rows rows = rows_of(2 * cases.size());
    const Outcome all = run(program, module, rows);
    Machine<numeric::Interval> intervals(program);
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const Row row{std::span(rows.inputs).subspan(r * input_words, input_words)};
        (void)numeric::Paths::explore(numeric::float32, 1, [&] {
            const auto permitted = test::interpreted(intervals, row.words, rows.output_words);
            for (std::size_t c = 0; c < cases.size(); ++c) {
                const std::size_t at = r * rows.output_words + 2 * c;
                const auto ours = std::bit_cast<double>(joined(all.ours, at));
                const auto device = std::bit_cast<double>(joined(all.device, at));
                const double wanted = cases[c].wanted(row);
                const auto name =
                    fmt::format("{} of {}, {}, {}, {}", cases[c].glsl, row.x(), row.y(), row.i(), row.j());
                EXPECT_TRUE(ours == wanted || (std::isnan(ours) && std::isnan(wanted)))
                    << name << ": " << ours << ", not " << wanted;
                const numeric::Bounds bounds = permitted[2 * c].number().bounds();
                EXPECT_TRUE(bounds.contains(ours)) << name << ": " << ours;
                if (std::isfinite(row.x()) && std::isfinite(row.y())) {
                    EXPECT_TRUE(bounds.contains(device)) << name << ": the device gives " << device;
                }
                // Near the ends of the format a result may overflow, or be flushed.
                const double size = std::abs(wanted);
                const bool usual =
                    size > 1e-290 && size < 1e290 && std::isnormal(row.x()) && std::isnormal(row.y());
                if (usual && cases[c].one_value) {
                    EXPECT_LE(bounds.high - bounds.low, 2.0 * numeric::float64.ulp(wanted)) << name;
                }
            }
            throw numeric::Paths::Enough{};
        });
    }
}

// Integers: the same words from C++, the interpreter and the device.
void expect_integers(const std::vector<Case<std::uint64_t>>& cases) {
    std::string body;
    for (std::size_t c = 0; c < cases.size(); ++c)
        body += fmt::format("{{ uvec2 w = unpackUint2x32(uint64_t({})); put({}, w.x); put({}, w.y); }}\n",
                            cases[c].glsl, 2 * c, 2 * c + 1);
    const shader::Spirv module = test::strictly_compiled(shader_of(body, 2 * cases.size()));
    const Program program(module);
    const Rows rows = rows_of(2 * cases.size());
    const Outcome all = run(program, module, rows);
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const Row row{std::span(rows.inputs).subspan(r * input_words, input_words)};
        for (std::size_t c = 0; c < cases.size(); ++c) {
            const std::size_t at = r * rows.output_words + 2 * c;
            const auto name = fmt::format("{} of {:#x}, {:#x}", cases[c].glsl, row.i(), row.j());
            EXPECT_EQ(joined(all.ours, at), cases[c].wanted(row)) << name;
            EXPECT_EQ(joined(all.device, at), cases[c].wanted(row)) << name << ", on the device";
        }
    }
}

template <class T>
std::uint64_t extended(T x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
}

TEST(Sizes, IntegersOf64BitsAreThoseOfTheProcessor) {
    const auto s = [](std::uint64_t x) { return static_cast<std::int64_t>(x); };
    expect_integers({
        {"i + j", [](const Row& r) { return r.i() + r.j(); }},
        {"i - j", [](const Row& r) { return r.i() - r.j(); }},
        {"i * j", [](const Row& r) { return r.i() * r.j(); }},
        {"i / (j | 1ul)", [](const Row& r) { return r.i() / (r.j() | 1U); }},
        {"i % (j | 1ul)", [](const Row& r) { return r.i() % (r.j() | 1U); }},
        {"int64_t(i) / int64_t(j >> 1 | 2ul)",
         [s](const Row& r) { return extended(s(r.i()) / s(r.j() >> 1U | 2U)); }},
        {"-int64_t(i)", [](const Row& r) { return 0 - r.i(); }},
        {"i << (word(6) & 63u)", [](const Row& r) { return r.i() << (r.words[6] & 63U); }},
        {"i >> (word(6) & 63u)", [](const Row& r) { return r.i() >> (r.words[6] & 63U); }},
        {"int64_t(i) >> (word(6) & 63u)",
         [s](const Row& r) { return extended(s(r.i()) >> (r.words[6] & 63U)); }},
        {"(i & j) | (~i ^ j)", [](const Row& r) { return (r.i() & r.j()) | (~r.i() ^ r.j()); }},
        {"i < j ? 1 : 0", [](const Row& r) { return r.i() < r.j() ? 1U : 0U; }},
        {"int64_t(i) < int64_t(j) ? 1 : 0", [s](const Row& r) { return s(r.i()) < s(r.j()) ? 1U : 0U; }},
        {"i == j ? 1 : 0", [](const Row& r) { return r.i() == r.j() ? 1U : 0U; }},
        {"max(int64_t(i), int64_t(j))", [s](const Row& r) { return extended(std::max(s(r.i()), s(r.j()))); }},
        {"clamp(i, 7ul, 1ul << 40)",
         [](const Row& r) { return std::clamp<std::uint64_t>(r.i(), 7, 1ULL << 40U); }},
        {"int64_t(int(word(4)))",
         [](const Row& r) { return extended(static_cast<std::int32_t>(r.words[4])); }},
        {"uint64_t(word(4))", [](const Row& r) { return std::uint64_t{r.words[4]}; }},
        {"uint(i)", [](const Row& r) { return std::uint64_t{r.words[4]}; }},
        {"packUint2x32(unpackUint2x32(i).yx)", [](const Row& r) { return std::rotl(r.i(), 32); }},
        {"pack64(u16vec4(i, j, 3, 4))",
         [](const Row& r) {
             return (r.i() & 0xffffU) | (r.j() & 0xffffU) << 16U | 3ULL << 32U | 4ULL << 48U;
         }},
        {"u64vec3(i, j, 5).zxy.y", [](const Row& r) { return r.i(); }},
        {"int64_t(double(word(4)) * -4096.0lf)",
         [](const Row& r) { return extended(static_cast<std::int64_t>(r.words[4]) * -4096); }},
    });
}

TEST(Sizes, SmallIntegersWrapAsThoseOfTheProcessor) {
    const auto b = [](std::uint64_t x) { return static_cast<std::int8_t>(x); };
    const auto h = [](std::uint64_t x) { return static_cast<std::int16_t>(x); };
    expect_integers({
        {"int8_t(i) + int8_t(j)", [b](const Row& r) { return extended(b(r.i() + r.j())); }},
        {"int8_t(i) * int8_t(j)", [b](const Row& r) { return extended(b(r.i() * r.j())); }},
        {"-int8_t(i)", [b](const Row& r) { return extended(b(0 - r.i())); }},
        {"uint8_t(i) - uint8_t(j)",
         [](const Row& r) { return std::uint64_t{static_cast<std::uint8_t>(r.i() - r.j())}; }},
        {"uint8_t(i) / uint8_t(j | 1ul)",
         [](const Row& r) { return std::uint64_t{r.i() & 255U} / ((r.j() & 255U) | 1U); }},
        {"int8_t(i) >> int8_t(word(6) & 7u)",
         [b](const Row& r) { return extended(b(r.i()) >> (r.words[6] & 7U)); }},
        {"uint8_t(i) << uint8_t(word(6) & 7u)",
         [](const Row& r) { return std::uint64_t{static_cast<std::uint8_t>(r.i() << (r.words[6] & 7U))}; }},
        {"~uint8_t(i)", [](const Row& r) { return ~r.i() & 255U; }},
        {"int8_t(i) < int8_t(j) ? 1 : 0", [b](const Row& r) { return b(r.i()) < b(r.j()) ? 1U : 0U; }},
        {"min(int8_t(i), int8_t(j))", [b](const Row& r) { return extended(std::min(b(r.i()), b(r.j()))); }},
        {"int16_t(i) * int16_t(j)", [h](const Row& r) { return extended(h(r.i() * r.j())); }},
        {"int16_t(int8_t(i))", [b](const Row& r) { return extended(b(r.i())); }},
        {"uint16_t(int8_t(i))",
         [b](const Row& r) { return std::uint64_t{static_cast<std::uint16_t>(b(r.i()))}; }},
        {"uint16_t(i) + uint16_t(j)", [](const Row& r) { return (r.i() + r.j()) & 0xffffU; }},
        {"(i16vec3(i, j, 9) - int16_t(7)).y", [h](const Row& r) { return extended(h(r.j() - 7)); }},
        {"abs(int16_t(i) / int16_t(2))", [h](const Row& r) { return extended(std::abs(h(r.i()) / 2)); }},
        {"pack32(u8vec4(i, 2, j, 4))",
         [](const Row& r) { return (r.i() & 255U) | 2U << 8U | (r.j() & 255U) << 16U | 4U << 24U; }},
        {"unpack8(word(4)).z", [](const Row& r) { return std::uint64_t{r.words[4] >> 16U & 255U}; }},
        {"float16BitsToUint16(float16_t(int(word(4) & 1u) - 2))",
         [](const Row& r) { return (r.words[4] & 1U) != 0 ? 0xbc00U : 0xc000U; }},
        {"int8_t(float(int(word(4) & 127u)) * -1.0)",
         [](const Row& r) { return extended(-static_cast<int>(r.words[4] & 127U)); }},
    });
}

// float16, of which every result is put as the float of its value.
TEST(Sizes, HalvesAreRoundedToTheirFormat) {
    const auto half = [](double x) {
        const double low = numeric::float16.round_down(x);
        const double high = numeric::float16.round_up(x);
        if (x - low != high - x) return x - low < high - x ? low : high;
        return std::fmod(low / numeric::float16.ulp(low), 2.0) == 0.0 ? low : high;
    };
    const auto h = [half](const Row& r) { return half((int(r.words[4] & 2047U) - 1000) * 0.0625); };
    const auto g = [half](const Row& r) { return half((int(r.words[6] & 1023U) + 1) * 0.125); };
    const std::vector<Case<double>> cases{
        {"h + g", [=](const Row& r) { return half(h(r) + g(r)); }},
        {"h * g", [=](const Row& r) { return half(h(r) * g(r)); }},
        {"h / g", [=](const Row& r) { return half(h(r) / g(r)); }, false},
        {"floor(h)", [=](const Row& r) { return std::floor(h(r)); }},
        {"sqrt(g)", [=](const Row& r) { return half(std::sqrt(g(r))); }, false},
        {"max(h, g)", [=](const Row& r) { return std::max(h(r), g(r)); }},
        {"float16_t(float(h) * 1.001)",
         [=](const Row& r) { return half(static_cast<float>(h(r)) * 1.001F); }},
        {"f16vec3(h, g, h).y", [=](const Row& r) { return g(r); }},
        {"unpackFloat2x16(packFloat2x16(f16vec2(h, g))).y", [=](const Row& r) { return g(r); }}};
    std::string body;
    for (std::size_t c = 0; c < cases.size(); ++c)
        body += fmt::format("put({}, float(float16_t({})));\n", c, cases[c].glsl);
    const shader::Spirv module = test::strictly_compiled(shader_of(body, cases.size()));
    const Program program(module);
    const Rows rows = rows_of(cases.size());
    const Outcome all = run(program, module, rows);
    Machine<numeric::Interval> intervals(program);
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const Row row{std::span(rows.inputs).subspan(r * input_words, input_words)};
        (void)numeric::Paths::explore(numeric::float32, 1, [&] {
            const auto permitted = test::interpreted(intervals, row.words, rows.output_words);
            for (std::size_t c = 0; c < cases.size(); ++c) {
                const std::size_t at = r * rows.output_words + c;
                const double ours = std::bit_cast<float>(all.ours[at]);
                const double wanted = cases[c].wanted(row);
                const auto name = fmt::format("{} of {}, {}", cases[c].glsl, h(row), g(row));
                EXPECT_EQ(ours, wanted) << name;
                const numeric::Bounds bounds = permitted[c].number().bounds();
                EXPECT_TRUE(bounds.contains(ours)) << name << ": " << ours;
                EXPECT_TRUE(bounds.contains(std::bit_cast<float>(all.device[at])))
                    << name << ", on the device";
                if (cases[c].one_value && std::isfinite(wanted)) {
                    EXPECT_LE(bounds.high - bounds.low, 2.0 * numeric::float16.ulp(wanted)) << name;
                }
            }
            throw numeric::Paths::Enough{};
        });
    }
}

}  // namespace gloam::sizes_test

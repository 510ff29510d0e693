// SPDX-License-Identifier: MIT
// Functions of doubles, float16 and integers of 8, 16 and 64 bits.
#include <array>
#include <cmath>
#include <limits>

#include "check/explain.hpp"
#include "check/fixture_functions.hpp"
#include "check/function.hpp"
#include "check/reproduction.hpp"
#include "support/changed_device.hpp"
#include "support/devices.hpp"

#include "support/test.hpp"

namespace gloam::check::own_numbers_test {

using shader::Scalar;

constexpr const char* file = "numbers.glsl";
constexpr std::size_t inputs_of_each = 1024;

constexpr std::array all_names{"double_sum",     "double_quotient", "double_vectors", "long_arithmetic",
                               "long_unsigned",  "byte_arithmetic", "byte_vectors",   "short_vectors",
                               "short_unsigned", "half_sum",        "half_vectors",   "numbers_changed",
                               "inside"};

// The answer to a device that changes the first output word.
Answer changed(const std::string& name, const std::function<void(std::span<Word>)>& change) {
    const auto device = std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), nullptr, change);
    return answer_of(Lab(options_of(file), device), file, name, {}, inputs_of_each);
}

struct Numbers {
    Float64 d;
    std::int64_t l;
    float f;
    glm::vec<2, std::uint8_t> b;
    Float16 h;
};

TEST(OwnNumbers, GoInAndOutOfAKernel) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<Float64(Float64, Float64)> sum(lab, file, "double_sum");
    EXPECT_EQ(sum(1.0, 0x1p-52), 1.0 + 0x1p-52);
    EXPECT_EQ(sum(1e300, -1e-300), 1e300);
    constexpr std::int64_t large = 0x1234'5678'9abc'def0;
    const Function<std::int64_t(std::int64_t, std::int64_t)> longs(lab, file, "long_arithmetic");
    EXPECT_EQ(longs(large, std::int64_t{-1}), -large + (large >> 3) - (-1 ^ ~large));
    const Function<std::int8_t(std::int8_t, std::int8_t)> bytes(lab, file, "byte_arithmetic");
    EXPECT_EQ(bytes(std::int8_t{100}, std::int8_t{-3}), std::int8_t(-300 + 2));
    const Function<std::uint16_t(std::uint16_t, std::uint16_t)> shorts(lab, file, "short_unsigned");
    EXPECT_EQ(shorts(std::uint16_t{50000}, std::uint16_t{3}), std::uint16_t(150000));
    const Function<Float16(Float16, Float16)> halves(lab, file, "half_sum");
    EXPECT_EQ(halves(2048.0F, 1.0F), 2048.0F) << "rounded to float16";
    const Function<Numbers(Numbers, std::array<Float64, 2>)> all(lab, file, "numbers_changed");
    const Numbers result = all(Numbers{0.1, large, 3.0F, {1, 250}, 0.5F}, std::array<Float64, 2>{7.0, 0.2});
    EXPECT_EQ(result.d, 0.1 + 0.2);
    EXPECT_EQ(result.l, large + 250);
    EXPECT_EQ(result.f, 3.0F);
    EXPECT_EQ(result.b, (glm::vec<2, std::uint8_t>(0, 250)));
    EXPECT_EQ(result.h, 1.0F);
    EXPECT_THAT(
        [&] { (void)Function<float(float, float)>(lab, file, "double_sum"); },
        testing::ThrowsMessage<std::invalid_argument>(HasSubstr("double double_sum(double a, double b)")));
}

TEST(OwnNumbers, AreJudgedInEveryVariant) {
    for (const shader::Variant& variant : shader::variants()) {
        const Lab lab(options_of(file, variant), test::SharedDevice::get());
        for (const char* name : all_names) {
            try {
                const Answer all = answer_of(lab, file, name, {}, inputs_of_each);
                EXPECT_EQ(all.outside(), 0U) << variant.name << " " << name << "\n" << all;
                EXPECT_GT(all.judged(), 0U) << variant.name << " " << name;
            } catch (const backend::Unsupported& error) {
                EXPECT_NE(variant.through, shader::Variant::Through::none) << error.what();
                EXPECT_THAT(error.what(),
                            HasSubstr("which the variant " + variant.name + " cannot translate"));
            }
        }
    }
}

TEST(OwnNumbers, WrongResultsAreFound) {
    const auto words = [](Scalar scalar, std::int64_t steps) {
        return [=](std::span<Word> row) {
            if (shader::is_float(scalar)) return step_float(scalar, steps, row);
            set_bits(scalar, bits_at(scalar, row) + static_cast<std::uint64_t>(steps), row);
        };
    };
    // A rounding is to either neighbour; a sum that is exact has one result.
    EXPECT_EQ(changed("double_sum", words(Scalar::double_, 0)).outside(), 0U);
    EXPECT_GT(changed("double_sum", words(Scalar::double_, 2)).outside(), 500U);
    EXPECT_LT(changed("double_quotient", words(Scalar::double_, 1)).outside(), 20U)
        << "2.5 ULP are permitted, but of 0 and infinity";
    EXPECT_GT(changed("double_quotient", words(Scalar::double_, 5)).outside(), 200U);
    EXPECT_GT(changed("half_sum", words(Scalar::float16_, 2)).outside(), 500U);
    const auto as_float = [](std::span<Word> row) {
        set_float(Scalar::double_, static_cast<float>(float_at(Scalar::double_, row)), row);
    };
    EXPECT_GT(changed("double_sum", as_float).outside(), 300U) << "no more than float32";
    EXPECT_GT(changed("long_arithmetic", words(Scalar::int64_, 1)).outside(), 1000U);
    EXPECT_GT(changed("long_arithmetic", words(Scalar::int64_, std::int64_t{1} << 62)).outside(), 1000U);
    EXPECT_GT(changed("long_unsigned", words(Scalar::uint64_, 1)).outside(), 500U);
    EXPECT_GT(changed("byte_arithmetic", words(Scalar::int8_, 1)).outside(), 1000U);
    EXPECT_GT(changed("byte_vectors", words(Scalar::uint8_, 128)).outside(), 1000U);
    EXPECT_GT(changed("short_vectors", words(Scalar::int16_, 1)).outside(), 1000U);
    EXPECT_GT(changed("short_unsigned", words(Scalar::uint16_, 1)).outside(), 1000U);
    for (const char* name : {"numbers_changed", "double_vectors", "half_vectors"}) {
        const auto last = [](std::span<Word> row) { row.back() ^= 0x00100000U; };
        EXPECT_GT(changed(name, last).outside(), 100U) << name;
    }
}

TEST(OwnNumbers, ADeviceWithoutThemSaysSo) {
    const auto devices = test::devices_at_hand();
    const auto found =
        std::ranges::find_if(devices, [](const auto& one) { return one.name.find("SwiftShader") == 0; });
    if (found == devices.end()) GTEST_SKIP() << "SwiftShader lacks them, and it is not here";
    LabOptions of_device = options_of(file);
    of_device.device = found->name;
    const Lab lab(of_device);
    const std::vector<std::pair<std::string, std::string>> features{{"double_sum", "shaderFloat64"},
                                                                    {"long_arithmetic", "shaderInt64"},
                                                                    {"half_sum", "shaderFloat16"},
                                                                    {"byte_arithmetic", "shaderInt8"}};
    for (const auto& [name, feature] : features)
        EXPECT_THAT([&] { (void)answer_of(lab, file, name, {}, inputs_of_each); },
                    testing::ThrowsMessage<backend::Unsupported>(AllOf(
                        HasSubstr(name + ": needs " + feature), HasSubstr("which device \"SwiftShader"))));
}

// The values that a parameter is given.
std::vector<Word> drawn(Scalar scalar, const Values& values) {
    const Domain::Inputs inputs = Domain({values}).draw(4000, 1);
    EXPECT_EQ(inputs.width, word_count(scalar));
    return inputs.words;
}

TEST(OwnNumbers, FloatsAreDrawnFromTheRangeOfTheirFormat) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    for (const auto& [name, scalar] :
         {std::pair{"double_sum", Scalar::double_}, {"half_sum", Scalar::float16_}}) {
        const Question question = question_of(lab, file, function_of(file, name), {});
        const std::vector<Word> words = drawn(scalar, question.domain.parameters().front());
        std::set<double> found;
        bool nan = false;
        std::size_t exact = 0;  // as float16
        for (std::size_t i = 0; i < words.size(); i += word_count(scalar)) {
            const double value = float_at(scalar, std::span(words).subspan(i));
            nan = nan || std::isnan(value);
            if (!std::isnan(value)) found.insert(value);
            if (numeric::float16.round_down(value) == value || std::isnan(value)) ++exact;
        }
        EXPECT_TRUE(nan) << name;
        for (const double special : numeric::special_values(format_of(scalar)))
            EXPECT_TRUE(std::isnan(special) || found.contains(special)) << name << " " << special;
        if (scalar == Scalar::float16_) {
            EXPECT_EQ(exact, words.size());
        }
        if (scalar == Scalar::double_) {
            EXPECT_TRUE(
                std::ranges::any_of(found, [](double x) { return x != static_cast<float>(x) && x < 1.0; }));
        }
    }
}

TEST(OwnNumbers, IntegersAreDrawnUpToTheirLimits) {
    const auto holds = [](Scalar scalar, std::int64_t least, std::uint64_t most) {
        const std::vector<Word> words = drawn(scalar, any_integer(scalar));
        std::set<std::uint64_t> found;
        for (std::size_t i = 0; i < words.size(); i += word_count(scalar))
            found.insert(bits_at(scalar, std::span(words).subspan(i)));
        const auto bits = [](std::uint64_t value, Scalar of) {
            return word_count(of) == 2 ? value : Word(value);
        };
        EXPECT_TRUE(found.contains(bits(static_cast<std::uint64_t>(least), scalar)));
        EXPECT_TRUE(found.contains(bits(most, scalar)));
        for (const std::uint64_t one : found) {
            const auto value = static_cast<std::int64_t>(
                word_count(scalar) == 2 ? one : std::uint64_t(std::int64_t(std::int32_t(one))));
            if (shader::bits_of(scalar) < 32) {
                EXPECT_TRUE(value >= least && value <= std::int64_t(most)) << value;
            }
        }
    };
    holds(Scalar::int8_, -128, 127);
    holds(Scalar::uint8_, 0, 255);
    holds(Scalar::int16_, -32768, 32767);
    holds(Scalar::uint16_, 0, 65535);
    holds(Scalar::int64_, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
    holds(Scalar::uint64_, 0, std::numeric_limits<std::uint64_t>::max());
}

TEST(OwnNumbers, FixedValuesAreOfTheType) {
    const Values doubles = uniform(0, 1, Scalar::double_);
    const Domain near({doubles.and_near({0.5}, Scalar::double_)});
    std::set<double> found;
    const std::vector<Word> words = near.draw(100, 1).words;
    for (std::size_t i = 0; i < words.size(); i += 2)
        found.insert(float_at(Scalar::double_, std::span(words).subspan(i)));
    EXPECT_TRUE(found.contains(0.5) && found.contains(0.5 + 0x1p-53) && found.contains(0.5 - 0x1p-54));
    EXPECT_THAT(
        [&] { (void)Domain({doubles.and_near({0.5})}); },
        testing::ThrowsMessage<std::invalid_argument>("a fixed value is of another type than those drawn"));
}

TEST(OwnNumbers, ARangeIsKept) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    const Question question = question_of(lab, file, function_of(file, "long_arithmetic"), {{"a", {-3, 5}}});
    const std::vector<Word> words = drawn(Scalar::int64_, question.domain.parameters().front());
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const auto value = static_cast<std::int64_t>(bits_at(Scalar::int64_, std::span(words).subspan(i)));
        EXPECT_TRUE(value >= -3 && value <= 5) << value;
    }
}

TEST(OwnNumbers, AreComparedInTheirOwnUlp) {
    const Lab lab = test::make_lab(FIXTURES);
    const Domain domain({uniform(0.5, 2.0, Scalar::double_)});
    const Budget budget{.ulp = 3};
    const auto exact = [](double x) { return 1.0 / x; };
    const Answer wrong = Function<Float64(Float64)>(lab, file, "double_reciprocal_wrong")
                             .compare(exact, domain, budget, {.inputs = 1024});
    EXPECT_GT(wrong.outside(), 500U);
    EXPECT_GT(wrong.max_ulp, 0x1p20) << "a float has 29 bits less";
    const Domain two({uniform(0.5, 2.0, Scalar::double_), uniform(0.5, 2.0, Scalar::double_)});
    const Answer right =
        Function<Float64(Float64, Float64)>(lab, file, "double_quotient")
            .compare([](double a, double b) { return a / b; }, two, budget, {.inputs = 1024});
    EXPECT_TRUE(right.passed()) << right;
    using Longs = Function<std::int64_t(std::int64_t, std::int64_t)>;
    const Domain longs({any_integer(Scalar::int64_), integers(1, 9, Scalar::int64_)});
    const auto reference = [](std::int64_t a, std::int64_t b) {
        const auto product = static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
        return static_cast<std::int64_t>(product + static_cast<std::uint64_t>(a >> 3) -
                                         static_cast<std::uint64_t>(b ^ ~a));
    };
    EXPECT_TRUE(Longs(lab, file, "long_arithmetic").compare(reference, longs).passed());
    const auto off_by_one = [&](std::int64_t a, std::int64_t b) { return reference(a, b) ^ 1; };
    EXPECT_GT(Longs(lab, file, "long_arithmetic").compare(off_by_one, longs).outside(), 60'000U);
}

TEST(OwnNumbers, AFailureIsShrunkAndToldInTheirText) {
    const auto second = [](std::span<Word> row) {
        set_bits(Scalar::int64_, bits_at(Scalar::int64_, row) + 1, row);
    };
    const auto device = std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), nullptr, second);
    const Lab lab(options_of(file), device);
    const Question question = question_of(lab, file, function_of(file, "long_arithmetic"), {});
    const RunOptions few{.inputs = 256};
    const Reproduction longs = reproduce(lab, question, few, run(lab, question, few).worst.value());
    EXPECT_EQ(longs.inputs, (std::vector<Word>{0, 0, 0, 0}));
    const Signature signature = function_of(file, "double_sum").signature();
    std::vector<Word> words;
    append_words(Float64(0.1), words);
    append_words(Float64(-2.0), words);
    EXPECT_EQ(describe_inputs(signature, words),
              "double 0.1 (0x3fb999999999999a), double -2 (0xc000000000000000)");
    EXPECT_EQ(text_at(Scalar::int64_, std::array<Word, 2>{0xfffffffeU, 0xffffffffU}), "-2");
    EXPECT_EQ(text_at(Scalar::uint64_, std::array<Word, 2>{1, 1}), "4294967297 (0x0000000100000001)");
}

TEST(OwnNumbers, AnExplanationHasTheirDigits) {
    const OwnFunction own = function_of(file, "half_sum");
    const KernelSource source{.file = file, .function = own.function, .images = {}, .text = own.excerpt};
    const std::array words{to_word(2048.0F), to_word(1.0F)};
    const Explanation all = explain({.variant = shader::variant("strict")}, source, words);
    ASSERT_EQ(all.steps.size(), 1U);
    EXPECT_EQ(all.steps[0].value, 2048.0);
    EXPECT_EQ(all.steps[0].exact, 2049.0);
    EXPECT_EQ(all.steps[0].ulps, 0.5) << "of float16";
    EXPECT_EQ(all.steps[0].permitted, (numeric::Bounds{2048.0, 2050.0, false}));
}

}  // namespace gloam::check::own_numbers_test

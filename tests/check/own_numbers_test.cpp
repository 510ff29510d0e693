// SPDX-License-Identifier: MIT
// Functions of float16, and of numbers that are not judged.
#include <array>
#include <cmath>

#include "check/explain.hpp"
#include "check/fixture_functions.hpp"
#include "check/function.hpp"
#include "support/changed_device.hpp"
#include "support/devices.hpp"

#include "support/test.hpp"

namespace gloam::check::own_numbers_test {

using shader::Scalar;

constexpr const char* file = "numbers.glsl";
constexpr std::size_t inputs_of_each = 1024;

// The answer to a device that changes the first output word.
Answer changed(const std::string& name, const std::function<void(std::span<Word>)>& change) {
    const auto device = std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), nullptr, change);
    return answer_of(Lab(options_of(file), device), file, name, {}, inputs_of_each);
}

struct Halves {
    glm::vec<2, Float16> h;
    float f;
};

TEST(OwnNumbers, GoInAndOutOfAKernel) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<Float16(Float16, Float16)> halves(lab, file, "half_sum");
    EXPECT_EQ(halves(2048.0F, 1.0F), 2048.0F) << "rounded to float16";
    const Function<Halves(Halves, std::array<Float16, 2>)> all(lab, file, "halves_changed");
    const Halves result = all(Halves{{0.5F, 3.0F}, 0.25F}, std::array<Float16, 2>{7.0F, 1.5F});
    EXPECT_EQ(result.h.x, 0.75F);
    EXPECT_EQ(result.h.y, 4.5F);
    EXPECT_EQ(result.f, 7.25F);
    EXPECT_THAT([&] { (void)Function<float(float, float)>(lab, file, "half_sum"); },
                testing::ThrowsMessage<std::invalid_argument>(
                    HasSubstr("float16_t half_sum(float16_t a, float16_t b)")));
}

TEST(OwnNumbers, AFunctionOfOthersSaysSo) {
    const Lab lab = test::make_lab(FIXTURES);
    EXPECT_THAT(
        [&] { (void)Function<float(float)>(lab, file, "double_inside"); },
        testing::ThrowsMessage<backend::Unsupported>(HasSubstr("double is not judged: gloam judges float")));
}

TEST(OwnNumbers, WrongResultsAreFound) {
    const auto moved = [](std::int64_t steps) {
        return [=](std::span<Word> row) { row[0] = stepped_float(Scalar::float16_, row[0], steps); };
    };
    // A rounding is to either neighbour.
    EXPECT_EQ(changed("half_sum", moved(0)).outside(), 0U);
    EXPECT_GT(changed("half_sum", moved(2)).outside(), 500U);
    for (const char* name : {"halves_changed", "half_vectors"}) {
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
    EXPECT_THAT([&] { (void)answer_of(lab, file, "half_sum", {}, inputs_of_each); },
                testing::ThrowsMessage<backend::Unsupported>(
                    AllOf(HasSubstr("half_sum: needs shaderFloat16, which device \"SwiftShader"))));
}

TEST(OwnNumbers, AreDrawnFromTheRangeOfTheirFormat) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    const Question question = question_of(lab, file, function_of(file, "half_sum"), {});
    const Domain::Inputs inputs = Domain({question.domain.parameters().front()}).draw(4000, 1);
    std::set<double> found;
    bool nan = false;
    for (const Word word : inputs.words) {
        const auto value = from_word<double>(word);
        nan = nan || std::isnan(value);
        if (std::isnan(value)) continue;
        found.insert(value);
        EXPECT_EQ(numeric::float16.round_down(value), value);
    }
    EXPECT_TRUE(nan);
    for (const double special : numeric::special_values(numeric::float16))
        EXPECT_TRUE(std::isnan(special) || found.contains(special)) << special;
}

TEST(OwnNumbers, FixedValuesAreOfTheType) {
    const Values halves = uniform(0, 1, Scalar::float16_).and_near({0.5}, Scalar::float16_);
    std::set<double> found;
    for (const Word word : Domain({halves}).draw(100, 1).words) found.insert(from_word<double>(word));
    EXPECT_TRUE(found.contains(0.5) && found.contains(0.5 + 0x1p-11) && found.contains(0.5 - 0x1p-12));
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

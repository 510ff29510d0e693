// SPDX-License-Identifier: MIT
// Functions that load and store images: each input has its own, whose pixels are inputs and outputs.
#include "check/explain.hpp"
#include "check/fixture_functions.hpp"
#include "interpreter/program.hpp"
#include "support/changed_device.hpp"

#include "support/test.hpp"

namespace gloam::check::own_images_test {

constexpr const char* file = "own_images.glsl";
constexpr std::size_t width = image_sides[0];
constexpr std::size_t height = image_sides[1];

const Ranges pixels{{"p", {0, 3}}};

TEST(OwnImages, ArePixelsOfTheInput) {
    const OwnFunction blurred = function_of(file, "blurred");
    ASSERT_EQ(blurred.function.parameters.size(), 2U);
    const shader::Parameter& picture = blurred.function.parameters[1];
    EXPECT_EQ(to_glsl(picture.type) + " " + picture.name, "vec4[4][5] picture");
    EXPECT_EQ(picture.direction, shader::Direction::inout);
    EXPECT_EQ(blurred.signature().output_words(), width * height * 4);
    const OwnFunction of_heights = function_of(file, "height");
    EXPECT_EQ(of_heights.function.parameters[1].direction, shader::Direction::in);
    EXPECT_EQ(to_glsl(of_heights.function.parameters[1].type), "float[4][5]");
    EXPECT_EQ(function_of(file, "loaded").function.parameters[1].direction, shader::Direction::in)
        << "nothing stores";
    EXPECT_EQ(to_glsl(function_of(file, "counted").function.parameters[2].type), "uint[4][5]");
}

TEST(OwnImages, MayBeMoreThanAnImageHasLayers) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    EXPECT_TRUE(answer_of(lab, file, "size_of", {}, 64).passed());
    EXPECT_TRUE(answer_of(lab, file, "height", pixels, 5000).passed());
}

TEST(OwnImages, APixelOutsideIsTheInputsFault) {
    const Lab lab(options_of(file), test::SharedDevice::get());
    EXPECT_THROW((void)answer_of(lab, file, "loaded", {{"p", {0, 7}}, {"picture", {0, 1}}}, 512),
                 interpreter::Error)
        << "all inputs are in ranges that were given";
    const Answer any = answer_of(lab, file, "loaded", {}, 512);
    EXPECT_GT(any.undefined, 0U);
    EXPECT_EQ(any.outside(), 0U) << any;
}

// What the device returns for a pixel that the function does not touch, and for one that it stores.
TEST(OwnImages, AWrongPixelIsNoticed) {
    const auto outside = [](const char* name, test::ChangedDevice::After after) {
        const Lab lab(options_of(file),
                      std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), nullptr, after));
        return answer_of(lab, file, name, pixels, 128).outside();
    };
    EXPECT_EQ(outside("blurred", [](std::span<Word> row) { row[width * height * 4 - 1] ^= 0x100U; }), 128U);
    EXPECT_EQ(
        outside("filled", [](std::span<Word> row) { std::ranges::swap_ranges(row.first(4), row.last(4)); }),
        128U);
    EXPECT_EQ(outside("counted", [](std::span<Word> row) { ++row[1]; }), 128U);
    EXPECT_EQ(outside("pair", [](std::span<Word> row) { row[2] = to_word(3.5F); }), 128U)
        << "a format of two channels";
    EXPECT_EQ(outside("counted", [](std::span<Word>) {}), 0U);
}

TEST(OwnImages, AnExplanationHasThePixels) {
    const OwnFunction own = function_of(file, "blurred");
    const KernelSource source{
        .file = file, .function = own.function, .images = own.images, .text = own.excerpt};
    std::vector<Word> input(2 + width * height * 4, to_word(1.0F));
    input[0] = input[1] = 2;  // the pixel
    const Explanation all = explain({}, source, input, {});
    const auto is_sum = [](const auto& step) { return step.operation == "OpFAdd" && step.value == 3.0F; };
    const auto sum = std::ranges::find_if(all.steps, is_sum);
    ASSERT_NE(sum, all.steps.end());
    EXPECT_EQ(sum->line, 19U);
}

}  // namespace gloam::check::own_images_test

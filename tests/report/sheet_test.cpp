// SPDX-License-Identifier: MIT
#include "report/sheet.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace gloam::report {
namespace sheet_test {

constexpr std::uint32_t width = 260;
constexpr std::uint32_t height = 40;

SheetPicture grey(const std::string& caption) {
    return {.rgb = std::vector<std::uint8_t>(3 * width * height, 128), .caption = caption};
}

// Big-endian, as PNG has it.
std::uint32_t word_at(const std::string& png, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word = word << 8U | static_cast<unsigned char>(png[at + i]);
    return word;
}

TEST(Sheet, HoldsItsPicturesInRows) {
    const std::vector<SheetPicture> three{grey("a"), grey("b"), grey("c")};
    const std::string png = to_sheet_png(three, width, height, 2);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(word_at(png, 16), 2 * width + 3 * 6);  // a gap of half a line of 13 pixels
    EXPECT_EQ(word_at(png, 20), 2 * (height + 13 + 2 * 6) + 6);
    EXPECT_EQ(word_at(to_sheet_png(three, width, height, 9), 16), 3 * width + 4 * 6);  // no empty columns
}

TEST(Sheet, CaptionsAreDrawnAndCutAtThePicturesWidth) {
    const auto png = [](const std::string& caption) {
        return to_sheet_png(std::vector{grey(caption)}, width, height, 1);
    };
    EXPECT_NE(png("gtao"), png(""));
    EXPECT_NE(png("gtao"), png("hbao"));
    EXPECT_EQ(png(std::string(500, 'x')), png(std::string(600, 'x')));
    EXPECT_NO_THROW((void)png("\xff\x01\x80"));
}

TEST(Sheet, RefusesWhatDoesNotFit) {
    EXPECT_THROW((void)to_sheet_png({}, width, height, 1), std::invalid_argument);
    EXPECT_THROW((void)to_sheet_png(std::vector{grey("")}, width, height, 0), std::invalid_argument);
    EXPECT_THROW((void)to_sheet_png(std::vector{grey("")}, width + 1, height, 1), std::invalid_argument);
}

}  // namespace sheet_test
}  // namespace gloam::report

// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/files.hpp"

namespace gloam::report {
namespace plot_test {

using testing::HasSubstr;

TEST(Plot, IsAnSvgThatNamesItsCurves) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = to_svg({.title = "it's a title",
                                    .x = "frame",
                                    .y = "error",
                                    .curves = {{"first", {{1, 2}, {2, gap}, {3, 1}}}, {"second", {{1, 1}}}}});
    for (const char* text : {"<svg", "it's a title", "frame", "error", "first", "second"})
        EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Plot, DrawsFrontsWithTheirLabelsAndPng) {
    const Plot plot{.title = "front",
                    .x = "time",
                    .y = "error",
                    .logarithmic = true,
                    .curves = {{"all", {{1, 4}, {2, 3}, {3, 3}}, CurveStyle::background},
                               {"some", {{2, 3}}, CurveStyle::points},
                               {"best", {{1, 4}, {2, 3}}, CurveStyle::steps, {"first/4", "second/8"}}}};
    const std::string svg = to_svg(plot);
    for (const char* text : {"all", "some", "best", "first/4", "second/8"}) EXPECT_THAT(svg, HasSubstr(text));
    EXPECT_THAT(to_png(plot), testing::StartsWith("\x89PNG"));
}

// Foreign texts, in every place that a text has, never reach gnuplot as its language. (They once did: a line
// break ended the title.)
TEST(Plot, TextsAreNeverObeyed) {
    const test::TemporaryDirectory scratch;
    const std::string proof = (scratch.path() / "proof").string();
    const std::vector<std::string> hostile = {"a\nsystem('touch " + proof + "')\n",
                                              "a'\nsystem('touch " + proof + "')\n#",
                                              "`touch " + proof + "`",
                                              "\"; system('touch " + proof + "'); #",
                                              "$(touch " + proof + ")",
                                              "END\nsystem('touch " + proof + "')\n",
                                              "@x\\\n! touch " + proof + "\n",
                                              std::string("a\0b", 3)};
    for (const std::string& text : hostile) {
        for (const bool logarithmic : {false, true}) {
            const Plot plot{.title = text,
                            .x = text,
                            .y = text,
                            .logarithmic = logarithmic,
                            .curves = {{text, {{1, 4}, {2, 3}}, CurveStyle::steps, {text, text}}}};
            EXPECT_THAT(to_svg(plot), HasSubstr("<svg")) << text;
            EXPECT_FALSE(std::filesystem::exists(proof)) << text;
        }
    }
}

// A text is shown literally, with any characters.
TEST(Plot, TextsAreShownAsTheyAre) {
    const std::string text = "7/4 \"x\" \\ 'y' `z` $w @v 100% {a}_b^c";
    const std::string svg = to_svg({.title = text, .curves = {{"c", {{1, 1}, {2, 3}}}}});
    EXPECT_THAT(svg, HasSubstr("7/4 \"x\" \\ 'y' `z` $w @v 100% {a}_b^c"));
}

// No shell is used: environment variables do not become part of a command.
TEST(Plot, TheFolderForTemporaryFilesIsNoCommand) {
    const test::TemporaryDirectory scratch;
    const std::string folder = (scratch.path() / "it's; a $(folder)").string();
    std::filesystem::create_directory(folder);
    ::setenv("TMPDIR", folder.c_str(), 1);
    EXPECT_THAT(to_svg({.title = "t", .curves = {{"c", {{1, 1}, {2, 2}}}}}), HasSubstr("<svg"));
    ::unsetenv("TMPDIR");
}

TEST(Plot, LabelsOfAnotherNumberAreAnError) {
    EXPECT_THAT(
        [] { (void)to_svg({.title = "t", .curves = {{"c", {{1, 1}, {2, 2}}, CurveStyle::steps, {"one"}}}}); },
        testing::ThrowsMessage<std::invalid_argument>(HasSubstr("1 labels, expected 2")));
}

TEST(Plot, WithoutAPointIsAnError) {
    EXPECT_THAT([] { (void)to_svg({.title = "empty", .curves = {{"none", {}}}}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("\"empty\"")));
}

}  // namespace plot_test
}  // namespace gloam::report

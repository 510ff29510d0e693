// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/internal/plot_layout.hpp"
#include "report/plot.hpp"
#include "support/files.hpp"
#include "support/matchers.hpp"

namespace gloam::report::plot_test {

using namespace internal;  // the layout of labels

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
    EXPECT_THAT(to_png(plot), StartsWith("\x89PNG"));
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
        ThrowsMessage<std::invalid_argument>(HasSubstr("1 labels, expected 2")));
}

TEST(Plot, WithoutAPointIsAnError) {
    EXPECT_THAT([] { (void)to_svg({.title = "empty", .curves = {{"none", {}}}}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("\"empty\"")));
}

TEST(PlotLayout, RangesHoldWhatIsShown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const LogRange range = range_around({20.0, nan, 0.0, -1.0, 80.0});
    EXPECT_GT(range.low, 15.0);
    EXPECT_LT(range.low, 20.0);
    EXPECT_GT(range.high, 80.0);
    EXPECT_LT(range.high, 100.0);
    EXPECT_DOUBLE_EQ(range.at(range.low), 0.0);
    EXPECT_DOUBLE_EQ(range.at(range.high), 1.0);
    const LogRange one = range_around({3.0});
    EXPECT_LT(one.low, 3.0);
    EXPECT_GT(one.high, 3.0);
    EXPECT_LT(range_around({}).low, range_around({}).high);
}

TEST(PlotLayout, TicsAreRoundAndWithinTheRange) {
    EXPECT_THAT(tics_of({3.0, 300.0}),
                testing::Pointwise(testing::DoubleEq(), {5.0, 10.0, 20.0, 50.0, 100.0, 200.0}));
    EXPECT_THAT(tics_of({0.07, 0.16}),
                testing::Pointwise(testing::DoubleNear(1e-12), {0.08, 0.1, 0.12, 0.15}));
}

// Twenty points that nearly coincide: every label can still be read.
TEST(PlotLayout, LabelsDoNotCoverEachOther) {
    Plot plot{.title = "crowd", .logarithmic = true};
    plot.curves.push_back({.name = "points"});
    for (int i = 0; i < 20; ++i) {
        plot.curves[0].points.emplace_back(10.0 + 0.1 * i, 0.1 + 0.0001 * i);
        plot.curves[0].labels.push_back("method/" + std::to_string(i));
    }
    plot.curves[0].points.emplace_back(1000.0, 1.0);
    plot.curves[0].labels.emplace_back("corner");
    const auto labels = placed_labels(plot, {5.0, 1010.0}, {0.05, 1.01});
    ASSERT_EQ(labels.size(), 21U);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool same_line = std::abs(labels[i].at.second - labels[j].at.second) < 0.03;
            const bool beside = std::abs(labels[i].at.first - labels[j].at.first) > 0.06;
            EXPECT_TRUE(!same_line || beside) << labels[i].text << ' ' << labels[j].text;
        }
    }
    EXPECT_LT(labels.back().at.first, labels.back().point.first - 0.05) << "it would reach beyond the plot";
}

}  // namespace gloam::report::plot_test

// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

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

TEST(Plot, LabelsOfAnotherNumberAreAnError) {
    EXPECT_THAT(
        [] {
            (void)to_svg({.title = "t", .curves = {{"c", {{1, 1}, {2, 2}}, CurveStyle::steps, {"one"}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(HasSubstr("1 labels, expected 2")));
}

TEST(Plot, WithoutAPointIsAnError) {
    EXPECT_THAT(
        [] {
            (void)to_svg({.title = "empty", .curves = {{"none", {}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(HasSubstr("\"empty\"")));
}

}  // namespace plot_test
}  // namespace gloam::report

// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace gloam::report {
namespace {

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

TEST(Plot, WithoutAPointIsAnError) {
    EXPECT_THAT(
        [] {
            (void)to_svg({.title = "empty", .curves = {{"none", {}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(HasSubstr("\"empty\"")));
}

}  // namespace
}  // namespace gloam::report

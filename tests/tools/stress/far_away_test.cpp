// SPDX-License-Identifier: MIT
#include "stress/far_away.hpp"

#include "stress/reprojected.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::far_away_test {

TEST(FarAway, NothingCentredOnTheCameraChanges) {
    const Bench bench;
    const Rows rows = far_away(bench.context());
    expect_all_passed(rows);
    // World coordinates do break, sooner for finer limits: the comparison means something.
    const double tenth = row_of(rows, "off by 0.1 pixel from", "static").measured;
    const double whole = row_of(rows, "off by 1 pixel from", "static").measured;
    EXPECT_GT(tenth, 10.0);
    EXPECT_GT(whole, tenth);
    EXPECT_LT(whole, 1e7);
    EXPECT_LT(row_of(rows, "rejected by TSSAO-8 (0.01) from").measured, 1e8);
}

TEST(FarAway, ShiftsAreExact) {
    const MovedPoints origin = points_at_origin(100, 2);
    for (const double distance : {1e3, 1e6, 1e8}) {
        const MovedPoints far = moved(origin, distance);
        EXPECT_NEAR(glm::length(far.shift), distance, 2.0);
        EXPECT_EQ(far.now.eye - far.shift, origin.now.eye);
        for (std::size_t i = 0; i < origin.points.size(); ++i)
            ASSERT_EQ(far.points[i] - far.shift, origin.points[i]);
    }
}

// What is compared to the bit depends on where the camera was.
TEST(FarAway, AnotherPreviousEyeIsNoticed) {
    const Bench bench;
    const CenteredForm form(bench.lab());
    MovedPoints all = points_at_origin(16, 2);
    const CenteredResults results = form.run(all);
    EXPECT_LT(CenteredForm::pixels(all, results), 0.01);
    all.before.eye.x += 1.0 / 1024.0;
    EXPECT_NE(form.run(all).words(), results.words());
    EXPECT_GT(CenteredForm::pixels(all, results), 0.01);
}

TEST(FarAway, PixelsBetweenClipPoints) {
    EXPECT_DOUBLE_EQ(pixels_between({1, 0, 0, 2}, {0, 0, 0, 1}), 0.25 * image_width);
    EXPECT_DOUBLE_EQ(pixels_between({0, -1, 0, 2}, {0, 0, 0, 5}), 0.25 * image_height);
    EXPECT_TRUE(std::isinf(pixels_between({0, 0, 0, -1}, {0, 0, 0, 1})));
}

}  // namespace gloam::stress::test::far_away_test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "effect/internal/progress.hpp"

namespace gloam::effect {
namespace {

TEST(Progress, TheHistoryLagsUntilTheFirstFrameOfTheNextView) {
    Progress progress;
    EXPECT_FALSE(progress.has_view());
    progress.begin();
    EXPECT_TRUE(progress.has_view());
    EXPECT_FALSE(progress.history_lags());
    progress.count_frame();
    progress.advance();
    EXPECT_TRUE(progress.history_lags());
    progress.count_frame();
    EXPECT_FALSE(progress.history_lags());
}

TEST(Progress, SettlesAfterTwoFramesOfAView) {
    Progress progress;
    progress.begin();
    EXPECT_TRUE(progress.first_of_view());
    progress.count_frame();
    EXPECT_FALSE(progress.first_of_view());
    EXPECT_FALSE(progress.settled());
    progress.count_frame();
    EXPECT_TRUE(progress.settled());
    progress.advance();
    EXPECT_FALSE(progress.settled());
    EXPECT_TRUE(progress.first_of_view());
}

}  // namespace
}  // namespace gloam::effect

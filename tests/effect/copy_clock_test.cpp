// SPDX-License-Identifier: MIT
#include "effect/study/copy_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace gloam::effect {
namespace copy_clock_test {

TEST(CopyClock, TimesACopy) {
    const gpu::Device device({.validation = gpu::Validation::on});
    const scene::PassLibrary passes(GLOAM_GLSL_DIR);
    CopyClock small(device, passes, {16, 16});
    CopyClock large(device, passes, {1024, 1024});
    const double time = small.measure();
    EXPECT_GT(time, 0.0);
    EXPECT_GT(large.measure(), time);  // 4096 times as many pixels
    EXPECT_TRUE(device.info().timestamp_period_ns > 0.0);
}

TEST(CopyClock, WithoutTimestampsIsAnErrorThatNamesTheDevice) {
    EXPECT_THAT([] { require_timestamps({.name = "sundial", .timestamp_period_ns = 0.0}); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::AllOf(testing::HasSubstr("sundial"), testing::HasSubstr("no timestamps"))));
    EXPECT_NO_THROW(require_timestamps({.timestamp_period_ns = 1.0}));
}

}  // namespace copy_clock_test
}  // namespace gloam::effect

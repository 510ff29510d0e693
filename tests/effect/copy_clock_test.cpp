// SPDX-License-Identifier: MIT
#include "effect/study/copy_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "effect/study/configuration_study.hpp"

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

TEST(ConfigurationStudy, TemporalRunsAreVisitedAsOftenAsFramesAreScored) {
    for (int round = 0; round < 20; ++round) {
        EXPECT_TRUE(ConfigurationStudy::due(false, round, 8));
        EXPECT_EQ(ConfigurationStudy::due(true, round, 8), round == 0 || round == 8 || round == 16);
    }
}

TEST(ConfigurationStudy, SettingsHoldTheSamplesAskedFor) {
    const Settings single = measured_settings("gtao", 16, false);
    EXPECT_EQ(single.method, "gtao");
    EXPECT_EQ(single.samples, 16U);
    EXPECT_EQ(single.samples_converged, 16U);
    const Settings temporal = measured_settings("hemisphere", 512, true);
    EXPECT_EQ(temporal.samples, 512U);
    EXPECT_GE(temporal.weight_max, 1024.0F);
    EXPECT_THROW((void)measured_settings("magic", 16, false), std::invalid_argument);
}

}  // namespace copy_clock_test
}  // namespace gloam::effect

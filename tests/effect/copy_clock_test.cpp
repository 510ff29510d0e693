// SPDX-License-Identifier: MIT
#include "effect/study/copy_clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "backend/vulkan/commands.hpp"

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

// Of a size that is no multiple of the groups.
TEST(CopyClock, TheShaderCopiesEveryPixel) {
    const gpu::Device device({.validation = gpu::Validation::on});
    const scene::PassLibrary passes(GLOAM_GLSL_DIR);
    const glm::ivec2 size(13, 21);
    const gpu::Extent extent{13, 21};
    using enum gpu::Format;
    for (const gpu::Format format : {r32f, rgba32f, rgba16f, rgba16ui}) {
        const gpu::ComputePipeline copy = copy_pipeline(device, passes, format);
        gpu::Image from(device, extent, format);
        gpu::Image to(device, extent, format);
        std::vector<float> texels(static_cast<std::size_t>(gpu::channels(format)) * extent.width *
                                  extent.height);
        to.upload(std::vector<float>(texels.size(), 0.0F));
        std::iota(texels.begin(), texels.end(), 1.0F);
        from.upload(texels);
        gpu::Commands commands(device);
        commands.dispatch(copy, std::vector<gpu::Resource>{std::cref(from), std::cref(to)}, {2, 3, 1},
                          std::as_bytes(std::span(&size, 1)));
        commands.submit();
        EXPECT_EQ(to.download(), texels) << static_cast<int>(format);
    }
}

TEST(CopyClock, WithoutTimestampsIsAnErrorThatNamesTheDevice) {
    EXPECT_THAT([] { require_timestamps({.name = "sundial", .timestamp_period_ns = 0.0}); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::AllOf(testing::HasSubstr("sundial"), testing::HasSubstr("no timestamps"))));
    EXPECT_NO_THROW(require_timestamps({.timestamp_period_ns = 1.0}));
}

}  // namespace copy_clock_test
}  // namespace gloam::effect

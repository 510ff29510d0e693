// SPDX-License-Identifier: MIT
#include "gpu/image.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "gpu/gpu_test.hpp"
#include "gpu/internal/half.hpp"
#include "shaders/image_comp.h"

namespace gloam::gpu::test {
namespace image_test {

// Every texel and channel different, and exact in binary16 too: halves count up to the largest finite one.
// Depth images hold values from 0 to 1 only.
std::vector<float> distinct_texels(Extent extent, Format format) {
    const auto channels_of_format = static_cast<std::size_t>(channels(format));
    std::vector<float> texels(std::size_t{extent.width} * extent.height * channels_of_format);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        switch (format) {
            case Format::r8:
                texels[i] = static_cast<float>(i % 256) / 255.0F;
                break;
            case Format::r16f:
            case Format::rgba16f:
                texels[i] = from_half(static_cast<std::uint16_t>(i % 0x7c00));
                break;
            case Format::rgba16ui:
                texels[i] = static_cast<float>(i % 0x10000);
                break;
            default:
                texels[i] = static_cast<float>(i) / static_cast<float>(texels.size());
        }
    }
    return texels;
}

class RoundTripTest : public GpuTest, public ::testing::WithParamInterface<std::tuple<Format, Extent>> {};

TEST_P(RoundTripTest, ComesBackAsItWas) {
    const auto [format, extent] = GetParam();
    Image image(device(), extent, format);
    EXPECT_EQ(image.extent(), extent);
    EXPECT_EQ(image.format(), format);
    auto texels = distinct_texels(extent, format);
    for (int pass = 0; pass < 2; ++pass) {
        image.upload(texels);
        ASSERT_EQ(image.download(), texels);
        std::ranges::reverse(texels);
    }
}

std::string case_name(const ::testing::TestParamInfo<RoundTripTest::ParamType>& info) {
    const auto [format, extent] = info.param;
    constexpr std::array names{"r32f", "rgba32f", "rgba16f", "rgba16ui", "depth32f", "r16f", "r8", "r32ui"};
    return names[static_cast<std::size_t>(format)] + ("_" + std::to_string(extent.width)) + "x" +
           std::to_string(extent.height);
}

constexpr Extent large{1500, 2000};  // as rgba32f more than is staged at once

INSTANTIATE_TEST_SUITE_P(Formats, RoundTripTest,
                         ::testing::Combine(::testing::Values(Format::r32f, Format::rgba32f, Format::rgba16f,
                                                              Format::rgba16ui, Format::depth32f,
                                                              Format::r16f, Format::r8, Format::r32ui),
                                            ::testing::Values(Extent{1, 1}, Extent{3, 5}, Extent{257, 129})),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Bands, RoundTripTest,
                         ::testing::Combine(::testing::Values(Format::rgba32f), ::testing::Values(large)),
                         case_name);

using ImageTest = GpuTest;

TEST_F(ImageTest, FloatsKeepTheirBits) {
    Image image(device(), {4, 2}, Format::r32f);
    const std::vector<float> texels{0.0f,
                                    -0.0f,
                                    std::numeric_limits<float>::denorm_min(),
                                    std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::infinity(),
                                    -std::numeric_limits<float>::infinity(),
                                    std::numeric_limits<float>::quiet_NaN(),
                                    1.0f / 3.0f};
    image.upload(texels);
    const auto back = image.download();
    for (std::size_t i = 0; i < texels.size(); ++i) {
        EXPECT_EQ(std::bit_cast<std::uint32_t>(back[i]), std::bit_cast<std::uint32_t>(texels[i]))
            << texels[i];
    }
}

TEST_F(ImageTest, HalvesAreRoundedToNearest) {
    Image image(device(), {1, 2}, Format::rgba16f);
    image.upload(std::vector{1.0f + 0x1p-11f, 1.0f + 3 * 0x1p-11f, 65519.0f, 65520.0f,  //
                             0x1p-25f, 3 * 0x1p-25f, -0.0f, -1e10f});
    const auto infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(image.download(), (std::vector{1.0f, 1.0f + 0x1p-9f, 65504.0f, infinity,  //
                                             0.0f, 0x1p-23f, -0.0f, -infinity}));
}

// Row 0 is the row with y = 0 in the shader, and uploads, dispatches and downloads see each other's writes.
TEST_F(ImageTest, ShadersSeeTheSamePixels) {
    constexpr Extent extent{13, 9};
    const ComputePipeline pipeline(
        device(),
        {.spirv = image_comp,
         .bindings = {BindingKind::storage_image, BindingKind::storage_image, BindingKind::storage_buffer}});
    Image from(device(), extent, Format::r32f);
    Image to(device(), extent, Format::rgba32f);
    Buffer buffer(device(), std::size_t{extent.width} * extent.height * 16);
    const auto texels = distinct_texels(extent, Format::r32f);
    from.upload(texels);
    run(device(), pipeline, {from, to, buffer}, {2, 2, 1});
    std::vector<float> expected;
    for (std::uint32_t i = 0; i < extent.width * extent.height; ++i) {
        expected.insert(expected.end(), {texels[i], static_cast<float>(i % extent.width),
                                         static_cast<float>(i / extent.width), 1.0f});
    }
    EXPECT_EQ(to.download(), expected);
    const auto copied = buffer.as<float>();
    EXPECT_EQ(std::vector(copied.begin(), copied.end()), expected);
}

TEST_F(ImageTest, MovesWithItsContent) {
    Image first(device(), {1, 1}, Format::r32f);
    first.upload(std::vector{5.0f});
    Image second(std::move(first));
    Image third(device(), {2, 2}, Format::rgba16f);
    third = std::move(second);
    EXPECT_EQ(third.extent(), (Extent{1, 1}));
    EXPECT_EQ(third.download(), std::vector{5.0f});
}

TEST_F(ImageTest, SizesThatCannotBe) {
    const auto most = device().info().max_image_size;
    for (const Extent extent : {Extent{0, 4}, Extent{4, 0}, Extent{most + 1, 1}, Extent{1, most + 1}}) {
        const auto size = std::to_string(extent.width) + "x" + std::to_string(extent.height);
        expect_error<std::runtime_error>([&] { Image(device(), extent, Format::rgba16f); },
                                         {size.c_str(), "rgba16f", std::to_string(most).c_str()});
    }
}

TEST_F(ImageTest, UploadWantsEveryTexel) {
    Image image(device(), {3, 2}, Format::rgba32f);
    for (const std::size_t count : {0u, 23u, 25u, 6u}) {
        expect_error<std::invalid_argument>([&] { image.upload(std::vector<float>(count)); },
                                            {std::to_string(count).c_str(), "3x2 rgba32f", "24"});
    }
}

TEST(Formats, HaveChannels) {
    EXPECT_EQ(channels(Format::r32f), 1);
    EXPECT_EQ(channels(Format::depth32f), 1);
    EXPECT_EQ(channels(Format::rgba32f), 4);
    EXPECT_EQ(channels(Format::rgba16f), 4);
}

}  // namespace image_test
}  // namespace gloam::gpu::test

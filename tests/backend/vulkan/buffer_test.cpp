// SPDX-License-Identifier: MIT
#include "backend/vulkan/gpu_test.hpp"
#include "backend/vulkan/resources.hpp"
#include "base/half.hpp"

namespace gloam::backend::vulkan::test::buffer_test {

using BufferTest = GpuTest;

TEST_F(BufferTest, SizesThatCannotBe) {
    const auto most = std::to_string(device().info().max_buffer_bytes);
    expect_error<std::runtime_error>([&] { Buffer(device(), 0); }, {"buffer of 0 bytes", most.c_str()});
    const auto too_much = static_cast<std::size_t>(device().info().max_buffer_bytes) + 1;
    expect_error<std::runtime_error>([&] { Buffer(device(), too_much); },
                                     {std::to_string(too_much).c_str(), most.c_str()});
}

// In the order of Format.
constexpr std::array format_names{"r32f",  "rgba32f", "rgba16f", "rgba16ui", "r16f",   "r8",     "r32ui",
                                  "rg32f", "rg16f",   "rgba8",   "r16ui",    "rg16ui", "rg32ui", "rgba32ui"};

// Every texel and channel different, and exact in binary16 too: halves count up to the largest finite one.
// Depth images hold values from 0 to 1 only.
std::vector<float> distinct_texels(Extent extent, Format format) {
    const auto channels_of_format = static_cast<std::size_t>(channels(format));
    std::vector<float> texels(std::size_t{extent.width} * extent.height * channels_of_format);
    const std::string_view name = format_names.at(static_cast<std::size_t>(format));
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (name.ends_with('8')) {
            texels[i] = static_cast<float>(i % 256) / 255.0F;
        } else if (name.ends_with("16f")) {
            texels[i] = base::from_half(static_cast<std::uint16_t>(i % 0x7c00));
        } else if (name.ends_with("16ui")) {
            texels[i] = std::bit_cast<float>(static_cast<std::uint32_t>(i % 0x10000));
        } else {
            texels[i] = static_cast<float>(i) / static_cast<float>(texels.size());
        }
    }
    return texels;
}

TEST(Formats, HaveTheirNamesOfGlsl) {
    for (std::size_t f = 0; f < format_names.size(); ++f)
        EXPECT_EQ(format_from(format_names.at(f)), static_cast<Format>(f));
    EXPECT_EQ(format_from("rgb9e5"), std::nullopt);
}

using ImageTest = GpuTest;

TEST_F(ImageTest, ComesBackAsItWas) {
    const auto expect_back = [this](Format format, Extent extent) {
        Image image(device(), extent, format);
        auto texels = distinct_texels(extent, format);
        for (int pass = 0; pass < 2; ++pass) {
            image.upload(texels);
            ASSERT_EQ(image.download(), texels) << format_names.at(static_cast<std::size_t>(format));
            std::ranges::reverse(texels);
        }
    };
    for (std::size_t f = 0; f < format_names.size(); ++f)
        for (const Extent extent : {Extent{1, 1}, Extent{257, 129}})
            expect_back(static_cast<Format>(f), extent);
    expect_back(Format::rgba32f, {1500, 2000});  // more than is staged at once
}

TEST_F(ImageTest, FloatsKeepTheirBits) {
    Image image(device(), {4, 1}, Format::r32f);
    const std::vector<float> texels{-0.0f, std::numeric_limits<float>::denorm_min(), -infinity, nan};
    image.upload(texels);
    const auto back = image.download();
    EXPECT_EQ(std::memcmp(back.data(), texels.data(), 4 * sizeof(float)), 0);
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

}  // namespace gloam::backend::vulkan::test::buffer_test

// SPDX-License-Identifier: MIT
#include "backend/vulkan/gpu_test.hpp"
#include "backend/vulkan/resources.hpp"
#include "base/half.hpp"

namespace gloam::backend::vulkan::test::buffer_test {

using BufferTest = GpuTest;

TEST_F(BufferTest, TheDeviceSeesAllOfIt) {
    constexpr std::uint32_t count = 1'000'003;
    const ComputePipeline fill = pipeline_of(device(), fill_shader, 8);
    Buffer buffer(device(), count * sizeof(float));
    std::ranges::fill(buffer.as<float>(), -1.0f);
    run(device(), fill, {buffer}, {(count + 63) / 64, 1, 1}, bytes_of(std::array{3.0f, 0.5f}));
    const auto values = buffer.as<float>();
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(values[i], 3.0f + static_cast<float>(i) * 0.5f) << i;
}

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
            texels[i] = static_cast<float>(i % 0x10000);
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

// Row 0 is the row with y = 0 in the shader, and uploads, dispatches and downloads see each other's writes.
TEST_F(ImageTest, ShadersSeeTheSamePixels) {
    constexpr Extent extent{13, 9};
    Image from(device(), extent, Format::r32f);
    Image to(device(), extent, Format::rgba32f);
    Buffer buffer(device(), std::size_t{extent.width} * extent.height * 16);
    const auto texels = distinct_texels(extent, Format::r32f);
    from.upload(texels);
    run(device(), copying(device()), {from, to, buffer}, {2, 2, 1});
    std::vector<float> expected;
    for (std::uint32_t i = 0; i < extent.width * extent.height; ++i) {
        expected.insert(expected.end(), {texels[i], static_cast<float>(i % extent.width),
                                         static_cast<float>(i / extent.width), 1.0f});
    }
    EXPECT_EQ(to.download(), expected);
    const auto copied = buffer.as<float>();
    EXPECT_EQ(std::vector(copied.begin(), copied.end()), expected);
}

// The last texel of a level becomes the level's number; of the level before, the texel beyond the edge is
// read.
TEST_F(ImageTest, ShadersWriteALevelAndSampleAll) {
    const ComputePipeline pipeline =
        pipeline_of(device(), R"(
layout(local_size_x = 1) in;
layout(binding = 0, r32f) uniform writeonly image2D to;
layout(binding = 1) uniform sampler2D from;
layout(std430, binding = 2) writeonly buffer Values { float values[]; };
layout(push_constant) uniform Parameters { int level; };
void main() {
    imageStore(to, imageSize(to) - 1, vec4(float(level)));
    if (level > 0) values[level - 1] = textureLod(from, vec2(1.5), float(level - 1)).x;
}
)",
                    4, {BindingKind::storage_image, BindingKind::sampled_image, BindingKind::storage_buffer});
    const Image image(device(), {12, 9}, Format::r32f, 4);
    const Buffer values(device(), 3 * sizeof(float));
    for (std::uint32_t level = 0; level < image.levels(); ++level)
        run(device(), pipeline, {ImageLevel{image, level}, image, values}, {1, 1, 1}, bytes_of(level));
    EXPECT_THAT(values.as<float>(), ElementsAre(0.0F, 1.0F, 2.0F));
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

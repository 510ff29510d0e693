// SPDX-License-Identifier: MIT
#include "backend/vulkan/gpu_test.hpp"

namespace gloam::backend::vulkan::test::raster_test {

constexpr Extent extent{8, 6};
constexpr std::size_t pixels = extent.width * extent.height;

using RasterTest = GpuTest;

// Fragments of the top left half add a value to an image of one channel.
RasterPipeline adding(const Device& device) {
    const module::Spirv vertex = compiled(R"(
void main() { gl_Position = vec4(2.0 * vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) - 1.0, 0.0, 1.0); }
)",
                                          source::Stage::vertex);
    const module::Spirv fragment = compiled(R"(
layout(binding = 0, r32f) uniform image2D values;
layout(push_constant) uniform Constants { float value; };
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    imageStore(values, pixel, imageLoad(values, pixel) + value);
}
)",
                                            source::Stage::fragment);
    return {device,
            {.vertex_spirv = vertex,
             .fragment_spirv = fragment,
             .push_constant_bytes = sizeof(float),
             .bindings = {BindingKind::storage_image}}};
}

// A pixel centre of the 8x6 image is never on the diagonal's edge between halves: (x+.5)/8 + (y+.5)/6 = 1 has
// a solution only where 3x + 4y = 20.5.
bool in_top_left(std::size_t pixel) {
    const auto x = static_cast<double>(pixel % extent.width) + 0.5;
    const auto y = static_cast<double>(pixel / extent.width) + 0.5;
    return x / extent.width + y / extent.height < 1.0;
}

// Render, read in a dispatch, render again over it: each sees the one before, and each pixel is met once.
TEST_F(RasterTest, EachPixelOfTheTriangleOnceAndInOrder) {
    const RasterPipeline raster = adding(device());
    const ComputePipeline copy = pipeline_of(device(), R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) uniform readonly image2D from;
layout(std430, binding = 1) writeonly buffer Values { float values[]; };
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(from);
    if (pixel.y < size.y) values[pixel.y * size.x + pixel.x] = imageLoad(from, pixel).r;
}
)",
                                             0, {BindingKind::storage_image, BindingKind::storage_buffer});
    Image value(device(), extent, Format::r32f);
    value.upload(std::vector<float>(pixels, 1.0f));
    const std::array buffers{Buffer(device(), pixels * 4), Buffer(device(), pixels * 4)};
    Commands commands(device());
    for (const Buffer& buffer : buffers) {
        render(commands, raster, extent, std::vector<Resource>{value}, bytes_of(2.0f));
        commands.dispatch(copy, std::vector<Resource>{value, buffer}, {1, 1, 1});
    }
    commands.submit();
    for (std::size_t i = 0; i < pixels; ++i) {
        EXPECT_EQ(buffers[0].as<float>()[i], in_top_left(i) ? 3.0f : 1.0f) << i;
        EXPECT_EQ(buffers[1].as<float>()[i], in_top_left(i) ? 5.0f : 1.0f) << i;
    }
}

// Rendering makes lavapipe defer later dispatches; their time must not fall behind the reading that follows
// them.
TEST_F(RasterTest, TimesOfLaterDispatchesAreTheirOwn) {
    if (device().info().timestamp_period_ns == 0.0) GTEST_SKIP() << "no timestamps on this device";
    const Image value(device(), extent, Format::r32f);
    const RasterPipeline raster = adding(device());
    Commands before(device());
    render(before, raster, extent, std::vector<Resource>{value}, bytes_of(0.0f));
    before.submit();
    const ComputePipeline slow = pipeline_of(device(), slow_shader, 4);
    const Buffer buffer(device(), 4);
    const std::vector<Resource> resources{buffer};
    double share =
        1.0;  // of the second dispatch, the least of several tries: other programs may interrupt it
    for (int i = 0; i < 8 && share > 0.2; ++i) {
        Commands commands(device());
        commands.timestamp();
        commands.dispatch(slow, resources, {10, 20, 1}, bytes_of(std::uint32_t{60'000}));
        commands.timestamp();
        commands.dispatch(slow, resources, {1, 1, 1}, bytes_of(std::uint32_t{1'000}));
        commands.timestamp();
        commands.submit();
        const auto times = commands.times_ms();
        share = std::min(share, (times[2] - times[1]) / times[2]);
    }
    EXPECT_LT(share, 0.2);  // the first has 12,000 times the work
}

}  // namespace gloam::backend::vulkan::test::raster_test

// SPDX-License-Identifier: MIT

#include "backend/vulkan/gpu_test.hpp"
#include "shaders/behind_frag.h"
#include "shaders/image_comp.h"
#include "shaders/slow_comp.h"
#include "shaders/triangle_frag.h"
#include "shaders/triangle_vert.h"

namespace gloam::gpu::test::raster_test {

constexpr Extent extent{8, 6};
constexpr std::size_t pixels = extent.width * extent.height;

struct Vertex {
    float x, y, z, value;
};

// The push constants of triangle.vert and triangle.frag.
struct Constants {
    float offset_x = 0.0f;
    float offset_y = 0.0f;
    float scale = 1.0f;
};

// Geometry on the device: covers all of the image, or its top left half.
struct Mesh {
    Mesh(const Device& device, const std::vector<Vertex>& corners)
        : vertices(device, corners.size() * sizeof(Vertex)),
          indices(device, corners.size() * sizeof(std::uint32_t)) {
        std::ranges::copy(corners, vertices.as<Vertex>().begin());
        std::iota(indices.as<std::uint32_t>().begin(), indices.as<std::uint32_t>().end(), 0u);
    }
    [[nodiscard]] Draw draw(const Constants& constants) const {
        return {.vertices = vertices,
                .indices = indices,
                .index_count = static_cast<std::uint32_t>(indices.size() / sizeof(std::uint32_t)),
                .push_constants = bytes_of(constants)};
    }
    Buffer vertices;
    Buffer indices;
};

Mesh whole(const Device& device, float z, float value) {
    return {device, {{-1, -1, z, value}, {3, -1, z, value}, {-1, 3, z, value}}};
}

Mesh top_left(const Device& device, float z, float value) {
    return {device, {{-1, -1, z, value}, {1, -1, z, value}, {-1, 1, z, value}}};
}

class RasterTest : public GpuTest {
  protected:
    RasterProgram program(bool reversed_z) {
        return {.vertex_spirv = triangle_vert,
                .fragment_spirv = triangle_frag,
                .attribute_sizes = {3, 1},
                .color_formats = {Format::rgba32f, Format::r32f},
                .push_constant_bytes = sizeof(Constants),
                .reversed_z = reversed_z};
    }

    struct Targets {
        explicit Targets(const Device& device)
            : place(device, extent, Format::rgba32f),
              value(device, extent, Format::r32f),
              depth(device, extent, Format::depth32f) {}
        [[nodiscard]] std::vector<std::reference_wrapper<const Image>> colors() const {
            return {place, value};
        }
        Image place, value, depth;
    };

    // Renders the meshes in order and returns the targets.
    Targets rendered(bool reversed_z, const std::vector<const Mesh*>& meshes, float clear_color) {
        const RasterPipeline pipeline(device(), program(reversed_z));
        Targets targets(device());
        const Constants constants;
        std::vector<Draw> draws;
        for (const Mesh* mesh : meshes) draws.push_back(mesh->draw(constants));
        Commands commands(device());
        render(commands, pipeline, targets.colors(), targets.depth, clear_color, draws);
        commands.submit();
        return targets;
    }
};

// A pixel centre of the 8x6 image is never on the diagonal's edge between halves: (x+.5)/8 + (y+.5)/6 = 1 has
// a solution only where 3x + 4y = 20.5.
bool in_top_left(std::size_t pixel) {
    const auto x = static_cast<double>(pixel % extent.width) + 0.5;
    const auto y = static_cast<double>(pixel / extent.width) + 0.5;
    return x / extent.width + y / extent.height < 1.0;
}

TEST_F(RasterTest, ClearsToTheColourAndTheFarDepth) {
    for (const bool reversed_z : {false, true}) {
        const auto targets = rendered(reversed_z, {}, -2.5f);
        EXPECT_EQ(targets.place.download(), std::vector<float>(pixels * 4, -2.5f));
        EXPECT_EQ(targets.value.download(), std::vector<float>(pixels, -2.5f));
        EXPECT_EQ(targets.depth.download(), std::vector<float>(pixels, reversed_z ? 0.0f : 1.0f));
    }
}

TEST_F(RasterTest, FillsEveryPixelOnceAtItsCentre) {
    const auto mesh = whole(device(), 0.5f, 3.0f);
    const auto targets = rendered(false, {&mesh}, 0.0f);
    const auto place = targets.place.download();
    for (std::size_t i = 0; i < pixels; ++i) {
        EXPECT_EQ(place[4 * i], static_cast<float>(i % extent.width) + 0.5f);
        EXPECT_EQ(place[4 * i + 1], static_cast<float>(i / extent.width) + 0.5f);
        EXPECT_EQ(place[4 * i + 2], 0.5f);
    }
    EXPECT_EQ(targets.value.download(), std::vector<float>(pixels, 3.0f));
    EXPECT_EQ(targets.depth.download(), std::vector<float>(pixels, 0.5f));
}

// Two triangles at different depths, in both orders and both z directions: the nearer one wins where both
// are.
TEST_F(RasterTest, TheNearerWins) {
    for (const bool reversed_z : {false, true}) {
        const float near_z = reversed_z ? 0.75f : 0.25f;
        const float far_z = reversed_z ? 0.25f : 0.75f;
        const auto near_half = top_left(device(), near_z, 1.0f);
        const auto far_all = whole(device(), far_z, 2.0f);
        for (const auto& order : {std::vector{&near_half, &far_all}, std::vector{&far_all, &near_half}}) {
            const auto targets = rendered(reversed_z, order, 0.0f);
            const auto value = targets.value.download();
            const auto depth = targets.depth.download();
            for (std::size_t i = 0; i < pixels; ++i) {
                EXPECT_EQ(value[i], in_top_left(i) ? 1.0f : 2.0f) << i;
                EXPECT_EQ(depth[i], in_top_left(i) ? near_z : far_z) << i;
            }
        }
    }
}

TEST_F(RasterTest, OfEqualDepthTheFirstWins) {
    const auto first = whole(device(), 0.5f, 1.0f);
    const auto second = whole(device(), 0.5f, 2.0f);
    for (const bool reversed_z : {false, true}) {
        EXPECT_EQ(rendered(reversed_z, {&first, &second}, 0.0f).value.download(),
                  std::vector<float>(pixels, 1.0f));
    }
}

TEST_F(RasterTest, BothWindingsAreDrawn) {
    const Mesh clockwise(device(), {{-1, -1, 0, 1}, {-1, 3, 0, 1}, {3, -1, 0, 1}});
    EXPECT_EQ(rendered(false, {&clockwise}, 0.0f).value.download(), std::vector<float>(pixels, 1.0f));
}

TEST_F(RasterTest, PushConstantsReachBothStages) {
    const RasterPipeline pipeline(device(), program(false));
    const Targets targets(device());
    const auto left = whole(device(), 0.5f, 3.0f);
    const auto right = whole(device(), 0.25f, 5.0f);
    const Constants everywhere;
    const Constants right_half{.offset_x = 1.0f, .scale = 2.0f};
    const std::vector draws{left.draw(everywhere), right.draw(right_half)};
    Commands commands(device());
    render(commands, pipeline, targets.colors(), targets.depth, 0.0f, draws);
    commands.submit();
    const auto value = targets.value.download();
    for (std::size_t i = 0; i < pixels; ++i)
        EXPECT_EQ(value[i], i % extent.width < extent.width / 2 ? 3.0f : 10.0f);
}

// Render, read in a dispatch, render again over it: each sees the one before.
TEST_F(RasterTest, DispatchesSeeWhatWasRendered) {
    const RasterPipeline raster(device(), program(false));
    const ComputePipeline copy(device(), {.spirv = image_comp,
                                          .bindings = {BindingKind::storage_image, BindingKind::storage_image,
                                                       BindingKind::storage_buffer}});
    const Targets targets(device());
    const Image out(device(), extent, Format::rgba32f);
    const std::array buffers{Buffer(device(), pixels * 16), Buffer(device(), pixels * 16)};
    const std::array meshes{whole(device(), 0.5f, 4.0f), top_left(device(), 0.5f, 6.0f)};
    const Constants constants;
    Commands commands(device());
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector draws{meshes[i].draw(constants)};
        render(commands, raster, targets.colors(), targets.depth, 9.0f, draws);
        commands.dispatch(copy, std::vector<Resource>{targets.value, out, buffers[i]}, {1, 1, 1});
    }
    commands.submit();
    for (std::size_t i = 0; i < pixels; ++i) {
        EXPECT_EQ(buffers[0].as<float>()[4 * i], 4.0f);
        EXPECT_EQ(buffers[1].as<float>()[4 * i], in_top_left(i) ? 6.0f : 9.0f);
    }
}

// Fragments read an image that an earlier pass has rendered to.
TEST_F(RasterTest, AnImageIsReadWhileAnotherIsRendered) {
    auto behind = program(false);
    behind.fragment_spirv = behind_frag;
    behind.bindings = {BindingKind::storage_image};
    const RasterPipeline all(device(), program(false));
    const RasterPipeline further(device(), behind);
    const Targets first(device());
    const Targets second(device());
    const std::array meshes{top_left(device(), 0.25f, 1.0f), whole(device(), 0.5f, 2.0f),
                            whole(device(), 0.75f, 3.0f)};
    const Constants constants;
    std::vector<Draw> draws;
    for (const Mesh& mesh : meshes) draws.push_back(mesh.draw(constants));
    Commands commands(device());
    render(commands, all, first.colors(), first.depth, 0.0f, draws);
    for (Draw& draw : draws) draw.resources = {first.place};
    render(commands, further, second.colors(), second.depth, 0.0f, draws);
    commands.submit();
    const auto value = second.value.download();
    for (std::size_t i = 0; i < pixels; ++i) EXPECT_EQ(value[i], in_top_left(i) ? 2.0f : 3.0f) << i;
}

// Rendering makes lavapipe defer later dispatches; their time must not fall behind the reading that follows
// them.
TEST_F(RasterTest, TimesOfLaterDispatchesAreTheirOwn) {
    if (device().info().timestamp_period_ns == 0.0) GTEST_SKIP() << "no timestamps on this device";
    const auto mesh = whole(device(), 0.5f, 3.0f);
    static_cast<void>(rendered(false, {&mesh}, 0.0f));
    const ComputePipeline slow(
        device(), {.spirv = slow_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 4});
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

TEST_F(RasterTest, HalfFloatTargets) {
    auto half = program(false);
    half.color_formats = {Format::rgba16f, Format::rgba16f};
    const RasterPipeline pipeline(device(), half);
    const Image place(device(), extent, Format::rgba16f);
    const Image value(device(), extent, Format::rgba16f);
    const Image depth(device(), extent, Format::depth32f);
    const auto mesh = whole(device(), 0.5f, 0.125f);
    const Constants constants;
    const std::vector draws{mesh.draw(constants)};
    const std::vector<std::reference_wrapper<const Image>> colors{place, value};
    Commands commands(device());
    render(commands, pipeline, colors, depth, 0.0f, draws);
    commands.submit();
    const auto texels = place.download();
    EXPECT_EQ(texels[0], 0.5f);
    EXPECT_EQ(texels[4 * (pixels - 1)], 7.5f);
    EXPECT_EQ(texels[4 * (pixels - 1) + 1], 5.5f);
    EXPECT_EQ(value.download()[0], 0.125f);
}

}  // namespace gloam::gpu::test::raster_test

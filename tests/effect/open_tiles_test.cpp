// SPDX-License-Identifier: MIT
// Tiles that are proven open take no taps, and their images stay bit-identical.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "scene/camera.hpp"
#include "skips.hpp"
#include "support/method_names.hpp"
#include "surface_views.hpp"

namespace gloam::effect::open_tiles_test {

class OpenTiles : public Skips {};

class OpenFloor : public OpenTiles, public testing::WithParamInterface<std::string> {};

TEST_P(OpenFloor, TakesNoTaps) {
    const Settings settings = with_method(quick(Settings{}), GetParam());
    for (const float bump : {0.0F, 0.02F, 0.3F}) {
        const std::vector<Frame> frames = expect_same({{floor_view({160, 90}, bump), 5}}, settings);
        const Work& work = frames.front().work;
        const std::uint64_t with_geometry = work.tiles - work.tiles_background;
        EXPECT_GT(work.tiles_open, 0U);
        // Far away the rounding of positions exceeds the bias.
        if (bump == 0.0F) {
            EXPECT_GT(work.tiles_open, with_geometry / 4);
        } else {
            EXPECT_LT(work.tiles_open, with_geometry);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenFloor, testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return method.open_proof != OpenProof::none;
                         })),
                         test::parameter_name);

TEST_F(OpenTiles, OfAFloorFewTilesCannotBeProvenOpen) {
    const Work work = run({{floor_view({160, 90}, 0.0F), 1}}, quick(Settings{})).front().work;
    EXPECT_GT(work.tiles_open, (work.tiles - work.tiles_background) / 2);
}

// Blocks of pixels that begin far behind the floor and end in front of it, along x and along y.
TEST_F(OpenTiles, ASurfaceThatComesNearWithinATileIsSeen) {
    scene::GBuffer view = floor_view({160, 90}, 0.0F);
    const auto ramp = [&](std::size_t left, std::size_t top, bool along_y) {
        const float near = view.depth[160 * (top + 7) + left + 7] - 0.3F;
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < 8; ++x)
                view.depth[160 * (top + y) + left + x] =
                    1.0F / std::lerp(1.0F / 40.0F, 1.0F / near, static_cast<float>(along_y ? y : x) / 7.0F);
    };
    ramp(80, 56, false);
    ramp(32, 64, true);
    const Frame frame = expect_same({{view, 2}}, quick(Settings{})).front();
    EXPECT_GT(frame.work.tiles_open, 0U);
    EXPECT_GT(frame.occlusion[160 * 60 + 90], 0.0F);
    EXPECT_GT(frame.occlusion[160 * 74 + 36], 0.0F);
}

// A sample reaches 60 pixels here, of 128 that the coarsest blocks have on a side: the step lies at the end
// of the reach of the pixels in the middle, in another block.
TEST_F(OpenTiles, AStepAtTheEndOfTheReachIsSeen) {
    constexpr gpu::Extent wide{192, 48};
    constexpr float depth = 5.0F;
    Settings settings = quick(Settings{});
    settings.samples = settings.samples_converged = 256;
    settings.filter = Filter::none;
    const scene::CameraFrame camera = scene::make_frame({.fovy_rad = 0.25}, 4.0);
    settings = with_radius(settings, 120.0F * depth / (192.0F * camera.p00_p11().x));
    scene::GBuffer view = wall_of(wide, [&](std::uint32_t x, std::uint32_t) {
        return depth - (x >= 144 ? 0.3F * settings.radius : 0.0F);
    });
    view.camera = camera;
    const Frame frame = expect_same({{view, 1}}, settings).front();
    EXPECT_GT(frame.work.tiles_open, 0U);
    EXPECT_GT(frame.occlusion[24 * wide.width + 95], 0.0F);
}

// A floor that ends at a tile's border, and a wall behind it: it is further away than every point of the
// floor's samples. Some are blocked for all that: they are compared at a pixel's centre, where a plane
// through them lies behind the wall.
TEST_F(OpenTiles, AWallBehindAllSamplesIsSeen) {
    constexpr gpu::Extent extent{16, 96};
    constexpr std::uint32_t end = 56;  // the first row of the floor, at depth 11.7
    Settings settings = with_radius(quick(Settings{}), 0.3F);
    settings.own.range = 50.0F;
    settings.samples = settings.samples_converged = 256;
    settings.filter = Filter::none;
    std::uint64_t open = 0;
    float most = 0.0F;
    for (float behind = 12.1F; behind < 13.6F; behind += 0.1F) {
        SCOPED_TRACE(behind);
        scene::GBuffer view = wall(extent, behind);
        const float row = 2.0F / (96.0F * std::abs(view.camera.p00_p11().y));
        for (std::uint32_t i = end * extent.width; i < extent.width * extent.height; ++i) {
            view.depth[i] = 1.0F / (row * (static_cast<float>(i / extent.width) - 47.5F));
            view.normal[i] = {0, 1, 0};
        }
        const Frame frame = expect_same({{view, 1}}, settings).front();
        open += frame.work.tiles_open;
        most = std::max(most, *std::max_element(frame.occlusion.begin() + end * extent.width,
                                                frame.occlusion.begin() + (end + 1) * extent.width));
    }
    EXPECT_GT(open, 0U);
    EXPECT_GT(most, 0.1F);
}

TEST_F(OpenTiles, TheUnitOfLengthChangesNoProof) {
    const auto open = [&](float scale) {
        scene::GBuffer view = floor_view({160, 90}, 0.3F);
        for (float& depth : view.depth) depth *= scale;
        const Settings settings = quick(Settings{});
        return run({{view, 1}}, with_radius(settings, scale * settings.radius)).front().work.tiles_open;
    };
    EXPECT_GT(open(1.0F), 0U);
    EXPECT_EQ(open(0x1p-8F), open(1.0F));
}

TEST_F(OpenTiles, APixelThatRisesByMoreThanTheBiasIsSeen) {
    const scene::GBuffer flat = floor_view({160, 90}, 0.0F);
    const Settings settings = quick(Settings{});
    const std::uint64_t open = run({{flat, 1}}, settings).front().work.tiles_open;
    const auto with_spike = [&](float biases) {
        scene::GBuffer view = flat;
        view.depth[60 * 160 + 83] -= biases * settings.bias;
        return expect_same({{view, 3}}, settings).front().work.tiles_open;
    };
    EXPECT_EQ(with_spike(0.1F), open) << "no sample is compared so closely";
    const std::uint64_t with_higher = with_spike(1.05F);
    EXPECT_LT(with_higher, open);
    EXPECT_LE(with_spike(20.0F), with_higher);
}

TEST_F(OpenTiles, SurfacesReadFromTheDepthChainMayLieBeyondTheRadius) {
    Settings settings = with_method(quick(Settings{}), "alchemy");
    const std::vector<Stay> stays{{floor_view({160, 90}, 0.0F), 2}};
    EXPECT_GT(expect_same(stays, settings).front().work.tiles_open, 0U);
    settings.own.mip_distance = 4.0F;
    EXPECT_EQ(expect_same(stays, settings).front().work.tiles_open, 0U);
}

TEST_F(OpenTiles, OfScenes) {
    std::uint64_t open = 0;
    for (const std::string name : {"columns", "far", "moving"}) {
        SCOPED_TRACE(name);
        Settings settings = settings_for(name);
        settings.samples = settings.samples_converged = 16;
        settings.invalidation = Invalidation::none;
        std::vector<Stay> stays;
        for (int i = 0; i < 2; ++i) stays.push_back({view(name, 3 * i, {320, 180})});
        for (const Frame& frame : expect_same(stays, settings)) open += frame.work.tiles_open;
    }
    EXPECT_GT(open, 30U);
}

}  // namespace gloam::effect::open_tiles_test

// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"
#include "effect/preparation.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace plan_test {

class PlanTest : public OnDevice<testing::Test> {};

std::vector<std::string> names_of(const std::vector<PassTime>& times) {
    std::vector<std::string> names;
    for (const PassTime& time : times) names.push_back(time.pass);
    return names;
}

// Of a frame in which everything runs, over the whole image.
Settings without_tiles(Settings settings) {
    settings.skip_open = settings.skip_settled = settings.skip_filtered = settings.skip_background = false;
    return settings;
}

TEST_F(PlanTest, IsWhatAFrameRuns) {
    const scene::Scene scene = scene::make_scene("room");
    const gpu::Extent extent{33, 17};
    const auto view = [&](int frame) {
        return scene::rasterize(device_, passes_, scene, extent, {.frame = frame});
    };
    for (const char* method : {"hemisphere", "mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const char* preset :
             {"paper", "balanced", "balanced, half", "balanced, frames alone", "paper, half"}) {
            const bool alone = std::string_view(preset).ends_with("alone");
            const bool half = std::string_view(preset).ends_with("half");
            const std::string_view named =
                std::string_view(preset).substr(0, std::string_view(preset).find(','));
            Settings settings = without_tiles(with_method(preset_named(std::string(named)).settings, method));
            settings.history = !alone;
            if (half) settings.resolution = Resolution::half;
            settings.remap_b = 2.0F;
            settings.filter_frames = every_frame;  // fewer: filter_frames_test.cpp
            AmbientOcclusion effect(device_, passes_, extent);
            effect.begin(view(0), settings);
            (void)effect.next(1);
            effect.advance(view(1));
            std::vector<std::string> ran = names_of(effect.next(1).times);
            std::erase(
                ran, "remap");  // of the unfiltered occlusion, which nobody is shown where there is a filter
            std::erase(ran, "sample_table");
            std::vector<std::string> planned;
            for (const PlannedPass& pass : plan_of(settings, {.view = extent}).passes)
                if (pass.turn != Turn::once) planned.push_back(pass.name);
            std::erase(planned, "remap");
            std::erase(planned, "upsample_filtered");  // a frame takes it in the place of "upsample"
            EXPECT_EQ(planned, ran) << method << " " << preset;
        }
    }
}

TEST_F(PlanTest, ImagesHaveTheSizeThatTheMethodPrepares) {
    for (const char* method : {"mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const gpu::Extent extent : {gpu::Extent{640, 360}, gpu::Extent{33, 17}, gpu::Extent{1, 1}}) {
            for (const Resolution resolution : {Resolution::full, Resolution::half}) {
                Settings settings = with_method({}, method);
                settings.resolution = resolution;
                const gpu::Extent read = resolution == Resolution::half ? half_of(extent) : extent;
                const Preparation preparation = preparation_of(settings, read).value();
                const Plan plan = plan_of(settings, {.view = extent});
                std::size_t next = 0;
                for (const PlannedImage& image : plan.images) {
                    const std::uint32_t d = image.divisor;
                    if (d == 0) continue;
                    EXPECT_EQ(image.extent.width, (extent.width + d - 1) / d) << image.name;
                    EXPECT_EQ(image.extent.height, (extent.height + d - 1) / d) << image.name;
                }
                for (const PlannedPass& pass : plan.passes) {
                    if (next == preparation.passes.size() || pass.name != preparation.passes[next].name)
                        continue;
                    const gpu::Extent needed = preparation.passes[next++].invocations;
                    const auto [x, y] = pass.pixels;
                    EXPECT_GE((extent.width + x - 1) / x * 8, needed.width) << pass.name;
                    EXPECT_GE((extent.height + y - 1) / y * 8, needed.height) << pass.name;
                }
                EXPECT_EQ(next, preparation.passes.size());
            }
        }
    }
}

// Passes over half-size images have groups of as many pixels of the half-size view.
TEST_F(PlanTest, GroupsCoverTheHalfSizeView) {
    Settings settings;
    settings.resolution = Resolution::half;
    for (const bool tiles : {false, true}) {
        const Plan plan = plan_of(settings, {.view = {35, 18}, .tiles = tiles, .normals = false});
        EXPECT_EQ(plan.tile, 16U);
        EXPECT_EQ(plan.result, "upsampled");
        std::size_t full = 0;
        for (const PlannedPass& pass : plan.passes) {
            full += pass.divisor == 1 && pass.turn != Turn::once ? 1 : 0;
            if (pass.pixels[0] == 0) continue;
            EXPECT_EQ(pass.pixels[1] % 16, pass.name == "normals_from_depth" ? 8U : 0U) << pass.name;
            EXPECT_EQ(pass.divisor, pass.name == "normals_from_depth" || pass.name == "halve_inputs" ||
                                            pass.name == "upsample"
                                        ? 1U
                                        : 2U)
                << pass.name;
        }
        EXPECT_EQ(full, 3U);
        const auto size = [&](const char* name) {
            const auto found = std::ranges::find(plan.images, name, &PlannedImage::name);
            return found == plan.images.end() ? gpu::Extent{} : found->extent;
        };
        EXPECT_EQ(size("depth"), (gpu::Extent{35, 18}));
        EXPECT_EQ(size("half_depth"), (gpu::Extent{18, 9}));
        EXPECT_EQ(size("history_after"), (gpu::Extent{18, 9}));
        EXPECT_EQ(size("upsampled"), (gpu::Extent{35, 18}));
    }
}

// Of the push constants the view's are what an engine must give, all others are the settings'.
TEST_F(PlanTest, TellsWhatIsTheViews) {
    const Plan plan = plan_of({}, {});
    for (const PlannedPass& pass : plan.passes) {
        if (pass.name != "ambient_occlusion") continue;
        ASSERT_EQ(pass.of_view.size(), pass.parameters.size());
        const auto any = [&](std::size_t first, std::size_t bytes) {
            return std::find(pass.of_view.begin() + static_cast<std::ptrdiff_t>(first),
                             pass.of_view.begin() + static_cast<std::ptrdiff_t>(first + bytes),
                             true) != pass.of_view.begin() + static_cast<std::ptrdiff_t>(first + bytes);
        };
        EXPECT_TRUE(any(0, 4) && any(4, 4));    // p00_p11
        EXPECT_TRUE(any(8, 4) && any(12, 4));   // size
        EXPECT_TRUE(any(16, 4) && any(20, 4));  // border
        constexpr std::size_t radius = offsetof(OcclusionParameters, radius);
        EXPECT_FALSE(any(radius, offsetof(OcclusionParameters, still) - radius));  // to confidence_factor
    }
}

TEST_F(PlanTest, RefusesWhatSettingsRefuse) {
    Settings settings;
    settings.samples = 0;
    EXPECT_THROW((void)plan_of(settings, {}), std::invalid_argument);
}

}  // namespace plan_test
}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
// A march that ends when no later tap can change it gives bit-identical images to one that continues.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bits.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "support/method_names.hpp"

namespace gloam::effect {
namespace ended_marches_test {

constexpr gpu::Extent odd{83, 45};

class EndedMarches : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view(const std::string& name, int frame, double guard = 0.0) const {
        return scene::rasterize(device_, passes_, scene::make_scene(name), odd,
                                {.frame = frame, .motion = name == "moving", .guard = guard});
    }

    // Every other skip off.
    [[nodiscard]] static Settings settings_for(const std::string& scene, const std::string& method) {
        const auto radius = static_cast<float>(scene::make_scene(scene).ao_radius);
        Settings settings =
            without_skips(with_method(with_radius(preset_named("paper").settings, radius), method));
        settings.skip_closed = true;
        return settings;
    }

    [[nodiscard]] std::vector<Frame> run(const std::vector<scene::GBuffer>& views,
                                         const Settings& settings) const {
        AmbientOcclusion& effect = effect_for(views.front().extent);
        std::vector<Frame> frames;
        for (const scene::GBuffer& view : views) {
            frames.empty() ? effect.begin(view, settings) : effect.advance(view);
            frames.push_back(effect.next());
        }
        return frames;
    }

    // Returns the number of pixels in each frame with a march that was ended.
    [[nodiscard]] std::vector<std::uint64_t> ended(const std::vector<scene::GBuffer>& views,
                                                   Settings settings) const {
        const std::vector<Frame> with = run(views, settings);
        settings.skip_closed = false;
        const std::vector<Frame> without = run(views, settings);
        std::vector<std::uint64_t> pixels;
        for (std::size_t i = 0; i < with.size(); ++i) {
            SCOPED_TRACE(fmt::format("frame {}", i));
            EXPECT_EQ(bits_of(with[i].occlusion), bits_of(without[i].occlusion));
            EXPECT_EQ(bits_of(with[i].filtered), bits_of(without[i].filtered));
            EXPECT_EQ(bits_of(with[i].kept), bits_of(without[i].kept));
            EXPECT_EQ(with[i].work.samples, without[i].work.samples);
            EXPECT_EQ(without[i].work.ended_early, 0U);
            EXPECT_LE(with[i].work.ended_early, with[i].work.pixels - with[i].work.background);
            pixels.push_back(with[i].work.ended_early);
        }
        return pixels;
    }
};

class EndedMarchesOf : public EndedMarches, public testing::WithParamInterface<std::string> {};

// By gtao.glsl, its marches never end early. Samples of points, taps and pairs count independently, and rays
// end at their hit.
bool may_close(const std::string& method) {
    return method == "bitmask" || method == "hbao" || method == "dual_resolution";
}

TEST_P(EndedMarchesOf, ChangesNothing) {
    const std::vector<std::uint64_t> pixels =
        ended({view("far", 0), view("far", 3)}, settings_for("far", GetParam()));
    EXPECT_EQ(pixels.front() > 0, may_close(GetParam())) << pixels.front();
}

INSTANTIATE_TEST_SUITE_P(All, EndedMarchesOf, testing::ValuesIn(test::method_names()), test::parameter_name);

TEST_F(EndedMarches, OfEveryScene) {
    for (const scene::SceneInfo& scene : scene::built_in_scenes()) {
        for (const std::string method : {"bitmask", "hbao"}) {
            SCOPED_TRACE(scene.name + " " + method);
            (void)ended({view(scene.name, 0)}, settings_for(scene.name, method));
        }
    }
}

// From radii of a few pixels to those that reach the eye, with few taps and with many.
TEST_F(EndedMarches, OfEveryLength) {
    const scene::GBuffer far = view("far", 0);
    const Settings settings = settings_for("far", "bitmask");
    std::uint64_t pixels = 0;
    for (const float factor : {0.1F, 1.0F, 3.0F, 50.0F}) {
        for (const std::uint32_t steps : {1U, 5U, 64U}) {
            SCOPED_TRACE(fmt::format("radius {} times that of the scene, {} steps", factor, steps));
            Settings changed = with_radius(settings_for("far", "bitmask"), factor * settings.radius);
            changed.own.steps = steps;
            changed.samples = 3 * steps;
            pixels += ended({far}, changed).front();
        }
    }
    EXPECT_GT(pixels, far.depth.size());
}

TEST_F(EndedMarches, WithRejectedTapsThinSurfacesAndAGuardBand) {
    Settings settings = settings_for("grass", "bitmask");
    settings.reject_taps = true;
    settings.own.thickness = 0.1F * settings.radius;
    settings.guard = 0.1F;
    EXPECT_GT(ended({view("grass", 0, 0.1)}, settings).front(), 0U);
}

// Pillars so near to the eye that how far a tap sees is not known: what ends the marches between them is that
// all sectors are covered.
TEST_F(EndedMarches, WhereAllSectorsAreCovered) {
    scene::GBuffer pit{.extent = odd};
    pit.camera = scene::make_frame({}, static_cast<double>(odd.width) / static_cast<double>(odd.height));
    for (std::uint32_t i = 0; i < odd.width * odd.height; ++i) {
        pit.depth.push_back(i % odd.width % 4 == 1 ? 2.0F : 1.0F);
        pit.normal.emplace_back(0.0F, 0.0F, 1.0F);
    }
    Settings settings = settings_for("far", "bitmask");
    settings.radius = 20.0F;
    settings.own.thickness = 100.0F;
    EXPECT_GT(ended({pit}, settings).front(), 0U);
}

TEST_F(EndedMarches, NotWhereTapsWatchMovingObjects) {
    const std::vector<std::uint64_t> pixels =
        ended({view("moving", 20), view("moving", 21)}, settings_for("moving", "bitmask"));
    EXPECT_GT(pixels.front(), 0U);
    EXPECT_EQ(pixels.back(), 0U);
}

}  // namespace ended_marches_test
}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
// A method that takes samples alone, and those that prepare something before them, on their real passes:
// scenes whose result is known, and the passes themselves.
#include "effect/methods.hpp"

#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::preparation_test {

std::vector<std::string> prepared_methods() {
    std::vector<std::string> names{"hemisphere"};
    for (const MethodInfo& method : methods()) {
        if (preparation_of({.method = method.name}, {8, 8})) names.push_back(method.name);
    }
    return names;
}

Settings settings_for(const std::string& method, float radius) {
    return with_radius(with_method(preset_named("tssao-paper").settings, method), radius);
}

class Prepared : public OnDevice<testing::TestWithParam<std::string>> {};

TEST_P(Prepared, NothingIsFoundWhereThereIsNothing) {
    const Settings settings = settings_for(GetParam(), 0.5F);
    for (const gpu::Extent extent : {gpu::Extent{1, 1}, gpu::Extent{3, 1}, gpu::Extent{17, 9}}) {
        for (const float depth : {infinity, 0.0F, -1.0F, nan}) {
            scene::GBuffer view = view_of(extent, false, [](glm::dvec2) { return 3.0; });
            view.depth.back() = depth;  // a surface before nothing
            EXPECT_THAT(run(view, settings, 2).occlusion, Each(0.0F));
            view.depth.assign(view.depth.size(), depth);
            const Frame frame = run(view, settings, 2);
            EXPECT_THAT(frame.filtered, Each(0.0F));
            EXPECT_THAT(frame.convergence, Each(0.0F));
        }
    }
}

// What decides of a pixel's samples decides of those that are prepared for it.
TEST_P(Prepared, SettingsOfSamplesReachThePreparation) {
    const scene::GBuffer view = groove({64, 64});
    const auto same = [&](const Settings& a, const Settings& b) {
        return run(view, a).occlusion == run(view, b).occlusion;
    };
    Settings fewer = settings_for(GetParam(), 0.5F);
    fewer.least_radius = 0.0F;
    fewer.own.steps = 3;
    Settings cap = fewer;
    const float pixels = 0.5F * 64.0F / static_cast<float>(view_height);  // of the radius, in the image
    cap.radius = 2.0F * fewer.radius;
    cap.radius_cap = pixels;  // the same radius everywhere, for the view is orthographic
    EXPECT_TRUE(same(fewer, cap));
    Settings distance = fewer;
    distance.samples = distance.samples_converged = 48;
    distance.samples_least = 24;
    distance.samples_distance = 1e-3F;  // every pixel lies beyond: 24 everywhere
    Settings as_many = fewer;
    as_many.samples = as_many.samples_converged = 24;
    EXPECT_TRUE(same(as_many, distance));
    distance.samples_distance = 0.0F;
    distance.samples_radius = 1e6F;
    EXPECT_TRUE(same(as_many, distance));
}

TEST_P(Prepared, RepeatsChangeNothing) {
    const scene::GBuffer view = drawn("corner", {63, 37});
    const Settings settings = settings_for(GetParam(), 1.0F);
    const Frame once = run(view, settings, 3);
    expect_same_images(once, run(view, settings, 3, 3));
    EXPECT_GT(*std::ranges::max_element(once.occlusion), 0.05F);
}

// What is prepared for the band alone is left out; the frame stays as it was.
TEST_P(Prepared, TheBandIsReadWithoutBeingShaded) {
    const scene::GBuffer view = drawn("corner", {63, 37}, {.guard = 0.1});
    Settings settings = settings_for(GetParam(), 1.0F);
    settings.guard = 0.1F;
    const int frames = GetParam() == "hemisphere" ? 3 : 1;  // later ones prepare from a band's history
    const Frame shaded = run(view, settings, frames);
    settings.guard_history = false;
    const Frame left_out = run(view, settings, frames);
    EXPECT_EQ(left_out.occlusion, shaded.occlusion);
}

INSTANTIATE_TEST_SUITE_P(All, Prepared, testing::ValuesIn(prepared_methods()),
                         [](const auto& info) { return info.param; });

using DepthChain = Prepared;
using Separable = Prepared;
using DualResolution = Prepared;

// The texels of the chain are pixels of the full image.
TEST_F(DepthChain, IsTheFullImageToTheBit) {
    for (const gpu::Extent extent : {gpu::Extent{96, 54}, gpu::Extent{97, 53}, gpu::Extent{61, 1}}) {
        const scene::GBuffer view = drawn("corner", extent);
        Settings settings = settings_for("sao", 1.5F);
        settings.own.mip_distance = 2.0F;
        const Frame full = run(view, settings, 3);
        settings.method = "sao_chain";
        EXPECT_EQ(run(view, settings, 3).occlusion, full.occlusion) << extent.width;
        settings.reject_taps = true;
        settings.own.range = 0.2F;
        const Frame rejected = run(view, settings, 3);
        settings.method = "sao";
        EXPECT_EQ(rejected.occlusion, run(view, settings, 3).occlusion) << extent.width;
        settings.method = "sao_chain";
        settings.reject_taps = false;
        if (extent.height == 1) continue;  // nothing is occluded in it
        settings.own.mip_distance = 0.0F;
        EXPECT_NE(run(view, settings, 3).occlusion, full.occlusion) << extent.width;
    }
}

// In one frame all pixels see the same pair of directions, along x and along y: a groove along one of them is
// seen in full by the other, and the mean of both is half of it, whichever is prepared.
TEST_F(Separable, AWallAlongADirectionIsSeenByTheOther) {
    Settings settings = settings_for("separable", 0.9F);
    settings.bias = 1e-5F;
    settings.samples = 64;
    settings.c_rot = 0.0F;
    const gpu::Extent extent{129, 129};
    const auto value_at_the_line = [&](bool turned) {
        scene::GBuffer view = groove(extent);
        if (turned) {
            const std::vector<float> depth = view.depth;
            for (unsigned y = 0; y < 129; ++y)
                for (unsigned x = 0; x < 129; ++x) view.depth[129 * y + x] = depth[129 * x + y];
        }
        return double{run(view, settings).occlusion[129 * 64 + 64]};
    };
    // sin(45 degrees)^2 / 2 of one slice, as the steps of pixels show it.
    EXPECT_NEAR(value_at_the_line(false), 0.5 * 0.25, 0.012);
    EXPECT_NEAR(value_at_the_line(true), value_at_the_line(false), 2e-3);
}

// All directions in turn make the cosine-weighted occlusion, (1 - cos 45 degrees) / 2.
TEST_F(Separable, AllPairsOfDirectionsAreTheHemisphere) {
    Settings settings = settings_for("separable", 0.5F);
    settings.bias = 1e-5F;
    settings.samples = 64;
    settings.samples_converged = 64;
    settings.weight_max = 8192.0F;
    settings.own.epsilon = 1e-3F;  // nothing is carried
    const Frame frame = run(groove({129, 129}), settings, 16);
    EXPECT_NEAR(frame.occlusion[129 * 64 + 64], 0.146447, 0.03);
}

// Whether the 3 x 3 small pixels around a pixel's own differ by more than the tolerance.
bool disagrees(const std::vector<float>& full, glm::ivec2 size, glm::ivec2 pixel, float tolerance) {
    float low = 1.0F;
    float high = 0.0F;
    for (int y = pixel.y / 2 - 1; y <= pixel.y / 2 + 1; ++y) {
        for (int x = pixel.x / 2 - 1; x <= pixel.x / 2 + 1; ++x) {
            if (x < 0 || y < 0 || 2 * x >= size.x || 2 * y >= size.y) continue;
            const float value = full[static_cast<std::size_t>(2 * y * size.x + 2 * x)];
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    return high - low > tolerance;
}

// Pixels of the small image have hbao's result, and so has every pixel whose neighbourhood disagrees.
TEST_F(DualResolution, IsHbaoWhereItIsNotInterpolated) {
    for (const glm::ivec2 size : {glm::ivec2(64, 36), glm::ivec2(63, 37)}) {
        const scene::GBuffer view =
            drawn("corner", {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)});
        Settings settings = settings_for("hbao", 1.0F);
        settings.c_rot = 0.0F;
        const std::vector<float> full = run(view, settings).occlusion;
        for (const float tolerance : {0.0F, 0.05F, 1.0F}) {
            settings.method = "dual_resolution";
            settings.own.disagreement = tolerance;
            const std::vector<float> dual = run(view, settings).occlusion;
            int in_full = 0;
            int interpolated = 0;
            double off = 0.0;
            for (int i = 0; i < size.x * size.y; ++i) {
                const glm::ivec2 pixel(i % size.x, i / size.x);
                const auto index = static_cast<std::size_t>(i);
                const bool small = pixel.x % 2 == 0 && pixel.y % 2 == 0;
                if (small || disagrees(full, size, pixel, tolerance)) {
                    EXPECT_EQ(dual[index], full[index]) << pixel.x << ' ' << pixel.y << ' ' << tolerance;
                    in_full += small ? 0 : 1;
                } else {
                    ++interpolated;
                    off += std::abs(double{dual[index]} - double{full[index]});
                }
            }
            EXPECT_EQ(in_full == 0, tolerance == 1.0F);
            EXPECT_GT(std::min(in_full, interpolated), tolerance == 0.05F ? 50 : -1);
            EXPECT_LE(off, 0.02 * interpolated) << tolerance;
        }
    }
}

}  // namespace gloam::effect::preparation_test

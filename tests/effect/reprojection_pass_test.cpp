// SPDX-License-Identifier: MIT
// The pass that moves the history, alone: what it brings to a pixel whose point was between four texels.
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec3.hpp>

#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/temporal.hpp"

namespace gloam::effect::reprojection_pass_test {

constexpr glm::ivec2 size(16, 8);
constexpr float depth_of_all = 2.0F;
constexpr glm::vec2 shift(0.25F, 0.125F);  // texels: fractions that are exact in floats

struct Texel {
    float occlusion = 0.0F;
    float weight = 0.0F;
    float index = 0.0F;
    float depth = depth_of_all;

    friend bool operator==(const Texel&, const Texel&) = default;
};

using Texels = std::vector<Texel>;

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y * size.x + x);
}

// Different everywhere, so that a texel that was mistaken for another shows.
Texels different() {
    Texels texels;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const auto i = static_cast<float>(at(x, y));
            texels.push_back(
                {.occlusion = i / 128.0F, .weight = 1.0F + i, .index = static_cast<float>(3 * x + 64 * y)});
        }
    }
    return texels;
}

Settings with_taps(HistoryTaps taps) {
    Settings settings;
    settings.taps = taps;
    return settings;
}

// The pass on images of that size.
class ReprojectionPass : public OnDevice<testing::Test> {
  protected:
    // The history of a wall that a parallel camera has moved along by `shift`.
    [[nodiscard]] Texels moved(const Texels& before, const Settings& settings, float tolerance = 0.1F) const {
        const glm::vec2 p00_p11(1.0F, -1.0F);
        const glm::vec2 step = 2.0F * shift / (glm::vec2(size) * p00_p11);  // view space
        Values values = values_of(Moment{.settings = settings});            // its cameras are orthographic
        values.set("previous_from_current", glm::translate(glm::mat4(1.0F), {step.x, step.y, 0.0F}));
        values.set("p00_p11", p00_p11);
        values.set("previous_p00_p11", p00_p11);
        values.set("size", size);
        values.set("depth_tolerance", tolerance);
        const gpu::Extent extent{static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
        using enum gpu::Format;
        Resources resources(device_);
        resources.image("depth", extent, r32f).upload(std::vector<float>(before.size(), depth_of_all));
        std::vector<float> words;
        for (const Texel& t : before) words.insert(words.end(), {t.occlusion, t.weight, t.index, t.depth});
        resources.image("before", extent, rgba32f).upload(words);
        const gpu::Image& after = resources.image("after", extent, rgba32f);
        Executor(device_, passes_)
            .run("reproject", {.file = "study/reproject.comp"}, {"depth", nothing_image, "before", "after"},
                 values, groups_for(extent), resources, {});
        Texels moved;
        const std::vector<float> got = after.download();
        for (std::size_t i = 0; i < got.size(); i += 4)
            moved.push_back({got[i], got[i + 1], got[i + 2], got[i + 3]});
        return moved;
    }

    // The bilinear mean of a member at the place between (x, y) and its three neighbours.
    [[nodiscard]] static double mean_at(const Texels& texels, int x, int y, float Texel::* member) {
        const double u = double{shift.x};
        const double v = double{shift.y};
        const auto value = [&](int i, int j) { return double{texels[at(x + i, y + j)].*member}; };
        return (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0)) +
               v * ((1 - u) * value(0, 1) + u * value(1, 1));
    }
};

TEST_F(ReprojectionPass, InterpolatesOcclusionAndWeightAndTakesTheIndexOfTheNearest) {
    const Texels before = different();
    const Texels after = moved(before, {});
    for (int y = 0; y + 1 < size.y; ++y) {
        for (int x = 0; x + 1 < size.x; ++x) {
            const Texel& got = after[at(x, y)];
            EXPECT_NEAR(got.occlusion, mean_at(before, x, y, &Texel::occlusion), 1e-5) << x << ", " << y;
            EXPECT_NEAR(got.weight, mean_at(before, x, y, &Texel::weight), 1e-3) << x << ", " << y;
            EXPECT_EQ(got.index, before[at(x, y)].index) << x << ", " << y;
        }
    }
}

TEST_F(ReprojectionPass, AtTheEdgeOfTheImageTheLastTexelStandsForThoseBeyond) {
    const Texels before = different();
    const Texels after = moved(before, {});
    // The last column that lies inside: its right neighbours are itself.
    for (int y = 0; y + 1 < size.y; ++y) {
        const Texel& own = before[at(size.x - 1, y)];
        const Texel& below = before[at(size.x - 1, y + 1)];
        const double weight = std::lerp(double{own.weight}, double{below.weight}, double{shift.y});
        EXPECT_NEAR(after[at(size.x - 1, y)].weight, weight, 1e-3) << y;
    }
}

TEST_F(ReprojectionPass, TheNearestTexelAloneIsCopied) {
    const Texels before = different();
    EXPECT_EQ(moved(before, with_taps(HistoryTaps::nearest)), before);
}

// Bilinear without a test of its own where the nearest texel passes; nothing where it does not.
TEST_F(ReprojectionPass, BilinearTapsAreValidWhereTheNearestIs) {
    Texels before = different();
    for (int y = 0; y < size.y; ++y) before[at(5, y)].depth = 10.0F * depth_of_all;
    const Texels after = moved(before, with_taps(HistoryTaps::bilinear));
    for (int y = 0; y + 1 < size.y; ++y) {
        EXPECT_EQ(after[at(5, y)].weight, 0.0F) << y;
        EXPECT_NEAR(after[at(4, y)].weight, mean_at(before, 4, y, &Texel::weight), 1e-3) << y;
    }
}

TEST_F(ReprojectionPass, ValidatedTapsLeaveOutAnotherSurface) {
    Texels before = different();
    for (int y = 0; y < size.y; ++y) before[at(5, y)].depth = 10.0F * depth_of_all;
    const Texels after = moved(before, {});
    for (int y = 0; y + 1 < size.y; ++y) {
        const double v = double{shift.y};
        const double left =
            (1 - v) * double{before[at(4, y)].weight} + v * double{before[at(4, y + 1)].weight};
        const double right =
            (1 - v) * double{before[at(6, y)].weight} + v * double{before[at(6, y + 1)].weight};
        EXPECT_NEAR(after[at(4, y)].weight, left, 1e-3) << y;
        EXPECT_NEAR(after[at(5, y)].weight, right, 1e-3) << y;
    }
}

TEST_F(ReprojectionPass, AFieldThatIsTheSameEverywhereStaysSo) {
    const Texel everywhere{.occlusion = 0.3F, .weight = 7.0F, .index = 41.0F};
    const Texels before(static_cast<std::size_t>(size.x * size.y), everywhere);
    for (const Texel& got : moved(before, {})) {
        EXPECT_NEAR(got.occlusion, everywhere.occlusion, 1e-6);
        EXPECT_EQ(got.index, everywhere.index);
    }
}

// What the samples' pass does to a history where surfaces have moved (TSSAO-9).

constexpr gpu::Extent extent{24, 16};
constexpr std::size_t pixels = 24 * 16;
constexpr std::size_t left_of_the_step = 8 * 24 + 11;
constexpr float samples_before = 8.0F;

bool is_right(std::size_t pixel) {
    return pixel % extent.width >= extent.width / 2;
}

Settings settings() {
    Settings all = with_radius(with_method({}, "hemisphere"), 1.0F);
    all.samples = all.samples_converged = 8;
    all.filter = Filter::none;
    return all;
}

// A wall whose right half stands further in front, with a history everywhere.
class WatchingPass : public OnDevice<testing::Test> {
  protected:
    // Weights of the history after a frame, whose camera stands still. displacement: of the pixel's point.
    template <class Displacement>
    [[nodiscard]] std::vector<float> weights(const Displacement& displacement) const {
        using enum gpu::Format;
        const View view{scene::make_frame({}, 1.5), extent, {}};
        Moment moment{.settings = settings(), .has_positions = true};
        moment.view = view;
        std::vector<float> depths;
        std::vector<float> history;
        std::vector<glm::vec3> places;
        const reference::GloamCamera camera{view.camera.p00_p11(), vector_of_size(extent), false};
        for (std::size_t i = 0; i < pixels; ++i) {
            depths.push_back(is_right(i) ? 4.7F : 5.0F);
            history.insert(history.end(), {0.25F, samples_before, samples_before, depths.back()});
            const glm::ivec2 pixel(i % extent.width, i / extent.width);
            places.emplace_back(reference::gloam_camera_position(pixel, double{depths.back()}, camera) +
                                displacement(i));
        }
        Resources resources(device_);
        resources.image("depth", extent, r32f).upload(depths);
        resources.image("normal", extent, rgba32f)
            .upload(texels_of(std::vector(pixels, glm::vec3(0.0F, 0.0F, 1.0F))));
        resources.image("before", extent, rgba32f).upload(history);
        resources.image("places", extent, rgba32f).upload(texels_of(places));
        resources.buffer("method", sizeof(MethodValues)).as<MethodValues>()[0] = settings().own;
        const gpu::Image& after = resources.image("after", extent, rgba32f);
        Executor(device_, passes_)
            .run("ambient_occlusion", occlusion_source(moment),
                 {"depth", "normal", "before", "after", "places", "method", nothing_image, nothing_image,
                  nothing_image},
                 values_of(moment), groups_for(extent), resources, {});
        return channel(after.download(), 1);
    }
};

const std::vector<float> all_kept(pixels, samples_before + 8.0F);

TEST_F(WatchingPass, WhatHasNotMovedKeepsItsHistory) {
    EXPECT_EQ(weights([](std::size_t) { return glm::dvec3(0.0); }), all_kept);
}

TEST_F(WatchingPass, WhatHasMovedTogetherKeepsItsHistory) {
    EXPECT_EQ(weights([](std::size_t) { return glm::dvec3(0.3, -0.1, 0.2); }), all_kept);
}

TEST_F(WatchingPass, WhatIsNearSomethingThatMovedLosesSome) {
    const auto right_half = [](std::size_t i) { return glm::dvec3(0.0, 0.0, is_right(i) ? 0.3 : 0.0); };
    const std::vector<float> found = weights(right_half);
    EXPECT_LT(found[left_of_the_step], 0.8F * all_kept[0]);
    EXPECT_EQ(found[8 * extent.width], all_kept[0]) << "further away than the radius";
}

}  // namespace gloam::effect::reprojection_pass_test

// SPDX-License-Identifier: MIT
// The frame of three short passes: as right as the presets, on every camera, size and encoding.
#include "effect/internal/frame.hpp"
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "reference/shading.hpp"
#include "surface_views.hpp"

namespace gloam::effect::frame_test {

constexpr backend::Extent odd{83, 45};

class Frames : public OnDevice<testing::TestWithParam<Preset>> {
  protected:
    [[nodiscard]] Frame frame(const scene::GBuffer& view, double radius) const {
        const Settings settings = with_radius(GetParam().settings, static_cast<float>(radius));
        return run(view, with(settings, "output=r32f history=off bent_normals=on"));
    }
};

// The mean of a noisy frame is that of the study's sweep with many slices, and follows the radius.
TEST_P(Frames, EstimateWhatTheSweepEstimates) {
    const Settings many = with({}, "method=sweep history=off filter=none c_rot=2 steps=16 samples=1024");
    const scene::GBuffer& view = drawn("columns", {192, 108});
    for (const double radius : {1.0, 0.4}) {
        const Truth limit =
            truth_from(view, run(view, with_radius(many, static_cast<float>(radius))).filtered);
        const Errors errors = errors_of(frame(view, radius).filtered, limit);
        EXPECT_LT(errors.rmse, 0.08);
        EXPECT_LT(std::abs(errors.bias), 0.02);
    }
}

// A bare plane is open, at any tilt and to the image's edge, up to the rounding of depth to 16 bits.
TEST_P(Frames, APlaneIsOpen) {
    for (const bool orthographic : {false, true})
        for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), {0.6, 0.3, 1}, {-0.4, 0.9, 1}}) {
            scene::GBuffer view = plane(odd, orthographic, normal);
            const Frame open = frame(view, 0.2);
            const std::vector<float>& shown = open.filtered;
            EXPECT_LE(std::ranges::max(shown), 0.02F) << orthographic << ' ' << normal.x;
            EXPECT_LE(mean_of(shown), 0.005) << orthographic << ' ' << normal.x;
            for (std::size_t i = 0; i < shown.size(); ++i)
                ASSERT_LT(glm::length(open.bent[i]), 0.03F) << orthographic << ' ' << i;
            view.normal.clear();
            EXPECT_LE(std::ranges::max(frame(view, 0.2).filtered), 0.02F) << orthographic << ' ' << normal.x;
        }
}

// At the sides of an image, too, where most taps of a large radius would stand outside.
TEST_P(Frames, APlaneIsOpenAtTheSides) {
    for (const glm::dvec3 normal : {glm::dvec3(0, 1, 0.4), {0, -1, 0.4}, {1, 0, 0.4}, {-1, 0, 0.4}}) {
        const scene::GBuffer view = plane({321, 179}, false, normal);
        EXPECT_LE(mean_of(frame(view, 1.0).filtered), 1e-4) << normal.x << ' ' << normal.y;
    }
}

// What is stored differs in rounding alone from what is eye-linear, and background is background. Normals
// from depth are those of the surface but at its silhouettes.
TEST_P(Frames, TakeWhatEnginesStore) {
    for (const Engine& engine : engines) {
        scene::GBuffer view = drawn(seen_by(engine), odd);
        view.depth[5] = std::numeric_limits<float>::infinity();
        const std::vector<float> expected = frame(view, 0.5).filtered;
        store(engine, view);
        view.depth.assign(view.depth.size(), 1.0F);
        const std::vector<float> shown = frame(view, 0.5).filtered;
        EXPECT_LT(errors_of(shown, expected).rmse, 0.002)
            << engine.depth << engine.depth_bits << ' ' << engine.normals << ' ' << engine.before_near;
        EXPECT_GT(mean_of(expected), 0.01) << engine.depth << ' ' << engine.normals;
        view.normal.clear();
        view.stored->normal.clear();
        EXPECT_LT(errors_of(frame(view, 0.5).filtered, expected).rmse, 0.012)
            << engine.depth << engine.depth_bits << ", normals from depth";
    }
}

// An image whose axis is not in its middle shows that part of the larger image.
TEST_P(Frames, AnOffCentreViewIsAPartOfACentredOne) {
    for (const Engine& engine : engines) {
        scene::GBuffer view = drawn(seen_by(engine), {96, 64});
        const std::vector<float> whole = frame(view, 0.25).filtered;
        view.border.right = 30;
        view.border.bottom = 20;
        const scene::GBuffer window = scene::cropped(view);
        std::vector<float> part = scene::cropped(view, whole);
        const std::vector<float> shown = frame(window, 0.25).filtered;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const bool cut = i % window.extent.width > 45 || i / window.extent.width > 23;
            if (cut) part[i] = std::numeric_limits<float>::quiet_NaN();
        }
        EXPECT_LT(errors_of(shown, part).rmse, 0.002) << engine.depth << ' ' << engine.normals;
    }
}

// Of a point beside a wall half the hemisphere is open. Bent normals, and light that bounces, change
// nothing of what the passes estimate.
TEST_P(Frames, HaveBentNormalsAndBounces) {
    const scene::GBuffer view = step(2.8F, 3.0F, close);
    const Frame shown = frame(view, 1.0);
    const glm::vec3 open = glm::normalize(glm::vec3(2.0 / std::numbers::pi, 0.0, 1.0));  // by the cosine
    EXPECT_LT(glm::distance(glm::normalize(view.normal[beside] + shown.bent[beside]), open), 0.2F);
    const std::vector<float> brighter =
        run(view, with(GetParam().settings, "output=r32f history=off bounce_albedo=0.5")).filtered;
    for (std::size_t i = 0; i < brighter.size(); ++i)
        ASSERT_NEAR(brighter[i],
                    1.0 - reference::gloam_multi_bounce(double{shown.filtered[i]}, glm::dvec3(0.5)).x, 1e-5);
}

// Tiles of background are left out on a CPU's driver: after frames in which they were, and in which they were
// not, and after another size whose texels are as many.
TEST_P(Frames, TilesThatAreLeftOutChangeNoPixel) {
    const Settings settings = with(GetParam().settings, "radius=0.6 history=off");
    const Settings all = with(settings, "skips=off");
    std::vector<scene::GBuffer> views;
    for (const char* name : {"sky", "columns", "sky", "far", "sky"}) views.push_back(drawn(name, odd));
    for (const bool first : {false, true})
        for (const bool rows : {false, true}) {  // and one half of the image is background
            views.push_back(drawn("columns", odd));
            for (std::uint32_t i = 0; i < odd.width * odd.height; ++i) {
                const bool before = rows ? i / odd.width < odd.height / 2 : i % odd.width < odd.width / 2;
                if (before == first) views.back().depth[i] = infinity;
            }
        }
    AmbientOcclusion effect(device_, passes_);
    const auto shown = [&](const scene::GBuffer& view, const Settings& chosen) {
        effect.begin(view, chosen);
        return effect.next().filtered;
    };
    const auto expect_same = [&](const scene::GBuffer& view, bool skips_first) {
        const std::vector<float> one = shown(view, skips_first ? settings : all);
        EXPECT_TRUE(same_bits(one, shown(view, skips_first ? all : settings), view.extent.width));
    };
    for (std::size_t i = 0; i < views.size(); ++i) expect_same(views[i], i % 2 == 0);
    const scene::GBuffer& twice = drawn("columns", {2 * odd.width, 2 * odd.height});
    (void)shown(drawn("sky", odd), with(settings, "resolution=full"));
    effect.advance(twice);
    expect_same(twice, true);
}

// Of 11 x 6 tiles: all in the first frame, then those with a surface in them. A group makes 2 in full, 8 at
// half size.
TEST_P(Frames, BackgroundIsSweptOnce) {
    if (device_.info().type != "cpu") GTEST_SKIP() << "only a CPU's driver has a list of tiles";
    scene::GBuffer view = drawn("columns", odd);
    for (std::uint32_t i = 0; i < odd.width * odd.height; ++i)
        if (i % odd.width >= 32) view.depth[i] = infinity;
    AmbientOcclusion effect(device_, passes_);
    std::vector<std::uint32_t> swept;
    effect.watch([&](const Step& pass, bool after) {
        if (!after && pass.name == "sweep")
            swept.push_back(pass.groups_from->as<std::uint32_t>()[pass.groups_at / 4]);
    });
    const Settings settings = with(GetParam().settings, "radius=0.6 history=off");
    effect.begin(view, settings);
    for (int i = 0; i < 2; ++i) (void)effect.next();
    const bool full = settings.resolution == Resolution::full;
    EXPECT_EQ(swept, full ? (std::vector{33U, 12U}) : (std::vector{9U, 3U}));
}

// A view that stands still is taken no more taps of, until something enters it; then it settles again.
TEST_P(Frames, ASettledViewStaysUntilSomethingMoves) {
    constexpr int settled = 68;
    const scene::GBuffer empty = drawn("columns", odd);
    scene::GBuffer entered = empty;
    for (std::uint32_t y = 20; y < 30; ++y)
        for (std::uint32_t x = 40; x < 50; ++x) entered.depth[y * odd.width + x] *= 0.9F;
    const auto standing = [&](const scene::GBuffer& view) {
        return std::vector<scene::GBuffer>(settled, view);
    };
    std::vector<scene::GBuffer> views = standing(empty);
    views.insert(views.end(), settled, entered);
    const Settings settings = with(GetParam().settings, "radius=0.5 bent_normals=on");
    const std::vector<Frame> frames = run(views, settings);
    const auto differ = [&](std::size_t one, std::size_t other) {
        return largest_difference(frames[one].filtered, frames[other].filtered);
    };
    EXPECT_GT(differ(settled - 8, settled - 5), 0.0);
    EXPECT_EQ(differ(settled - 2, settled - 1), 0.0);
    EXPECT_EQ(frames[settled - 2].bent, frames[settled - 1].bent);
    EXPECT_GT(differ(settled - 1, settled), 0.01) << "what enters is seen at once";
    EXPECT_GT(differ(settled + 1, settled + 4), 0.0);
    EXPECT_EQ(differ(2 * settled - 2, 2 * settled - 1), 0.0);
    const std::vector<float> anew = run(standing(entered), settings).back().filtered;
    EXPECT_LT(errors_of(frames.back().filtered, anew).rmse, 0.01);
}

// To the bit, whatever the device's memory holds from frames before.
TEST_P(Frames, AFirstFrameIsAlwaysTheSame) {
    const scene::GBuffer& view = drawn("columns", odd);
    const Settings settings = with(GetParam().settings, "output=r32f");
    const std::vector<float> first = run(view, settings).filtered;
    (void)run(std::vector<scene::GBuffer>(3, drawn("room", odd)), settings);
    EXPECT_TRUE(same_bits(first, run(view, settings).filtered, odd.width));
}

INSTANTIATE_TEST_SUITE_P(Names, Frames, testing::ValuesIn(frames_of_all_resolutions()), preset_name);

}  // namespace gloam::effect::frame_test

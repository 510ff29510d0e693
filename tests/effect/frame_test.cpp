// SPDX-License-Identifier: MIT
// The frame of three short passes: as right as the presets, on every camera, size and encoding.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "support/poison.hpp"
#include "surface_views.hpp"

namespace gloam::effect::frame_test {

constexpr gpu::Extent odd{83, 45};

class Frames : public OnDevice<testing::TestWithParam<Preset>> {
  protected:
    [[nodiscard]] Frame frame(const scene::GBuffer& view, double radius) const {
        Settings exact = GetParam().settings;
        exact.radius = static_cast<float>(radius);
        exact.output = OutputFormat::r32f;
        exact.history = false;
        return run(view, exact);
    }
};

// The mean of a noisy frame is that of the same method with many slices, and follows the radius.
TEST_P(Frames, EstimateWhatTheSweepEstimates) {
    const scene::GBuffer& view = drawn("columns", {192, 108});
    for (const double radius : {1.0, 0.4}) {
        const Truth limit = truth_from(view, run(view, many_slices(static_cast<float>(radius))).filtered);
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
            const std::vector<float> shown = frame(view, 0.2).filtered;
            EXPECT_LE(std::ranges::max(shown), 0.02F) << orthographic << ' ' << normal.x;
            EXPECT_LE(mean_of(shown), 0.005) << orthographic << ' ' << normal.x;
            view.normal.clear();
            EXPECT_LE(std::ranges::max(frame(view, 0.2).filtered), 0.02F) << orthographic << ' ' << normal.x;
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

TEST_P(Frames, PoisonedDepthStaysInRange) {
    scene::GBuffer view = drawn("columns", odd);
    test::poison(view);
    const std::vector<float> shown = frame(view, 1.0).filtered;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        ASSERT_TRUE(shown[i] >= 0.0F && shown[i] <= 1.0F) << i << ": " << shown[i];
        if (i % 7 == 0) {
            EXPECT_EQ(shown[i], 0.0F) << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Names, Frames, testing::ValuesIn(own_presets()), preset_name);

}  // namespace gloam::effect::frame_test

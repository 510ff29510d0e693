// SPDX-License-Identifier: MIT
// Views rendered larger than the frame: the pixels of the frame look along the same rays.
#include "scene/guard_band.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "scene/pixel_positions.hpp"
#include "scene/rasterize.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace guard_band_test {

constexpr gpu::Extent frame{160, 90};

class GuardBand : public gpu::test::GpuTest {
  protected:
    GBuffer shot(const Scene& scene, double guard, int number = 0, bool motion = false) {
        return rasterize(device(), passes_, scene, frame,
                         {.frame = number, .motion = motion, .ids = motion, .guard = guard});
    }

    [[nodiscard]] const PassLibrary& passes() const { return passes_; }

  private:
    static std::filesystem::path cache() {
        const char* directory = std::getenv("GLOAM_CACHE_DIR");
        return directory == nullptr ? "" : directory;
    }
    PassLibrary passes_{GLOAM_GLSL_DIR, cache()};
};

TEST(GuardBorder, IsWholePixelsOfEachSide) {
    EXPECT_EQ(guard_border({640, 360}, 0.1), (gpu::Extent{64, 36}));
    EXPECT_EQ(guard_border({33, 47}, 0.05), (gpu::Extent{2, 2}));  // 1.65 and 2.35
    EXPECT_EQ(guard_border({5, 4}, 0.1), (gpu::Extent{1, 0}));     // one half is rounded up
    EXPECT_EQ(guard_border({640, 360}, 0.0), gpu::Extent{});
    EXPECT_EQ(with_border({640, 360}, {64, 36}), (gpu::Extent{768, 432}));
    for (const double bad : {-0.01, 0.51, std::numeric_limits<double>::quiet_NaN()})
        expect_error<std::invalid_argument>([&] { (void)guard_border(frame, bad); }, {"guard", "0 to 0.5"});
}

TEST(GuardBorder, ThatLeavesNoFrameIsAnError) {
    for (const gpu::Extent border : {gpu::Extent{4, 0}, gpu::Extent{0, 3}, gpu::Extent{0xFFFFFFFF, 0}}) {
        const GBuffer view{.extent = {8, 6}, .border = border};
        expect_error<std::invalid_argument>([&] { (void)frame_of(view); }, {"guard band", "no frame"});
    }
}

// In the projections' own numbers: the pixel centres of the frame are those of the plain view.
TEST(GuardBorder, InnerPixelsLookAlongTheSameRays) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.projection = projection};
        for (const double guard : {0.05, 0.1, 0.37, 0.5}) {
            const gpu::Extent border = guard_border(frame, guard);
            const gpu::Extent wide = with_border(frame, border);
            const double aspect = static_cast<double>(frame.width) / frame.height;
            const double wide_aspect = static_cast<double>(wide.width) / wide.height;
            const GBuffer plain{.extent = frame, .camera = make_frame(camera, aspect)};
            const GBuffer view{.extent = wide,
                               .camera = make_frame(with_border(camera, frame, border), wide_aspect),
                               .border = border};
            for (const auto& [x, y] : {std::pair{0U, 0U}, std::pair{159U, 89U}, std::pair{31U, 77U}}) {
                const std::size_t inner = y * frame.width + x;
                const std::size_t outer = (y + border.height) * wide.width + x + border.width;
                const glm::dvec3 seen = PixelPositions(view).at(outer, 3.0);
                EXPECT_LT(glm::distance(seen, PixelPositions(plain).at(inner, 3.0)), 1e-6) << guard;
                EXPECT_LT(glm::distance(seen, PixelPositions(cropped(view)).at(inner, 3.0)), 1e-6) << guard;
            }
        }
    }
}

TEST_F(GuardBand, NoneChangesNothing) {
    const Scene scene = make_scene("moving");
    const GBuffer plain = rasterize(device(), passes(), scene, frame, {.frame = 3, .motion = true});
    const GBuffer view = shot(scene, 0.0, 3, true);
    EXPECT_EQ(view.border, gpu::Extent{});
    EXPECT_EQ(view.depth, plain.depth);
    EXPECT_EQ(view.motion, plain.motion);
    EXPECT_EQ(cropped(view).depth, plain.depth);
}

// The device rounds vertices to a part of a pixel, not to the same one in both views: at silhouettes a few
// pixels see the other surface.
TEST_F(GuardBand, TheFrameIsThatOfThePlainView) {
    for (const char* name : {"moving", "columns", "far"}) {
        const Scene scene = make_scene(name);
        const GBuffer plain = shot(scene, 0.0, 2, true);
        const GBuffer view = shot(scene, 0.1, 2, true);
        EXPECT_EQ(view.border, (gpu::Extent{16, 9}));
        EXPECT_EQ(view.extent, (gpu::Extent{192, 108}));
        const GBuffer inner = cropped(view);
        ASSERT_EQ(inner.extent, frame);
        std::size_t same = 0;
        std::size_t surface = 0;
        for (std::size_t i = 0; i < plain.depth.size(); ++i) {
            if (std::isinf(plain.depth[i])) continue;
            ++surface;
            const bool close = std::abs(inner.depth[i] - plain.depth[i]) < 1e-4F * plain.depth[i] &&
                               glm::distance(inner.normal[i], plain.normal[i]) < 1e-3F &&
                               glm::distance(inner.motion[i], plain.motion[i]) < 2e-2F &&
                               inner.object[i] == plain.object[i];
            same += close ? 1 : 0;
        }
        EXPECT_GT(static_cast<double>(same), 0.995 * static_cast<double>(surface)) << name;
    }
}

TEST_F(GuardBand, MotionOutOfTheBandIsNoneForTheFrame) {
    GBuffer view{.extent = {6, 4}, .border = {1, 1}};
    view.depth.assign(24, 1.0F);
    view.motion.assign(24, glm::vec3(1.0F, 0.0F, 1.0F));  // what is now in the first column was in the band
    const GBuffer inner = cropped(view);
    for (std::size_t i = 0; i < inner.motion.size(); ++i)
        EXPECT_EQ(inner.motion[i].z, i % 4 == 0 ? 0.0F : 1.0F) << i;
}

}  // namespace guard_band_test
}  // namespace gloam::scene::test

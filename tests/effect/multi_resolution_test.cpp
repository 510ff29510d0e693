// SPDX-License-Identifier: MIT
// MSSAO on its real passes: what its coarser resolutions see, and how they are combined.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect {
namespace multi_resolution_test {

Settings settings_of(float radius) {
    return with_radius(with_method(preset_named("paper").settings, "mssao"), radius);
}

class MultiResolution : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] Frame run(const scene::GBuffer& view, const Settings& settings, int frames = 1) const {
        AmbientOcclusion& effect = effect_for(view.extent);
        effect.begin(view, settings);
        for (int i = 1; i < frames; ++i) (void)effect.next();
        return effect.next();
    }
};

// A block stands 20 pixels from the middle, beyond the reach of the finest kernel alone.
TEST_F(MultiResolution, CoarserLevelsReachFurther) {
    scene::GBuffer view = view_of({129, 65}, true, [](glm::dvec2 at) { return at.x > 0.62 ? 4.6 : 5.0; });
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    Settings settings = settings_of(0.9F);
    std::vector<float> at_the_middle;
    for (const std::uint32_t resolutions : {1U, 2U, 3U, 4U, 5U, 9U}) {
        settings.own.steps = resolutions;
        at_the_middle.push_back(run(view, settings, 8).occlusion[129 * 32 + 64]);
    }
    EXPECT_EQ(at_the_middle[0], 0.0F);
    EXPECT_EQ(at_the_middle[1], 0.0F);  // 12 pixels
    EXPECT_GT(at_the_middle[2], 0.004F);
    EXPECT_GT(at_the_middle[4], 0.004F);
}

// What one resolution sees of a surface is combined with nothing: 1 - (1 - x)^2, x being the mean
// contribution.
TEST_F(MultiResolution, OneLevelIsItsOwnMaximumAndMean) {
    const double slope = 0.5;
    scene::GBuffer view =
        view_of({65, 65}, true, [&](glm::dvec2 at) { return 5.0 - slope * std::abs(at.x); });
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    Settings settings = settings_of(0.15F);  // 5 pixels
    settings.bias = 0.0F;
    settings.own.steps = 1;
    settings.samples = 256;
    settings.samples_converged = 256;
    settings.weight_max = 1e6F;
    const double found = double{run(view, settings, 16).occlusion[65 * 32 + 32]};
    // The mean over all places in the disc, each read at its pixel's centre.
    const double pixel = 2.0 / 65.0;
    double sum = 0.0;
    int count = 0;
    for (double y = -0.15; y < 0.15; y += 0.0005) {
        for (double x = -0.15; x < 0.15; x += 0.0005) {
            if (x * x + y * y > 0.15 * 0.15) continue;
            const glm::dvec2 at = pixel * glm::round(glm::dvec2(x, y) / pixel);
            const glm::dvec3 v(at, slope * std::abs(at.x));
            const double d = glm::length(v);
            sum += d > 0.0 ? std::max(1.0 - d * d / (0.15 * 0.15), 0.0) * v.z / d : 0.0;
            ++count;
        }
    }
    const double x = sum / count;
    EXPECT_NEAR(found, 1.0 - (1.0 - x) * (1.0 - x), 0.005);
}

// A valley in the middle of images of sizes that do and do not halve: its occlusion stays in the middle.
TEST_F(MultiResolution, NothingDriftsWithTheLevels) {
    for (const std::uint32_t width : {64U, 63U, 61U, 67U}) {
        const gpu::Extent extent{width, 31};
        scene::GBuffer view = view_of(extent, true, [](glm::dvec2 at) { return 5.0 - 0.6 * std::abs(at.x); });
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            const double side = 2.0 * static_cast<double>(i % width) + 1.0 - width;
            view.normal.emplace_back(glm::normalize(glm::dvec3(-0.6 * glm::sign(side), 0, 1)));
        }
        Settings settings = settings_of(0.8F);
        settings.own.range = 1.0F;
        const Frame frame = run(view, settings, 16);
        double sum = 0.0;
        double moment = 0.0;
        for (unsigned y = 10; y < 21; ++y) {
            for (unsigned x = 0; x < width; ++x) {
                const double value = double{frame.occlusion[width * y + x]};
                sum += value;
                moment += value * (x + 0.5 - 0.5 * width);
            }
        }
        EXPECT_GT(sum / (11.0 * width), 0.02);
        EXPECT_LT(std::abs(moment / sum), 0.25) << width;  // pixels
    }
}

// A square post of 2 x 2 pixels is a texel of level 1, and no surface of a 4 x 4 block. Around the middle are
// none nearer than the 6 pixels of the finest kernel: level 1 alone sees them. y being what it sees, two
// resolutions have the largest y and the mean y / 2, three y and y / 3.
TEST_F(MultiResolution, OneOfThreeLevelsIsAThirdOfTheMean) {
    const gpu::Extent extent{132, 68};
    scene::GBuffer view = view_of(extent, true, [](glm::dvec2) { return 5.0; });
    for (unsigned y = 0; y < extent.height; ++y) {
        for (unsigned x = 0; x < extent.width; ++x) {
            const int from_middle =
                std::max(std::abs(static_cast<int>(x) - 66), std::abs(static_cast<int>(y) - 34));
            if (x % 4 < 2 && y % 4 < 2 && from_middle > 8) view.depth[extent.width * y + x] = 4.5F;
        }
    }
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    Settings settings = settings_of(0.9F);
    std::vector<double> found{0.0};
    for (const std::uint32_t resolutions : {1U, 2U, 3U}) {
        settings.own.steps = resolutions;
        found.push_back(double{run(view, settings, 8).occlusion[extent.width * 34 + 66]});
    }
    EXPECT_EQ(found[1], 0.0);
    const double y = 1.5 - std::sqrt(2.25 - 2.0 * found[2]);  // 1 - (1 - y) (1 - y / 2)
    EXPECT_GT(y, 0.03);
    EXPECT_NEAR(found[3], 1.0 - (1.0 - y) * (1.0 - y / 3.0), 1e-3);
}

// One pixel of each block of four is far away. The blocks' surfaces are the plane of the others, and have the
// radius that the cap leaves at its depth, not that of the far pixel.
TEST_F(MultiResolution, TheCapOfACoarserLevelIsThatOfItsSurface) {
    const gpu::Extent extent{132, 68};
    const float tan_half = 1.0F / view_of(extent, false, [](glm::dvec2) { return 1.0; }).camera.p00_p11().y;
    scene::GBuffer view = view_of(extent, false, [](glm::dvec2 at) { return at.x > 0.05 ? 0.9 : 1.0; });
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    for (unsigned y = 1; y < extent.height; y += 2)
        for (unsigned x = 1; x < extent.width; x += 2) view.depth[extent.width * y + x] = 20.0F;
    Settings settings = settings_of(0.4F);
    settings.own.steps = 2;
    Settings capped = settings;
    capped.radius = 2.0F;
    capped.radius_cap = 0.4F * 34.0F / std::abs(tan_half);  // pixels of 0.4 at depth 1
    const Frame want = run(view, settings, 4);
    const Frame found = run(view, capped, 4);
    double largest = 0.0;
    for (unsigned y = 0; y < extent.height; y += 2) {
        for (unsigned x = 0; x < 66; x += 2) {
            const std::size_t pixel = extent.width * y + x;
            EXPECT_NEAR(found.occlusion[pixel], want.occlusion[pixel], 2e-3) << x << ' ' << y;
            largest = std::max(largest, double{want.occlusion[pixel]});
        }
    }
    EXPECT_GT(largest, 0.02);
}

}  // namespace multi_resolution_test
}  // namespace gloam::effect

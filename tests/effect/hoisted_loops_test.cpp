// SPDX-License-Identifier: MIT
// Passes are compiled so that what a loop does not change is computed before it, and short loops are
// unrolled: the same images, to the bit, as when it is computed in every round.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bits.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "shader/variant.hpp"

namespace gloam::effect {
namespace hoisted_loops_test {

constexpr gpu::Extent odd{83, 45};

// A method of each kind of loop over samples.
class HoistedLoops : public OnDevice<testing::TestWithParam<std::string>> {
  protected:
    // Two frames of a moving scene. converged: samples of a pixel that has; the loops are unrolled where they
    // are as many as all others take.
    [[nodiscard]] std::vector<Frame> frames(const scene::PassLibrary& passes, std::uint32_t converged) const {
        const scene::Scene scene = scene::make_scene("moving");
        Settings settings = with_method(
            with_radius(preset_named("paper").settings, static_cast<float>(scene.ao_radius)), GetParam());
        settings.samples_converged = converged;
        AmbientOcclusion effect(device_, passes, odd);
        effect.begin(scene::rasterize(device_, passes, scene, odd, {.frame = 0}), settings);
        std::vector<Frame> frames{effect.next()};
        effect.advance(scene::rasterize(device_, passes, scene, odd, {.frame = 1}));
        frames.push_back(effect.next());
        return frames;
    }

    void expect_the_same(std::uint32_t converged) const {
        const std::vector<Frame> optimized = frames(passes_, converged);
        const std::vector<Frame> written = frames(passes_.with(shader::Optimization::performance), converged);
        for (std::size_t i = 0; i < optimized.size(); ++i) {
            EXPECT_EQ(bits_of(optimized[i].occlusion), bits_of(written[i].occlusion)) << "frame " << i;
            EXPECT_EQ(bits_of(optimized[i].filtered), bits_of(written[i].filtered)) << "frame " << i;
            EXPECT_EQ(bits_of(optimized[i].kept), bits_of(written[i].kept)) << "frame " << i;
        }
    }
};

TEST_P(HoistedLoops, ChangeNothing) {
    expect_the_same(16);
}

TEST_P(HoistedLoops, ChangeNothingWhereTheyAreUnrolled) {
    expect_the_same(32);
}

INSTANTIATE_TEST_SUITE_P(Methods, HoistedLoops,
                         testing::Values("hemisphere", "alchemy", "sao", "gtao", "hbao", "volumetric",
                                         "poisson", "disc_proxy", "curvature"),
                         [](const auto& asked) { return asked.param; });

}  // namespace hoisted_loops_test
}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
// The setting `resolution` = half beside all others.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "effect/errors.hpp"
#include "effect/settings.hpp"
#include "half_size.hpp"
#include "scene/camera.hpp"

namespace gloam::effect::half_resolution_settings_test {

// Whatever settings there are beside it. The difference to the full size is that of single samples a block.
struct Beside {
    const char* name;
    std::vector<std::pair<const char*, const char*>> settings;
    double most = 0.08;  // root mean square difference of the full size
};

class HalfSizeBeside : public HalfSize, public testing::WithParamInterface<Beside> {
  protected:
    // Three views of a moving scene, with the inputs that the case names.
    [[nodiscard]] std::vector<scene::GBuffer> given(const Settings& settings) const {
        const std::string name = GetParam().name;
        std::vector<scene::GBuffer> all;
        for (int i = 0; i < 3; ++i) {
            all.push_back(view("moving", 20 + i,
                               {.motion = true,
                                .layers = static_cast<int>(settings.layers),
                                .guard = double{settings.guard}}));
            if (name == "no_normals") all.back().normal.clear();
            if (name == "stored")  // as an engine with a depth buffer and world-space normals has it
                all.back().stored =
                    scene::stored_inputs(all.back(), scene::encoding_named("buffer", "world"));
        }
        return all;
    }
};

TEST_P(HalfSizeBeside, IsNearTheFullSize) {
    Settings settings = with_radius(Settings{}, 0.4F);
    settings.samples = 64;
    for (const auto& [name, value] : GetParam().settings) set(settings, name, value);
    const std::vector<scene::GBuffer> all = given(settings);
    const std::vector<Frame> full = run(all, settings);
    settings.resolution = Resolution::half;
    const std::vector<Frame> halved = run(all, settings);
    expect_same_images(halved, run(all, settings));  // twice the same
    for (std::size_t i = 0; i < full.size(); ++i) {
        EXPECT_EQ(halved[i].extent, full[i].extent);
        for (const auto& [image, name] : images_of_frame)
            ASSERT_EQ((halved[i].*image).size(), (full[i].*image).size()) << name;
        for (const float value : halved[i].filtered) ASSERT_TRUE(value >= 0.0F && value <= 1.0F) << value;
        EXPECT_GT(*std::ranges::max_element(halved[i].filtered), 0.05F);
        EXPECT_LT(errors_of(halved[i].filtered, full[i].filtered).rmse, GetParam().most) << "frame " << i;
        EXPECT_GT(errors_of(halved[i].filtered, full[i].filtered).rmse, 0.0) << "frame " << i;
        EXPECT_LT(halved[i].work.samples, full[i].work.samples / 3);
        EXPECT_LT(errors_of(halved[i].occlusion, full[i].occlusion).rmse, 3 * GetParam().most)
            << "frame " << i;
    }
    // And back.
    settings.resolution = Resolution::full;
    expect_same_images(run(all, settings), full, {&Frame::filtered});
}

INSTANTIATE_TEST_SUITE_P(
    Of, HalfSizeBeside,
    testing::Values(
        Beside{"defaults", {}}, Beside{"no_filter", {{"filter", "none"}}},
        Beside{"geometry", {{"filter", "geometry"}}}, Beside{"bilateral", {{"filter", "bilateral"}}},
        Beside{"sao_filter", {{"filter", "sao"}}}, Beside{"alone", {{"filter", "none"}, {"history", "off"}}},
        Beside{"alone_r8", {{"filter", "none"}, {"history", "off"}, {"output", "r8"}}},
        Beside{"remap", {{"remap_b", "0.9"}, {"remap_c", "1.5"}}},
        Beside{"remap_r16f", {{"remap_a", "0.05"}, {"filter", "none"}, {"output", "r16f"}}},
        Beside{"r8", {{"output", "r8"}}}, Beside{"layers", {{"layers", "2"}}},
        Beside{"float16", {{"precision", "float16"}, {"table_size", "2048"}}},
        Beside{"packed", {{"precision", "packed"}, {"filter", "none"}}}, Beside{"guard", {{"guard", "0.1"}}},
        Beside{"guard_unshaded", {{"guard", "0.1"}, {"guard_history", "off"}}}, Beside{"no_normals", {}},
        Beside{"stored", {}}, Beside{"mssao", {{"method", "mssao"}}, 0.2},
        Beside{"dual_resolution", {{"method", "dual_resolution"}}, 0.1},
        Beside{"separable", {{"method", "separable"}}, 0.1},
        Beside{"sao_chain", {{"method", "sao_chain"}}, 0.1}, Beside{"sweep", {{"method", "sweep"}}, 0.1}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace gloam::effect::half_resolution_settings_test

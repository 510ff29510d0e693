// SPDX-License-Identifier: MIT
// What the samples' pass does to a history where surfaces have moved (TSSAO-9).
#include <gtest/gtest.h>

#include <bit>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/tiles.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/compute.hpp"
#include "on_device.hpp"
#include "reference/temporal.hpp"

namespace gloam::effect {
namespace watching_pass_test {

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
    all.sample_table = false;
    all.filter = Filter::none;
    return all;
}

// A wall whose right half stands further in front, with a history everywhere.
class WatchingPass : public OnDevice<testing::Test> {
  protected:
    // Weights of the history after a frame. displacement: of the pixel's point. still: the view has not
    // changed.
    template <class Displacement>
    [[nodiscard]] std::vector<float> weights(const Displacement& displacement, bool still = false) const {
        using enum gpu::Format;
        const View view{scene::make_frame({}, 1.5), extent, {}};
        OcclusionParameters parameters = occlusion_parameters(view, settings());
        parameters.still = still ? 1 : 0;
        Moment moment{.settings = settings(), .has_positions = true, .counting = Counting::each_group};
        moment.view = view;
        gpu::Image depth(device_, extent, r32f);
        gpu::Image normal(device_, extent, rgba32f);
        gpu::Image before(device_, extent, rgba32f);
        gpu::Image displacements(device_, extent, r32ui);
        const gpu::Image after(device_, extent, rgba32f);
        const gpu::Image shown(device_, extent, r32f);
        const gpu::Image nothing(device_, {1, 1}, rgba32f);
        const gpu::Buffer states(device_, 6 * sizeof(TileState));
        const gpu::Buffer lists(device_, 256);
        gpu::Buffer method(device_, sizeof(MethodValues));
        method.as<MethodValues>()[0] = settings().own;
        std::vector<float> depths;
        std::vector<float> normals;
        std::vector<float> history;
        std::vector<float> codes;
        for (std::size_t i = 0; i < pixels; ++i) {
            depths.push_back(is_right(i) ? 4.7F : 5.0F);
            normals.insert(normals.end(), {0.0F, 0.0F, 1.0F, 0.0F});
            history.insert(history.end(), {0.25F, samples_before, samples_before, depths.back()});
            codes.push_back(std::bit_cast<float>(reference::gloam_displacement_to_code(
                displacement(i), double{parameters.displacement_unit})));
        }
        depth.upload(depths);
        normal.upload(normals);
        before.upload(history);
        displacements.upload(codes);
        using enum gpu::BindingKind;
        std::vector<gpu::BindingKind> kinds(12, storage_image);
        for (const std::size_t buffer : {4, 6, 9}) kinds[buffer] = storage_buffer;
        const gpu::ComputePipeline pass = pipeline_of(device_, passes_, occlusion_source(moment), kinds);
        gpu::Commands commands(device_);
        commands.dispatch(pass,
                          std::vector<gpu::Resource>{depth, normal, before, after, states, displacements,
                                                     method, nothing, nothing, lists, shown, nothing},
                          groups_for(extent), std::as_bytes(std::span(&parameters, 1)));
        commands.submit();
        std::vector<float> found;
        const std::vector<float> texels = after.download();
        for (std::size_t i = 0; i < pixels; ++i) found.push_back(texels[4 * i + 1]);
        return found;
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
    EXPECT_EQ(weights(right_half, true), all_kept) << "of an earlier frame";
}

}  // namespace watching_pass_test
}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
// Depth layers in the loops of all methods.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "scene/truth.hpp"
#include "support/method_names.hpp"

namespace gloam::effect {
namespace layers_test {

class Layers : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view_of(const char* name, gpu::Extent extent, int layers) const {
        return scene::rasterize(device_, passes_, scene::make_scene(name), extent, {.layers = layers});
    }

    [[nodiscard]] std::vector<float> occlusion(const scene::GBuffer& view, const Settings& settings,
                                               int frames = 2) const {
        AmbientOcclusion& effect = effect_for(view.extent);
        effect.begin(view, settings);
        Frame frame = effect.next();
        for (int i = 1; i < frames; ++i) frame = effect.next();
        return frame.occlusion;
    }
};

Settings settings_for(const std::string& method, std::uint32_t layers, double radius) {
    Settings settings = with_radius(with_method({}, method), static_cast<float>(radius));
    settings.layers = layers;
    return settings;
}

class LayersOf : public Layers, public testing::WithParamInterface<std::string> {};

// Each can only miss what the others show: the same surface again shows nothing. Compilers may contract the
// first try of a tap in another way than the later ones: Mesa 25 rounds one of 2,583 pixels of tangent_sphere
// to the next number.
TEST_P(LayersOf, TheSameAgainChangesNothing) {
    scene::GBuffer view = view_of("moving", {63, 41}, 1);
    const double radius = scene::make_scene("moving").ao_radius;
    view.layers.clear();
    const auto once = occlusion(view, settings_for(GetParam(), 1, radius));
    view.layers = {view.depth, view.depth, view.depth};
    constexpr float rounding = 0x1p-23F;
    for (const std::uint32_t layers : {1U, 2U, 4U})
        EXPECT_THAT(occlusion(view, settings_for(GetParam(), layers, radius)),
                    testing::Pointwise(testing::FloatNear(rounding), once))
            << layers << " layers";
}

// Behind a bare plane seen at a tilt other planes: nothing of them rises above the first.
TEST_P(LayersOf, WhatLiesBehindAPlaneLeavesItOpen) {
    scene::GBuffer view = view_of("corner", {63, 41}, 1);
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    view.depth.assign(view.depth.size(), 2.0F);
    view.layers.clear();
    for (const float depth : {2.4F, 2.8F, 3.2F}) view.layers.emplace_back(view.depth.size(), depth);
    EXPECT_THAT(occlusion(view, settings_for(GetParam(), 4, 1.0)), testing::Each(0.0F));
}

INSTANTIATE_TEST_SUITE_P(All, LayersOf, testing::ValuesIn(test::method_names()), test::parameter_name);

// A tube before a wall: one layer takes it for as thick as the range, and does not see what it hides.
TEST_F(Layers, WhatATubeHidesIsFoundAgain) {
    const scene::Scene scene = scene::make_scene("knot");
    const scene::GBuffer view = view_of("knot", {96, 54}, 4);
    const Truth truth = truth_from(
        view,
        scene::trace_geometry(scene, 0, view, {.rays = {.radius = scene.ao_radius, .rays = 128}}).occlusion);
    const auto error = [&](std::uint32_t layers) {
        const Settings settings = settings_for("hemisphere", layers, scene.ao_radius);
        return errors_of(occlusion(view, settings, 8), truth).rmse;
    };
    const double one = error(1);
    EXPECT_LT(error(2), 0.4 * one);
    EXPECT_LT(error(3), 0.5 * one);
    EXPECT_LT(error(4), 0.5 * one);
}

TEST_F(Layers, MoreThanTheViewHasAreRefused) {
    const scene::GBuffer view = view_of("corner", {8, 8}, 2);
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings settings;
    settings.layers = 3;
    EXPECT_THAT([&] { effect.begin(view, settings); }, testing::ThrowsMessage<std::invalid_argument>(
                                                           testing::HasSubstr("layers 3: the view has 2")));
    scene::GBuffer uneven = view;
    uneven.layers[0].pop_back();
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
    uneven.layers.assign(4, view.depth);
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
}

}  // namespace layers_test
}  // namespace gloam::effect

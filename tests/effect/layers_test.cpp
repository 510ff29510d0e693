// SPDX-License-Identifier: MIT
// Depth layers in the methods that see them.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "scene/truth.hpp"
#include "support/method_names.hpp"
#include "surface_views.hpp"

namespace gloam::effect::layers_test {

class Layers : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] std::vector<float> occlusion(const scene::GBuffer& view, const Settings& settings,
                                               int frames = 2) const {
        return run(view, settings, frames).occlusion;
    }
};

Settings settings_of_layers(const std::string& method, int layers, double radius) {
    Settings settings = with_radius(with_method({}, method), static_cast<float>(radius));
    settings.own.layers = layers;
    return settings;
}

class LayersOf : public Layers, public testing::WithParamInterface<std::string> {};

// Each can only miss what the others show: the same surface again shows nothing.
TEST_P(LayersOf, TheSameAgainChangesNothing) {
    scene::GBuffer view = drawn("moving", {63, 41}, {.layers = 1});
    const double radius = scene::make_scene("moving").ao_radius;
    view.layers.clear();
    const auto once = occlusion(view, settings_of_layers(GetParam(), 1, radius));
    view.layers = {view.depth, view.depth, view.depth};
    for (const int layers : {1, 4})  // 2 and 3: tests/glsl/method_layers_test.cpp
        EXPECT_EQ(occlusion(view, settings_of_layers(GetParam(), layers, radius)), once)
            << layers << " layers";
}

// Behind a bare plane seen at a tilt other planes: nothing of them rises above the first.
TEST_P(LayersOf, WhatLiesBehindAPlaneLeavesItOpen) {
    scene::GBuffer view = wall({63, 41}, 2.0F);
    for (const float depth : {2.4F, 2.8F, 3.2F}) view.layers.emplace_back(view.depth.size(), depth);
    EXPECT_THAT(occlusion(view, settings_of_layers(GetParam(), 4, 1.0)), Each(0.0F));
}

INSTANTIATE_TEST_SUITE_P(All, LayersOf, testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return reads(method, "layers");
                         })),
                         test::parameter_name);

// A tube before a wall: one layer takes it for as thick as the range, and does not see what it hides.
TEST_F(Layers, WhatATubeHidesIsFoundAgain) {
    const scene::Scene scene = scene::make_scene("knot");
    const scene::GBuffer view = drawn("knot", {96, 54}, {.layers = 4});
    const Truth truth = truth_from(
        view,
        scene::trace_geometry(scene, 0, view, {.rays = {.radius = scene.ao_radius, .rays = 128}}).occlusion);
    const auto error = [&](int layers) {
        const Settings settings = settings_of_layers("hemisphere", layers, scene.ao_radius);
        return errors_of(occlusion(view, settings, 8), truth).rmse;
    };
    const double one = error(1);
    EXPECT_LT(error(2), 0.4 * one);
    EXPECT_LT(error(3), 0.5 * one);
    EXPECT_LT(error(4), 0.5 * one);
}

TEST_F(Layers, MoreThanTheViewHasAreRefused) {
    const scene::GBuffer view = drawn("corner", {8, 8}, {.layers = 2});
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings settings;
    settings.own.layers = 3;
    expect_error<std::invalid_argument>([&] { effect.begin(view, settings); }, {"layers 3: the view has 2"});
    scene::GBuffer uneven = view;
    uneven.layers[0].pop_back();
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
    uneven.layers.assign(4, view.depth);
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
}

}  // namespace gloam::effect::layers_test

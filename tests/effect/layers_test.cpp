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

}  // namespace gloam::effect::layers_test

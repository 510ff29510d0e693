// SPDX-License-Identifier: MIT
#include "effect/further_views.hpp"
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "scene/mesh.hpp"
#include "scene/truth.hpp"
#include "support/method_names.hpp"
#include "surface_views.hpp"

namespace gloam::effect::further_views_test {

constexpr gpu::Extent extent{95, 63};

// A table with a thin top on a floor, seen from straight above: its underside and the floor below it are
// hidden.
scene::Scene table(double azimuth_degrees, double elevation_degrees) {
    scene::Scene scene{.name = "table", .ao_radius = 0.6};
    scene.mesh = scene::make_parallelogram({-3, 0, -3}, {0, 0, 6}, {6, 0, 0}, 0.5);
    append(scene.mesh, scene::make_box({-0.4, 0, -0.4}, {0.4, 1.2, 0.4}, 0.2));
    append(scene.mesh, scene::make_box({-0.9, 0.35, -0.9}, {0.9, 0.37, 0.9}, 0.2));
    const double a = azimuth_degrees * std::numbers::pi / 180.0;
    const double e = elevation_degrees * std::numbers::pi / 180.0;
    scene.camera.eye = 5.0 * glm::dvec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
    scene.camera.target = {0, 0.3, 0};
    scene.camera.up = elevation_degrees > 80.0 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    scene.camera.fovy_rad = 0.7;
    return scene;
}

class Further : public OnDevice<testing::Test> {
  protected:
    FurtherViews further_{device_, passes_};

    [[nodiscard]] scene::GBuffer view_from(double azimuth, double elevation,
                                           gpu::Extent size = extent) const {
        return rasterized(table(azimuth, elevation), size);
    }

    [[nodiscard]] std::vector<float> one_frame(const scene::GBuffer& view, const Settings& settings) const {
        return run(view, settings).occlusion;
    }
};

Settings settings_for(const std::string& method, std::uint32_t samples = 32) {
    Settings settings = with_radius(with_method({}, method), 0.6F);
    settings.samples = settings.samples_converged = samples;
    settings.history = false;
    settings.least_radius = 0.0F;
    return settings;
}

class FurtherOf : public Further, public testing::WithParamInterface<std::string> {};

// The same depth buffer adds no information: the samples are those of the first frame.
TEST_P(FurtherOf, TheSameViewChangesNothing) {
    const scene::GBuffer view = view_from(20, 50);
    const scene::GBuffer views[] = {view, view};
    const Settings settings = settings_for(GetParam());
    const std::vector<float> once = one_frame(view, settings);
    const std::vector<float> again = further_.raised(view, once, views, settings);
    ASSERT_GT(std::ranges::max(once), 0.05F);
    for (std::size_t i = 0; i < once.size(); ++i) ASSERT_NEAR(again[i], once[i], 2e-3F) << i;
}

INSTANTIATE_TEST_SUITE_P(All, FurtherOf, testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return method.prepare == nullptr;
                         })),
                         test::parameter_name);

TEST_F(Further, WhatAnEngineStoresIsReadAsDepth) {
    scene::GBuffer view = view_from(0, 89);
    scene::GBuffer other = view_from(40, 30);
    const Settings settings = settings_for("alchemy");
    const std::vector<float> once = one_frame(view, settings);
    const std::vector<float> wanted = further_.raised(view, once, std::span(&other, 1), settings);
    ASSERT_NE(wanted, once);
    for (scene::GBuffer* each : {&view, &other})
        each->stored = scene::stored_inputs(*each, {.depth_buffer = true, .world = true});
    EXPECT_EQ(further_.raised(view, once, std::span(&other, 1), settings), wanted);
}

TEST_F(Further, AViewThatDoesNotShowThePointChangesNothing) {
    const scene::GBuffer view = view_from(0, 89);
    scene::Scene away = table(0, 30);
    away.camera.target = 2.0 * away.camera.eye;
    const scene::GBuffer others[] = {rasterized(away, extent)};
    const std::vector<float> once = one_frame(view, settings_for("alchemy"));
    EXPECT_EQ(further_.raised(view, once, others, settings_for("alchemy")), once);
    EXPECT_EQ(further_.raised(view, once, {}, settings_for("alchemy")), once);
}

// An object hides everything from the other camera, and is near enough to block: this view is not used.
TEST_F(Further, APointHiddenInTheOtherViewIsNotAskedThere) {
    const scene::GBuffer view = view_from(0, 60);
    scene::GBuffer covered = view;
    for (float& depth : covered.depth) depth -= 0.5F;
    const scene::GBuffer others[] = {covered};
    const std::vector<float> once = one_frame(view, settings_for("hemisphere"));
    EXPECT_EQ(further_.raised(view, once, others, settings_for("hemisphere")), once);
}

// The other camera looks along the same rays but shows the middle only, with a ridge near its border. It is
// not used for points beside its image, but for those inside.
TEST_F(Further, BesideTheOtherImageNothingIsKnown) {
    const auto floor = [](glm::dvec2) { return 5.0; };
    scene::GBuffer view = view_of(extent, true, floor);
    scene::GBuffer narrow =
        view_of({33, 63}, true, [](glm::dvec2 at) { return at.x > 0.3 && at.x < 0.4 ? 4.8 : 5.0; });
    const scene::GBuffer others[] = {narrow};
    const std::vector<float> once(view.depth.size(), 0.0F);
    const std::vector<float> all = further_.raised(view, once, others, settings_for("alchemy"));
    float most = 0.0F;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double x =
            (static_cast<double>(i % extent.width) + 0.5 - 0.5 * extent.width) * view_height / extent.height;
        if (std::abs(x) > 0.53) {
            ASSERT_EQ(all[i], 0.0F) << x;
        }
        most = std::max(most, all[i]);
    }
    EXPECT_GT(most, 0.05F);
}

// From above the sides of the box and of the table's edge are seen edge-on, and the floor beside reads as
// open. From the sides they are seen, in images of another size and in parallel, and the occlusion comes
// nearer to the truth; nowhere does it fall.
TEST_F(Further, WhatOneEyeMissesAnotherSees) {
    const scene::GBuffer view = view_from(0, 89);
    const Truth truth = truth_from(
        view, scene::trace_geometry(table(0, 89), 0, view, {.rays = {.radius = 0.6, .rays = 128}}).occlusion);
    const Settings settings = settings_for("gtao", 128);
    const std::vector<float> once = one_frame(view, settings);
    std::vector<scene::GBuffer> others;
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) others.push_back(view_from(azimuth, 25, {80, 80}));
    scene::Scene parallel = table(45, 25);
    parallel.camera.projection = scene::Projection::orthographic;
    parallel.camera.view_height = 4.0;
    others.push_back(rasterized(parallel, {72, 64}));
    const std::vector<float> all = further_.raised(view, once, others, settings);
    std::size_t more = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_GE(all[i], once[i]);
        more += all[i] > once[i] + 0.02F ? 1 : 0;
    }
    EXPECT_GT(more, all.size() / 50);
    EXPECT_LT(errors_of(all, truth).rmse, 0.9 * errors_of(once, truth).rmse);
}

TEST_F(Further, WhatCannotBeUsedIsNamed) {
    const scene::GBuffer view = view_from(0, 50, {16, 16});
    const std::vector<float> once(view.depth.size());
    const scene::GBuffer others[] = {view};
    expect_error<std::invalid_argument>(
        [&] { (void)further_.raised(view, once, others, settings_for("mssao")); }, {"mssao"});
    expect_error<std::invalid_argument>(
        [&] { (void)further_.raised(view, {}, others, settings_for("gtao")); }, {"0 occlusions"});
    scene::GBuffer wide = view;
    wide.border = {1, 1};
    expect_error<std::invalid_argument>(
        [&] { (void)further_.raised(wide, once, others, settings_for("gtao")); }, {"guard band"});
}

// Depth layers in the loops of all methods.

class Layers : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] std::vector<float> occlusion(const scene::GBuffer& view, const Settings& settings,
                                               int frames = 2) const {
        return run(view, settings, frames).occlusion;
    }
};

Settings settings_of_layers(const std::string& method, std::uint32_t layers, double radius) {
    Settings settings = with_radius(with_method({}, method), static_cast<float>(radius));
    settings.layers = layers;
    return settings;
}

class LayersOf : public Layers, public testing::WithParamInterface<std::string> {};

// Each can only miss what the others show: the same surface again shows nothing. Compilers may contract the
// first try of a tap in another way than the later ones: Mesa 25 rounds one of 2,583 pixels of tangent_sphere
// to the next number.
TEST_P(LayersOf, TheSameAgainChangesNothing) {
    scene::GBuffer view = rasterized("moving", {63, 41}, {.layers = 1});
    const double radius = scene::make_scene("moving").ao_radius;
    view.layers.clear();
    const auto once = occlusion(view, settings_of_layers(GetParam(), 1, radius));
    view.layers = {view.depth, view.depth, view.depth};
    constexpr float rounding = 0x1p-23F;
    for (const std::uint32_t layers : {1U, 4U})  // 2 and 3: tests/glsl/method_layers_test.cpp
        EXPECT_THAT(occlusion(view, settings_of_layers(GetParam(), layers, radius)),
                    testing::Pointwise(testing::FloatNear(rounding), once))
            << layers << " layers";
}

// Behind a bare plane seen at a tilt other planes: nothing of them rises above the first.
TEST_P(LayersOf, WhatLiesBehindAPlaneLeavesItOpen) {
    scene::GBuffer view = wall({63, 41}, 2.0F);
    for (const float depth : {2.4F, 2.8F, 3.2F}) view.layers.emplace_back(view.depth.size(), depth);
    EXPECT_THAT(occlusion(view, settings_of_layers(GetParam(), 4, 1.0)), Each(0.0F));
}

INSTANTIATE_TEST_SUITE_P(All, LayersOf, testing::ValuesIn(test::method_names()), test::parameter_name);

// A tube before a wall: one layer takes it for as thick as the range, and does not see what it hides.
TEST_F(Layers, WhatATubeHidesIsFoundAgain) {
    const scene::Scene scene = scene::make_scene("knot");
    const scene::GBuffer view = rasterized("knot", {96, 54}, {.layers = 4});
    const Truth truth = truth_from(
        view,
        scene::trace_geometry(scene, 0, view, {.rays = {.radius = scene.ao_radius, .rays = 128}}).occlusion);
    const auto error = [&](std::uint32_t layers) {
        const Settings settings = settings_of_layers("hemisphere", layers, scene.ao_radius);
        return errors_of(occlusion(view, settings, 8), truth).rmse;
    };
    const double one = error(1);
    EXPECT_LT(error(2), 0.4 * one);
    EXPECT_LT(error(3), 0.5 * one);
    EXPECT_LT(error(4), 0.5 * one);
}

TEST_F(Layers, MoreThanTheViewHasAreRefused) {
    const scene::GBuffer view = rasterized("corner", {8, 8}, {.layers = 2});
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings settings;
    settings.layers = 3;
    expect_error<std::invalid_argument>([&] { effect.begin(view, settings); }, {"layers 3: the view has 2"});
    scene::GBuffer uneven = view;
    uneven.layers[0].pop_back();
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
    uneven.layers.assign(4, view.depth);
    EXPECT_THROW(effect.begin(uneven, {}), std::invalid_argument);
}

}  // namespace gloam::effect::further_views_test

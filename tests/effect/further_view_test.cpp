// SPDX-License-Identifier: MIT
// The pass that samples surface points again in the depth buffer of another camera.
#include "effect/errors.hpp"
#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "on_device.hpp"
#include "scene/mesh.hpp"
#include "scene/truth.hpp"

namespace gloam::effect::further_view_test {

constexpr backend::Extent extent{95, 63};

// The pass's push constants.
struct Parameters {
    glm::mat4 other_from_this;
    glm::vec2 p00_p11;
    glm::vec2 other_p00_p11;
    glm::ivec2 size;
    glm::ivec2 other_size;
    float radius;
    float bias;
};

// A table with a thin top on a floor: its underside and the floor below it are hidden from above.
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

class FurtherView : public OnDevice<testing::Test> {
  protected:
    // The occlusion of a view, raised to that of each other view where that is larger.
    [[nodiscard]] std::vector<float> raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                            std::span<const scene::GBuffer> others,
                                            const Settings& settings) {
        Executor executor(device_, passes_);
        Resources resources(device_);
        resources.buffer("method", sizeof(MethodValues)).as<MethodValues>()[0] = settings.own;
        backend::vulkan::Image& result = resources.image("raised", extent, backend::vulkan::Format::r32f);
        result.upload(occlusion);
        take_linear(view, resources, executor);
        for (const scene::GBuffer& other : others) {
            resources.image("other_depth", other.extent, backend::vulkan::Format::r32f).upload(other.depth);
            resources.image("other_normal", other.extent, backend::vulkan::Format::rgba32f)
                .upload(texels_of(other.normal));
            const PlannedPass pass = single_pass(
                "further_view", source_for(settings, other),
                {"depth", "normal", "other_depth", "other_normal", "raised", "method"},
                Parameters{.other_from_this = glm::mat4(glm::dmat4(other.camera.view) *
                                                        glm::inverse(glm::dmat4(view.camera.view))),
                           .p00_p11 = view.camera.p00_p11(),
                           .other_p00_p11 = other.camera.p00_p11(),
                           .size = {extent.width, extent.height},
                           .other_size = {other.extent.width, other.extent.height},
                           .radius = settings.radius,
                           .bias = settings.bias},
                groups_for(extent));
            executor.run(pass, resources);
        }
        return result.download();
    }

    [[nodiscard]] static PassSource source_for(const Settings& settings, const scene::GBuffer& other) {
        const MethodInfo& method = method_named(settings.method);
        return {.file = "study/further_view.comp",
                .defines = {"METHOD(position, normal, camera, kernel, values) " + call_of(method)},
                .replaced = {{file_of(methods().front()), file_of(method)}},
                .constants = {{.id = 1, .bits = other.camera.orthographic() ? 1U : 0U},
                              {.id = 2, .bits = settings.samples},
                              {.id = 3, .bits = settings.own.steps}}};
    }
};

// From above the sides of the box and of the table's edge are seen edge-on, and the floor beside reads as
// open. From the sides they are seen, in images of another size and in parallel, and the occlusion comes
// nearer to the truth; nowhere does it fall. The same view again changes nothing, and a view in which
// something hides every point changes nothing either.
TEST_F(FurtherView, WhatOneEyeMissesAnotherSees) {
    const scene::GBuffer view = drawn(table(0, 89), extent);
    const Settings settings = with({}, "method=gtao radius=0.6 samples=128 history=off least_radius=0");
    const std::vector<float> once = run(view, settings).occlusion;
    EXPECT_THAT(raised(view, once, std::span(&view, 1), settings),
                testing::Pointwise(testing::FloatNear(2e-3F), once));
    scene::GBuffer covered = view;
    for (float& depth : covered.depth) depth -= 0.5F;
    EXPECT_EQ(raised(view, once, std::span(&covered, 1), settings), once);

    std::vector<scene::GBuffer> others;
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0})
        others.push_back(drawn(table(azimuth, 25), {80, 80}));
    scene::Scene parallel = table(45, 25);
    parallel.camera.projection = scene::Projection::orthographic;
    parallel.camera.view_height = 4.0;
    others.push_back(drawn(parallel, {72, 64}));
    const std::vector<float> all = raised(view, once, others, settings);
    std::size_t more = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_GE(all[i], once[i]);
        more += all[i] > once[i] + 0.02F ? 1 : 0;
    }
    EXPECT_GT(more, all.size() / 50);
    const Truth truth = truth_from(
        view, scene::trace_geometry(table(0, 89), 0, view, {.rays = {.radius = 0.6, .rays = 128}}).occlusion);
    EXPECT_LT(errors_of(all, truth).rmse, 0.9 * errors_of(once, truth).rmse);
}

}  // namespace gloam::effect::further_view_test

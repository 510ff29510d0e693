// SPDX-License-Identifier: MIT
// The views whose occlusion is known in closed form.
#include "scene/analytic_scene.hpp"
#include "scene/tracer.hpp"
#include "support/test.hpp"

namespace gloam::scene::closed_form_views_test {

// Of both projections.
std::vector<ClosedFormView> all_views() {
    std::vector<ClosedFormView> all = closed_form_views(Projection::perspective);
    for (const ClosedFormView& view : closed_form_views(Projection::orthographic)) all.push_back(view);
    return all;
}

TEST(ClosedFormViews, TheirScenesHaveTheOcclusionThatTheySay) {
    for (const ClosedFormView& view : all_views()) {
        const OcclusionTracer tracer(view.scene.mesh, {.radius = 1.0, .rays = 1 << 16});
        EXPECT_NEAR(tracer.occlusion({.clearance = 1e-5}, 0).occlusion, view.occlusion, 5e-4)
            << view.scene.name;
    }
}

TEST(ClosedFormViews, ShowTheirPointInTheMiddle) {
    for (const ClosedFormView& view : all_views()) {
        const GBuffer buffer = draw(view, 65);
        const std::size_t middle = std::size_t{65} * 32 + 32;
        EXPECT_NEAR(double{buffer.depth[middle]}, glm::length(view.scene.camera.eye), 1e-5)
            << view.scene.name;
        EXPECT_EQ(buffer.normal[middle], glm::vec3(view_rotation(view.scene.camera)[2])) << view.scene.name;
        EXPECT_EQ(buffer.border, (gpu::Extent{32, 32})) << view.scene.name;
        for (std::size_t i = 0; i < buffer.depth.size(); ++i) {
            const double length = glm::length(glm::dvec3(buffer.normal[i]));
            EXPECT_NEAR(length, std::isfinite(buffer.depth[i]) ? 1.0 : 0.0, 1e-6) << view.scene.name;
        }
    }
}

}  // namespace gloam::scene::closed_form_views_test

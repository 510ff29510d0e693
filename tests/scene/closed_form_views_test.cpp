// SPDX-License-Identifier: MIT
// The views whose occlusion is known in closed form.
#include "scene/analytic_scene.hpp"
#include "support/test.hpp"

namespace gloam::scene::closed_form_views_test {

constexpr double pi = std::numbers::pi;

// Of both projections.
std::vector<ClosedFormView> all_views() {
    std::vector<ClosedFormView> all = closed_form_views(Projection::perspective);
    for (const ClosedFormView& view : closed_form_views(Projection::orthographic)) all.push_back(view);
    return all;
}

// Occlusion by rays through the scene itself: cosine-weighted, linear falloff.
double traced(const ClosedFormView& view) {
    constexpr int size = 512;
    constexpr glm::dvec3 up{0, 0, 1};
    double sum = 0.0;
    for (int i = 0; i < size * size; ++i) {
        const double squared = (i / size + 0.5) / size;
        const double angle = 2.0 * pi * (i % size + 0.5) / size;
        const glm::dvec3 direction = std::sqrt(squared) * glm::dvec3(std::cos(angle), std::sin(angle), 0) +
                                     std::sqrt(1.0 - squared) * up;
        const auto hit = first_hit(view.scene, 1e-7 * up, direction);
        if (hit) sum += std::max(1.0 - hit->distance, 0.0);
    }
    return sum / (size * size);
}

TEST(ClosedFormViews, TheirScenesHaveTheOcclusionThatTheySay) {
    for (const ClosedFormView& view : all_views())
        EXPECT_NEAR(traced(view), view.occlusion, 5e-4) << view.name;
}

TEST(ClosedFormViews, ShowTheirPointInTheMiddle) {
    for (const ClosedFormView& view : all_views()) {
        const GBuffer buffer = draw(view, 65);
        const std::size_t middle = std::size_t{65} * 32 + 32;
        EXPECT_NEAR(double{buffer.depth[middle]}, glm::length(view.camera.eye), 1e-6) << view.name;
        EXPECT_EQ(buffer.normal[middle], glm::vec3(view_rotation(view.camera)[2])) << view.name;
        EXPECT_EQ(buffer.border, (gpu::Extent{32, 32})) << view.name;
        for (std::size_t i = 0; i < buffer.depth.size(); ++i) {
            const double length = glm::length(glm::dvec3(buffer.normal[i]));
            EXPECT_NEAR(length, std::isfinite(buffer.depth[i]) ? 1.0 : 0.0, 1e-6) << view.name;
        }
    }
}

}  // namespace gloam::scene::closed_form_views_test

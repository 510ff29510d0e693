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
    const glm::dvec3 helper = std::abs(view.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, view.normal));
    const glm::dvec3 bitangent = glm::cross(view.normal, tangent);
    double sum = 0.0;
    for (int i = 0; i < size * size; ++i) {
        const double squared = (i / size + 0.5) / size;
        const double angle = 2.0 * pi * (i % size + 0.5) / size;
        const glm::dvec3 direction =
            std::sqrt(squared) * (std::cos(angle) * tangent + std::sin(angle) * bitangent) +
            std::sqrt(1.0 - squared) * view.normal;
        const auto hit = first_hit(view.scene, view.point + 1e-7 * view.normal, direction);
        if (hit) sum += std::max(1.0 - hit->distance, 0.0);
    }
    return sum / (size * size);
}

TEST(ClosedFormViews, TheirScenesHaveTheOcclusionThatTheySay) {
    for (const ClosedFormView& view : all_views())
        EXPECT_NEAR(traced(view), view.occlusion, 5e-4) << view.name;
}

// Whether some of the open space that the point sees within the radius is hidden from the eye.
bool hides_space(const ClosedFormView& view) {
    const bool orthographic = view.camera.projection == Projection::orthographic;
    const auto blocked = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const auto hit = first_hit(view.scene, from, to - from);
        return hit && hit->distance < 1.0;
    };
    constexpr int size = 48;
    bool hidden = false;
    for (int i = 0; i < 5 * size * size; ++i) {
        const double distance = 0.1 + 0.2 * (i % 5);
        const double height = 2.0 * (i / 5 % size + 0.5) / size - 1.0;
        const double turn = 2.0 * pi * (i / 5 / size + 0.5) / size;
        const double across = std::sqrt(1.0 - height * height);
        const glm::dvec3 direction(across * std::cos(turn), across * std::sin(turn), height);
        if (glm::dot(direction, view.normal) <= 0.0) continue;
        const glm::dvec3 start = view.point + 1e-6 * view.normal;
        const glm::dvec3 at = start + distance * direction;
        const glm::dvec3 eye = orthographic ? glm::dvec3(glm::dvec2(at), 0.0) : glm::dvec3(0.0);
        hidden |= !blocked(start, at) && blocked(at, eye);
    }
    return hidden;
}

TEST(ClosedFormViews, ShowAllOfTheirSceneUnlessAPlateHidesIt) {
    for (const ClosedFormView& view : all_views())
        EXPECT_EQ(hides_space(view), view.name == "plate") << view.name;
}

TEST(ClosedFormViews, ShowTheirPointInTheMiddle) {
    for (const ClosedFormView& view : all_views()) {
        const GBuffer buffer = draw(view, 65);
        const std::size_t middle = std::size_t{65} * 32 + 32;
        EXPECT_NEAR(double{buffer.depth[middle]}, -view.point.z, 1e-6) << view.name;
        EXPECT_EQ(buffer.normal[middle], glm::vec3(view.normal)) << view.name;
        EXPECT_EQ(buffer.border, (gpu::Extent{32, 32})) << view.name;
        for (std::size_t i = 0; i < buffer.depth.size(); ++i) {
            const double length = glm::length(glm::dvec3(buffer.normal[i]));
            EXPECT_NEAR(length, std::isfinite(buffer.depth[i]) ? 1.0 : 0.0, 1e-6) << view.name;
        }
    }
}

}  // namespace gloam::scene::closed_form_views_test

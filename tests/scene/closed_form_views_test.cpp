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

// Calls `visit` with the middles of size^2 cells of the unit square.
template <class Visit>
void over_square(int size, const Visit& visit) {
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) visit((i + 0.5) / size, (j + 0.5) / size);
}

// Occlusion by rays through the scene itself: cosine-weighted, linear falloff.
double traced(const ClosedFormView& view) {
    constexpr int size = 512;
    const glm::dvec3 helper = std::abs(view.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, view.normal));
    const glm::dvec3 bitangent = glm::cross(view.normal, tangent);
    double sum = 0.0;
    over_square(size, [&](double squared, double turn) {
        const double angle = 2.0 * pi * turn;
        const glm::dvec3 direction =
            std::sqrt(squared) * (std::cos(angle) * tangent + std::sin(angle) * bitangent) +
            std::sqrt(1.0 - squared) * view.normal;
        const auto hit = view.scene.first_hit(view.point + 1e-7 * view.normal, direction);
        if (hit) sum += std::max(1.0 - hit->distance, 0.0);
    });
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
        const auto hit = view.scene.first_hit(from, to - from);
        return hit && hit->distance < 1.0;
    };
    bool hidden = false;
    for (const double distance : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        over_square(48, [&](double share, double turn) {
            const double height = 2.0 * share - 1.0;
            const double across = std::sqrt(1.0 - height * height);
            const glm::dvec3 direction(across * std::cos(2.0 * pi * turn), across * std::sin(2.0 * pi * turn),
                                       height);
            if (glm::dot(direction, view.normal) <= 0.0) return;
            const glm::dvec3 start = view.point + 1e-6 * view.normal;
            const glm::dvec3 at = start + distance * direction;
            const glm::dvec3 eye = orthographic ? glm::dvec3(glm::dvec2(at), 0.0) : glm::dvec3(0.0);
            hidden |= !blocked(start, at) && blocked(at, eye);
        });
    }
    return hidden;
}

TEST(ClosedFormViews, ShowAllOfTheirSceneOrSayThatTheyDoNot) {
    for (const ClosedFormView& view : all_views())
        EXPECT_EQ(!hides_space(view), view.seen_whole) << view.name;
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

TEST(ClosedFormViews, AreDrawnInOddSizesOnly) {
    const ClosedFormView view = all_views().front();
    for (const std::uint32_t size : {0U, 1U, 2U, 64U}) {
        EXPECT_THROW((void)draw(view, size), std::invalid_argument) << size;
    }
}

}  // namespace gloam::scene::closed_form_views_test

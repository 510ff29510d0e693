// SPDX-License-Identifier: MIT
// The one list of views and built-in scenes.
#include "scene/mesh_scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::views_test {

// The view or scene, or nothing where its mesh file is not installed.
std::optional<Scene> made(const ViewInfo& view) {
    if (view.kind == "mesh" && !std::filesystem::is_directory(installed_meshes())) return std::nullopt;
    return make_scene(view.name);
}

// What was claimed of unseen views holds only while none of them was ever used for tuning. Each kind is in
// both halves.
TEST(Views, NoneChangesItsHalf) {
    std::map<std::string, std::string> names;  // of both lists, by half
    std::map<std::string, std::set<std::string>> halves;
    for (const ViewInfo& view : all_views()) {
        names[view.half] += view.name + " ";
        if (!view.half.empty()) halves[view.kind].insert(view.half);
        if (view.kind == "scene") names["scene"] += view.name + " ";
    }
    EXPECT_EQ(names["unseen"],
              "workshop plan aisle stairs grove lawn pipes panel canyon town horse asteroids far knot room "
              "gallery ");
    EXPECT_EQ(names["scene"], "columns corner far grass knot moving relief room sky ");
    EXPECT_EQ(halves.size(), 8U);
    for (const auto& [kind, of_kind] : halves) EXPECT_EQ(of_kind.size(), 2U) << kind;
}

// A fifth of the image or more shows surfaces, at five depths or more: no camera stands in a wall or looks
// away.
void expect_seen(const Scene& scene, int frame) {
    const GBuffer seen = draw(scene, {64, 36}, {.frame = frame});
    std::multiset<long> depths;
    for (const float depth : seen.depth)
        if (std::isfinite(depth)) depths.insert(std::lround(depth / (0.5 * scene.ao_radius)));
    EXPECT_GE(5 * depths.size(), seen.depth.size()) << frame;
    EXPECT_GE(std::set(depths.begin(), depths.end()).size(), 5U) << frame;
}

// Sound meshes, the same bits twice, and a camera that moves smoothly, by the frame's number alone; so do
// the objects, which are rigid.
TEST(Views, AreMadeTheSameTwiceAndMove) {
    std::set<Projection> seen;
    for (const ViewInfo& view : all_views()) {
        const auto scene = made(view);
        if (!scene) continue;
        SCOPED_TRACE(view.name);
        const Scene again = *made(view);
        EXPECT_EQ(scene->name, view.name);
        EXPECT_FALSE(view.description.empty());
        EXPECT_GT(scene->ao_radius, 0.0);
        for (const glm::vec3& normal : scene->mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-4F);
        if (view.kind == "scene" || view.name == "bunny") expect_whole(scene->mesh);
        for (const int frame : {0, 15})  // the first and the last that is scored
            if (view.kind != "scene") expect_seen(*scene, frame);
        EXPECT_EQ(bits(components(scene->mesh.positions)), bits(components(again.mesh.positions)));
        EXPECT_EQ(bits(components(scene->mesh.normals)), bits(components(again.mesh.normals)));
        EXPECT_EQ(scene->mesh.indices, again.mesh.indices);
        const double step = std::max(0.05, 0.3 * scene->ao_radius);
        for (int frame = 1; frame < 400; ++frame) {
            const Camera now = camera_at(*scene, frame);
            const Camera before = camera_at(*scene, frame - 1);
            (void)make_frame(now, 1.5, before);
            ASSERT_LT(glm::distance(now.eye, before.eye), step);
            for (const MovingObject& object : scene->objects) {
                ASSERT_NEAR(glm::determinant(object.transform(frame)), 1.0, 1e-12);
                ASSERT_LT(glm::distance(object.transform(frame)[3], object.transform(frame - 1)[3]), 0.1);
            }
        }
        const Camera later = camera_at(*scene, 7);
        EXPECT_EQ(later.eye, camera_at(again, 7).eye);
        EXPECT_EQ(later.eye == scene->camera.eye && later.target == scene->camera.target,
                  view.name == "corner");
        seen.insert(scene->camera.projection);
    }
    EXPECT_EQ(seen.size(), 2U);
}

}  // namespace gloam::scene::test::views_test

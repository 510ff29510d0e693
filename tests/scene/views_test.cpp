// SPDX-License-Identifier: MIT
#include "scene/views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "scene/rasterize.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace views_test {

using testing::HasSubstr;

bool shows_a_mesh(const ViewInfo& view) {
    return view.kind == "mesh";
}

// The view, or nothing where its mesh file is not installed.
std::optional<Scene> made(const ViewInfo& view) {
    if (shows_a_mesh(view) && !std::filesystem::is_directory(installed_meshes())) return std::nullopt;
    return make_view(view.name, installed_meshes());
}

bool same(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target;
}

// The rule is stated in views.hpp: even places are for tuning. Names at known places hold it to that.
TEST(Views, APlaceInTheListDecidesTheHalf) {
    ASSERT_GE(all_views().size(), 24U);
    for (std::size_t i = 0; i < all_views().size(); ++i)
        EXPECT_EQ(all_views()[i].half, i % 2 == 0 ? ViewHalf::tuning : ViewHalf::unseen) << i;
    EXPECT_EQ(all_views()[0].name, "study");
    EXPECT_EQ(all_views()[23].name, "asteroids");
    const auto tuning = views_of(ViewHalf::tuning);
    const auto unseen = views_of(ViewHalf::unseen);
    EXPECT_EQ(tuning.size() + unseen.size(), all_views().size());
    EXPECT_EQ(tuning.at(0), "study");
    EXPECT_EQ(unseen.at(0), "workshop");
}

TEST(Views, EachKindIsInBothHalves) {
    std::map<std::string, std::set<ViewHalf>> halves;
    std::set<std::string> names;
    for (const ViewInfo& view : all_views()) {
        halves[view.kind].insert(view.half);
        names.insert(view.name);
    }
    EXPECT_EQ(names.size(), all_views().size());
    EXPECT_GE(halves.size(), 6U);
    for (const auto& [kind, of_kind] : halves) EXPECT_EQ(of_kind.size(), 2U) << kind;
}

// The same bits twice, a camera that moves, and both projections.
TEST(Views, AreMadeTheSameTwiceAndMove) {
    std::set<Projection> projections;
    for (const ViewInfo& view : all_views()) {
        const auto scene = made(view);
        if (!scene) continue;
        SCOPED_TRACE(view.name);
        validate(*scene);
        EXPECT_EQ(scene->name, view.name);
        const Scene again = make_view(view.name, installed_meshes());
        EXPECT_EQ(scene->mesh.positions, again.mesh.positions);
        EXPECT_EQ(scene->mesh.indices, again.mesh.indices);
        if (view.kind != "scene") {
            EXPECT_TRUE(same(camera_at(*scene, 0), scene->camera));
        }
        EXPECT_TRUE(same(camera_at(*scene, 7), camera_at(again, 7)));
        EXPECT_FALSE(same(camera_at(*scene, 0), camera_at(*scene, 7)));
        projections.insert(scene->camera.projection);
        for (const glm::vec3& normal : scene->mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-4F);
    }
    EXPECT_EQ(projections.size(), 2U);
}

class ViewPictures : public gpu::test::GpuTest {};

// No camera stands in a wall or looks away: in the first and the last frame that is scored, a fifth of the
// image or more shows surfaces, at five depths or more.
TEST_F(ViewPictures, ShowSomethingInEachFrame) {
    const PassLibrary passes(GLOAM_GLSL_DIR);
    for (const ViewInfo& view : all_views()) {
        const auto scene = made(view);
        if (!scene || view.kind == "scene") continue;
        for (const int frame : {0, 15}) {
            SCOPED_TRACE(view.name + " " + std::to_string(frame));
            const GBuffer seen = rasterize(device(), passes, *scene, {64, 36}, {.frame = frame});
            std::size_t shown = 0;
            std::set<int> depths;
            for (const float depth : seen.depth) {
                if (!std::isfinite(depth)) continue;
                ++shown;
                depths.insert(static_cast<int>(std::lround(depth / (0.5 * scene->ao_radius))));
            }
            EXPECT_GE(5 * shown, seen.depth.size());
            EXPECT_GE(depths.size(), 5U);
        }
    }
}

TEST(Views, WhatIsMissingIsNamed) {
    try {
        (void)make_view("bunny", "/nowhere");
        FAIL() << "a mesh from a folder that is not there";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/bunny.obj"));
        EXPECT_THAT(error.what(), HasSubstr("glmark2-data"));
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    try {
        (void)make_view("nothing", installed_meshes());
        FAIL() << "a view that is not there";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("unknown view \"nothing\": expected study"));
    }
}

}  // namespace views_test
}  // namespace gloam::scene::test

// SPDX-License-Identifier: MIT
// A sequence read from files is linked as draw() links it.
#include "scene/draw.hpp"
#include "scene/scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::views_test {

constexpr gpu::Extent extent{96, 54};

class FrameLink : public testing::Test {
  protected:
    static GBuffer shot(const Scene& scene, int frame, double guard = 0.0) {
        return draw(scene, extent, {.frame = frame, .motion = true, .guard = guard});
    }

    // As an engine would write it and gloam reads it.
    static GBuffer from_files(GBuffer view, bool previous_depth) {
        if (previous_depth) {
            for (const glm::vec3& p : view.previous_position) view.previous_depth.push_back(0.0F - p.z);
        }
        const TemporaryDirectory folder;
        write_frame(folder, 3, view);
        return read_gbuffer(folder.path(), 3);
    }
};

TEST_F(FrameLink, PositionsComeBackFromFiles) {
    const Scene scene = make_scene("moving");
    for (const double guard : {0.0, 0.1}) {
        const GBuffer before = from_files(shot(scene, 8, guard), true);
        const GBuffer drawn = shot(scene, 9, guard);
        GBuffer read = from_files(drawn, true);
        EXPECT_TRUE(read.previous_position.empty());
        ASSERT_EQ(cut_between(before, read), "");
        link(read, before);
        ASSERT_EQ(read.previous_position.size(), drawn.depth.size());
        EXPECT_EQ(read.camera.previous_from_current, drawn.camera.previous_from_current);
        for (std::size_t i = 0; i < drawn.depth.size(); ++i) {
            const float error = glm::distance(read.previous_position[i], drawn.previous_position[i]);
            EXPECT_LT(error, 3e-6F * drawn.depth[i]) << i;
        }
    }
}

// What stands still is where it was; the objects of this scene hardly move towards the eye.
TEST_F(FrameLink, WithoutDepthsTheCamerasTell) {
    const Scene scene = make_scene("moving");
    const GBuffer before = shot(scene, 8);
    const GBuffer drawn = shot(scene, 9);
    GBuffer read = from_files(drawn, false);
    link(read, before);
    for (std::size_t i = 0; i < drawn.depth.size(); ++i) {
        const float error = glm::distance(read.previous_position[i], drawn.previous_position[i]);
        EXPECT_LT(error, 0.02F * drawn.depth[i]) << i;
    }
}

TEST_F(FrameLink, WithoutMotionTheMatricesTell) {
    const Scene scene = make_scene("far");  // 128 km from the origin
    GBuffer drawn = shot(scene, 5);
    drawn.motion.clear();
    drawn.previous_position.clear();
    GBuffer read = from_files(drawn, false);
    link(read, shot(scene, 4));
    EXPECT_TRUE(read.previous_position.empty());
    EXPECT_EQ(read.camera.previous_from_current, drawn.camera.previous_from_current);

    GBuffer near = shot(make_scene("room"), 5);
    const glm::mat4 exact = near.camera.previous_from_current.value();
    near.camera.previous_from_current.reset();
    link(near, shot(make_scene("room"), 4));
    for (int i = 0; i < 16; ++i)
        EXPECT_NEAR((*near.camera.previous_from_current)[i / 4][i % 4], exact[i / 4][i % 4], 1e-5F) << i;
}

TEST_F(FrameLink, CutsAreNamed) {
    const Scene scene = make_scene("moving");
    const GBuffer before = shot(scene, 8);
    const GBuffer view = shot(scene, 9);
    EXPECT_EQ(cut_between(before, view), "");
    EXPECT_EQ(cut_between(shot(scene, 7), view), "prev_view is not the view before");
    GBuffer other = view;
    other.camera.previous_view.reset();
    EXPECT_EQ(cut_between(before, other), "") << "previous_from_current is enough";
    other.camera.previous_from_current.reset();
    EXPECT_EQ(cut_between(before, other), "there is no prev_view");
    EXPECT_EQ(cut_between(shot(scene, 8, 0.1), view), "the size has changed");
}

// Two pixels of depth 2 before a camera that stands still; motion and depth as given.
glm::vec3 earlier(const glm::vec3& motion, std::vector<float> previous_depth, float depth = 2.0F) {
    GBuffer view{.extent = {2, 1},
                 .depth = {depth, depth},
                 .motion = {motion, glm::vec3(0)},
                 .previous_depth = std::move(previous_depth),
                 .camera = make_frame({}, 2.0, {})};
    link(view, {.extent = {2, 1}, .camera = make_frame({}, 2.0)});
    return view.previous_position.at(0);
}

TEST(FrameLinkOf, MotionThatIsNotValid) {
    const glm::vec3 none(0);
    EXPECT_EQ(earlier({0, 0, 0}, {}), none) << "it leads into the image, so nothing is known";
    EXPECT_EQ(earlier({-1, 0, 0}, {}), none);
    EXPECT_LT(earlier({1, 0, 0}, {}).x, earlier({0, 0, 1}, {}).x) << "outside: that is where it was";
    EXPECT_EQ(earlier({0, 0, 1}, {3, 3}).z, -3.0F);
    for (const float bad : {nan, infinity, 0.0F, -1.0F}) EXPECT_EQ(earlier({0, 0, 1}, {bad, 1}), none) << bad;
    EXPECT_EQ(earlier({0, 0, 1}, {}, infinity), none) << "background";
    EXPECT_EQ(earlier({0, 0, 1}, {}, nan), none);
}

TEST(FrameLinkOf, DepthsWithoutMotionAreAnError) {
    const TemporaryDirectory folder;
    GBuffer view{.extent = {2, 1}, .depth = {1, 2}, .previous_depth = {1, 2}, .camera = make_frame({}, 2.0)};
    write_frame(folder, 0, view);
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_previous_depth.pfm", "motion"});
}

// Views rendered larger than the frame: the pixels of the frame look along the same rays.

constexpr gpu::Extent frame{160, 90};

GBuffer shot(const Scene& scene, double guard, int number = 0, bool motion = false) {
    return draw(scene, frame, {.frame = number, .motion = motion, .ids = motion, .guard = guard});
}

TEST(GuardBorder, IsWholePixelsOfEachSide) {
    EXPECT_EQ(guard_border({640, 360}, 0.1), (gpu::Extent{64, 36}));
    EXPECT_EQ(guard_border({33, 47}, 0.05), (gpu::Extent{2, 2}));  // 1.65 and 2.35
    EXPECT_EQ(guard_border({5, 4}, 0.1), (gpu::Extent{1, 0}));     // one half is rounded up
    EXPECT_EQ(guard_border({640, 360}, 0.0), gpu::Extent{});
    EXPECT_EQ(with_border({640, 360}, gpu::Extent{64, 36}), (gpu::Extent{768, 432}));
    for (const double bad : {-0.01, 0.51, std::numeric_limits<double>::quiet_NaN()})
        expect_error<std::invalid_argument>([&] { (void)guard_border(frame, bad); }, {"guard", "0 to 0.5"});
}

TEST(GuardBorder, ThatLeavesNoFrameIsAnError) {
    for (const gpu::Extent border : {gpu::Extent{4, 0}, gpu::Extent{0, 3}, gpu::Extent{0xFFFFFFFF, 0}}) {
        const GBuffer view{.extent = {8, 6}, .border = border};
        expect_error<std::invalid_argument>([&] { (void)frame_of(view); }, {"guard band", "no frame"});
    }
}

// In the projections' own numbers: the pixel centres of the frame are those of the plain view.
TEST(GuardBorder, InnerPixelsLookAlongTheSameRays) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.projection = projection};
        for (const double guard : {0.05, 0.1, 0.37, 0.5}) {
            const gpu::Extent border = guard_border(frame, guard);
            const gpu::Extent wide = with_border(frame, border);
            const double aspect = static_cast<double>(frame.width) / frame.height;
            const double wide_aspect = static_cast<double>(wide.width) / wide.height;
            const GBuffer plain{.extent = frame, .camera = make_frame(camera, aspect)};
            const GBuffer view{.extent = wide,
                               .camera = make_frame(with_border(camera, frame, border), wide_aspect),
                               .border = border};
            for (const auto& [x, y] : {std::pair{0U, 0U}, std::pair{159U, 89U}, std::pair{31U, 77U}}) {
                const std::size_t inner = y * frame.width + x;
                const std::size_t outer = (y + border.height) * wide.width + x + border.width;
                const glm::dvec3 seen = PixelPositions(view).at(outer, 3.0);
                EXPECT_LT(glm::distance(seen, PixelPositions(plain).at(inner, 3.0)), 1e-6) << guard;
                EXPECT_LT(glm::distance(seen, PixelPositions(cropped(view)).at(inner, 3.0)), 1e-6) << guard;
            }
        }
    }
}

TEST(GuardBand, NoneChangesNothing) {
    const Scene scene = make_scene("moving");
    const GBuffer plain = draw(scene, frame, {.frame = 3, .motion = true});
    const GBuffer view = shot(scene, 0.0, 3, true);
    EXPECT_EQ(view.border, gpu::Extent{});
    EXPECT_EQ(view.depth, plain.depth);
    EXPECT_EQ(view.motion, plain.motion);
    EXPECT_EQ(cropped(view).depth, plain.depth);
}

// The device rounds vertices to a part of a pixel, not to the same one in both views: at silhouettes a few
// pixels see the other surface.
TEST(GuardBand, TheFrameIsThatOfThePlainView) {
    for (const char* name : {"moving", "columns", "far"}) {
        const Scene scene = make_scene(name);
        const GBuffer plain = shot(scene, 0.0, 2, true);
        const GBuffer view = shot(scene, 0.1, 2, true);
        EXPECT_EQ(view.border, (gpu::Extent{16, 9}));
        EXPECT_EQ(view.extent, (gpu::Extent{192, 108}));
        const GBuffer inner = cropped(view);
        ASSERT_EQ(inner.extent, frame);
        std::size_t same = 0;
        std::size_t surface = 0;
        for (std::size_t i = 0; i < plain.depth.size(); ++i) {
            if (std::isinf(plain.depth[i])) continue;
            ++surface;
            const bool close = std::abs(inner.depth[i] - plain.depth[i]) < 1e-4F * plain.depth[i] &&
                               glm::distance(inner.normal[i], plain.normal[i]) < 1e-3F &&
                               glm::distance(inner.motion[i], plain.motion[i]) < 2e-2F &&
                               inner.object[i] == plain.object[i];
            same += close ? 1 : 0;
        }
        EXPECT_GT(static_cast<double>(same), 0.995 * static_cast<double>(surface)) << name;
    }
}

TEST(GuardBand, MotionOutOfTheBandIsNoneForTheFrame) {
    GBuffer view{.extent = {6, 4}, .border = gpu::Extent{1, 1}};
    view.depth.assign(24, 1.0F);
    view.motion.assign(24, glm::vec3(1.0F, 0.0F, 1.0F));  // what is now in the first column was in the band
    const GBuffer inner = cropped(view);
    for (std::size_t i = 0; i < inner.motion.size(); ++i)
        EXPECT_EQ(inner.motion[i].z, i % 4 == 0 ? 0.0F : 1.0F) << i;
}

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

// What was claimed of unseen views holds only while none of them was ever used for tuning.
TEST(Views, NoneChangesItsHalf) {
    std::vector<std::string> unseen;
    for (const ViewInfo& view : all_views())
        if (view.half == ViewHalf::unseen) unseen.push_back(view.name);
    EXPECT_THAT(unseen,
                ElementsAre("workshop", "plan", "aisle", "stairs", "grove", "lawn", "pipes", "panel",
                            "canyon", "town", "horse", "asteroids", "far", "knot", "room", "gallery"));
}

TEST(Views, EachKindIsInBothHalves) {
    std::map<std::string, std::set<ViewHalf>> halves;
    std::set<std::string> names;
    for (const ViewInfo& view : all_views()) {
        halves[view.kind].insert(*view.half);
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
        EXPECT_EQ(bits(components(scene->mesh.positions)), bits(components(again.mesh.positions)));
        EXPECT_EQ(bits(components(scene->mesh.normals)), bits(components(again.mesh.normals)));
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

// No camera stands in a wall or looks away: in the first and the last frame that is scored, a fifth of the
// image or more shows surfaces, at five depths or more.
TEST(ViewPictures, ShowSomethingInEachFrame) {
    for (const ViewInfo& view : all_views()) {
        const auto scene = made(view);
        if (!scene || view.kind == "scene") continue;
        for (const int frame : {0, 15}) {
            SCOPED_TRACE(view.name + " " + std::to_string(frame));
            const GBuffer seen = draw(*scene, {64, 36}, {.frame = frame});
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

// What rolls and what tumbles stays in the picture, and what slides leaves it.
TEST(ViewPictures, OfMovingObjects) {
    for (const ViewInfo& view : all_views()) {
        if (view.kind != "motion") continue;
        SCOPED_TRACE(view.name);
        const Scene scene = make_view(view.name, installed_meshes());
        ASSERT_EQ(scene.objects.size(), 3U);
        std::array<std::array<double, 4>, 2> shown{};
        for (const int end : {0, 1})
            for (const std::uint32_t object : draw(scene, {160, 90}, {.frame = 23 * end, .ids = true}).object)
                shown[static_cast<std::size_t>(end)][object] += 1.0;
        for (const std::size_t object : {1U, 2U, 3U}) EXPECT_GT(shown[0][object], 60.0) << object;
        for (const std::size_t object : {1U, 2U}) EXPECT_GT(shown[1][object], 60.0) << object;
        EXPECT_LT(shown[1][3], 0.4 * shown[0][3]);
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

}  // namespace gloam::scene::test::views_test

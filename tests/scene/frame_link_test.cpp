// SPDX-License-Identifier: MIT
// A sequence read from files is linked as the rasterizer links it.
#include "scene/frame_link.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "scene/frame_files.hpp"
#include "scene/rasterize.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace frame_link_test {

constexpr gpu::Extent extent{96, 54};

class FrameLink : public gpu::test::GpuTest {
  protected:
    GBuffer shot(const Scene& scene, int frame, double guard = 0.0) {
        return rasterize(device(), passes_, scene, extent, {.frame = frame, .motion = true, .guard = guard});
    }

    // As an engine would write it and gloam reads it.
    static GBuffer from_files(GBuffer view, bool previous_depth) {
        if (previous_depth) {
            for (const glm::vec3& p : view.previous_position) view.previous_depth.push_back(0.0F - p.z);
        }
        const Folder folder;
        write_frame(folder, 3, view);
        return read_gbuffer(folder.path(), 3);
    }

  private:
    static std::filesystem::path cache() {
        const char* directory = std::getenv("GLOAM_CACHE_DIR");
        return directory == nullptr ? "" : directory;
    }
    PassLibrary passes_{GLOAM_GLSL_DIR, cache()};
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
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
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
    const Folder folder;
    GBuffer view{.extent = {2, 1}, .depth = {1, 2}, .previous_depth = {1, 2}, .camera = make_frame({}, 2.0)};
    write_frame(folder, 0, view);
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_previous_depth.pfm", "motion"});
}

}  // namespace frame_link_test
}  // namespace gloam::scene::test

// SPDX-License-Identifier: MIT
// Frames that follow each other, and views larger than their frame.
#include "scene/support.hpp"

namespace gloam::scene::test::frames_test {

GBuffer shot(const Scene& scene, int number) {
    return draw(scene, {96, 54}, {.frame = number, .motion = true});
}

// tests/tools/stories has the cuts of files, and sequences that are read back and give the same pictures.
TEST(FrameLink, WithoutMotionTheMatricesTell) {
    const Scene scene = make_scene("far");  // 128 km from the origin
    GBuffer drawn = shot(scene, 5);
    drawn.motion.clear();
    drawn.previous_position.clear();
    const TemporaryDirectory folder;
    write_frame(folder, 5, drawn);
    GBuffer read = read_gbuffer(folder.path(), 5);
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

TEST(FrameLink, MotionThatIsNotValid) {
    const glm::vec3 none(0);
    EXPECT_EQ(earlier({0, 0, 0}, {}), none) << "it leads into the image, so nothing is known";
    EXPECT_LT(earlier({1, 0, 0}, {}).x, earlier({0, 0, 1}, {}).x) << "outside: that is where it was";
    EXPECT_EQ(earlier({0, 0, 1}, {3, 3}).z, -3.0F);
    for (const float bad : {nan, infinity, 0.0F, -1.0F}) EXPECT_EQ(earlier({0, 0, 1}, {bad, 1}), none) << bad;
    EXPECT_EQ(earlier({0, 0, 1}, {}, infinity), none) << "background";
}

TEST(GuardBand, IsWholePixelsOfEachSide) {
    EXPECT_EQ(guard_border({640, 360}, 0.1), (backend::Extent{64, 36}));
    EXPECT_EQ(guard_border({33, 47}, 0.05), (backend::Extent{2, 2}));  // 1.65 and 2.35
    EXPECT_EQ(guard_border({5, 4}, 0.1), (backend::Extent{1, 0}));     // one half is rounded up
    EXPECT_EQ(guard_border({640, 360}, 0.0), backend::Extent{});
    EXPECT_EQ(with_border({640, 360}, backend::Extent{64, 36}), (backend::Extent{768, 432}));
}

TEST(GuardBand, MotionOutOfTheBandIsNoneForTheFrame) {
    GBuffer view{.extent = {6, 4}, .border = backend::Extent{1, 1}};
    view.depth.assign(24, 1.0F);
    view.motion.assign(24, glm::vec3(1.0F, 0.0F, 1.0F));  // what is now in the first column was in the band
    const GBuffer inner = cropped(view);
    for (std::size_t i = 0; i < inner.motion.size(); ++i)
        EXPECT_EQ(inner.motion[i].z, i % 4 == 0 ? 0.0F : 1.0F) << i;
}

// Parts of a view look along the rays of the whole: the frame of a guard band, and an image whose camera's
// axis is not in its middle, which is written, read and centred.
TEST(PartsOfViews, HaveTheRaysOfTheWholeView) {
    for (const Projection projection : projections) {
        for (const Border& around :
             {Border(0, 0, 20, 0), Border(15, 0, 0, 0), Border(0, 0, 0, 9), Border(0, 13, 0, 0),
              Border(12, 0, 0, 5), Border(0, 0, 24, 24), Border(3, 5, 3, 5)}) {
            GBuffer whole = floor_and_wall(projection);
            whole.border = around;
            const GBuffer part = cropped(whole);
            const TemporaryDirectory folder;
            write_frame(folder, 0, part);
            const GBuffer read = read_gbuffer(folder.path(), 0);
            EXPECT_EQ(read.off_centre, part.off_centre);
            const bool even = around == Border(around.each_side());
            EXPECT_EQ(centred(read).extent, even ? part.extent : whole.extent);
            EXPECT_EQ(cropped(centred(read)).depth, read.depth);
            const PixelPositions positions(read);
            for (std::size_t i = 0; i < read.depth.size(); ++i) {
                const glm::dvec3 at = positions.at(i, 3.0);
                const glm::dvec2 place = positions.center(i);
                ASSERT_LT(glm::distance(positions.pixel_of(at), place), 1e-9) << i;
                const glm::dvec2 outer = place + glm::dvec2(around.left, around.top);
                ASSERT_LT(glm::distance(PixelPositions(whole).pixel_of(at), outer), 1e-4) << i;
            }
        }
    }
}

// three.js gives orthographic cameras a near plane behind the eye: what lies there is part of the picture.
TEST(OrthographicViews, BehindTheEyesPlaneAreReadAsTheSameView) {
    const GBuffer view = floor_and_wall(Projection::orthographic);
    for (const bool reversed : {false, true}) {
        for (const bool buffer : {false, true}) {
            const Encoding encoding{.depth_buffer = buffer};
            glm::dmat4 projection =
                make_frame({.projection = Projection::orthographic, .reversed_z = reversed}, 1.0).proj_vk;
            for (const int axis : {0, 1}) projection[axis][axis] = view.camera.proj_vk[axis][axis];
            constexpr double ahead = 50.0;  // the eye stands there
            const glm::dmat4 shift{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -ahead, 1}};
            GBuffer moved = view;
            moved.camera.proj_vk = glm::mat4(projection * shift);
            moved.camera.view = glm::mat4(glm::inverse(shift) * glm::dmat4(view.camera.view));
            const CameraFrame unmoved{.proj_vk = glm::mat4(projection)};
            for (float& d : moved.depth)
                d = static_cast<float>(buffer ? stored_depth(double{d}, encoding, unmoved)
                                              : double{d} - ahead);
            const TemporaryDirectory folder;
            write_frame(folder, 0, moved);
            const GBuffer read = read_gbuffer(folder.path(), 0, encoding);
            EXPECT_GT(planes_of(read.camera.proj_vk).near, 0.0);
            for (std::size_t i = 0; i < view.depth.size(); ++i) {
                const auto world = [&](const GBuffer& one) {
                    return glm::inverse(glm::dmat4(one.camera.view)) *
                           glm::dvec4(PixelPositions(one).at(i, double{one.depth[i]}), 1.0);
                };
                ASSERT_LT(glm::distance(world(view), world(read)), 1e-4) << i;
            }
        }
    }
}

}  // namespace gloam::scene::test::frames_test

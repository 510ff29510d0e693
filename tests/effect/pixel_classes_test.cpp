// SPDX-License-Identifier: MIT
// Where a pixel was in the frame before, and the classes of pixels that follow: settled, uncovered, near
// motion.
#include "effect/pixel_classes.hpp"
#include "on_device.hpp"

namespace gloam::effect::pixel_classes_test {

constexpr std::uint32_t width = 40;
constexpr std::uint32_t height = 30;
constexpr double camera_scale = 2.0;  // pixels for each world unit, at any depth

int count(const Mask& mask) {
    return std::accumulate(mask.begin(), mask.end(), 0);
}

scene::Camera camera_at(double x) {
    return {.eye = {x, 0, 0},
            .target = {x, 0, -1},
            .projection = scene::Projection::orthographic,
            .view_height = height / camera_scale};
}

// A wall at depth 10, and a square of 8 x 8 pixels at depth 5, seen straight on, without perspective.
// `square`: its left column in world pixels; `camera`: how many pixels the camera stands to the right.
scene::GBuffer square_view(int square, int camera, int square_before, int camera_before) {
    scene::GBuffer view{.extent = {width, height}};
    view.camera = scene::make_frame(camera_at(camera / camera_scale), 1.0 * width / height,
                                    camera_at(camera_before / camera_scale));
    view.normal.assign(width * height, glm::vec3(0, 0, 1));
    for (int y = 0; y < static_cast<int>(height); ++y) {
        for (int x = 0; x < static_cast<int>(width); ++x) {
            const bool front = x + camera >= square && x + camera < square + 8 && y >= 10 && y < 18;
            view.depth.push_back(front ? 5.0F : 10.0F);
            const double world_x = x + camera - (front ? square - square_before : 0);
            view.previous_position.emplace_back((world_x - camera_before + 0.5 - 0.5 * width) / camera_scale,
                                                (0.5 * height - y - 0.5) / camera_scale,
                                                front ? -5.0 : -10.0);
        }
    }
    return view;
}

TEST(HistoryMap, OfAStillViewIsTheViewItself) {
    const scene::GBuffer view = square_view(10, 0, 10, 0);
    const HistoryMap history(view, view);
    std::vector<float> image(width * height);
    std::iota(image.begin(), image.end(), 0.0F);
    for (std::size_t i = 0; i < image.size(); ++i) {
        ASSERT_TRUE(history.seen(i));
        EXPECT_EQ(history.nearest(i), i);
        EXPECT_NEAR(history.sample(i, image), image[i], 1e-2);
        EXPECT_FALSE(history.moved(i));
    }
    EXPECT_NEAR(mean_change(history, image, image), 0.0, 1e-2);
}

// The camera moves three pixels to the right: three columns come in, and three that the square had hidden.
TEST(HistoryMap, OfAMovingCamera) {
    const scene::GBuffer before = square_view(10, 0, 10, 0);
    scene::GBuffer view = square_view(10, 3, 10, 0);
    for (const bool positions : {true, false}) {
        if (!positions) view.previous_position.clear();  // the cameras say the same
        const HistoryMap history(view, before);
        for (std::size_t i = 0; i < width * height; ++i) {
            const std::size_t x = i % width;
            EXPECT_EQ(history.seen(i), x + 3 < width) << i;
            if (history.seen(i)) {
                EXPECT_EQ(history.nearest(i), i + 3);
            }
            EXPECT_FALSE(history.moved(i));
        }
    }
}

// The square moves two pixels to the right: it uncovers two columns of the wall.
TEST(HistoryMap, OfAMovingObject) {
    const scene::GBuffer before = square_view(10, 0, 10, 0);
    const HistoryMap history(square_view(12, 0, 10, 0), before);
    for (std::size_t i = 0; i < width * height; ++i) {
        const std::size_t x = i % width;
        const std::size_t y = i / width;
        const bool row = y >= 10 && y < 18;
        EXPECT_EQ(history.seen(i), !(row && x >= 10 && x < 12)) << i;
        EXPECT_EQ(history.moved(i), row && x >= 12 && x < 20) << i;
        if (history.moved(i)) {
            EXPECT_EQ(history.nearest(i), i - 2);
        }
    }
    // What is carried along does not flicker; what stands still in the image does where the square passes.
    std::vector<float> now(width * height, 0.0F);
    std::vector<float> then(width * height, 0.0F);
    for (std::size_t i = 0; i < then.size(); ++i) then[i] = before.depth[i] < 7 ? 1.0F : 0.0F;
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = history.moved(i) ? 1.0F : 0.0F;
    EXPECT_NEAR(mean_change(history, now, then), 0.0, 1e-6);
    EXPECT_NEAR(mean_change(history, then, then), (2.0 * 8) / (width * height - 16), 1e-6);
}

// Motion vectors alone: dx, dy, valid.
TEST(HistoryMap, FromMotionVectors) {
    const scene::GBuffer before = square_view(10, 0, 10, 0);
    scene::GBuffer view = square_view(12, 0, 10, 0);
    view.previous_position.clear();
    for (std::size_t i = 0; i < width * height; ++i)
        view.motion.emplace_back(view.depth[i] < 7 ? 2.0F : 0.0F, 0.0F, 1.0F);
    view.motion[5].z = 0.0F;
    const HistoryMap history(view, before);
    EXPECT_FALSE(history.seen(5));
    const std::size_t on_square = 12 * width + 15;
    EXPECT_TRUE(history.moved(on_square));
    EXPECT_EQ(history.nearest(on_square), on_square - 2);
}

TEST(HistoryMap, BackgroundHasNone) {
    scene::GBuffer view = square_view(10, 0, 10, 0);
    view.depth[7] = infinity;
    EXPECT_FALSE(HistoryMap(view, view).seen(7));
    scene::GBuffer small = view;
    small.depth.pop_back();
    EXPECT_THROW(HistoryMap(view, small), std::invalid_argument);
    view.normal.clear();
    EXPECT_THROW(HistoryMap(view, view), std::invalid_argument);
}

TEST(DistanceTransform, IsTheDistanceToTheNearest) {
    Mask mask(35 * 21, 0);
    EXPECT_EQ(distance_to(mask, {35, 21})[0], infinity);
    const std::vector<std::size_t> set{3, 200, 201, 640, 734};
    for (const std::size_t i : set) mask[i] = 1;
    const std::vector<float> distance = distance_to(mask, {35, 21});
    for (std::size_t i = 0; i < mask.size(); ++i) {
        double nearest = infinity;
        for (const std::size_t k : set)
            nearest = std::min(nearest,
                               std::hypot(double(i % 35) - double(k % 35), double(i / 35) - double(k / 35)));
        EXPECT_NEAR(distance[i], nearest, 1e-5);
    }
    EXPECT_THROW((void)distance_to(mask, {35, 20}), std::invalid_argument);
}

TEST(PixelClasses, OfAStillViewSettle) {
    const scene::GBuffer view = square_view(10, 0, 10, 0);
    PixelClasses classes({.radius = 1.0, .settled_frames = 3});
    classes.advance(view, std::nullopt);
    EXPECT_EQ(count(classes.disoccluded()), static_cast<int>(width * height));
    for (int frame = 1; frame <= 3; ++frame) {
        EXPECT_EQ(count(classes.settled()), 0) << frame;
        classes.advance(view, HistoryMap(view, view));
        EXPECT_EQ(count(classes.disoccluded()), 0);
        EXPECT_EQ(count(classes.near_moving()), 0);
    }
    EXPECT_EQ(count(classes.settled()), static_cast<int>(width * height));
}

// A square moves by two pixels in one frame, then stands still. World radius 1.5 is 3 pixels.
TEST(PixelClasses, OfAMovingObject) {
    PixelClasses classes({.radius = 1.5, .settled_frames = 2, .memory = 2});
    const scene::GBuffer still = square_view(10, 0, 10, 0);
    const scene::GBuffer moved = square_view(12, 0, 10, 0);
    const scene::GBuffer rest = square_view(12, 0, 12, 0);
    classes.advance(still, std::nullopt);
    for (int i = 0; i < 3; ++i) classes.advance(still, HistoryMap(still, still));
    classes.advance(moved, HistoryMap(moved, still));
    EXPECT_EQ(count(classes.disoccluded()), 16);
    const Mask& near = classes.near_moving();
    EXPECT_NE(near[14 * width + 22], 0);  // three pixels right of the square's last column, 19
    EXPECT_EQ(near[14 * width + 23], 0);
    EXPECT_NE(near[7 * width + 15], 0);  // and above its first row, 10
    EXPECT_EQ(near[6 * width + 15], 0);
    EXPECT_NE(classes.settled()[14 * width + 30], 0);
    EXPECT_EQ(classes.settled()[14 * width + 22], 0);
    for (std::size_t i = 0; i < near.size(); ++i)
        ASSERT_LE(near[i] + classes.settled()[i] + classes.disoccluded()[i], 1);
    // One frame in which the square still stood where it had moved, then two of memory.
    for (int i = 0; i < 3; ++i) {
        classes.advance(rest, HistoryMap(rest, i == 0 ? moved : rest));
        EXPECT_NE(classes.near_moving()[14 * width + 22], 0) << i;
    }
    classes.advance(rest, HistoryMap(rest, rest));
    EXPECT_EQ(count(classes.near_moving()), 0);
    EXPECT_EQ(count(classes.settled()), static_cast<int>(width * height));
}

TEST(PixelClasses, OfAnotherSizeNeedACut) {
    const scene::GBuffer view = square_view(10, 0, 10, 0);
    PixelClasses classes({});
    EXPECT_THROW(classes.advance(view, HistoryMap(view, view)), std::invalid_argument);
}

}  // namespace gloam::effect::pixel_classes_test

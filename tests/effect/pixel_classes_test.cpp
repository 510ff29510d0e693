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
    scene::GBuffer view = square_view(12, 0, 10, 0);
    const HistoryMap history(view, before);
    view.previous_position.clear();  // the same by motion vectors: dx, dy, valid
    for (const float depth : view.depth) view.motion.emplace_back(depth < 7 ? 2.0F : 0.0F, 0.0F, 1.0F);
    const HistoryMap by_vectors(view, before);
    for (std::size_t i = 0; i < width * height; ++i) {
        const std::size_t x = i % width;
        const std::size_t y = i / width;
        const bool row = y >= 10 && y < 18;
        EXPECT_EQ(history.seen(i), !(row && x >= 10 && x < 12)) << i;
        EXPECT_EQ(history.moved(i), row && x >= 12 && x < 20) << i;
        if (history.moved(i)) {
            EXPECT_EQ(history.nearest(i), i - 2);
            EXPECT_EQ(by_vectors.nearest(i), i - 2);
        }
        EXPECT_EQ(by_vectors.moved(i), history.moved(i)) << i;
    }
    view.motion[5].z = 0.0F;
    EXPECT_FALSE(HistoryMap(view, before).seen(5));
    // What is carried along does not flicker; what stands still in the image does where the square passes.
    std::vector<float> now(width * height, 0.0F);
    std::vector<float> then(width * height, 0.0F);
    for (std::size_t i = 0; i < then.size(); ++i) then[i] = before.depth[i] < 7 ? 1.0F : 0.0F;
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = history.moved(i) ? 1.0F : 0.0F;
    EXPECT_NEAR(mean_change(history, now, then).value(), 0.0, 1e-6);
    EXPECT_NEAR(mean_change(history, then, then).value(), (2.0 * 8) / (width * height - 16), 1e-6);
    // What is due is no flicker; the uncovered columns have no frame before.
    const std::vector<float> due(width * height, -1.0F);
    EXPECT_NEAR(mean_change(history, now, then, due).value(), 1.0, 1e-6);
    Mask uncovered(width * height, 0);
    for (std::size_t i = 0; i < uncovered.size(); ++i) uncovered[i] = history.seen(i) ? 0 : 1;
    EXPECT_FALSE(mean_change(history, now, then, {}, uncovered));
}

TEST(HistoryMap, BackgroundHasNone) {
    scene::GBuffer view = square_view(10, 0, 10, 0);
    view.depth[7] = infinity;
    EXPECT_FALSE(HistoryMap(view, view).seen(7));
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
}

int count(const PixelClasses& classes, PixelClass one) {
    return count(classes.mask(one));
}

// A square of 8 x 8 pixels, columns 10 to 17 of rows 10 to 17, moves right by two in one frame, then stands
// still. World radius 4 is 8 pixels.
TEST(PixelClasses, OfAMovingObject) {
    PixelClasses classes({.radius = 4.0, .settled_frames = 2, .near = 5.0, .memory = 3});
    const scene::GBuffer still = square_view(10, 0, 10, 0);
    const scene::GBuffer moved = square_view(12, 0, 10, 0);
    const scene::GBuffer rest = square_view(12, 0, 12, 0);
    classes.advance(still, std::nullopt);
    for (int i = 0; i < 3; ++i) classes.advance(still, HistoryMap(still, still));
    classes.advance(moved, HistoryMap(moved, still));
    EXPECT_EQ(count(classes, PixelClass::disoccluded), 2 * 8);
    EXPECT_EQ(count(classes, PixelClass::moving), 8 * 8);
    // Up to five pixels from columns 12 to 19: 4 x 5 x 8 beside and, in each corner, the places at (x, y)
    // with x x + y y <= 25, of which 15 have x > 0 and y > 0. The 16 uncovered pixels are among those beside.
    EXPECT_EQ(count(classes, PixelClass::near_moving), 4 * 5 * 8 + 4 * 15 - 16);
    EXPECT_EQ(classes.at(14 * width + 24), PixelClass::near_moving);
    EXPECT_EQ(classes.at(14 * width + 25), PixelClass::young) << "within the radius";
    EXPECT_EQ(classes.at(14 * width + 27), PixelClass::young);
    EXPECT_EQ(classes.at(14 * width + 28), PixelClass::settled);
    // What moved in the last three frames; and what nothing has come near for two frames has settled again.
    for (int i = 0; i < 3; ++i) {
        classes.advance(rest, HistoryMap(rest, i == 0 ? moved : rest));
        EXPECT_EQ(count(classes, PixelClass::moving), 0) << i;
        EXPECT_EQ(count(classes, PixelClass::near_moving), 18 * 18 - 4 * 10) << i;
    }
    classes.advance(rest, HistoryMap(rest, rest));
    EXPECT_EQ(count(classes, PixelClass::settled), static_cast<int>(width * height));
}

}  // namespace gloam::effect::pixel_classes_test

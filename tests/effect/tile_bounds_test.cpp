// SPDX-License-Identifier: MIT
// What the search for open tiles rests on: a bound of the inverse depth that every surface of a tile keeps.
#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/tiles.hpp"
#include "effect/pixel_classes.hpp"
#include "numeric/random.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::tile_bounds_test {

struct Bound {
    float c = 0.0F;
    float slope_x = 0.0F;
    float slope_y = 0.0F;
    float any = 0.0F;  // 1: the tile holds a surface
};

class TileBounds : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] std::vector<Bound> bounds_of(glm::ivec2 size, const std::vector<float>& depth) const {
        gpu::Image image(device_, {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)},
                         gpu::Format::r32f);
        image.upload(depth);
        const glm::uvec2 tiles = (glm::uvec2(size) + tile_side - 1U) / tile_side;
        const glm::uvec2 groups = (tiles + 7U) / 8U;
        const gpu::Buffer buffer(device_, std::size_t{tiles.x} * tiles.y * sizeof(Bound));
        const gpu::ComputePipeline pass = pipeline_of(device_, passes_, {.file = "tiles/bound.comp"});
        gpu::Commands commands(device_);
        commands.dispatch(pass, std::vector<gpu::Resource>{image, buffer}, {groups.x, groups.y, 1},
                          std::as_bytes(std::span(&size, 1)));
        commands.submit();
        const auto written = buffer.as<Bound>();
        return {written.begin(), written.end()};
    }

    [[nodiscard]] std::uint64_t open_tiles(const scene::GBuffer& view, const Settings& settings) const {
        return run(view, settings).work.tiles_open;
    }
};

// Sides of one pixel beyond whole tiles among them: such a tile has no slope along that side.
TEST_F(TileBounds, NoSurfaceOfATileIsNearerThanItsBound) {
    numeric::Random random(3);
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(9, 17), glm::ivec2(17, 1), glm::ivec2(13, 24)}) {
        std::vector<float> depth;
        for (int i = 0; i < size.x * size.y; ++i)
            depth.push_back(1.0F + 9.0F * static_cast<float>(random.unit()));
        const std::vector<Bound> bounds = bounds_of(size, depth);
        const int tiles_x = (size.x + 7) / 8;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const Bound& bound = bounds[static_cast<std::size_t>(y / 8 * tiles_x + x / 8)];
                EXPECT_EQ(bound.any, 1.0F);
                const double most =
                    double{bound.c} + double{bound.slope_x} * (x % 8) + double{bound.slope_y} * (y % 8);
                const double inverse = 1.0 / double{depth[static_cast<std::size_t>(y * size.x + x)]};
                EXPECT_GE(most, inverse)
                    << size.x << " x " << size.y << ": " << x << ", " << y;  // false for NaN
                EXPECT_LT(most, 1e3) << "no bound of any use";
            }
        }
    }
}

// The inverse depth of a plane is affine in the image: its bound touches it everywhere.
TEST_F(TileBounds, OfAPlaneIsThePlane) {
    constexpr glm::ivec2 size(16, 8);
    std::vector<float> depth;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            depth.push_back(static_cast<float>(1.0 / (0.1 + 0.002 * x + 0.003 * y)));
    for (const Bound& bound : bounds_of(size, depth)) {
        EXPECT_NEAR(bound.slope_x, 0.002, 1e-6);
        EXPECT_NEAR(bound.slope_y, 0.003, 1e-6);
    }
}

TEST_F(TileBounds, ATileWithoutSurfacesSaysSo) {
    const std::vector<float> background(81, infinity);
    for (const Bound& bound : bounds_of({9, 9}, background)) EXPECT_EQ(bound.any, 0.0F);
}

// The proof subtracts from the bias what rounding may add to the depth of a sample: of the point, of the
// radius and of the rays (tiles/open.comp), and the 1e-6 of a bound.
TEST_F(TileBounds, ABiasBelowTheRoundingProvesNothing) {
    const scene::GBuffer view = wall({83, 45}, 5.0F);
    const float depth = view.depth.front();
    const auto open = [&](float radius, float bias) {
        return open_tiles(view, {.radius = radius, .bias = bias, .skip_open = true});
    };
    for (const float radius : {0.5F, 4.8F}) {
        const float units = (11.0F * depth + 64.0F * radius) / depth + 11.0F + 14.0F;
        const float rounding = depth * (0x1p-24F * units + 1e-6F);
        EXPECT_EQ(open(radius, rounding), 0U) << radius;
        EXPECT_GT(open(radius, 3.0F * rounding), 0U) << radius;
    }
}

// No pixel of a tile may see a surface rise above its own plane: one tilted normal is enough.
TEST_F(TileBounds, EachPixelOfATileHasItsPlaneConsidered) {
    const Settings settings{.radius = 0.5F, .bias = 0.01F, .skip_open = true};
    scene::GBuffer view = wall({83, 45}, 5.0F);
    const std::uint64_t all = open_tiles(view, settings);
    EXPECT_EQ(all, 11U * 6U);
    for (const std::size_t pixel : {0U, 7U, 27U, 7U * 83U, 7U * 83U + 7U, 3U * 83U + 4U}) {
        glm::vec3& normal = view.normal[pixel];
        normal = glm::normalize(glm::vec3(1, 1, 1));
        EXPECT_EQ(open_tiles(view, settings), all - 1) << pixel;
        normal = {0, 0, 1};
    }
}

// Not even where whole blocks of the pyramid's coarser levels have no surface.
TEST_F(TileBounds, BackgroundDisprovesNothing) {
    const scene::GBuffer view =
        wall_of({320, 32}, [](std::uint32_t x, std::uint32_t) { return x < 64 ? 5.0F : infinity; });
    EXPECT_EQ(open_tiles(view, {.radius = 2.0F, .bias = 0.01F, .skip_open = true}), 8U * 4U);
}

// The tile of a raised pixel is not open, and no other one is closed but those that reach that tile.
TEST_F(TileBounds, ARaisedPixelClosesTheTilesAroundIt) {
    const gpu::Extent extent{96, 96};
    scene::GBuffer view = wall(extent, 5.0F);
    view.depth[44 * extent.width + 44] -= 0.5F;
    const float three_pixels = 30.0F / (96.0F * view.camera.p00_p11().x);
    EXPECT_EQ(open_tiles(view, {.radius = three_pixels, .bias = 0.01F, .skip_open = true}), 144U - 9U);
}

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

}  // namespace gloam::effect::tile_bounds_test

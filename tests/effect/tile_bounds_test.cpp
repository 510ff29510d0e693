// SPDX-License-Identifier: MIT
// What the search for open tiles rests on: a bound of the inverse depth that every surface of a tile keeps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/tiles.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/compute.hpp"
#include "numeric/random.hpp"
#include "on_device.hpp"

namespace gloam::effect {
namespace tile_bounds_test {

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
        AmbientOcclusion& effect = effect_for(view.extent);
        effect.begin(view, settings);
        return effect.next().work.tiles_open;
    }
};

// A wall that faces the eye.
scene::GBuffer wall() {
    scene::GBuffer view{.extent = {83, 45}};
    view.camera = scene::make_frame({}, 83.0 / 45.0);
    view.depth.assign(std::size_t{83} * 45, 5.0F);
    view.normal.assign(view.depth.size(), {0, 0, 1});
    return view;
}

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
    const std::vector<float> background(81, std::numeric_limits<float>::infinity());
    for (const Bound& bound : bounds_of({9, 9}, background)) EXPECT_EQ(bound.any, 0.0F);
}

// The proof subtracts from the bias what rounding may add to the depth of a sample: of the point, of the
// radius and of the rays (tiles/open.comp), and the 1e-6 of a bound.
TEST_F(TileBounds, ABiasBelowTheRoundingProvesNothing) {
    const scene::GBuffer view = wall();
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
    scene::GBuffer view = wall();
    const std::uint64_t all = open_tiles(view, settings);
    EXPECT_EQ(all, 11U * 6U);
    for (const std::size_t pixel : {0U, 7U, 27U, 7U * 83U, 7U * 83U + 7U, 3U * 83U + 4U}) {
        glm::vec3& normal = view.normal[pixel];
        normal = glm::normalize(glm::vec3(1, 1, 1));
        EXPECT_EQ(open_tiles(view, settings), all - 1) << pixel;
        normal = {0, 0, 1};
    }
}

}  // namespace tile_bounds_test
}  // namespace gloam::effect

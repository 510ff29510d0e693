// SPDX-License-Identifier: MIT
// Depth layers by peeling, and as files.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/rasterize.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::layers_test {

constexpr float infinity = std::numeric_limits<float>::infinity();

class LayersTest : public SceneTest {
  protected:
    [[nodiscard]] GBuffer shot(const Scene& scene, const RasterizeOptions& options) {
        return rasterize(device(), passes_, scene, {48, 32}, options);
    }
};

// A box from depth 2 to 3 before a wall at 5.
Scene box_before_a_wall(const Camera& camera = {}) {
    Scene scene{.name = "test", .mesh = make_box({-0.4, -0.3, -3}, {0.4, 0.3, -2}, 0.5), .camera = camera};
    append(scene.mesh, make_parallelogram({-9, -9, -5}, {18, 0, 0}, {0, 18, 0}, 2.0));
    return scene;
}

constexpr std::size_t center = 16 * 48 + 24;

TEST_F(LayersTest, FrontBackAndWhatIsBehind) {
    for (const bool reversed : {false, true}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            const Camera camera{.projection = projection, .reversed_z = reversed};
            const GBuffer view = shot(box_before_a_wall(camera), {.layers = 4});
            ASSERT_EQ(view.layers.size(), 3U);
            EXPECT_NEAR(view.depth[center], 2.0F, 1e-4);
            EXPECT_NEAR(view.layers[0][center], -3.0F, 1e-4);
            EXPECT_NEAR(view.layers[1][center], 5.0F, 1e-4);
            EXPECT_EQ(view.layers[2][center], infinity);
            EXPECT_NEAR(view.depth[0], 5.0F, 1e-4);
            for (const std::vector<float>& layer : view.layers) EXPECT_EQ(layer[0], infinity);
        }
    }
}

TEST_F(LayersTest, EachLiesBehindTheOneBefore) {
    for (const char* name : {"room", "knot", "grass", "columns"}) {
        const GBuffer view = shot(make_scene(name), {.layers = 4});
        std::size_t further = 0;
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            float before = view.depth[i];
            for (const std::vector<float>& layer : view.layers) {
                if (!std::isfinite(layer[i])) {
                    before = infinity;
                    continue;
                }
                ++further;
                ASSERT_GE(std::abs(layer[i]), before) << name << " " << i;
                before = std::abs(layer[i]);
            }
        }
        EXPECT_GT(further, view.depth.size() / 50) << name;
    }
}

// What coincides to the bit is one surface.
TEST_F(LayersTest, NoSurfaceIsFoundTwice) {
    const Scene once = box_before_a_wall();
    Scene twice = once;
    append(twice.mesh, once.mesh);
    EXPECT_EQ(shot(twice, {.layers = 4}).layers, shot(once, {.layers = 4}).layers);
}

TEST_F(LayersTest, OneLayerIsWhatTheEyeSees) {
    const Scene scene = box_before_a_wall();
    EXPECT_THAT(shot(scene, {}).layers, testing::IsEmpty());
    EXPECT_EQ(shot(scene, {}).depth, shot(scene, {.layers = 2}).depth);
    const GBuffer guarded = shot(scene, {.motion = true, .layers = 2, .guard = 0.25});
    EXPECT_EQ(guarded.layers[0].size(), guarded.depth.size());
    EXPECT_EQ(cropped(guarded).layers[0].size(), 48U * 32U);
}

TEST_F(LayersTest, NumbersThatAreNotPossible) {
    for (const int layers : {-1, 0, 5}) {
        expect_error<std::invalid_argument>([&] { (void)shot(box_before_a_wall(), {.layers = layers}); },
                                            {std::to_string(layers).c_str(), "expected 1 to 4"});
    }
}

TEST(LayerFiles, AreReadInTheirOrder) {
    const TemporaryDirectory folder;
    const GBuffer view{.extent = {2, 2}, .depth = {1, 2, 3, 4}, .camera = make_frame({}, 1.0)};
    write_frame(folder, 0, view);
    EXPECT_THAT(read_gbuffer(folder.path(), 0).layers, testing::IsEmpty());
    folder.write("f0000_layer1.pfm", pfm_text(view.extent, {-2, 0, std::nanf(""), -infinity}));
    folder.write("f0000_layer2.pfm", pfm_text(view.extent, {5, 6, 7, 8}));
    const GBuffer read = read_gbuffer(folder.path(), 0);
    EXPECT_THAT(read.layers, testing::ElementsAre(testing::ElementsAre(-2, infinity, infinity, infinity),
                                                  testing::ElementsAre(5, 6, 7, 8)));
}

TEST(LayerFiles, ALayerNeedsTheOneBefore) {
    const TemporaryDirectory folder;
    const GBuffer view{.extent = {2, 2}, .depth = {1, 2, 3, 4}, .camera = make_frame({}, 1.0)};
    write_frame(folder, 0, view);
    folder.write("f0000_layer2.pfm", pfm_text(view.extent, {5, 6, 7, 8}));
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_layer2.pfm", "the layer before it"});
    folder.write("f0000_layer1.pfm", pfm_text({1, 2}, {5, 6}));
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_layer1.pfm", "1x2", "expected 2x2"});
}

}  // namespace gloam::scene::test::layers_test

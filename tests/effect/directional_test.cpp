// SPDX-License-Identifier: MIT
// Bent normals and light by direction, as their passes make them, and the lit image.
#include "effect/directional.hpp"
#include "effect/composite.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::directional_test {

class Directions : public OnDevice<testing::Test> {
  protected:
    Directional directional_{device_, passes_};
};

// A corner of a white floor, a green and a red wall, or what `change` makes of it. Red of the lights, x of
// the bent normal and the cone's half angle. Of eight samples: another number of them, or another sample, is
// seen.
struct Known {
    const char* what;
    std::size_t pixel;
    float direct, bounced, bent, half_angle;
    void (*change)(scene::GBuffer& view) = [](scene::GBuffer&) {};
    int interleave = 1;
    double guard = 0.0;
    unsigned samples = 8;
};

// Beside a step that is higher than the radius half the hemisphere is blocked: 45 degrees, acos(sqrt(2) - 1).
void put_step(scene::GBuffer& view) {
    view = step(1.5F, 3.0F, close);
    view.color.assign(view.depth.size(), glm::vec3(0.5F));
}

const Known known[] = {
    {"", 1369, 0.3428F, 0.0601F, 0.5567F, 1.2464F},
    {"", 1554, 0.2110F, 0.0349F, 0.5771F, 1.5708F},
    {"interleaved", 1369, 0.3428F, 0.0601F, 0.6885F, 1.4977F, [](scene::GBuffer&) {}, 4},
    {"stored", 1369, 0.3428F, 0.0601F, 0.5567F, 1.2464F,
     [](scene::GBuffer& view) {
         view.stored = scene::stored_inputs(view, {.depth_buffer = true, .octahedral = true});
     }},
    {"normals from depth", 1369, 0.2884F, 0.0194F, 0.6094F, 1.5708F,
     [](scene::GBuffer& view) { view.normal.clear(); }},
    {"background", 1369, 0.0F, 0.0F, 0.0F, 0.0F,
     [](scene::GBuffer& view) { std::ranges::fill(view.depth, infinity); }},
    {"nothing open", 1369, 0.0F, 0.0F, 0.7399F, 0.0F, [](scene::GBuffer& view) { view.depth[1369] += 0.7F; }},
    {"guarded", 1369, 0.2741F, 0.0774F, 0.3053F, 1.2464F, [](scene::GBuffer&) {}, 1, 0.25},
    {"beside a step", beside, 0.1291F, 0.0F, 0.6787F, 1.1940F, put_step, 1, 0.0, 1024},
    {"beside a step, interleaved", beside, 0.1276F, 0.0F, 0.6528F, 1.2164F, put_step, 4, 0.0, 64},
    {"beside a step in front of the range", beside, 0.4251F, 0.0F, 0.0579F, 1.5708F,
     [](scene::GBuffer& view) { view = step(1.0F, 3.0F, close); }, 1, 0.0, 1024},
    {"normals that differ, interleaved", 1369, 0.3480F, 0.0120F, 0.7184F, 1.4789F,
     [](scene::GBuffer& view) {
         for (std::size_t i = 0; i < view.normal.size(); ++i)
             view.normal[i].x += 0.3F * static_cast<float>(i % 3);
     },
     4},
    {"beside a low step, interleaved", beside, 0.4292F, 0.0F, 0.0744F, 1.5480F,
     [](scene::GBuffer& view) { view = step(2.95F, 3.0F, close); }, 4},
    {"behind the eye", 1369, 0.2617F, 0.0245F, 0.3651F, 1.2560F,
     [](scene::GBuffer& view) {
         for (float& depth : view.depth) depth *= 0.125F;
     },
     1, 0.0, 1024}};

TEST_F(Directions, KeepTheirPixels) {
    for (const auto& [what, pixel, direct, bounced, bent, half_angle, change, interleave, guard, samples] :
         known) {
        scene::GBuffer view = drawn("corner", {64, 36}, {.color = true, .guard = guard});
        change(view);
        Settings few = with_radius({}, 0.8F);
        few.samples = samples;
        const DirectionalLight light = directional_.light(view, few, clear_sky);
        const BentNormals directions = directional_.bent_normals(view, few, interleave);
        EXPECT_NEAR(light.direct.at(pixel).x, direct, 2e-4) << what << pixel;
        EXPECT_NEAR(light.bounced.at(pixel).x, bounced, 2e-4) << what << pixel;
        EXPECT_NEAR(directions.direction.at(pixel).x, bent, 2e-4) << what << pixel;
        EXPECT_NEAR(directions.half_angle.at(pixel), half_angle, 2e-4) << what << pixel;
    }
}

class CompositePass : public OnDevice<testing::Test> {
  protected:
    Composite composite_{device_, passes_};
};

// ISSAO-2 and direct light; with an albedo GTAO-bounce in the place of the first. Occlusion outside of [0, 1]
// is clamped, and NaN counts as 0.
struct Lit {
    float occlusion;
    glm::vec3 ambient, direct, plain, bounced;
};
const glm::vec3 white(1, 2, 4);
const glm::vec3 red(0.5F, 0, 0);
const Lit rows[] = {{0.0F, white, red, {1.5F, 2, 4}, {1.5F, 2, 4}},
                    {0.5F, white, red, {1, 1, 2}, {1, 2 * 0.68096F, 4 * 0.8979F}},
                    {0.25F, {4, 0, 8}, {0, 1, 0}, {3, 1, 6}, {3, 1, 8 * 0.9684F}},
                    {1.5F, white, red, red, red},
                    {-1.0F, white, red, {1.5F, 2, 4}, {1.5F, 2, 4}},
                    {nan, white, red, {1.5F, 2, 4}, {1.5F, 2, 4}}};

// In an image whose sides are no multiples of a group's.
TEST_F(CompositePass, LightsEachPixel) {
    const backend::Extent extent{37, 21};
    std::vector<glm::vec3> ambient, direct;
    std::vector<float> occlusion;
    for (std::size_t i = 0; i < 37 * 21; ++i) {
        const Lit& row = rows[i % std::size(rows)];
        ambient.push_back(row.ambient);
        direct.push_back(row.direct);
        occlusion.push_back(row.occlusion);
    }
    const std::vector<glm::vec3> albedo(ambient.size(), {0, 0.5F, 1});
    const std::vector<glm::vec3> plain = composite_.lit(extent, ambient, direct, occlusion);
    const std::vector<glm::vec3> bounced = composite_.lit(extent, ambient, direct, occlusion, albedo);
    const std::vector<glm::vec3> open = composite_.lit(extent, ambient, direct, {});
    ASSERT_EQ(plain.size(), ambient.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const Lit& row = rows[i % std::size(rows)];
        EXPECT_EQ(plain[i], row.plain) << i;
        EXPECT_LT(glm::distance(bounced[i], row.bounced), 1e-3F) << i;
        EXPECT_EQ(open[i], row.ambient + row.direct) << i;
    }
}

}  // namespace gloam::effect::directional_test

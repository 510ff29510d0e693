// SPDX-License-Identifier: MIT
// Bent normals and light by direction, as their passes make them, and the lit image.
#include "effect/directional.hpp"
#include "effect/composite.hpp"
#include "numeric/random.hpp"
#include "on_device.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/occlusion.hpp"
#include "reference/sampling.hpp"
#include "reference/shading.hpp"
#include "surface_views.hpp"

namespace gloam::effect::directional_test {

double degrees_between(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(std::clamp(glm::dot(glm::dvec3(a), glm::dvec3(b)), -1.0, 1.0)) * 180.0 /
           std::numbers::pi;
}

class Directions : public OnDevice<testing::Test> {
  protected:
    Directional directional_{device_, passes_};
};

Settings many(float radius = 1.0F) {
    Settings settings = with_radius({}, radius);
    settings.samples = 1024;
    return settings;
}

constexpr float high = 1.5F;  // a step that is higher than the radius

// Every window with as many pixels as share a pattern contains the whole pattern. On a plane, all pixels with
// few samples therefore agree with each other, and with a single pixel that takes all samples. Without
// interleaving each pixel has a direction of its own.
TEST_F(Directions, InterleavedPixelsShareOnePattern) {
    const scene::GBuffer view = step(3.0F, 3.0F);
    Settings few = with_radius({}, 1.0F);
    few.samples = 4;
    Settings all = few;
    all.samples = 4 * 16;
    const auto off = [&](const BentNormals& bent) {
        float most = 0.0F;
        for (std::size_t y = 4; y + 4 < 32; ++y)
            for (std::size_t x = 4; x + 4 < 48; ++x)
                most =
                    std::max(most, glm::distance(bent.direction[48 * y + x], bent.direction[48 * 16 + 24]));
        return most;
    };
    EXPECT_GT(off(directional_.bent_normals(view, few)), 0.1F);
    const BentNormals shared = directional_.bent_normals(view, few, 4);
    EXPECT_LT(off(shared), 1e-6F);
    // One pixel with the same points, but for its turn around the normal.
    const BentNormals alone = directional_.bent_normals(view, all);
    EXPECT_NEAR(shared.direction[48 * 16 + 24].z, alone.direction[48 * 16 + 24].z, 1e-6F);
    EXPECT_NEAR(shared.half_angle[48 * 16 + 24], alone.half_angle[48 * 16 + 24], 1e-5F);
}

// Interleaved, pixels on another surface do not count, in whatever unit of length.
TEST_F(Directions, HalfABlockedHemisphereBendsBy45Degrees) {
    const float diagonal = std::sqrt(0.5F);
    for (const auto& [interleave, unit] : {std::pair(1, 1.0F), {4, 1.0F}, {4, 0.02F}}) {
        const scene::GBuffer view = step(unit * (3.0F - high), unit * 3.0F, double{unit} * close);
        const BentNormals bent = directional_.bent_normals(view, many(unit), interleave);
        EXPECT_LT(degrees_between(bent.direction[beside], {diagonal, 0, diagonal}), 10.0) << interleave;
        EXPECT_LT(degrees_between(bent.direction[beside - 1], {0, 0, 1}), 0.5) << "on top";
        EXPECT_NEAR(bent.half_angle[beside], std::acos(std::sqrt(2.0) - 1.0), 0.1) << interleave;
    }
}

// The world's up lies in the image's plane or towards the eye.
TEST_F(Directions, LightComesFromWhereItIs) {
    const Sky blue_above{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}};
    const auto seen_with = [&](const glm::dvec3& up, float left) {
        scene::GBuffer view = step(left, 3.0F, close);
        view.camera = scene::make_frame({.target = {0, 0, -1},
                                         .up = up,
                                         .projection = scene::Projection::orthographic,
                                         .view_height = close},
                                        1.5);
        return directional_.light(view, many(), blue_above).direct[beside];
    };
    const glm::vec3 open = seen_with({0, 1, 0}, 3.0F);
    EXPECT_NEAR(open.x, 0.5F, 0.02F);
    EXPECT_NEAR(open.z, 0.5F, 0.02F);
    EXPECT_GT(seen_with({1, 0, 0}, 3.0F - high).x, 0.45F) << "turned, the wall hides the sky";
    EXPECT_LT(seen_with({1, 0, 0}, 3.0F - high).z, 0.1F);
    scene::GBuffer floor = step(3.0F, 3.0F);  // looking down: up is the surface's normal
    floor.camera = scene::make_frame({.target = {0, -1, 0},
                                      .up = {0, 0, -1},
                                      .projection = scene::Projection::orthographic,
                                      .view_height = 8.0},
                                     1.5);
    const DirectionalLight sky = directional_.light(floor, many(), clear_sky);
    EXPECT_GT(sky.direct[beside].z, sky.direct[beside].x + 0.1F);
}

// One pixel's bounce by the references, from random points.
glm::dvec3 bounce_of(const scene::GBuffer& view, const DirectionalLight& light, const Settings& settings,
                     glm::ivec2 pixel) {
    const reference::GloamCamera camera{
        glm::dvec2(view.camera.p00_p11()),
        {static_cast<int>(view.extent.width), static_cast<int>(view.extent.height)},
        view.camera.orthographic()};
    const auto at = [&](glm::ivec2 p) { return static_cast<std::size_t>(p.y * camera.size.x + p.x); };
    const glm::dvec3 position =
        reference::gloam_camera_position(pixel, double{view.depth[at(pixel)]}, camera);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(view.normal[at(pixel)]));
    const glm::dmat3 frame = reference::gloam_tangent_frame(normal);
    const double radius = double{settings.radius};
    numeric::Random random(11);
    glm::dvec3 sum(0);
    double count = 0.0;
    for (int i = 0; i < 80'000; ++i) {
        const glm::dvec3 point =
            reference::gloam_hemisphere_uniform(glm::dvec3(random.unit(), random.unit(), random.unit()));
        const glm::dvec3 there = position + radius * (frame * point);
        if (there.z >= 0.0) continue;  // behind the eye
        count += 1.0;
        const glm::ivec2 seen =
            reference::gloam_nearest_pixel(reference::gloam_camera_uv(there, camera), camera.size);
        const glm::dvec2 ray(reference::gloam_camera_position(seen, 1.0, camera));
        const double depth = reference::gloam_plane_depth(ray, there, normal, camera.orthographic);
        const double buffer = double{view.depth[at(seen)]};
        if (!reference::gloam_sample_blocked(depth, buffer, double{settings.bias},
                                             double{settings.own.range}))
            continue;
        const glm::dvec3 offset = reference::gloam_camera_position(seen, buffer, camera) - position;
        sum += reference::gloam_ssdo_bounce(offset, normal, glm::dvec3(view.normal[at(seen)]),
                                            glm::dvec3(light.direct[at(seen)]), radius,
                                            double{settings.own.epsilon}, 0.0);
    }
    return glm::dvec3(view.color[at(pixel)]) * sum / count;
}

// The corner's walls are red and green. Of the larger radius many samples are behind the eye.
class Bounces : public Directions, public testing::WithParamInterface<float> {};
TEST_P(Bounces, AWallTintsTheFloorBesideIt) {
    const scene::GBuffer view = drawn("corner", {64, 36}, {.color = true});
    const Settings settings = many(GetParam());
    const DirectionalLight light = directional_.light(view, settings, Sky{});
    int red = 0;
    int green = 0;
    int compared = 0;
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto i = static_cast<std::size_t>(64 * y + x);
            const bool floor = view.color[i].x == view.color[i].y && view.color[i].x > 0.0F;
            const glm::vec3& bounce = light.bounced[i];
            if (!floor || bounce.x + bounce.y < 0.05F) continue;
            red += bounce.x > 1.5F * bounce.y ? 1 : 0;
            green += bounce.y > 1.5F * bounce.x ? 1 : 0;
            if (++compared % 20 != 0) continue;
            const glm::dvec3 expected = bounce_of(view, light, settings, {x, y});
            EXPECT_LT(glm::length(glm::dvec3(bounce) - expected), 0.05 * glm::length(expected) + 2e-3)
                << x << " " << y;
        }
    }
    EXPECT_GT(red, 20);
    EXPECT_GT(green, 20);
    EXPECT_GT(compared, 100);
}
INSTANTIATE_TEST_SUITE_P(Radii, Bounces, testing::Values(1.0F, 6.0F), testing::PrintToStringParamName());

// Of eight samples: another number of them, or another sample, is seen.
struct Known {
    const char* what;
    std::size_t pixel;
    float direct, bounced, bent, half_angle;
    void (*change)(scene::GBuffer& view) = [](scene::GBuffer&) {};
    int interleave = 1;
    double guard = 0.0;
};
const Known known[] = {
    {"", 1369, 0.3428F, 0.0434F, 0.5567F, 1.2464F},
    {"", 1554, 0.1710F, 0.0891F, 0.3612F, 1.4791F},
    {"interleaved", 1369, 0.3428F, 0.0434F, 0.6787F, 1.4758F, [](scene::GBuffer&) {}, 4},
    {"stored", 1369, 0.3428F, 0.0434F, 0.5567F, 1.2464F,
     [](scene::GBuffer& view) {
         view.stored = scene::stored_inputs(view, {.depth_buffer = true, .octahedral = true});
     }},
    {"normals from depth", 1369, 0.2884F, 0.0155F, 0.6094F, 1.5708F,
     [](scene::GBuffer& view) { view.normal.clear(); }},
    {"background", 1369, 0.0F, 0.0F, 0.0F, 0.0F,
     [](scene::GBuffer& view) { std::ranges::fill(view.depth, infinity); }},
    {"nothing open", 1369, 0.0F, 0.0F, 0.7399F, 0.0F, [](scene::GBuffer& view) { view.depth[1369] += 1.5F; }},
    {"guarded", 1369, 0.2641F, 0.0766F, 0.4772F, 0.9589F, [](scene::GBuffer&) {}, 1, 0.25}};

TEST_F(Directions, KeepTheirPixels) {
    Settings few = many();
    few.samples = 8;
    for (const auto& [what, pixel, direct, bounced, bent, half_angle, change, interleave, guard] : known) {
        scene::GBuffer view = drawn("corner", {64, 36}, {.color = true, .guard = guard});
        change(view);
        const DirectionalLight light = directional_.light(view, few, clear_sky);
        const BentNormals directions = directional_.bent_normals(view, few, interleave);
        EXPECT_NEAR(light.direct.at(pixel).x, direct, 1e-3) << what << pixel;
        EXPECT_NEAR(light.bounced.at(pixel).x, bounced, 1e-3) << what << pixel;
        EXPECT_NEAR(directions.direction.at(pixel).x, bent, 1e-3) << what << pixel;
        EXPECT_NEAR(directions.half_angle.at(pixel), half_angle, 1e-3) << what << pixel;
    }
}

TEST_F(Directions, OfWrongImagesAndOptionsAreRefused) {
    scene::GBuffer view = step(3.0F, 3.0F);
    for (const int sides : {0, 9, -1})
        EXPECT_THROW((void)directional_.bent_normals(view, many(), sides), std::invalid_argument);
    view.color.resize(7);
    EXPECT_THROW((void)directional_.light(view, many(), clear_sky), std::invalid_argument);
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
    const gpu::Extent extent{37, 21};
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

TEST_F(CompositePass, RefusesImagesOfAnotherSize) {
    const std::vector<glm::vec3> light(6);
    for (const auto& [extent, occlusions, message] : {std::tuple{gpu::Extent{3, 2}, 4, "4 occlusions"},
                                                      {gpu::Extent{3, 3}, 0, "6 pixels with ambient light"}})
        EXPECT_THAT([&] { (void)composite_.lit(extent, light, light, std::vector<float>(occlusions)); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
}

}  // namespace gloam::effect::directional_test

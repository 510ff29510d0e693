// SPDX-License-Identifier: MIT
// Bent normals and light by direction, as their passes make them.
#include "directions.hpp"
#include "numeric/random.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/occlusion.hpp"
#include "reference/sampling.hpp"
#include "reference/shading.hpp"
#include "scene/mesh.hpp"

namespace gloam::effect::directional_test {

constexpr double pi = std::numbers::pi;

double degrees_between(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(std::clamp(glm::dot(glm::dvec3(a), glm::dvec3(b)), -1.0, 1.0)) * 180.0 / pi;
}

// An engine's depth buffer and encoded normals are converted before.
TEST_F(Directions, WhatAnEngineStoresIsReadAsDepth) {
    scene::GBuffer view = step(1.5F, 3.0F, close);
    const BentNormals wanted = directional_.bent_normals(view, many());
    view.stored = scene::stored_inputs(view, {.depth_buffer = true, .octahedral = true});
    const BentNormals found = directional_.bent_normals(view, many());
    EXPECT_EQ(found.direction, wanted.direction);
    EXPECT_EQ(found.half_angle, wanted.half_angle);
}

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
    const BentNormals shared = directional_.bent_normals(view, few, {.interleave = 4});
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
        const BentNormals bent = directional_.bent_normals(view, many(unit), {.interleave = interleave});
        EXPECT_LT(degrees_between(bent.direction[beside], {diagonal, 0, diagonal}), 10.0) << interleave;
        EXPECT_LT(degrees_between(bent.direction[beside - 1], {0, 0, 1}), 0.5) << "on top";
        EXPECT_NEAR(bent.half_angle[beside], std::acos(std::sqrt(2.0) - 1.0), 0.1) << interleave;
    }
    for (const int sides : {0, 9, -1})
        EXPECT_THROW((void)directional_.bent_normals(step(3.0F, 3.0F), many(), {.interleave = sides}),
                     std::invalid_argument);
}

// Inside a ball that is small beside the radius nothing is open.
TEST_F(Directions, WhereNothingIsOpenTheNormalStays) {
    scene::Scene ball{.name = "ball", .mesh = scene::make_sphere({0, 0, 0}, 1.0, 24, 48)};
    ball.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .near = 0.01};
    const scene::GBuffer view = drawn(ball, {24, 16});
    Settings settings = with_radius({}, 1e4F);
    settings.samples = 32;
    settings.filter = Filter::none;
    const BentNormals bent = directional_.bent_normals(view, settings);
    const DirectionalLight light = directional_.light(view, settings, Sky{});
    std::size_t closed = 0;  // a sample that falls beside the image may be open
    for (std::size_t i = 0; i < bent.direction.size(); ++i) {
        if (light.direct[i] != glm::vec3(0)) continue;
        ++closed;
        ASSERT_EQ(bent.half_angle[i], 0.0F) << i;
        ASSERT_LT(degrees_between(bent.direction[i], view.normal[i]), 0.1) << i;
    }
    EXPECT_GT(closed, bent.direction.size() / 2);
}

// Albedo times light times visibility, whichever directions it is estimated by.
TEST_F(Directions, ConstantLightIsVisibility) {
    const scene::GBuffer view = drawn("corner", {64, 36}, {.color = true});
    const glm::vec3 radiance(0.5F, 2.0F, 1.0F);
    const DirectionalLight light = directional_.light(view, many(), Sky{radiance, radiance, radiance});
    AmbientOcclusion effect(device_, passes_, view.extent);
    effect.begin(view, many());
    const Frame frame = effect.next();
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        if (!std::isfinite(view.depth[i])) continue;
        const glm::vec3 expected = view.color[i] * radiance * (1.0F - frame.occlusion[i]);
        ASSERT_LT(glm::length(light.direct[i] - expected), 0.03F * glm::length(view.color[i] * radiance))
            << i;
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
TEST_F(Directions, KeepTheirPixels) {
    const scene::GBuffer view = drawn("corner", {64, 36}, {.color = true});
    Settings few = many();
    few.samples = 8;
    const DirectionalLight light = directional_.light(view, few, clear_sky);
    const BentNormals bent = directional_.bent_normals(view, few);
    struct Known {
        std::size_t pixel;
        float direct, bounced, half_angle;
    };
    for (const Known& known : {Known{1369, 0.3428F, 0.0434F, 1.2464F}, {1554, 0.1710F, 0.0891F, 1.4791F}}) {
        EXPECT_NEAR(light.direct[known.pixel].x, known.direct, 1e-3) << known.pixel;
        EXPECT_NEAR(light.bounced[known.pixel].x, known.bounced, 1e-3) << known.pixel;
        EXPECT_NEAR(bent.half_angle[known.pixel], known.half_angle, 1e-3) << known.pixel;
    }
}

TEST_F(Directions, BackgroundHasNoBentNormalAndNoLight) {
    scene::GBuffer view = step(3.0F, 3.0F);
    view.depth[100] = infinity;
    view.color.assign(view.depth.size(), glm::vec3(1));
    const DirectionalLight light = directional_.light(view, many(), clear_sky);
    EXPECT_EQ(light.direct[100], glm::vec3(0));
    EXPECT_EQ(light.bounced[100], glm::vec3(0));
    for (const int interleave : {1, 4}) {
        const BentNormals bent = directional_.bent_normals(view, many(), {.interleave = interleave});
        EXPECT_EQ(bent.direction[100], glm::vec3(0)) << interleave;
        EXPECT_EQ(bent.half_angle[100], 0.0F) << interleave;
    }
}

TEST_F(Directions, WithoutNormalsAndWithABand) {
    scene::GBuffer view = drawn("corner", {31, 17}, {.color = true, .guard = 0.25});
    Settings settings = many();
    settings.samples = 16;
    view.normal.clear();
    const BentNormals bent = directional_.bent_normals(view, settings);
    EXPECT_EQ(bent.direction.size(), 31U * 17U);
    for (const glm::vec3& direction : bent.direction) EXPECT_NEAR(glm::length(direction), 1.0F, 1e-5);
    EXPECT_EQ(directional_.light(view, settings, clear_sky).bounced.size(), 31U * 17U);
    view.color.pop_back();
    EXPECT_THROW((void)directional_.light(view, settings, clear_sky), std::invalid_argument);
}

}  // namespace gloam::effect::directional_test

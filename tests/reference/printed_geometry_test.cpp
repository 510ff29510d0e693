// SPDX-License-Identifier: MIT
#include "reference/geometry/borders.hpp"
#include "reference/geometry/camera.hpp"
#include "reference/geometry/linear_depth.hpp"
#include "reference/geometry/normal.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/geometry/position.hpp"
#include "reference/geometry/projected_radius.hpp"
#include "reference/geometry/reprojection.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/printed.hpp"

namespace gloam::reference::test {
namespace printed_geometry_test {

dmat4 random_matrix(numeric::Random& random) {
    dmat4 m(1.0);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) m[column][row] = random.uniform(-1, 1);
    }
    return m;
}

TEST(Printed, DepthInvertsItsProjection) {
    for_random([](numeric::Random& random) {
        const double near = random.uniform(0.1, 1);
        const double far = near * random.uniform(2, 100);
        const double d = random.uniform(near, far);
        const auto inverts = [&](auto linear_depth, double p22, double p32, double w, bool gl) {
            for (const double sign : {1.0, -1.0}) {  // standard and, in OpenGL's range, reversed
                const double ndc = sign * (p22 * -d + p32) / w;
                const double b = gl ? (ndc + 1.0) / 2.0 : ndc;
                if (sign > 0.0 || gl) expect_same(linear_depth(b, sign * p22, sign * p32), d, 100.0 * d);
            }
        };
        const double span = near - far;
        inverts([](auto... x) { return gloam_linear_depth_perspective_vk(x...); }, far / span,
                far * near / span, d, false);
        inverts([](auto... x) { return gloam_linear_depth_perspective_gl(x...); }, (far + near) / span,
                2 * far * near / span, d, true);
        inverts([](auto... x) { return gloam_linear_depth_orthographic_vk(x...); }, 1 / span, near / span, 1,
                false);
        inverts([](auto... x) { return gloam_linear_depth_orthographic_gl(x...); }, 2 / span,
                (far + near) / span, 1, true);
    });
}

TEST(Printed, PositionsAndTheirProjections) {
    for_random([](numeric::Random& random) {
        const glm::ivec2 size(1 + static_cast<int>(random.below(4096)),
                              1 + static_cast<int>(random.below(4096)));
        const glm::ivec2 pixel(static_cast<int>(random.below(4096)), static_cast<int>(random.below(4096)));
        const dvec2 ndc = gloam_ndc_from_pixel(pixel, size);
        const dvec2 center((pixel.x + 0.5) / size.x, (pixel.y + 0.5) / size.y);
        expect_same(ndc, 2.0 * center - 1.0, 1.0 + std::max(center.x, center.y));
        expect_same(gloam_uv_from_ndc(ndc), center, 1.0);
        const dvec2 scale(random.uniform(0.5, 2), -random.uniform(0.5, 2));
        const double d = log_uniform(random, 0.1, 100);
        const dvec3 p(ndc.x * d / scale.x, ndc.y * d / scale.y, -d);
        expect_same(gloam_view_position_perspective(ndc, d, scale), p);
        expect_same(gloam_ndc_perspective(p, scale), dvec2(scale.x * p.x / d, scale.y * p.y / d));
        const dvec3 flat(ndc.x / scale.x, ndc.y / scale.y, -d);
        expect_same(gloam_view_position_orthographic(ndc, d, scale), flat);
        expect_same(gloam_ndc_orthographic(flat, scale), dvec2(scale.x * flat.x, scale.y * flat.y));
    });
}

TEST(Printed, ProjectedRadius) {
    for_random([](numeric::Random& random) {
        const dvec2 scale(random.uniform(0.5, 2), -random.uniform(0.5, 2));
        const double d = log_uniform(random, 0.1, 100);
        const double r = log_uniform(random, 0.01, 10);
        const glm::ivec2 size(1920, 1080);
        const dvec2 near(r * scale.x / (2 * d), r * -scale.y / (2 * d));
        const dvec2 flat(r * scale.x / 2, r * -scale.y / 2);
        expect_same(gloam_projected_radius_uv(r, d, scale), near);
        expect_same(gloam_projected_radius_pixels(r, d, scale, size), near * dvec2(size));
        expect_same(gloam_projected_radius_uv_orthographic(r, d, scale), flat);
        expect_same(gloam_projected_radius_pixels_orthographic(r, d, scale, size), flat * dvec2(size));
    });
}

// n . (o + t w - q) = 0 with the ray's origin o and direction w, w.z = -1, so that t is the depth.
TEST(Printed, PlaneDepthIsOnTheRayAndInThePlane) {
    for_random([](numeric::Random& random) {
        const GloamCamera camera{dvec2(1.5, -1.25), glm::ivec2(64, 48), random.below(2) == 0};
        const glm::ivec2 pixel(static_cast<int>(random.below(64)), static_cast<int>(random.below(48)));
        const dvec2 ndc = gloam_ndc_from_pixel(pixel, camera.size);
        const dvec2 side(ndc.x / 1.5, ndc.y / -1.25);
        const dvec3 origin = camera.orthographic ? dvec3(side.x, side.y, 0) : dvec3(0);
        const dvec3 direction = camera.orthographic ? dvec3(0, 0, -1) : dvec3(side.x, side.y, -1);
        const dvec3 normal(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1.0);
        const dvec3 point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-9, -3));
        const double t = (dot(normal, point) - dot(normal, origin)) / dot(normal, direction);
        expect_same(gloam_plane_depth(pixel, point, normal, camera), t > 0.0 ? t : -point.z, 10.0);
    });
}

TEST(Printed, NormalsAreNormalizedCrossProducts) {
    for_random([](numeric::Random& random) {
        const dvec3 v = point3(random) * log_uniform(random, 1e-30, 1e30);
        expect_same(gloam_safe_normalize(v, dvec3(0)), v / length(v));
        // A slanted plane: every one-sided difference lies in it.
        const dvec3 c(0.1, 0.2, -4);
        const dvec3 x(0.1, 0.0, random.uniform(-0.1, 0.1));
        const dvec3 y(0.0, 0.1, random.uniform(-0.1, 0.1));
        dvec3 n = cross(x, y);
        n = n / length(n);
        if (dot(n, c) > 0.0) n = -n;
        expect_same(gloam_normal_from_neighbors(c, c - x, c + x, c + y, c - y), n);
        expect_same(gloam_normal_from_neighbors_orthographic(c, c - x, c + x, c + y, c - y),
                    n.z < 0 ? -n : n);
    });
}

TEST(Printed, ReprojectionIsTheProductOfItsMatrices) {
    for_random([](numeric::Random& random) {
        const dvec4 clip(random.uniform(-1, 1), random.uniform(-1, 1), random.unit(), random.uniform(0.1, 1));
        const dmat4 a = random_matrix(random);
        const dmat4 b = random_matrix(random);
        const dmat4 c = random_matrix(random);
        const dmat4 d = random_matrix(random);
        expect_same(gloam_previous_clip_static(clip, a, b, c, d), d * c * b * a * clip, 100.0);
        const dmat4 e = random_matrix(random);
        const dmat4 f = random_matrix(random);
        expect_same(gloam_previous_clip_moving(clip, a, b, c, d, e, f), f * e * d * (c * b * a) * clip,
                    100.0);
        const dvec3 world = point3(random, 10);
        const dvec4 moved = b * a * dvec4(world.x, world.y, world.z, 1.0);
        expect_same(gloam_previous_world(world, a, b), dvec3(moved), 1000.0);
        expect_same(gloam_previous_depth(world, a), -(a * dvec4(world.x, world.y, world.z, 1.0)).z, 1000.0);
        dvec2 uv(0);
        if (gloam_uv_from_clip(clip, uv)) {
            expect_same(uv, dvec2(clip.x / clip.w / 2 + 0.5, clip.y / clip.w / 2 + 0.5), 1.0);
        } else {
            EXPECT_TRUE(std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w);
        }
    });
}

TEST(Printed, PixelsAndGuardBands) {
    for_random([](numeric::Random& random) {
        const glm::ivec2 size(1 + static_cast<int>(random.below(4096)),
                              1 + static_cast<int>(random.below(4096)));
        const dvec2 uv(random.unit(), random.unit());
        const dvec2 center((std::floor(uv.x * size.x) + 0.5) / size.x,
                           (std::floor(uv.y * size.y) + 0.5) / size.y);
        expect_same(gloam_pixel_center(uv, size), center);
        const double guard = random.unit();
        const glm::ivec2 border = gloam_guard_band_border(size, guard);
        EXPECT_EQ(border, glm::ivec2(std::lround(guard * size.x), std::lround(guard * size.y)));
        EXPECT_EQ(gloam_guard_band_size(size, guard), size + 2 * border);
        const dvec2 g = gloam_guard_band_guard(size, guard);
        expect_same(g, dvec2(border) / dvec2(size));
        expect_same(gloam_guard_band_inner_uv(uv, g), uv * (1.0 + 2.0 * g) - g, 3.0);
        expect_same(gloam_guard_band_outer_uv(gloam_guard_band_inner_uv(uv, g), g), uv, 3.0);
        expect_same(gloam_guard_band_tan_half_fov(0.7, g.x), (1.0 + 2.0 * g.x) * 0.7);
    });
}

}  // namespace printed_geometry_test
}  // namespace gloam::reference::test

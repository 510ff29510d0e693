// SPDX-License-Identifier: MIT
// What equations say of each other: places, normals, counts, frames that follow one another. Of the
// references: tests/catalogue compares each function of the library with its reference.
#include <glm/gtc/matrix_transform.hpp>

#include "numeric/random.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/temporal.hpp"
#include "support/test.hpp"

namespace gloam::reference::equations_test {

using glm::ivec2;

const dvec3 up(0, 0, 1);

TEST(Geometry, PositionsProjectBackOntoTheirPixels) {
    const ivec2 size(33, 7);
    for (const dvec2 scale : {dvec2(1.5, -2), dvec2(1.5, 2)}) {
        for (const ivec2 pixel : {ivec2(0, 0), ivec2(32, 6), ivec2(5, 1)}) {
            const dvec2 ndc = gloam_ndc_from_pixel(pixel, size);
            EXPECT_NEAR(ndc.x, (2 * pixel.x + 1) / 33.0 - 1, 1e-12);
            const dvec3 p = gloam_view_position_perspective(ndc, 4.0, scale);
            EXPECT_EQ(p.z, -4.0);
            EXPECT_GT(p.y * ndc.y * scale.y, 0.0);  // up is where the projection says
            EXPECT_LT(distance(gloam_ndc_perspective(p, scale), ndc), 1e-12);
            const dvec2 center = gloam_pixel_center(0.5 * ndc + 0.5, size);
            EXPECT_EQ(gloam_pixel_center(center, size), center);
        }
    }
    const dvec2 scale(0.8, -1.3);
    const dvec2 there = 0.5 * abs(gloam_ndc_perspective({0.6, 0.6, -3}, scale));
    EXPECT_LT(distance(gloam_projected_radius_uv(0.6, 3.0, scale), there), 1e-12);
}

// Whatever the rounding, a pixel of the crop is the same pixel of the image with the band: same place, same
// footprint. inner: texture coordinates in the crop of those in the image with the band.
TEST(Geometry, CropIsConsistentAtOddSizes) {
    const auto inner = [](dvec2 uv, dvec2 guard) { return uv + guard * (2.0 * uv - 1.0); };
    for (const ivec2 size : {ivec2(33, 17), ivec2(1, 1), ivec2(101, 7)}) {
        const ivec2 band = gloam_guard_band_border(size, 0.07);
        const dvec2 guard = gloam_guard_band_guard(size, 0.07);
        const ivec2 with_band = size + 2 * band;
        for (const ivec2 pixel : {ivec2(0), size / 2, size - 1}) {
            const dvec2 band_uv = (dvec2(pixel + band) + 0.5) / dvec2(with_band);
            EXPECT_LT(distance(inner(band_uv, guard), (dvec2(pixel) + 0.5) / dvec2(size)), 1e-12);
        }
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(gloam_guard_band_tan_half_fov(0.5, guard[axis]) / with_band[axis], 0.5 / size[axis],
                        1e-12);
    }
    // With the guard asked for instead, the first pixel of a 33-pixel row would be off by more than a tenth
    // of a pixel.
    EXPECT_GT(std::abs(inner(dvec2(2.5 / 37, 0.5), dvec2(0.07)).x - 0.5 / 33) * 33, 0.1);
}

TEST(Geometry, CurvaturesOfABallACylinderASaddleAndAPlaneInAnyDirections) {
    const double r = 4;
    const double step = 0.01;
    for (const double turn : {0.0, 0.4, 1.1}) {
        for (const double apart : {0.6, 1.57, 2.4}) {  // between the two axes of the image on the surface
            const dvec3 x(on_circle(turn), 0);
            const dvec3 y(on_circle(turn + apart), 0);
            const auto expect = [&](auto normal_change, dvec2 want) {
                const dvec2 got = gloam_principal_curvatures(
                    step * x, 1.5 * step * y, normal_change(step * x), normal_change(1.5 * step * y));
                EXPECT_LT(distance(got, want), 1e-9) << turn << ' ' << apart;
            };
            expect([&](dvec3 p) { return -p / r; }, {1 / r, 1 / r});   // inside
            expect([&](dvec3 p) { return p / r; }, {-1 / r, -1 / r});  // outside
            expect([&](dvec3 p) { return dvec3(-p.x / r, 0, 0); }, {1 / r, 0});
            expect([&](dvec3 p) { return dvec3(p.x, -p.y, 0) / r; }, {1 / r, -1 / r});
            expect([](dvec3) { return dvec3(0); }, {0, 0});
        }
    }
}

// 90 degrees, aspect 1, y down, reversed depth range with the far plane at infinity (near 0.1).
const dmat4 projection{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 0, -1}, {0, 0, 0.1, 0}};

// The view of an eye that looks along -z of the world.
dmat4 view_from(const dvec3& eye) {
    return glm::translate(dmat4(1.0), -eye);
}

// Clip-space point of a world position, not divided.
dvec4 clip(const dvec3& eye, const dvec3& x) {
    return projection * view_from(eye) * dvec4(x, 1.0);
}

// The place in the image, if it is inside.
std::optional<dvec2> place_of(const dvec4& point) {
    dvec2 uv;
    return gloam_uv_from_clip(point, uv) ? std::optional(uv) : std::nullopt;
}

// The eye now, the eye before, a point and where that one was seen before: by the chain of matrices, and by
// the one matrix of the host.
TEST(Reprojection, FindsWhereAPointWasSeen) {
    struct Case {
        dvec3 eye, previous, point;
        dvec2 uv;
    };
    std::vector<Case> cases{
        {dvec3(0), {-1, 0, 0}, {0, 0, -5}, {0.6, 0.5}},  // it was to the left, and saw the point to the right
        {dvec3(0), {0, -1, 0}, {0, 0, -5}, {0.5, 0.4}},  // y down
        {{0, 0, -1}, dvec3(0), {1.2, 0, -6}, {0.6, 0.5}}};  // a step forward
    for (const dvec3 x : {dvec3(2, -1, -2), dvec3(0, 1, -4), dvec3(5, -3, -3)})
        cases.push_back({{2, -1, 3}, {2, -1, 3}, x, place_of(clip({2, -1, 3}, x)).value()});
    for (const auto& [eye, previous, point, uv] : cases) {
        const dvec4 now = clip(eye, point);
        const dmat4 matrix =
            projection * view_from(previous) * glm::inverse(view_from(eye)) * glm::inverse(projection);
        const auto chain = place_of(gloam_previous_clip_static(
            now, glm::inverse(projection), glm::inverse(view_from(eye)), view_from(previous), projection));
        dvec2 by_matrix;
        EXPECT_TRUE(gloam_reproject_clip(now, matrix, by_matrix));
        EXPECT_LT(distance(chain.value(), uv), 1e-9);
        EXPECT_LT(distance(by_matrix, uv), 1e-9);
    }
    // The point is 5 ahead now and was 6 ahead: its depth of today would be rejected by any test of a few per
    // cent.
    EXPECT_EQ(gloam_previous_depth({0, 0, -6}, view_from(dvec3(0))), 6.0);
    EXPECT_EQ(gloam_previous_depth({0, 0, 4}, view_from(dvec3(0))), -4.0);
    EXPECT_EQ(gloam_previous_depth(dvec3(NAN), dmat4(1.0)), 0.0);
    EXPECT_TRUE(gloam_depth_consistent(6.0, 6.0, 0.01));
    EXPECT_FALSE(gloam_depth_consistent(6.0, 5.0, 0.05));
    // x / w alone would put a point behind the previous camera in the middle of the image.
    EXPECT_FALSE(place_of(clip({0, 0, -7}, {0, 0, -6})));
    // Depth 0 of the reversed range is at infinity: a step of the camera does not change where it is seen.
    const auto sky = place_of(gloam_previous_clip_static({0.25, -0.5, 0, 1}, glm::inverse(projection),
                                                         glm::inverse(view_from({3, 2, 1})),
                                                         view_from({-5, 0, 2}), projection));
    EXPECT_LT(distance(sky.value(), dvec2(0.625, 0.25)), 1e-9);
}

// The chain printed without frame indices is the identity: it would find the point where it is now.
TEST(Reprojection, AMovingObjectIsFoundWhereItWas) {
    const dvec3 eye(0.5, 0, 1);
    const dvec3 point(0.25, 0.5, -4);  // of the object
    const dvec3 now_at(1.0, -0.5, 0.25);
    const dvec3 was_at(0.25, -0.25, -0.5);
    const dvec4 now = clip(eye, point + now_at);
    const auto found = place_of(gloam_previous_clip_moving(now, glm::inverse(projection),
                                                           glm::inverse(view_from(eye)), view_from(now_at),
                                                           view_from(-was_at), view_from(eye), projection));
    EXPECT_LT(distance(found.value(), place_of(clip(eye, point + was_at)).value()), 1e-9);
    EXPECT_GT(distance(found.value(), place_of(now).value()), 0.05);
}

const auto camera_of = [](ivec2 size) { return GloamCamera{{1.2, -1.6}, size, false}; };

// Depth under a pixel of the plane through a point.
double plane_depth(const dvec3& normal, const dvec3& through, ivec2 pixel, const GloamCamera& camera) {
    const dvec2 size(camera.size);
    const dvec2 side = (2.0 * dvec2(pixel) + 1.0 - size) / size / camera.p00_p11;
    if (camera.orthographic) return (dot(dvec3(side, 0.0), normal) - dot(through, normal)) / normal.z;
    return dot(through, normal) / dot(dvec3(side, -1.0), normal);
}

// Calls seen(pixel, normal) for all pixels of a depth image.
template <class Seen>
void for_normals(const GloamCamera& camera, const Fetch<double>& depth, const Seen& seen) {
    for (int y = 0; y < camera.size.y; ++y)
        for (int x = 0; x < camera.size.x; ++x)
            seen(ivec2(x, y), gloam_camera_normal(ivec2(x, y), camera, depth));
}

// Perspective and orthographic, y up and down: a row each.
TEST(Normals, OfAPlaneAreItsNormalForEveryCameraAtEveryPixelAndSize) {
    for (const dvec3 n : {up, normalize(dvec3(0.5, 0.3, 1)), normalize(dvec3(-0.2, 0.8, 0.7))})
        for (const GloamCamera& camera : std::vector<GloamCamera>{{{1.2, 1.6}, {3, 3}, false},
                                                                  {{0.7, -0.4}, {2, 2}, true},
                                                                  {{0.9, 1.6}, {31, 17}, true},
                                                                  {{2.5, -2.5}, {9, 5}, true}})
            for_normals(
                camera, [&](ivec2 p) { return plane_depth(n, {0, 0, -4}, p, camera); },
                [&](ivec2, dvec3 normal) { EXPECT_LT(distance(normal, n), 1e-9) << camera.size.x; });
}

TEST(Normals, WhereNothingElseIsKnownFaceTheViewerAndOfBackgroundAreZero) {
    for (const ivec2 size : {ivec2(1, 1), ivec2(1, 5), ivec2(5, 1)})
        for_normals(
            camera_of(size), [](ivec2 pixel) { return 2.0 + 0.1 * pixel.x; },
            [](ivec2, dvec3 normal) { EXPECT_EQ(normal, up); });
    for (const double background : {infinity, 0.0, -1.0, double{NAN}})
        for_normals(
            camera_of({5, 3}), [=](ivec2) { return background; },
            [](ivec2, dvec3 normal) { EXPECT_EQ(normal, dvec3(0)); });
}

// Beside background and at a step of depth, each side keeps the normal of its own surface.
TEST(Normals, DoNotReachAcrossSilhouettes) {
    const GloamCamera camera = camera_of({9, 6});
    const dvec3 near = normalize(dvec3(0.3, 0.2, 1));
    const dvec3 far = normalize(dvec3(-0.4, 0.1, 1));
    const auto depth = [&](ivec2 pixel) {
        if (pixel.x == 8) return infinity;
        return pixel.x < 4 ? plane_depth(near, {0, 0, -2}, pixel, camera)
                           : plane_depth(far, {0, 0, -9}, pixel, camera);
    };
    for_normals(camera, depth, [&](ivec2 pixel, dvec3 normal) {
        EXPECT_TRUE(pixel.x == 8 || distance(normal, pixel.x < 4 ? near : far) < 1e-9) << pixel.x;
    });
}

// A wall to the right that leans away a little: its normal has z < 0, yet the eye sees that side.
TEST(Normals, TurnToTheEyeInPerspectiveAndAgainstTheViewInOrthographic) {
    const dvec3 normal = normalize(dvec3(-1, 0, -0.1));
    const dvec3 c(3, 0, -3);
    const dvec3 along = 0.01 * normalize(dvec3(0.1, 0, -1));
    const dvec3 y(0, 0.01, 0);
    EXPECT_LT(distance(gloam_normal_from_neighbors(c, c + along, c - along, c + y, c - y), normal), 1e-9);
    EXPECT_LT(
        distance(gloam_normal_from_neighbors_orthographic(c, c + along, c - along, c + y, c - y), -normal),
        1e-9);
}

TEST(Samples, ChainOfAnyImageSizeStaysInsideItWithoutDrift) {
    for (const ivec2 size : {ivec2(1, 1), ivec2(7, 5), ivec2(8, 1), ivec2(1920, 1081)})
        for (const int level : {0, 1, 2, 5})
            EXPECT_TRUE(has_pixel(
                size, gloam_depth_mip_source(gloam_depth_mip_pixel(size - 1, size, level), size, level)))
                << size.x << "x" << size.y << " level " << level;
    for (const ivec2 at : {ivec2(0, 0), ivec2(13, 21), ivec2(31, 17)})
        for (const int level : {1, 2, 5})
            EXPECT_EQ(gloam_depth_mip_source(at, ivec2(2048), level) >> level, at) << level;
}

// A bare plane, seen at a tilt through the depth chain. Placed where it was aimed (as published), a tap has
// the depth of another pixel, and the plane blocks itself; placed where its depth is from, it does not.
TEST(Samples, TapsPlacedWhereTheirDepthIsFromKeepAPlaneOpen) {
    const ivec2 size(501, 333);
    const ivec2 center(250, 166);
    const auto ray = [&](ivec2 at) { return dvec3((dvec2(at) + 0.5 - dvec2(size) / 2.0) / 300.0, -1.0); };
    for (const double tilt : {0.0, 0.5, 1.0}) {
        const dvec3 n(std::sin(tilt), 0, std::cos(tilt));
        const auto depth = [&](ivec2 at) { return -5 * n.z / dot(n, ray(at)); };
        const dvec3 p = depth(center) * ray(center);
        double aimed = 0;
        for (int x = -160; x <= 160; x += 7) {
            const ivec2 tap = center + ivec2(x, x / 3);
            const int level = gloam_depth_mip_level(length(dvec2(tap - center)), 16.0, 5);
            const ivec2 from = gloam_depth_mip_source(gloam_depth_mip_pixel(tap, size, level), size, level);
            const auto at = [&](ivec2 place) {
                return gloam_contribution_sao(depth(from) * ray(place) - p, n, 8.0, 1e-5, 0.01, 1.0);
            };
            EXPECT_EQ(at(from), 0.0) << "tilt " << tilt << " tap " << x;
            aimed += at(tap);
        }
        EXPECT_TRUE(tilt == 0 || aimed > 0.05) << tilt << " " << aimed;
    }
}

// An even image with one other value at (3, 2).
TEST(DualResolution, LooksAtThreeByThree) {
    struct Row {
        ivec2 pixel;
        double other, tolerance;
        bool disagrees;
        ivec2 size{5, 5};
    };
    for (const Row& row : {Row{{2, 2}, 0.5, 0.1, true},
                           {{4, 3}, 0.5, 0.1, true},
                           {{1, 2}, 0.5, 0.1, false},
                           {{3, 4}, 0.5, 0.1, false},
                           {{2, 2}, 0.5, 0.25, false},
                           {{2, 2}, 0.5, 0.24, true},
                           {{0, 0}, 0.5, 0.1, false, {1, 1}},
                           {{0, 0}, 0.5, 0.0, false, {3, 1}},
                           {{2, 2}, NAN, 0.5, true},
                           {{2, 2}, 1.0001, 0.9, true},
                           {{2, 2}, -1e-6, 0.9, true},
                           {{0, 0}, 0.25, NAN, true}})
        EXPECT_EQ(
            gloam_dual_resolution_disagrees(row.pixel, row.size, row.tolerance,
                                            [&](ivec2 p) { return p == ivec2(3, 2) ? row.other : 0.25; }),
            row.disagrees)
            << row.pixel.x << ' ' << row.other << ' ' << row.tolerance;
    for (const double all : {0.0, 1.0})
        EXPECT_FALSE(gloam_dual_resolution_disagrees({2, 2}, {5, 5}, 0.05, [=](ivec2) { return all; }));
}

// Over all places the rule of the sectors' centres covers what the sample is wide.
TEST(Slices, SectorsCoverWhatASampleIsWide) {
    double centres = 0.0;
    for (int i = 0; i < 4096; ++i) {
        const double lower = 0.1 + 0.5 * i / 4096;
        centres += gloam_bitmask_occlusion(gloam_bitmask_sectors({lower, lower + 0.02})) / 4096;
    }
    EXPECT_NEAR(centres, 0.02, 1e-4);
}

TEST(Frames, BlendIsTheMeanOfAllSamplesUntilItIsFullAndThenExponential) {
    dvec2 state(0);
    double sum = 0.0;
    for (int frame = 0; frame < 10; ++frame) {
        const double fresh = 0.1 + 0.08 * ((frame * 7) % 10);
        state = gloam_blend(state.x, state.y, fresh, 32.0, 500.0);
        sum += fresh;
    }
    EXPECT_NEAR(state.x, sum / 10, 1e-12);
    EXPECT_EQ(state.y, 320.0);
    const dvec2 first = gloam_blend(0.3, 96.0, 0.25, 16.0, 500.0);  // two batches are one of both
    const dvec2 both = gloam_blend(0.3, 96.0, 0.5, 32.0, 500.0);
    EXPECT_LT(distance(gloam_blend(first.x, first.y, 0.75, 16.0, 500.0), both), 1e-12);
    dvec2 full(1.0, 500.0);
    double smooth = 0.9;
    for (int frame = 1; frame <= 20; ++frame) {
        full = gloam_blend(full.x, full.y, 0.0, 16.0, 500.0);
        EXPECT_LT(distance(full, dvec2(std::pow(500.0 / 516.0, frame), 500.0)), 1e-12);
        smooth = gloam_temporal_smooth(smooth, true, 0.2, 0.25);
        EXPECT_NEAR(smooth, 0.2 + 0.7 * std::pow(0.75, frame), 1e-12);
    }
}

// w_max = 500, k_1 = 32, k_2 = 16; thresholds 0.2 (filter), 0.3 (samples), 0.5 (rotation).
TEST(Frames, TimelineOfAStaticPixel) {
    std::map<std::string, int> first;
    dvec2 state(0);
    for (int frame = 1; frame <= 30; ++frame) {
        const int k = gloam_sample_count(gloam_convergence(state.y, 500.0), 0.3, 32, 16);
        state = gloam_blend(state.x, state.y, 0.5, k, 500.0);
        const double now = gloam_convergence(state.y, 500.0);
        if (k == 16) first.emplace("fewer samples", frame);
        if (gloam_shrink(now, 0.2) == 0.0) first.emplace("unfiltered", frame);
        if (!gloam_rotation_enabled(now, 0.5)) first.emplace("unrotated", frame);
        if (now == 1.0) first.emplace("full", frame);
    }
    EXPECT_EQ(first, (std::map<std::string, int>{
                         {"unfiltered", 4}, {"fewer samples", 6}, {"unrotated", 11}, {"full", 27}}));
}

// Four texels of one value are that at every position between them.
TEST(Frames, AHistoryThatIsTheSameEverywhereIsKeptEverywhere) {
    for (const double occlusion : {0.0, 1.0}) {
        const auto fetch = [=](ivec2) { return dvec4(occlusion, 100.0, 7.0, 5.0); };
        for (int i = 0; i < 4000; ++i) {
            const dvec2 uv(fract(0.6180339887 * i), fract(0.7548776662 * i));
            const GloamHistory history = gloam_reprojected_history(uv, {40, 30}, 5.0, 0.02, fetch);
            EXPECT_NEAR(history.occlusion, occlusion, 1e-12);
            EXPECT_NEAR(history.weight, 100.0, 1e-9);
            EXPECT_EQ(history.index, 7U);
        }
        for (const ivec2 none : {ivec2(0, 30), ivec2(40, 0), ivec2(0)})
            EXPECT_EQ(gloam_reprojected_history(dvec2(0.5), none, 5.0, 0.02, fetch).weight, 0.0);
    }
}

TEST(Frames, RigidMotionChangesNothing) {
    numeric::Random random(5);
    const auto vector = [&](double extent) {
        return dvec3(random.uniform(-extent, extent), random.uniform(-extent, extent),
                     random.uniform(-extent, extent));
    };
    for (int i = 0; i < 100; ++i) {
        const dmat3 turn(glm::rotate(dmat4(1), random.uniform(-3, 3), normalize(vector(1) + 1.1 * up)));
        const dvec3 shift = vector(2);
        const dvec3 p = vector(2);
        const dvec3 s = p + vector(1);
        EXPECT_LE(gloam_neighborhood_change(s, p, turn * s + shift, turn * p + shift), 1e-12) << i;
    }
}

}  // namespace gloam::reference::equations_test

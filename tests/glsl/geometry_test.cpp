// SPDX-License-Identifier: MIT
#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::geometry_test {

using check::Function;
using check::ImageSet;
using check::Out;

class Geometry : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

TEST_F(Geometry, PositionsProjectBackOntoTheirPixels) {
    const std::string file = "gloam/geometry/position.glsl";
    const Function<glm::vec2(glm::ivec2, glm::ivec2)> ndc_of(lab, file, "gloam_ndc_from_pixel");
    const Function<glm::vec3(glm::vec2, float, glm::vec2)> position(lab, file,
                                                                    "gloam_view_position_perspective");
    const Function<glm::vec2(glm::vec3, glm::vec2)> project(lab, file, "gloam_ndc_perspective");
    const glm::ivec2 size(33, 7);
    for (const glm::vec2 scale : {glm::vec2(1.5F, -2.0F), glm::vec2(1.5F, 2.0F)}) {
        for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(32, 6), glm::ivec2(5, 1)}) {
            const glm::vec2 ndc = ndc_of(pixel, size);
            EXPECT_NEAR(ndc.x, (2 * pixel.x + 1) / 33.0 - 1, 1e-7);
            const glm::vec3 p = position(ndc, 4.0F, scale);
            EXPECT_EQ(p.z, -4.0F);
            EXPECT_GT(p.y * ndc.y * scale.y, 0.0F);  // up is where the projection says
            EXPECT_LT(glm::distance(project(p, scale), ndc), 1e-6F);
        }
    }
}

TEST_F(Geometry, ProjectedRadiusIsThatOfAProjectedPoint) {
    const Function<glm::vec2(float, float, glm::vec2)> uv(lab, "gloam/geometry/projected_radius.glsl",
                                                          "gloam_projected_radius_uv");
    const Function<glm::vec2(glm::vec3, glm::vec2)> project(lab, "gloam/geometry/position.glsl",
                                                            "gloam_ndc_perspective");
    const glm::vec2 scale(0.8F, -1.3F);
    const glm::vec2 there = project(glm::vec3(0.6F, 0.6F, -3.0F), scale) * 0.5F;
    const glm::vec2 radius = uv(0.6F, 3.0F, scale);
    EXPECT_NEAR(radius.x, std::abs(there.x), 1e-6);
    EXPECT_NEAR(radius.y, std::abs(there.y), 1e-6);
}

TEST_F(Geometry, PixelCentresAreTheirOwnCentres) {
    const Function<glm::vec2(glm::vec2, glm::ivec2)> center(lab, "gloam/geometry/pixel_center.glsl",
                                                            "gloam_pixel_center");
    numeric::Random random(3);
    std::vector<std::tuple<glm::vec2, glm::ivec2>> inputs;
    for (int i = 0; i < 4096; ++i) {
        const glm::ivec2 size(1 + random.below(5000), 1 + random.below(5000));
        inputs.emplace_back(glm::vec2(random.unit(), random.unit()), size);
    }
    const std::vector<glm::vec2> once = center(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) std::get<0>(inputs[i]) = once[i];
    EXPECT_EQ(center(inputs), once);
}

TEST_F(Geometry, CameraCentredPositionsDoNotCareWhereTheWorldIs) {
    const Function<glm::vec3(glm::vec3, glm::vec3)> previous(lab, "gloam/geometry/camera_centered.glsl",
                                                             "gloam_camera_centered_previous");
    const glm::dvec3 x(3.25, -1.5, 7.125);
    const glm::dvec3 eye(1.0, 0.5, 10.0);
    const glm::dvec3 previous_eye(1.0 + 0x1p-10, 0.5, 10.0 - 0x1p-9);
    const auto at = [&](const glm::dvec3& shift) {
        return previous(glm::vec3((x + shift) - (eye + shift)),
                        glm::vec3((eye + shift) - (previous_eye + shift)));
    };
    const glm::vec3 here = at(glm::dvec3(0));
    EXPECT_EQ(at(glm::dvec3(1e6, 0, 0)), here);
    EXPECT_EQ(glm::dvec3(here), x - previous_eye);  // exactly representable
    // World coordinates in float lose the movement of the eye altogether.
    const float naive = static_cast<float>(x.x + 1e6) - static_cast<float>(previous_eye.x + 1e6);
    EXPECT_GT(std::abs(static_cast<double>(naive) - (x.x - previous_eye.x)), 9e-4);
}

// Changes that do not span a plane have no curvature, and lengths are those of their vectors in any
// direction.
TEST_F(Geometry, OfVectorsInAnyDirection) {
    const Function<glm::vec2(glm::vec3, glm::vec3, glm::vec3, glm::vec3)> curvatures(
        lab, "gloam/geometry/curvature.glsl", "gloam_principal_curvatures");
    const Function<float(glm::vec3)> length(lab, "gloam/geometry/length.glsl", "gloam_length");
    const glm::vec3 turn(0.01F, 0.002F, 0.0F);
    std::vector<std::tuple<glm::vec3, glm::vec3, glm::vec3, glm::vec3>> parallel;
    std::vector<std::tuple<glm::vec3>> vectors;
    for (int i = 0; i < 500; ++i) {
        const float a = 0.7F * static_cast<float>(i);
        const glm::vec3 direction =
            glm::normalize(glm::vec3(std::cos(a), std::sin(1.3F * a), std::sin(2.1F * a)));
        vectors.emplace_back(3.0F * direction);
        for (const float factor : {1.0F, -1.0F, 0.5F, 3.0F, 0.0F}) {
            parallel.emplace_back(0.01F * direction, factor * 0.01F * direction, turn, -turn);
            parallel.emplace_back(factor * 0.01F * direction, 0.01F * direction, turn, turn);
        }
    }
    EXPECT_THAT(curvatures(parallel), Each(glm::vec2(0)));
    EXPECT_THAT(length(vectors), Each(testing::FloatNear(3.0F, 2e-6F)));
}

// Whatever the bits of a NaN are.
TEST_F(Geometry, NoNaNIsFinite) {
    const Function<bool(float)> finite(lab, "gloam/geometry/finite.glsl", "gloam_is_finite");
    const Function<bool(glm::vec2)> finite2(lab, "gloam/geometry/finite.glsl", "gloam_is_finite2");
    const Function<bool(glm::vec3)> finite3(lab, "gloam/geometry/finite.glsl", "gloam_is_finite3");
    const Function<bool(glm::vec4)> finite4(lab, "gloam/geometry/finite.glsl", "gloam_is_finite4");
    for (const std::uint32_t bits : {0x7F800000U, 0x7FC00001U, 0xFFFFFFFFU, 0x7FD5AAAAU}) {
        const float none = std::bit_cast<float>(bits);
        EXPECT_FALSE(finite(none) || finite2(glm::vec2(0, none)) || finite3(glm::vec3(0, none, 0)) ||
                     finite4(glm::vec4(none, 0, 0, 0)))
            << bits;
    }
}

class Borders : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/borders.glsl";
    const Function<glm::ivec2(glm::ivec2, float)> border{lab, file, "gloam_guard_band_border"};
    const Function<glm::vec2(glm::ivec2, float)> rendered_guard{lab, file, "gloam_guard_band_guard"};
    const Function<float(float, float)> tangent{lab, file, "gloam_guard_band_tan_half_fov"};
};

// Whatever the rounding, a pixel of the crop is the same pixel of the image with the band: same place, same
// footprint. inner: texture coordinates in the crop of those in the image with the band.
TEST_F(Borders, CropIsConsistentAtOddSizes) {
    const auto inner = [](glm::vec2 uv, glm::vec2 guard) { return uv + guard * (2.0F * uv - 1.0F); };
    for (const glm::ivec2 size : {glm::ivec2(33, 17), glm::ivec2(1, 1), glm::ivec2(101, 7)}) {
        const glm::ivec2 band = border(size, 0.07F);
        const glm::vec2 guard = rendered_guard(size, 0.07F);
        const glm::ivec2 with_band = size + 2 * band;
        for (const glm::ivec2 pixel : {glm::ivec2(0), size / 2, size - 1}) {
            const glm::vec2 crop_uv = (glm::vec2(pixel) + 0.5F) / glm::vec2(size);
            const glm::vec2 band_uv = (glm::vec2(pixel + band) + 0.5F) / glm::vec2(with_band);
            EXPECT_LT(glm::distance(inner(band_uv, guard), crop_uv), 1e-6F);
        }
        for (int axis = 0; axis < 2; ++axis) {
            const auto pixel_with_band = tangent(0.5F, guard[axis]) / static_cast<float>(with_band[axis]);
            EXPECT_NEAR(pixel_with_band, 0.5F / static_cast<float>(size[axis]), 1e-7F);
        }
    }
    // With the guard asked for instead, the first pixel of a 33-pixel row would be off by more than a tenth
    // of a pixel.
    const float naive = inner(glm::vec2((2 + 0.5F) / 37, 0.5F), glm::vec2(0.07F)).x;
    EXPECT_GT(std::abs(naive - 0.5F / 33) * 33, 0.1F);
}

// 90 degrees, aspect 1, y down, reversed depth range with the far plane at infinity (near 0.1).
glm::dmat4 projection() {
    glm::dmat4 p(0.0);
    p[0][0] = 1.0;
    p[1][1] = -1.0;
    p[2][3] = -1.0;
    p[3][2] = 0.1;
    return p;
}

// The view of an eye that looks along -z of the world.
glm::dmat4 view_from(const glm::dvec3& eye) {
    glm::dmat4 view(1.0);
    view[3] = glm::dvec4(-eye, 1.0);
    return view;
}

glm::dmat4 moved_by(const glm::dvec3& offset) {
    return view_from(-offset);
}

class Reprojection : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/reprojection.glsl";
    const Function<bool(glm::vec4, Out<glm::vec2>)> uv_of{lab, file, "gloam_uv_from_clip"};
    const Function<bool(glm::vec4, glm::mat4, Out<glm::vec2>)> reproject{lab, file, "gloam_reproject_clip"};
    const Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)> previous_static{
        lab, file, "gloam_previous_clip_static"};
    const Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)>
        previous_moving{lab, file, "gloam_previous_clip_moving"};
    const Function<float(glm::vec3, glm::mat4)> previous_depth{lab, file, "gloam_previous_depth"};

    const glm::dmat4 p = projection();

    // Clip-space point of a world position, not divided.
    glm::vec4 clip(const glm::dvec3& eye, const glm::dvec3& x) const {
        return glm::vec4(p * view_from(eye) * glm::dvec4(x, 1.0));
    }

    // Previous texture coordinates by the chain of matrices, and by the one matrix of the host.
    void expect_uv(const glm::dvec3& eye, const glm::dvec3& previous_eye, const glm::dvec3& x,
                   glm::vec2 uv) const {
        const glm::vec4 now = clip(eye, x);
        const glm::vec4 chain =
            previous_static(now, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                            glm::mat4(view_from(previous_eye)), glm::mat4(p));
        const glm::mat4 matrix(p * view_from(previous_eye) * glm::inverse(view_from(eye)) * glm::inverse(p));
        for (const auto& [inside, got] : {uv_of(chain), reproject(now, matrix)}) {
            EXPECT_TRUE(inside);
            EXPECT_NEAR(got.x, uv.x, 1e-6);
            EXPECT_NEAR(got.y, uv.y, 1e-6);
        }
    }
};

TEST_F(Reprojection, SameCameraGivesTheSamePlace) {
    const glm::dvec3 eye(2, -1, 3);
    for (const glm::dvec3 x : {glm::dvec3(2, -1, -2), glm::dvec3(0, 1, -4), glm::dvec3(5, -3, -3)}) {
        const auto [inside, now] = uv_of(clip(eye, x));
        EXPECT_TRUE(inside);
        expect_uv(eye, eye, x, now);
    }
}

TEST_F(Reprojection, CameraThatWasToTheLeftSawThePointToTheRight) {
    expect_uv(glm::dvec3(0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -5), glm::vec2(0.6F, 0.5F));
    expect_uv(glm::dvec3(0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -5), glm::vec2(0.5F, 0.4F));  // y down
}

TEST_F(Reprojection, DollyForwardExpectsTheDepthOfThePreviousCamera) {
    // The point is 5 ahead now and was 6 ahead; its depth of today would be rejected by any test of a few per
    // cent.
    EXPECT_FLOAT_EQ(previous_depth(glm::vec3(0, 0, -6), glm::mat4(view_from(glm::dvec3(0)))), 6.0F);
    expect_uv(glm::dvec3(0, 0, -1), glm::dvec3(0), glm::dvec3(1.2, 0, -6), glm::vec2(0.6F, 0.5F));
    EXPECT_FLOAT_EQ(previous_depth(glm::vec3(0, 0, 4), glm::mat4(view_from(glm::dvec3(0)))), -4.0F);
    EXPECT_EQ(previous_depth(glm::vec3(NAN), glm::mat4(1.0F)), 0.0F);
}

// The chain printed without frame indices is the identity: it would find the point where it is now.
TEST_F(Reprojection, MovingObjectIsFoundWhereItWas) {
    const glm::dvec3 eye(0.5, 0, 1);
    const glm::dvec3 point(0.25, 0.5, -4);  // of the object
    const glm::dvec3 now_at(1.0, -0.5, 0.25);
    const glm::dvec3 was_at(0.25, -0.25, -0.5);
    const glm::mat4 inverse_model(glm::inverse(moved_by(now_at)));
    const glm::mat4 previous_model(moved_by(was_at));
    const glm::vec4 now = clip(eye, point + now_at);
    const glm::vec4 previous =
        previous_moving(now, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                        inverse_model, previous_model, glm::mat4(view_from(eye)), glm::mat4(p));
    const auto [inside, uv] = uv_of(previous);
    const auto [expected_inside, expected] = uv_of(clip(eye, point + was_at));
    EXPECT_TRUE(inside && expected_inside);
    EXPECT_LT(glm::distance(uv, expected), 1e-6F);
    EXPECT_GT(glm::distance(uv, std::get<1>(uv_of(now))), 0.05F);
}

TEST_F(Reprojection, PointsAtInfinityMoveWithTheDirectionOnly) {
    // Depth 0 of the reversed range is at infinity: a step of the camera does not change where it is seen.
    const glm::dvec3 eye(3, 2, 1);
    const glm::vec4 sky(0.25F, -0.5F, 0.0F, 1.0F);
    const glm::vec4 previous =
        previous_static(sky, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                        glm::mat4(view_from(glm::dvec3(-5, 0, 2))), glm::mat4(p));
    const auto [inside, uv] = uv_of(previous);
    EXPECT_TRUE(inside);
    EXPECT_LT(glm::distance(uv, glm::vec2(0.625F, 0.25F)), 1e-6F);
}

// x / w alone would put this point, behind the previous camera, in the middle of the image.
TEST_F(Reprojection, NothingIsFoundBehindTheCamera) {
    const auto [inside, uv] = uv_of(clip(glm::dvec3(0, 0, -7), glm::dvec3(0, 0, -6)));
    EXPECT_FALSE(inside);
    EXPECT_EQ(uv, glm::vec2(0.0F));
}

const glm::vec2 scale(1.2F, -1.6F);

// A plane through `through` with the given normal, seen from the eye.
struct Plane {
    glm::dvec3 normal;
    glm::dvec3 through{0, 0, -4};

    double depth(glm::ivec2 pixel, glm::ivec2 size) const {
        const glm::dvec2 ndc = (2.0 * glm::dvec2(pixel) + 1.0 - glm::dvec2(size)) / glm::dvec2(size);
        const glm::dvec3 ray(ndc.x / scale.x, ndc.y / scale.y, -1.0);
        return glm::dot(through, normal) / glm::dot(ray, normal);
    }
};

class Normal : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const Function<glm::vec3(glm::ivec2, glm::ivec2, glm::vec2)> from_depth{
        lab, "gloam/geometry/normal_from_depth.glsl", "gloam_normal_from_depth"};

    template <class Depth>
    static ImageSet image(glm::ivec2 size, Depth depth) {
        return {{"gloam_fetch_depth", check::make_image<float>(size, depth)}};
    }

    // The normals of all pixels of a depth image, row by row.
    std::vector<glm::vec3> normals(glm::ivec2 size, const ImageSet& images) const {
        std::vector<std::tuple<glm::ivec2, glm::ivec2, glm::vec2>> inputs;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) inputs.emplace_back(glm::ivec2(x, y), size, scale);
        }
        return from_depth(inputs, images);
    }
};

TEST_F(Normal, OfAPlaneIsItsNormalAtEveryPixelAndSize) {
    for (const glm::dvec3 direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(0.5, 0.3, 1), glm::dvec3(-0.2, 0.8, 0.7)}) {
        const Plane plane{.normal = glm::normalize(direction)};
        for (const glm::ivec2 size :
             {glm::ivec2(2, 2), glm::ivec2(3, 3), glm::ivec2(9, 5), glm::ivec2(31, 17)}) {
            const ImageSet images = image(size, [&](glm::ivec2 pixel) { return plane.depth(pixel, size); });
            for (const glm::vec3 normal : normals(size, images)) {
                EXPECT_LT(glm::distance(normal, glm::vec3(plane.normal)), 1e-5F) << size.x << " x " << size.y;
            }
        }
    }
}

TEST_F(Normal, FacesTheViewerWhereNothingElseIsKnown) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 5), glm::ivec2(5, 1)}) {
        const ImageSet images = image(size, [](glm::ivec2 pixel) { return 2.0 + 0.1 * pixel.x; });
        for (const glm::vec3 normal : normals(size, images)) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
}

TEST_F(Normal, OfBackgroundIsZero) {
    const glm::ivec2 size(5, 3);
    for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
        const ImageSet images = image(size, [background](glm::ivec2) { return background; });
        for (const glm::vec3 normal : normals(size, images)) EXPECT_EQ(normal, glm::vec3(0.0F));
    }
}

// Beside background and at a step of depth, each side keeps the normal of its own surface.
TEST_F(Normal, DoesNotReachAcrossSilhouettes) {
    const glm::ivec2 size(9, 6);
    const Plane near{.normal = glm::normalize(glm::dvec3(0.3, 0.2, 1)), .through = {0, 0, -2}};
    const Plane far{.normal = glm::normalize(glm::dvec3(-0.4, 0.1, 1)), .through = {0, 0, -9}};
    const ImageSet images = image(size, [&](glm::ivec2 pixel) {
        if (pixel.x == 8) return static_cast<double>(infinity);
        return (pixel.x < 4 ? near : far).depth(pixel, size);
    });
    const std::vector<glm::vec3> all = normals(size, images);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto x = static_cast<int>(i) % size.x;
        if (x == 8) continue;
        EXPECT_LT(glm::distance(all[i], glm::vec3((x < 4 ? near : far).normal)), 1e-5F) << "column " << x;
    }
}

TEST_F(Normal, TurnsToTheEyeInPerspectiveAndAgainstTheViewInOrthographic) {
    using Neighbors = Function<glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, glm::vec3)>;
    const Neighbors perspective(lab, "gloam/geometry/normal.glsl", "gloam_normal_from_neighbors");
    const Neighbors orthographic(lab, "gloam/geometry/normal.glsl",
                                 "gloam_normal_from_neighbors_orthographic");
    // A wall to the right that leans away a little: its normal has z < 0, yet the eye sees that side.
    const glm::vec3 normal = glm::normalize(glm::vec3(-1.0F, 0.0F, -0.1F));
    const glm::vec3 center(3.0F, 0.0F, -3.0F);
    const glm::vec3 along = glm::normalize(glm::vec3(0.1F, 0.0F, -1.0F)) * 0.01F;
    const glm::vec3 up(0.0F, 0.01F, 0.0F);
    const auto of = [&](const Neighbors& kernel) {
        return kernel(center, center + along, center - along, center + up, center - up);
    };
    EXPECT_LT(glm::distance(of(perspective), normal), 1e-4F);
    EXPECT_LT(glm::distance(of(orthographic), -normal), 1e-4F);
}

}  // namespace gloam::geometry_test

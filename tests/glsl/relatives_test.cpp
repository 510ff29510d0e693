// SPDX-License-Identifier: MIT
// What is related to occlusion, beyond its known values: bent normals and light by direction, curvature,
// scalable obscurance, resolutions and layers, balls in the place of the scene.
#include "support/lab.hpp"

namespace gloam::relatives_test {

using check::Function;
using glm::ivec2;
using glm::vec3;

constexpr double right = std::numbers::pi / 2;
const vec3 up(0, 0, 1);

class Directions : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    Function<float(float)> cone{lab, "gloam/shading/bent_cone.glsl", "gloam_cone_angle"};
    Function<glm::vec4(glm::vec4, vec3, float)> add{lab, "gloam/shading/bent_normal.glsl", "gloam_bent_add"};
    Function<vec3(glm::vec4, vec3)> bent{lab, "gloam/shading/bent_normal.glsl", "gloam_bent_normal"};
    Function<float(glm::vec4)> agreement{lab, "gloam/shading/bent_normal.glsl", "gloam_bent_length"};

    // The sums over many directions of the hemisphere, of which some are open.
    template <class Open>
    glm::vec4 sums(Open open) const {
        std::vector<std::tuple<glm::vec4, vec3, float>> inputs;
        constexpr int rings = 48;
        for (int i = 0; i < rings; ++i) {
            for (int j = 0; j < 96; ++j) {
                const double z = (i + 0.5) / rings;
                const double angle = 2 * std::numbers::pi * (j + 0.5) / 96;
                const double r = std::sqrt(1 - z * z);
                const vec3 w(r * std::cos(angle), r * std::sin(angle), z);
                inputs.emplace_back(glm::vec4(0), w, open(w) ? 1.0F : 0.0F);
            }
        }
        glm::dvec4 sum(0);
        for (const glm::vec4 part : add(inputs)) sum += part;
        return sum;
    }
};

TEST_F(Directions, OpenHemisphereBendsNothing) {
    const glm::vec4 sum = sums([](vec3) { return true; });
    EXPECT_NEAR(agreement(sum), 0.5, 1e-3);
    EXPECT_NEAR(bent(sum, up).z, 1.0, 1e-6);
}

TEST_F(Directions, HalfSpaceBlockedBendsTheNormalBy45Degrees) {
    const glm::vec4 sum = sums([](vec3 w) { return w.x > 0; });
    const vec3 b = bent(sum, up);
    EXPECT_NEAR(b.x, std::numbers::sqrt2 / 2, 2e-3);
    EXPECT_NEAR(b.y, 0.0, 1e-5);
    EXPECT_NEAR(b.z, std::numbers::sqrt2 / 2, 2e-3);
}

TEST_F(Directions, CapIsItsOwnCone) {
    const glm::vec4 sum = sums([](vec3 w) { return w.z > 0.5F; });
    EXPECT_NEAR(agreement(sum), 0.75, 1e-3);
    EXPECT_NEAR(cone(agreement(sum)), right * 2 / 3, 2e-3);
}

class Curvature : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    Function<float(float, float, float)> occlusion{lab, "gloam/occlusion/curvature.glsl",
                                                   "gloam_occlusion_curvature"};
    Function<glm::vec2(vec3, vec3, vec3, vec3)> principal{lab, "gloam/geometry/curvature.glsl",
                                                          "gloam_principal_curvatures"};
};

// The mean over directions as it is defined, in double.
double mean_of_sin_squared(double k_1, double k_2, double radius) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / steps;
        const double k = k_1 * std::pow(std::cos(phi), 2) + k_2 * std::pow(std::sin(phi), 2);
        const double q = std::max(k, 0.0) * radius / 2;
        sum += q * q / (1 + q * q);
    }
    return sum / steps;
}

TEST_F(Curvature, ClosedFormIsTheMeanOverDirections) {
    for (const float k_1 : {0.01F, 0.5F, 2.0F, 30.0F}) {
        for (const float k_2 : {-20.0F, -3.0F, -0.5F, -1e-4F, 0.0F, 0.3F, 3.0F, 40.0F}) {
            EXPECT_NEAR(occlusion(k_1, k_2, 1.5F), mean_of_sin_squared(k_1, k_2, 1.5), 2e-6)
                << k_1 << " " << k_2;
            EXPECT_EQ(occlusion(k_1, k_2, 1.5F), occlusion(k_2, k_1, 1.5F)) << k_1 << " " << k_2;
        }
    }
}

TEST_F(Curvature, OfABallACylinderAndAPlaneInAnyDirections) {
    const double r = 4;
    const double step = 0.01;
    const auto near_curvatures = [](glm::vec2 got, double k_1, double k_2) {
        EXPECT_NEAR(got.x, k_1, 1e-4);
        EXPECT_NEAR(got.y, k_2, 1e-4);
    };
    for (const double turn : {0.0, 0.4, 1.1}) {
        for (const double apart :
             {0.6, 1.57, 2.4}) {  // angle between the two axes of the image on the surface
            const glm::dvec3 x(std::cos(turn), std::sin(turn), 0);
            const glm::dvec3 y(std::cos(turn + apart), std::sin(turn + apart), 0);
            const auto curvatures = [&](auto normal_change) {
                return principal(step * x, 1.5 * step * y, normal_change(step * x),
                                 normal_change(1.5 * step * y));
            };
            near_curvatures(curvatures([&](glm::dvec3 p) { return -p / r; }), 1 / r, 1 / r);   // inside
            near_curvatures(curvatures([&](glm::dvec3 p) { return p / r; }), -1 / r, -1 / r);  // outside
            near_curvatures(curvatures([&](glm::dvec3 p) { return glm::dvec3(-p.x / r, 0, 0); }), 1 / r, 0);
            near_curvatures(curvatures([&](glm::dvec3 p) { return glm::dvec3(p.x, -p.y, 0) / r; }), 1 / r,
                            -1 / r);
            near_curvatures(curvatures([](glm::dvec3) { return glm::dvec3(0); }), 0, 0);
        }
    }
}

// More than one depth image, more than one resolution, more than one pass, more than one frame.

class DualResolution : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    Function<bool(ivec2, ivec2, float)> disagrees{lab, "gloam/filter/dual_resolution.glsl",
                                                  "gloam_dual_resolution_disagrees"};

    // An even image with one other value at (3, 2).
    bool at(ivec2 pixel, float other, float tolerance, ivec2 size = {5, 5}) const {
        const auto value = [&](ivec2 p) { return p == ivec2(3, 2) ? other : 0.25F; };
        return disagrees.with_images({{"gloam_fetch_occlusion", check::make_image<float>(size, value)}},
                                     {pixel, size, tolerance});
    }
};

TEST_F(DualResolution, LooksAtThreeByThree) {
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.1F));
    EXPECT_TRUE(at({4, 3}, 0.5F, 0.1F));
    EXPECT_FALSE(at({1, 2}, 0.5F, 0.1F));
    EXPECT_FALSE(at({3, 4}, 0.5F, 0.1F));
    EXPECT_FALSE(at({2, 2}, 0.5F, 0.25F));
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.24F));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.1F, {1, 1}));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.0F, {3, 1}));
    EXPECT_TRUE(at({2, 2}, NAN, 0.5F));
    EXPECT_TRUE(at({0, 0}, 0.25F, NAN));
}

TEST_F(DualResolution, NeighboursThatAreAllOpenOrAllBlockedAgree) {
    const auto with = [&](auto occlusion) {
        return disagrees.with_images(
            {{"gloam_fetch_occlusion", check::make_image<float>(ivec2(5), occlusion)}},
            {ivec2(2), ivec2(5), 0.05F});
    };
    EXPECT_FALSE(with([](ivec2) { return 1.0F; }));
    EXPECT_FALSE(with([](ivec2) { return 0.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p.x < 2 ? 0.0F : 1.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p == ivec2(1) ? 1.0001F : 1.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p == ivec2(1) ? -1e-6F : 0.0F; }));
}

class Scalable : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    const Function<float(vec3, vec3, float, float, float, float)> sao{lab, "gloam/occlusion/sao.glsl",
                                                                      "gloam_contribution_sao"};
};

// A bare plane, seen at a tilt through the depth chain. Placed where it was aimed (as published), a tap has
// the depth of another pixel, and the plane blocks itself; placed where its depth is from, it does not.
TEST_F(Scalable, TapsPlacedWhereTheirDepthIsFromKeepAPlaneOpen) {
    const std::string file = "gloam/sampling/depth_mip.glsl";
    const Function<int(float, float, int)> level(lab, file, "gloam_depth_mip_level");
    const Function<ivec2(ivec2, ivec2, int)> pixel(lab, file, "gloam_depth_mip_pixel");
    const Function<ivec2(ivec2, ivec2, int)> source(lab, file, "gloam_depth_mip_source");
    const ivec2 size(501, 333);
    const auto ray = [&](ivec2 at) {
        return glm::dvec3((glm::dvec2(at) + 0.5 - glm::dvec2(size) / 2.0) / 300.0, -1.0);
    };
    for (const double tilt : {0.0, 0.5, 1.0}) {
        const glm::dvec3 n(std::sin(tilt), 0, std::cos(tilt));
        const auto depth = [&](ivec2 at) { return -5 * n.z / glm::dot(n, ray(at)); };
        const ivec2 center(250, 166);
        const glm::dvec3 p = depth(center) * ray(center);
        float aimed = 0;
        for (int x = -160; x <= 160; x += 7) {
            const ivec2 tap = center + ivec2(x, x / 3);
            const int l = level(glm::length(glm::vec2(tap - center)), 16.0F, 5);
            const ivec2 from = source(pixel(tap, size, l), size, l);
            const auto at = [&](ivec2 place) {
                return sao(depth(from) * ray(place) - p, n, 8.0F, 1e-5F, 0.01F, 1.0F);
            };
            EXPECT_EQ(at(from), 0.0F) << "tilt " << tilt << " tap " << x;
            aimed += at(tap);
        }
        EXPECT_TRUE(tilt == 0 || aimed > 0.05F) << tilt << " " << aimed;
    }
}

TEST_F(Scalable, EveryParameterChangesTheContribution) {
    const vec3 v(0.3F, 0.1F, 0.4F);
    const float base = sao(v, up, 1.0F, 0.01F, 0.01F, 1.0F);
    EXPECT_NE(sao(v, up, 1.5F, 0.01F, 0.01F, 1.0F), base);
    EXPECT_NE(sao(v, up, 1.0F, 0.05F, 0.01F, 1.0F), base);
    EXPECT_NE(sao(v, up, 1.0F, 0.01F, 0.10F, 1.0F), base);
    EXPECT_NE(sao(v, vec3(1, 0, 0), 1.0F, 0.01F, 0.01F, 1.0F), base);
    EXPECT_NEAR(sao(v, up, 1.0F, 0.01F, 0.01F, 2.0F), 2.0F * base, 1e-6);
}

TEST_F(Scalable, NothingBlocksOnABarePlane) {
    for (const float tilt : {0.0F, 0.5F, 1.0F, 1.5F}) {
        const vec3 n(std::sin(tilt), 0, std::cos(tilt));
        const vec3 along(std::cos(tilt), 0, -std::sin(tilt));
        for (const float t : {-0.9F, -0.1F, 0.2F, 0.7F})
            EXPECT_EQ(sao(t * along + vec3(0, 0.3F, 0), n, 1.0F, 0.01F, 0.01F, 1.0F), 0.0F) << tilt;
    }
}

// The mean of the contributions over an infinite wall beside the point, against a quadrature in double.
TEST_F(Scalable, WallConvergesToItsOwnIntegral) {
    const double a = 0.25;
    std::vector<std::tuple<vec3, vec3, float, float, float, float>> inputs;
    double want = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const glm::dvec3 v(a, (i - 31.5) / 32, (j + 0.5) / 64);
            inputs.emplace_back(vec3(v), up, 1.0F, 0.01F, 0.01F, 1.0F);
            const double vv = glm::dot(v, v);
            want += std::pow(std::max(1 - vv, 0.0), 3) * std::max(v.z - 0.01, 0.0) / (vv + 0.01);
        }
    }
    double got = 0;
    for (const float c : sao(inputs)) got += static_cast<double>(c);
    EXPECT_NEAR(got / want, 1.0, 1e-6);
}

TEST_F(Scalable, LevelsThatAgreeLessOccludeLess) {
    const Function<float(float, float)> combine(lab, "gloam/occlusion/mssao.glsl", "gloam_mssao_combine");
    for (const float x : {0.1F, 0.25F, 0.5F, 0.9F}) {
        EXPECT_NEAR(combine(x, x), 1 - (1 - x) * (1 - x), 1e-6);  // one level
        for (const float mean : {0.0F, x / 3, x}) {
            EXPECT_GE(combine(x, mean), x);
            EXPECT_GE(combine(x, x), combine(x, mean));
        }
    }
}

// The solid angle of a ball over that of the half space, by counting directions.
TEST(Proxies, SolidAngleOfABall) {
    const check::Lab lab = test::make_lab();
    const Function<float(float, float)> fraction(lab, "gloam/occlusion/sphere_proxy.glsl",
                                                 "gloam_sphere_fraction");
    for (const double sine : {0.1, 0.5, 0.9, 0.999999}) {
        constexpr int steps = 1000000;
        int hits = 0;
        for (int i = 0; i < steps; ++i) {
            const double cosine = (i + 0.5) / steps;  // uniform on the half sphere around the axis
            if (1 - cosine * cosine < sine * sine) ++hits;
        }
        EXPECT_NEAR(fraction(static_cast<float>(sine), 1.0F), static_cast<double>(hits) / steps, 3e-5)
            << sine;
    }
}

// Under light that is the same from everywhere a point sends on albedo times visibility, the cosine-weighted
// one.
TEST(DirectionalOcclusion, UniformLightGivesAlbedoTimesVisibility) {
    const check::Lab lab = test::make_lab();
    const std::string file = "gloam/shading/directional_occlusion.glsl";
    const Function<vec3(vec3, vec3, vec3, float)> direct(lab, file, "gloam_ssdo_direct");
    const Function<vec3(vec3, float, vec3)> light(lab, file, "gloam_ssdo_light");
    const vec3 radiance(1, 0.5F, 0.25F);
    const vec3 albedo(1, 0.8F, 0.6F);
    for (const float horizon : {0.0F, 0.5F, 1.0F}) {  // all around, as a sine
        std::vector<std::tuple<vec3, vec3, vec3, float>> inputs;
        constexpr int count = 4000;
        for (int i = 0; i < count; ++i) {
            const float z = (static_cast<float>(i) + 0.5F) / count;
            const float angle = 2.399963F * static_cast<float>(i);
            const float r = std::sqrt(1 - z * z);
            inputs.emplace_back(vec3(r * std::cos(angle), r * std::sin(angle), z), up, radiance,
                                z > horizon ? 1.0F : 0.0F);
        }
        glm::dvec3 sum(0);
        for (const vec3 term : direct(inputs)) sum += term;
        const vec3 got = light(sum, float{count}, albedo);
        const double visible = 1 - static_cast<double>(horizon * horizon);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], albedo[c] * radiance[c] * visible, 1e-3) << horizon;
    }
}

}  // namespace gloam::relatives_test

// SPDX-License-Identifier: MIT
#include "numeric/random.hpp"
#include "reference/builtin.hpp"
#include "reference/filter.hpp"
#include "reference/geometry.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/math.hpp"
#include "reference/numeric.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/sampling.hpp"
#include "reference/shading.hpp"
#include "reference/temporal.hpp"
#include "support/test.hpp"

namespace gloam::reference::printed_test {

constexpr int draws = 2000;

// Calls check(random) for many states of one random generator.
template <class Check>
void for_random(Check check) {
    numeric::Random random(1);
    for (int i = 0; i < draws; ++i) check(random);
}

// Equal but for the rounding of doubles, relative to the larger of the value and `scale`.
void expect_same(double got, double want, double scale = 0.0) {
    EXPECT_NEAR(got, want, 1e-12 * std::max(std::abs(want), scale));
}
// Vectors, relative to their largest component (or `scale`).
template <glm::length_t N>
void expect_same(const glm::vec<N, double>& got, const glm::vec<N, double>& want, double scale = 0.0) {
    for (glm::length_t i = 0; i < N; ++i) scale = std::max(scale, std::abs(want[i]));
    for (glm::length_t i = 0; i < N; ++i) expect_same(got[i], want[i], scale);
}

// Printed equations against what they solve: an integral, an inverse, a search over all points.

const double whole_turn = 2 * pi;

// Simpson's rule.
template <class F>
double integral(double low, double high, F&& f) {
    constexpr int steps = 512;
    double sum = f(low) + f(high);
    for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(low + (high - low) * i / steps);
    return sum * (high - low) / (3 * steps);
}

dvec2 turned_by(double angle) {
    return {std::cos(angle), std::sin(angle)};
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

// A slanted plane: every one-sided difference lies in it.
TEST(Printed, NormalsOfAPlaneAreItsNormal) {
    for_random([](numeric::Random& random) {
        const dvec3 c(0.1, 0.2, -4);
        const dvec3 n = normalize(dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
        const dvec3 x(0.1, 0, -0.1 * n.x / n.z);
        const dvec3 y(0, 0.1, -0.1 * n.y / n.z);
        expect_same(gloam_normal_from_neighbors(c, c - x, c + x, c + y, c - y), dot(n, c) > 0 ? -n : n);
        expect_same(gloam_normal_from_neighbors_orthographic(c, c - x, c + x, c + y, c - y), n);
    });
}

// Every point of the border of a disc across the view ray, projected: the farthest from the centre's image.
TEST(Printed, CoveringRadiusIsThatOfTheProjectedDisc) {
    for_random([](numeric::Random& random) {
        const dvec3 p(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-6, -3));
        const dvec3 s = normalize(cross(p, dvec3(0, 0, 1)));
        const dvec3 t = normalize(cross(p, s));
        const auto image = [](const dvec3& q) { return dvec2(q.x, q.y) / -q.z; };
        double farthest = 0.0;
        for (int i = 0; i < 720; ++i) {
            const double angle = 2 * pi * i / 720;
            farthest =
                std::max(farthest, length(image(p + s * std::cos(angle) + t * std::sin(angle)) - image(p)));
        }
        EXPECT_NEAR(gloam_covering_radius_perpendicular(p, 1.0, 100.0), farthest, 1e-4 * farthest);
    });
}

TEST(Printed, TangentFramesAreRotations) {
    for_random([](numeric::Random& random) {
        const dvec3 normal(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const dmat3 frame = gloam_tangent_frame(normalize(normal));
        const dmat3 one = transpose(frame) * frame;
        for (int i = 0; i < 3; ++i) expect_same(one[i], dmat3(1.0)[i], 1.0);
        expect_same(frame[2], normalize(normal));
        expect_same(cross(frame[0], frame[1]), frame[2]);
    });
}

// Through acos at -1, -1/2, 0, 1/2 and 1 there is one odd cubic about (0, pi / 2).
TEST(Printed, CubicPassesThroughTheArcCosine) {
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) EXPECT_NEAR(gloam_acos_cubic(x), std::acos(x), 1e-12);
}

// What is between a horizon and the tangent plane, as the integral that GTAO solves.
TEST(Printed, SlicesAreTheirIntegrals) {
    numeric::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const double n = random.uniform(-1.5, 1.5);
        const double end = n + whole_turn / 4;
        const double h = random.uniform(0, end);
        const auto weighted = [n](double a) { return std::cos(a - n) * std::abs(std::sin(a)); };
        const GloamSlice slice{.normal = turned_by(n), .angle = n, .weight = 1.0};
        EXPECT_NEAR(gloam_gtao_arc(end - h, turned_by(h), turned_by(n)), integral(h, end, weighted), 1e-8)
            << n << " " << h;
        EXPECT_NEAR(gloam_gtao_side(std::cos(h), n, turned_by(n)), integral(h, end, weighted), 1e-8);
        const double start = n - whole_turn / 4;
        const double whole = integral(start, 0, weighted) + integral(0, end, weighted);
        EXPECT_NEAR(whole, gloam_slice_whole(slice), 1e-8);
        const dvec2 above = turned_by(h);
        EXPECT_NEAR(gloam_slice_fraction_cosine(above, slice), 1 - integral(h, end, weighted) / whole, 1e-8);
        const double low = random.uniform(start, 0);
        EXPECT_NEAR(gloam_slice_fraction_cosine(turned_by(low), slice),
                    integral(start, low, weighted) / whole, 1e-8);
    }
}

// The whole hemisphere by slices: pi for the cosine-weighted measure, whatever the tilt.
TEST(Printed, SlicesSumToTheHemisphere) {
    const dvec3 view(0, 0, 1);
    for (const double tilt : {0.0, 0.5, 1.2}) {
        const dvec3 normal(std::sin(tilt), 0, std::cos(tilt));
        double sum = 0.0;
        constexpr int slices = 4096;
        for (int i = 0; i < slices; ++i) {
            const double a = whole_turn / 2 * (i + 0.5) / slices;
            const auto slice = gloam_slice(dvec2(std::cos(a), std::sin(a)), view, normal);
            sum += slice.weight * (std::cos(slice.angle) + slice.angle * std::sin(slice.angle));
        }
        EXPECT_NEAR(sum / slices, 1.0, 1e-6) << tilt;
    }
}

// The closed forms against the mean over directions that they stand for.
TEST(Printed, OcclusionByCurvature) {
    numeric::Random random(1);
    for (int i = 0; i < 100; ++i) {
        const double a = random.uniform(-6, 6);
        const double b = random.uniform(-6, 6);
        constexpr int steps = 4000;
        double sum = 0;
        for (int s = 0; s < steps; ++s) {
            const double phi = pi * (s + 0.5) / steps;
            const double k = a * std::pow(std::cos(phi), 2) + b * std::pow(std::sin(phi), 2);
            const double q = std::max(k, 0.0) / 2;
            sum += q * q / (1 + q * q);
        }
        EXPECT_NEAR(gloam_occlusion_curvature(a, b, 1.0), sum / steps, 2e-8) << a << " " << b;
    }
}

// An angle from what the cone of that angle holds.
TEST(Printed, ConesHoldWhatTheirAnglesStandFor) {
    for_random([](numeric::Random& random) {
        const double angle = random.uniform(0, pi / 2);
        EXPECT_NEAR(gloam_cone_angle((1 + std::cos(angle)) / 2), angle, 1e-7);
    });
}

TEST(Printed, LevelIsTheLogarithmOfTheDistanceInPixels) {
    for_random([](numeric::Random& random) {
        const double h = std::exp2(random.uniform(-3.3, 12));
        const int printed = std::clamp(static_cast<int>(std::floor(std::log2(h))) - 3, 0, 5);
        EXPECT_EQ(gloam_depth_mip_level(h, 16.0, 5), printed) << h;
    });
}

// 10 h mod 2 pi with 60 digits; at x = 0 the hash is y.
TEST(Printed, TheHashsAngleLosesNoDigitOfItsTurns) {
    const std::pair<unsigned, double> angles[] = {{1U, 3.71681469282041352307},
                                                  {355U, 0.00030144353364053721},
                                                  {1068966896U, 6.28318529673325368618},
                                                  {2147483648U, 5.54276186321225303096},
                                                  {4294967295U, 1.08552372642450606193}};
    for (const auto& [hash, angle] : angles)
        EXPECT_NEAR(gloam_hash_rotation({0, static_cast<int>(hash)}), angle, 1e-15) << hash;
}

// The references of GLSL's own functions that are more than a call, in double.

TEST(Builtin, RoundEvenTakesHalvesToEven) {
    for (const auto& [x, want] :
         {std::pair{0.5, 0.0}, {1.5, 2.0}, {2.5, 2.0}, {-0.5, 0.0}, {-1.5, -2.0}, {3.4, 3.0}}) {
        EXPECT_EQ(round_even(x), want) << x;
    }
}

TEST(Builtin, QuantizeGivesTheNearestHalf) {
    const double ulp = 0x1p-10;
    EXPECT_EQ(quantize_to_half(1.0 + 0.49 * ulp), 1.0);
    EXPECT_EQ(quantize_to_half(1.0 + 0.5 * ulp), 1.0);  // to even
    EXPECT_EQ(quantize_to_half(1.0 + 1.5 * ulp), 1.0 + 2 * ulp);
    EXPECT_EQ(quantize_to_half(0x1.8p-25), 0x1p-24);  // the smallest subnormal
    EXPECT_EQ(quantize_to_half(0x1p-25), 0.0);
    EXPECT_EQ(quantize_to_half(-65519.9), -65504.0);
    EXPECT_EQ(quantize_to_half(65520.0), infinity);
    EXPECT_TRUE(std::isnan(quantize_to_half(std::nan(""))));
}

}  // namespace gloam::reference::printed_test

// SPDX-License-Identifier: MIT
#include "reference/filter/depth_key.hpp"
#include "reference/filter/mssao_upsample.hpp"
#include "reference/geometry/length.hpp"
#include "reference/occlusion/aksoy_phaneuf.hpp"
#include "reference/occlusion/curvature.hpp"
#include "reference/occlusion/disc_proxy.hpp"
#include "reference/occlusion/mssao.hpp"
#include "reference/occlusion/sao.hpp"
#include "reference/occlusion/sphere_proxy.hpp"
#include "reference/printed.hpp"
#include "reference/sampling/count_by_distance.hpp"
#include "reference/sampling/depth_mip.hpp"
#include "reference/shading/bent_cone.hpp"
#include "reference/shading/bent_normal.hpp"
#include "reference/shading/directional_occlusion.hpp"

namespace gloam::reference::test {
namespace printed_relatives_test {

dvec3 unit3(numeric::Random& random) {
    const dvec3 v = point3(random);
    return v / length(v);
}

TEST(Printed, ScalableAmbientObscurance) {
    for_random([](numeric::Random& random) {
        const double r = random.uniform(0.5, 2);
        const dvec3 v = point3(random, 1.2);
        const dvec3 n = unit3(random);
        const double bias = random.uniform(0, 0.1);
        const double epsilon = log_uniform(random, 1e-3, 0.1);
        const double vv = dot(v, v);
        const double vn = dot(v, n);
        const double f = std::max(r * r - vv, 0.0);
        const double within = vv < r * r ? 1.0 : 0.0;
        const double quotient = std::max((vn - bias) / (epsilon + vv), 0.0);
        // Printed with the factor 1 / r^6 taken out of the sum.
        expect_same(gloam_contribution_sao(v, n, r, bias, epsilon), f * f * f * quotient / std::pow(r, 6),
                    1.0);
        expect_same(gloam_contribution_deep(v, n, r, bias, epsilon),
                    std::max(1 - vv / (r * r), 0.0) * std::max((vn - bias) / std::sqrt(epsilon + vv), 0.0),
                    1.0);
        // Printed for a radius of 1.
        const dvec3 u = v / r;
        const double u_bias = bias / r;
        const double u_epsilon = epsilon / (r * r);
        const double printed_paper =
            0.6 * within * std::max((dot(u, n) - u_bias) / (u_epsilon + dot(u, u)), 0.0);
        const double printed_medium =
            4.0 * std::max(1.0 - dot(u, u), 0.0) * std::max(dot(u, n) - u_bias, 0.0);
        const double printed_low = 2.0 * within * std::max(dot(u, n) - u_bias, 0.0);
        expect_same(gloam_contribution_sao_paper(v, n, r, bias, epsilon) * r, printed_paper, 1.0);
        expect_same(gloam_contribution_sao_medium(v, n, r, bias) * r, printed_medium, 1.0);
        expect_same(gloam_contribution_sao_low(v, n, r, bias) * r, printed_low, 1.0);
        const double sum = random.uniform(0, 3);
        expect_same(gloam_visibility_sao(dvec2(sum, 11.0), 0.5), std::max(0.0, 1 - 5 * 0.5 / 11 * sum), 1.0);
        expect_same(gloam_visibility_deep(dvec2(sum, 11.0), 2.0),
                    std::pow(std::max(0.0, 1 - std::sqrt(3 * sum / 11)), 2), 1.0);
    });
}

TEST(Printed, LevelIsTheLogarithmOfTheDistanceInPixels) {
    for_random([](numeric::Random& random) {
        const double h = log_uniform(random, 0.1, 4096);
        const int printed = std::clamp(static_cast<int>(std::floor(std::log2(h))) - 3, 0, 5);
        EXPECT_EQ(gloam_depth_mip_level(h, 16.0, 5), printed) << h;
    });
}

TEST(Printed, SamplesByDistance) {
    for_random([](numeric::Random& random) {
        const double d = random.unit();
        const int printed = std::max(static_cast<int>(64 / (1 + 64 * d)), 6);
        EXPECT_EQ(gloam_count_by_distance(d * 100, 100.0, 64, 6), printed) << d;
    });
}

TEST(Printed, MultiResolution) {
    for_random([](numeric::Random& random) {
        const dvec3 v = point3(random, 1.2);
        const dvec3 n = unit3(random);
        const double d = length(v);
        expect_same(gloam_length(v), d);
        const double falloff = 1 - std::min(1.0, d * d / 2.25);
        expect_same(gloam_contribution_mssao(v, n, 1.5), falloff * std::max(dot(v, n) / d, 0.0), 1.0);
        const double largest = random.unit();
        const double mean = random.uniform(0, largest);
        expect_same(gloam_mssao_combine(largest, mean), 1 - (1 - largest) * (1 - mean), 1.0);
        const double cosine = random.uniform(-1, 1);
        expect_same(gloam_mssao_upsample_weight(largest, v.x, cosine, 0.5, 10.0),
                    largest * std::pow(1 / (1 + std::abs(v.x)), 0.5) * std::pow((cosine + 1) / 2, 10), 1.0);
    });
}

TEST(Printed, ConesAndBentNormals) {
    for_random([](numeric::Random& random) {
        const double angle = random.uniform(0, pi / 2);
        EXPECT_NEAR(gloam_cone_angle((1 + std::cos(angle)) / 2), angle, 1e-7);
        EXPECT_NEAR(gloam_cone_angle_uniform(1 - std::cos(angle)), angle, 1e-7);
        EXPECT_NEAR(gloam_cone_angle_cosine(std::pow(std::sin(angle), 2)), angle, 1e-7);
        const double agreement = random.unit();
        expect_same(gloam_cone_angle_linear(agreement), (1 - std::max(0.0, 2 * agreement - 1)) * pi / 2, 1.0);
        const dvec3 sum = point3(random);
        const dvec4 bent(sum.x, sum.y, sum.z, 2.0);
        expect_same(gloam_bent_normal(bent, dvec3(0, 0, 1)), sum / length(sum));
        expect_same(gloam_bent_length(bent), length(sum) / 2.0);
    });
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

TEST(Printed, ProxiesOfTheScene) {
    for_random([](numeric::Random& random) {
        const dvec3 v = point3(random, 2);
        const dvec3 n = unit3(random);
        const dvec3 e = unit3(random);
        const double d = length(v);
        const double up = std::max(dot(v, n) / d, 0.0);
        const double facing = std::max(-dot(v, e) / d, 0.0);
        const double r = random.uniform(0, 0.99) * d;
        expect_same(gloam_contribution_sphere(v, n, r), (1 - std::sqrt(1 - r * r / (d * d))) * up, 1.0);
        expect_same(gloam_contribution_sphere_cosine(v, n, r), r * r / (d * d) * up, 1.0);
        const double area = log_uniform(random, 1e-3, 10);
        const double squared = pi * d * d;
        expect_same(gloam_contribution_disc_proxy(v, n, e, area, 0.5),
                    0.5 * (1 - 1 / std::sqrt(1 + area / squared)) * facing * std::min(4 * up, 1.0), 1.0);
        expect_same(gloam_contribution_disc_proxy_cosine(v, n, e, area, 1.0),
                    area / (area + squared) * facing * up, 1.0);
        expect_same(gloam_contribution_aksoy_phaneuf(v, n, 1.5, 0.0),
                    dot(v, n) > 0 ? std::max(1 - d / 1.5, 0.0) : 0.0, 1.0);
    });
}

TEST(Printed, DirectionalOcclusion) {
    for_random([](numeric::Random& random) {
        const dvec3 w = unit3(random);
        const dvec3 n = unit3(random);
        const dvec3 s = unit3(random);
        const dvec3 radiance(random.unit(), random.unit(), random.unit());
        const dvec3 albedo(random.unit(), random.unit(), random.unit());
        constexpr double count = 16;
        const double visible = random.unit();
        // (rho / pi) L V cos 2 pi / N
        const double cosine = std::max(dot(w, n), 0.0);
        const dvec3 direct = albedo * radiance * (visible * cosine * 2 / count);
        expect_same(gloam_ssdo_light(gloam_ssdo_direct(w, n, radiance, visible), count, albedo), direct, 1.0);
        // (rho / pi) L (1 - V) A_s cos_s cos_r / d^2, A_s = pi R^2 / N
        const double d = random.uniform(0.5, 2);
        const double radius = random.uniform(0.1, 2);
        const double sender = std::max(-dot(w, s), 0.0);
        const dvec3 bounced =
            albedo * radiance * ((1 - visible) * radius * radius / count * sender * cosine / (d * d));
        expect_same(
            gloam_ssdo_light(gloam_ssdo_bounce(d * w, n, s, radiance, radius, 0.25, visible), count, albedo),
            bounced, 1.0);
    });
}

TEST(Printed, KeysInTwoBytes) {
    for_random([](numeric::Random& random) {
        const double key = random.unit();
        const dvec2 bytes = gloam_pack_key(key) * 255.0;
        EXPECT_EQ(std::round(bytes.x) * 256 + std::round(bytes.y), std::round(key * 65535));
        EXPECT_NEAR(gloam_unpack_key(bytes / 255.0), key, 0.5 / 65535 + 1e-12);
    });
}

}  // namespace printed_relatives_test
}  // namespace gloam::reference::test

// SPDX-License-Identifier: MIT
#include "reference/filter/gaussian.hpp"
#include "reference/filter/shrink.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/occlusion/fox_compton.hpp"
#include "reference/printed.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference::test {
namespace printed_occlusion_test {

TEST(Printed, FalloffsOfTheDistanceOverTheRadius) {
    for_random([](numeric::Random& random) {
        const double radius = log_uniform(random, 1e-30, 1e30);
        const double x = random.uniform(0, 1.2);
        const double d = x * radius;
        const auto within = [&](double value) { return x < 1.0 ? value : 0.0; };
        EXPECT_EQ(gloam_falloff_step(d, radius), within(1.0));
        expect_same(gloam_falloff_linear(d, radius), within(1.0 - x), 1.0);
        expect_same(gloam_falloff_quadratic(d, radius), within(1.0 - x * x), 1.0);
        expect_same(gloam_falloff_cubic(d, radius), within(1.0 - x * x * x), 1.0);
        expect_same(gloam_falloff_sao(d, radius), within(std::pow(1.0 - x * x, 3)), 1.0);
        expect_same(gloam_falloff_exponential(d, radius), std::exp(-x));
        EXPECT_EQ(gloam_falloff_exponential(5.5414 * radius, radius), 0.0);
        expect_same(gloam_falloff_alchemy(d, radius), radius * d / std::pow(std::max(d, radius), 2));
        expect_same(gloam_visibility_filion(radius, d), within(1.0 - x), 1.0);
    });
}

TEST(Printed, CosineAndCreaseShading) {
    for_random([](numeric::Random& random) {
        const dvec3 p = point3(random);
        const dvec3 s = point3(random);
        const dvec3 direction = point3(random);
        const dvec3 n = direction / length(direction);
        const double r = length(s - p);
        const double cosine = std::max(dot(s - p, n) / r, 0.0);
        const double epsilon = log_uniform(random, 1e-3, 10);
        expect_same(gloam_sample_cosine(s - p, n), cosine, 1.0);
        expect_same(gloam_contribution_fox_compton(p, n, s, epsilon), cosine / std::max(epsilon, r),
                    1.0 / epsilon);
        expect_same(gloam_contribution_fox_compton_scaled(p, n, s, epsilon),
                    epsilon * cosine / std::max(epsilon, r), 1.0);
    });
}

TEST(Printed, MeanGaussianSigmaShrinkAndRemap) {
    for_random([](numeric::Random& random) {
        const double sum = random.uniform(0, 9);
        expect_same(gloam_estimator_mean(dvec2(sum, 9.0)), sum / 9.0);
        const double d = random.uniform(0, 3);
        const double sigma = random.uniform(0.5, 3);
        const double weight = std::exp(-d * d / (2 * sigma * sigma));
        expect_same(gloam_gaussian(d * d, sigma), weight);
        const double scale = gloam_gaussian_scale(sigma);
        expect_same(scale * scale, 0.5 / (sigma * sigma) / std::log(2.0));
        expect_same(gloam_gaussian_scaled(d * d, scale), weight);
        expect_same(gloam_filter_sigma(d + 1, 0.5, 1080.0, 1.25), 1.25 * 2 * (d + 1) * 0.5 / 1080.0);
        const double conv = random.unit();
        expect_same(gloam_shrink(conv, 0.5), std::max(0.5 - conv, 0.0) / 0.5);
        const double base = random.uniform(0, 1.5);
        const double c = random.uniform(0.1, 4);
        expect_same(gloam_remap(base, 0.25, 0.5, c), std::min(std::pow(0.5 * (base + 0.25), c), 1.0));
    });
}

}  // namespace printed_occlusion_test
}  // namespace gloam::reference::test

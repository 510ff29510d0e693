// SPDX-License-Identifier: MIT
// The comparative study's methods, ISSAO, GTAO and the visibility bitmask as they stand in print, or as the
// integrals that they claim to be.
#include "reference/filter/bilateral_weight.hpp"
#include "reference/filter/geometry_weight.hpp"
#include "reference/geometry/covering_radius.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/acos_approximation.hpp"
#include "reference/occlusion/alchemy.hpp"
#include "reference/occlusion/angle_based.hpp"
#include "reference/occlusion/filion.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/occlusion/hbao.hpp"
#include "reference/occlusion/issao.hpp"
#include "reference/occlusion/visibility_bitmask.hpp"
#include "reference/occlusion/volumetric.hpp"
#include "reference/printed.hpp"
#include "reference/sampling/issao_offset.hpp"

namespace gloam::reference::test {
namespace printed_methods_test {

const double whole_turn = 2 * std::acos(-1.0);

dvec3 direction3(numeric::Random& random) {
    const dvec3 v = point3(random);
    return v / length(v);
}

// Simpson's rule.
template <class F>
double integral(double low, double high, F&& f) {
    constexpr int steps = 512;
    double sum = f(low) + f(high);
    for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(low + (high - low) * i / steps);
    return sum * (high - low) / (3 * steps);
}

TEST(Printed, AlchemyAndIssao) {
    for_random([](numeric::Random& random) {
        const dvec3 v = point3(random);
        const dvec3 n = direction3(random);
        const double bias = random.uniform(0, 0.1);
        const double epsilon = random.uniform(1e-6, 1e-2);
        const double above = std::max(dot(v, n) - bias, 0.0);
        expect_same(gloam_contribution_alchemy(v, n, bias, epsilon), above / (dot(v, v) + epsilon), 1.0);
        const double radius = random.uniform(0.5, 2);
        const double phi = random.uniform(0.1, 1);
        const double tap = length(v) < radius ? phi * above / (dot(v, v) + epsilon) : 0.0;
        expect_same(gloam_contribution_issao(v, n, radius, phi, bias, epsilon), tap, 1.0);
        const double mu = random.uniform(0.1, 2);
        const double q = phi * length(v) / std::pow(std::max(mu, length(v)), 2);
        expect_same(gloam_issao_attenuation(length(v), phi, mu), q);
        // Eq 4 without its clamp at mu is eq 6 without its guards.
        if (length(v) > mu && length(v) < radius)
            expect_same(gloam_contribution_issao_attenuated(v, n, radius, phi, mu),
                        gloam_contribution_issao(v, n, radius, phi, 0.0, 0.0), 1.0);
        const double sum = random.uniform(0, 8);
        const double sigma = random.uniform(0, 1);
        const double k = random.uniform(0.5, 3);
        const double a = std::pow(std::max(0.0, 1 - 2 * sigma / 8 * sum), k);
        expect_same(gloam_visibility_alchemy(dvec2(sum, 8.0), sigma, k), a, 1.0);
        expect_same(gloam_issao_occlusion(dvec2(sum, 8.0), 1.06), std::min(1.06 / 8 * sum, 1.0));
    });
}

TEST(Printed, OffsetsAndProjectedDiscOfIssao) {
    for_random([](numeric::Random& random) {
        const dvec2 e(random.unit(), random.unit());
        const double turn = whole_turn;
        expect_same(gloam_issao_offset_polar(e, 3.0),
                    dvec2(3 * e.x * std::sin(turn * e.y), 3 * e.x * std::cos(turn * e.y)), 3.0);
        dvec2 printed(e.x * std::sin(turn * e.y), e.y * std::cos(turn * e.x));
        if (length(printed) > 1) printed = printed / length(printed);
        expect_same(gloam_issao_offset_printed(e, 3.0), printed * 3.0, 3.0);
        // Every point of the border of a disc across the view ray, projected: the farthest from the centre's
        // image.
        const dvec3 p(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-6, -3));
        const dvec3 toward = p / length(p);
        const dvec3 u = cross(toward, dvec3(0, 0, 1));
        const dvec3 s = length(u) > 0 ? dvec3(u / length(u)) : dvec3(1, 0, 0);
        const dvec3 t = cross(toward, s);
        const auto image = [](const dvec3& q) { return dvec2(q.x, q.y) / -q.z; };
        double farthest = 0.0;
        for (int i = 0; i < 720; ++i) {
            const double angle = turn * i / 720;
            const dvec3 q = p + s * std::cos(angle) + t * std::sin(angle);
            farthest = std::max(farthest, length(image(q) - image(p)));
        }
        EXPECT_NEAR(gloam_covering_radius_perpendicular(p, 1.0, 100.0), farthest, 1e-4 * farthest);
        expect_same(gloam_covering_radius_parallel(p, 1.0, 100.0), 1 / -p.z);
    });
}

TEST(Printed, FilionHbaoAndVolumes) {
    for_random([](numeric::Random& random) {
        const double delta = random.uniform(0.01, 4);
        const double radius = random.uniform(0.5, 2);
        const double visible = std::clamp((delta - radius) / delta, 0.0, 1.0);
        expect_same(gloam_contribution_filion(8.0, 8.0 - delta, radius), 1 - visible, 8.0);
        const dvec3 v = point3(random);
        const double tangent = v.z / std::hypot(v.x, v.y);
        const double before = random.uniform(-1, 1);
        const double sine = tangent / std::sqrt(1 + tangent * tangent);
        const bool counts = length(v) < radius && sine > before;
        const double added = counts ? (sine - before) * (1 - dot(v, v) / (radius * radius)) : 0.0;
        expect_same(gloam_hbao_step(dvec2(before, 0.25), v, radius),
                    dvec2(counts ? sine : before, 0.25 + added), 1.0);
        expect_same(gloam_sine_of_tangent(tangent), sine, 1.0);
        const dvec2 xi = point2(random, 0.7);
        const double h = radius * std::sqrt(1 - dot(xi, xi));
        expect_same(gloam_chord_half_height(xi, radius), h);
        const double depth = random.uniform(-2, 2);  // of the surface behind the point
        expect_same(gloam_line_occlusion(-depth, h), std::clamp((h - depth) / (2 * h), 0.0, 1.0), 1.0);
    });
}

dvec2 turned_by(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

// What is between a horizon and the tangent plane, as the integral that GTAO solves; with the printed
// solution of the rest.
TEST(Printed, SlicesAreTheirIntegrals) {
    numeric::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const double n = random.uniform(-1.5, 1.5);
        const double end = n + whole_turn / 4;
        const double h = random.uniform(0, end);
        const auto weighted = [n](double a) { return std::cos(a - n) * std::abs(std::sin(a)); };
        const auto plain = [](double a) { return std::abs(std::sin(a)); };
        const GloamSlice slice{.normal = turned_by(n), .angle = n, .weight = 1.0};
        EXPECT_NEAR(gloam_gtao_arc(end - h, turned_by(h), turned_by(n)), integral(h, end, weighted), 1e-8)
            << n << " " << h;
        EXPECT_NEAR(gloam_gtao_side(std::cos(h), n, turned_by(n)), integral(h, end, weighted), 1e-8);
        EXPECT_NEAR(gloam_gtao_inner(h, n), integral(0, h, weighted), 1e-8) << n << " " << h;
        EXPECT_NEAR(gloam_gtao_arc_uniform(std::cos(h), std::sin(n)), 0.5 * integral(h, end, plain), 1e-8)
            << n;
        const double start = n - whole_turn / 4;
        const double whole = integral(start, 0, weighted) + integral(0, end, weighted);
        EXPECT_NEAR(whole, gloam_slice_whole(slice), 1e-8);
        const dvec2 above = turned_by(h);
        EXPECT_NEAR(gloam_slice_fraction_cosine(above, slice), 1 - integral(h, end, weighted) / whole, 1e-8);
        EXPECT_NEAR(gloam_slice_fraction_uniform(above, slice), 1 - 0.5 * integral(h, end, plain), 1e-8);
        EXPECT_NEAR(gloam_slice_fraction_angle(above, slice), (h - start) / (whole_turn / 2), 1e-8);
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

TEST(Printed, AnglesAndWeights) {
    for_random([](numeric::Random& random) {
        const double pi = whole_turn / 2;
        const double x = random.uniform(-1, 1);
        // Through acos at -1, -1/2, 0, 1/2 and 1 there is one odd cubic about (0, pi / 2).
        const double odd = x * (x * x - 0.25) / 0.75;
        expect_same(gloam_acos_cubic(x), pi / 2 - (4 * (pi / 6) * 0.5 * x) - (pi / 2 - pi / 3) * odd, 1e4);
        expect_same(gloam_acos_linear(x), pi / 2 * (1 - x), 1e4);
        expect_same(gloam_acos_quadratic(x), pi / 2 * (1 - (x < 0 ? -1 : 1) * x * x), 1e4);
        const dvec3 v = point3(random);
        const dvec3 n = direction3(random);
        const dvec3 view = direction3(random);
        const dvec3 s = v / length(v);
        const dvec3 t = dot(s, n) < 0 ? dvec3(s - n * dot(s, n)) : s;
        expect_same(gloam_lifted_cosine(v, n, view), dot(view, t) / length(t), 1.0);
        const double difference = random.uniform(-4, 4);
        const double weight = std::pow(dot(n, view) / 2 + 0.5, 10) * std::pow(1 + std::abs(difference), -0.5);
        expect_same(gloam_geometry_weight(n, view, difference, 10.0, 0.5), weight, 1.0);
        const dvec2 offset = point2(random, 4);
        const double bilateral =
            std::exp(-0.5 * std::pow(length(offset) / 2, 2)) * std::exp(-0.5 * std::pow(difference / 3, 2));
        expect_same(gloam_bilateral_weight(offset, difference, 2.0, 3.0), bilateral, 1.0);
    });
}

}  // namespace printed_methods_test
}  // namespace gloam::reference::test

// SPDX-License-Identifier: MIT
#include "reference/printed.hpp"
#include "reference/sampling/circle.hpp"
#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hash_rotation.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/poisson.hpp"
#include "reference/sampling/radius_law.hpp"
#include "reference/sampling/reflect.hpp"
#include "reference/sampling/rotation.hpp"
#include "reference/sampling/spiral.hpp"
#include "reference/sampling/tangent_frame.hpp"

namespace gloam::reference::test {
namespace printed_sampling_test {

const double two_pi = 2.0 * pi;

// a_0 / b + a_1 / b^2 + ... of the digits a_m of the index.
double mirrored_digits(unsigned index, unsigned base) {
    double value = 0.0;
    double place = 1.0;
    for (unsigned rest = index; rest > 0U; rest /= base) {
        place /= base;
        value += rest % base * place;
    }
    return value;
}

TEST(Printed, RadicalInverseIsTheSumOfMirroredDigits) {
    for_random([](numeric::Random& random) {
        const auto index = static_cast<unsigned>(random.below(16777216));
        for (const unsigned base : {2U, 3U, 5U, 7U, 16777213U}) {
            expect_same(gloam_radical_inverse(index, base), mirrored_digits(index, base));
        }
        EXPECT_EQ(gloam_radical_inverse_base2(index), mirrored_digits(index, 2U));
        const dvec3 point = gloam_halton_3d(index);
        expect_same(point,
                    dvec3(mirrored_digits(index, 2), mirrored_digits(index, 3), mirrored_digits(index, 5)));
    });
}

TEST(Printed, DiscAndHemisphereMaps) {
    for_random([](numeric::Random& random) {
        const dvec3 zeta(random.unit(), random.unit(), random.unit());
        const double a = two_pi * zeta.x;
        const dvec2 on_circle(std::cos(a), std::sin(a));
        expect_same(gloam_circle_point(zeta.x), on_circle);
        expect_same(gloam_disc_sample(dvec2(zeta.x, zeta.y)), std::sqrt(zeta.y) * on_circle);
        const double r = zeta.y;
        const double side = std::sqrt(1.0 - zeta.z);
        expect_same(gloam_hemisphere_cosine(zeta),
                    dvec3(r * std::cos(a) * side, r * std::sin(a) * side, r * std::sqrt(zeta.z)));
        const double uniform = std::sqrt(1.0 - zeta.z * zeta.z);
        expect_same(gloam_hemisphere_uniform(zeta),
                    dvec3(r * std::cos(a) * uniform, r * std::sin(a) * uniform, r * zeta.z));
    });
}

TEST(Printed, CubicRadiusIsTheCubeRoot) {
    for_random([](numeric::Random& random) {
        const double zeta = log_uniform(random, 1e-37, 1.0);
        expect_same(gloam_radius_cubic(zeta), std::cbrt(zeta));
    });
}

TEST(Printed, RotationIsByTheAngleItself) {
    for_random([](numeric::Random& random) {
        const dvec2 s = point2(random);
        const double angle = random.uniform(-100, 100);
        const double c = std::cos(angle);
        const double d = std::sin(angle);
        expect_same(gloam_rotate_disc(s, angle), dvec2(c * s.x - d * s.y, d * s.x + c * s.y), 100.0);
        const dvec3 turned = gloam_rotate_hemisphere(dvec3(s.x, s.y, 0.25), angle);
        expect_same(turned, dvec3(c * s.x - d * s.y, d * s.x + c * s.y, 0.25), 100.0);
    });
}

TEST(Printed, HashRotationIsTenTimesTheHashInRadians) {
    for_random([](numeric::Random& random) {
        const glm::ivec2 pixel(static_cast<int>(random.below(64)), static_cast<int>(random.below(64)));
        const int hash = (3 * pixel.x) ^ (pixel.y + pixel.x * pixel.y);
        expect_same(gloam_hash_rotation(pixel), std::fmod(10.0 * hash, two_pi), 100.0);
        const double turn = std::fmod(10.0 * hash / two_pi, 1.0);
        EXPECT_NEAR(gloam_hash_turn(static_cast<unsigned>(hash)), turn * 0x1p32, 1.0);
    });
}

TEST(Printed, SpiralTap) {
    for_random([](numeric::Random& random) {
        const int count = 1 + static_cast<int>(random.below(64));
        const int index = static_cast<int>(random.below(static_cast<unsigned>(count)));
        const int turns = static_cast<int>(random.below(41)) - 20;
        const double phase = random.uniform(-7, 7);
        const double a = (index + 0.5) / count;
        const double angle = two_pi * a * turns + phase;
        expect_same(gloam_spiral_tap(index, count, turns, phase), a * dvec2(std::cos(angle), std::sin(angle)),
                    100.0);
    });
}

TEST(Printed, HemisphereLiftAndPoissonDistance) {
    for_random([](numeric::Random& random) {
        const dvec2 p = point2(random, 0.7);
        expect_same(gloam_hemisphere_lift(p), dvec3(p.x, p.y, std::sqrt(1.0 - dot(p, p))));
        const dvec2 q = point2(random);
        const double apart = std::hypot(p.x - q.x, p.y - q.y);
        EXPECT_TRUE(gloam_poisson_accepts(p, q, apart * (1.0 - 1e-12)));
        EXPECT_FALSE(gloam_poisson_accepts(p, q, apart * (1.0 + 1e-12)));
    });
}

TEST(Printed, ReflectionAtANormalizedDirection) {
    for_random([](numeric::Random& random) {
        const dvec3 s = point3(random);
        const dvec3 encoded(random.unit(), random.unit(), random.unit());
        const dvec3 direction = 2.0 * encoded - 1.0;
        const dvec3 n = direction / length(direction);
        expect_same(gloam_reflect_sample(s, encoded), s - 2.0 * dot(s, n) * n);
    });
}

// Rodrigues' rotation of z onto n; below the horizon of z onto -n, with y then negated to stay right-handed.
TEST(Printed, TangentFrameIsARotationOfTheAxes) {
    for_random([](numeric::Random& random) {
        const dvec3 normal = point3(random);
        const dvec3 n = normal / length(normal);
        const dvec3 up = n.z < 0.0 ? -n : n;
        const double k = 1.0 / (1.0 + up.z);
        const dvec3 x(1.0 - up.x * up.x * k, -up.x * up.y * k, -up.x);
        const dvec3 y(-up.x * up.y * k, 1.0 - up.y * up.y * k, -up.y);
        const dmat3 frame = gloam_tangent_frame(normal);
        expect_same(dvec3(frame[0]), x);
        expect_same(dvec3(frame[1]), n.z < 0.0 ? -y : y);
        expect_same(dvec3(frame[2]), n);
    });
}

}  // namespace printed_sampling_test
}  // namespace gloam::reference::test

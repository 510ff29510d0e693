// SPDX-License-Identifier: MIT
// The references of GLSL's own functions that are more than a call, in double.
#include "reference/builtin.hpp"
#include "reference/printed.hpp"

namespace gloam::reference::test {
namespace builtin_test {

TEST(Builtin, RoundEvenTakesHalvesToEven) {
    for (const auto& [x, want] :
         {std::pair{0.5, 0.0}, {1.5, 2.0}, {2.5, 2.0}, {-0.5, 0.0}, {-1.5, -2.0}, {3.4, 3.0}}) {
        EXPECT_EQ(builtin_round_even(x), want) << x;
    }
}

TEST(Builtin, QuantizeGivesTheNearestHalf) {
    const double ulp = 0x1p-10;
    EXPECT_EQ(builtin_quantize(1.0 + 0.49 * ulp), 1.0);
    EXPECT_EQ(builtin_quantize(1.0 + 0.5 * ulp), 1.0);  // to even
    EXPECT_EQ(builtin_quantize(1.0 + 1.5 * ulp), 1.0 + 2 * ulp);
    EXPECT_EQ(builtin_quantize(0x1.8p-25), 0x1p-24);  // the smallest subnormal
    EXPECT_EQ(builtin_quantize(0x1p-25), 0.0);
    EXPECT_EQ(builtin_quantize(-65519.9), -65504.0);
    EXPECT_EQ(builtin_quantize(65520.0), infinity);
    EXPECT_TRUE(std::isnan(builtin_quantize(std::nan(""))));
}

TEST(Builtin, FrexpIsThatOfTheStandardLibrary) {
    for_random([](numeric::Random& random) {
        const double x = log_uniform(random, 1e-37, 1e38) * (random.below(2) == 0 ? 1 : -1);
        int exponent = 0;
        int want = 0;
        EXPECT_EQ(builtin_frexp(x, exponent), std::frexp(x, &want));
        EXPECT_EQ(exponent, want);
    });
}

TEST(Builtin, InverseTimesTheMatrixIsOne) {
    for_random([](numeric::Random& random) {
        dmat3 m(1.0);
        for (int column = 0; column < 3; ++column) {
            m[column] = point3(random) + 3.0 * dvec3(column == 0, column == 1, column == 2);
        }
        const dmat3 one = builtin_matrix_matrix(builtin_inverse(m), m);
        for (int column = 0; column < 3; ++column) {
            expect_same(dvec3(one[column]), dvec3(column == 0, column == 1, column == 2), 100.0);
        }
    });
}

TEST(Builtin, RefractionKeepsSnellsLaw) {
    for_random([](numeric::Random& random) {
        const dvec3 n(0, 0, 1);
        const double angle = random.uniform(0, 1.5);
        const double eta = random.uniform(0.5, 0.99);
        const dvec3 out = builtin_refract(dvec3(std::sin(angle), 0, -std::cos(angle)), n, eta);
        expect_same(out.x, eta * std::sin(angle), 1.0);
        expect_same(length(out), 1.0);
    });
    EXPECT_EQ(builtin_refract(dvec3(1, 0, 0), dvec3(0, 0, 1), 1.5), dvec3(0));  // total reflection
}

TEST(Builtin, SignBitsAreThoseOfEachComponent) {
    EXPECT_EQ(probe_normalize_sign(dvec3(-0.0, 1, -2)), 5.0);
}

}  // namespace builtin_test
}  // namespace gloam::reference::test

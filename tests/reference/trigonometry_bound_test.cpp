// SPDX-License-Identifier: MIT
// What the comments of glsl/gloam/numeric promise "whatever the rounding", proved: boxes cover the domain,
// and over each the error of any conforming arithmetic is bounded; the polynomials' own error, which is
// smooth, is taken in the middle of each box.
#include <vector>

#include "reference/error_bound.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"
#include "reference/printed.hpp"

namespace gloam::reference::test {
namespace trigonometry_bound_test {

constexpr double turn = 6.28318530717958647692;

// Ends of boxes from low to high, a little inside them: a comparison at the ends themselves would be open.
std::vector<double> evenly(double low, double high, int boxes = 20'000) {
    std::vector<double> ends;
    for (int i = 0; i <= boxes; ++i) ends.push_back(low + (high - low) * (1e-9 + i * (1.0 - 2e-9) / boxes));
    return ends;
}
// Ends of boxes towards side * 1, each a thousandth nearer to it, as near as the last float before it.
std::vector<double> toward_one(double side) {
    std::vector<double> ends;
    for (double rest = 0.5 - 1e-9; rest > 0x1p-25; rest *= 0.999) ends.push_back(side * (1.0 - rest));
    if (side < 0.0) std::ranges::reverse(ends);
    return ends;
}

// The largest error of f, a function of a Bounded, against `exact` over the boxes between the ends.
template <class F, class Exact>
double proven_error(const std::vector<double>& ends, F f, Exact exact) {
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Bounded box = Bounded::box(ends[i], ends[i + 1]);
        const Bounded got = f(box);
        const double off = std::abs(static_cast<double>(got.value - exact(box.value)));
        worst = std::max(worst, off + got.error);
    }
    return worst;
}

TEST(ErrorBound, SineAndCosineOfAnOctant) {
    const auto c = proven_error(
        evenly(0, turn / 8), [](Bounded a) { return gloam_sincos_octant(a).x; },
        [](long double a) { return std::cos(a); });
    const auto s = proven_error(
        evenly(0, turn / 8), [](Bounded a) { return gloam_sincos_octant(a).y; },
        [](long double a) { return std::sin(a); });
    EXPECT_LT(c, 4e-7);
    EXPECT_LT(s, 4e-7);
    EXPECT_GT(c, 1e-7);  // the rounding alone is as much
}

TEST(ErrorBound, SineAndCosineOfTurns) {
    for (int octant = 0; octant < 8; ++octant) {
        const double low = octant / 8.0;
        const auto c = proven_error(
            evenly(low, low + 0.125), [](Bounded t) { return gloam_sincos_turns(t).x; },
            [](long double t) { return std::cos(t * 6.28318530717958647692528676656L); });
        const auto s = proven_error(
            evenly(low, low + 0.125), [](Bounded t) { return gloam_sincos_turns(t).y; },
            [](long double t) { return std::sin(t * 6.28318530717958647692528676656L); });
        EXPECT_LT(std::max(c, s), 5e-7) << octant;
    }
}

TEST(ErrorBound, ArcSineAndArcCosine) {
    const auto half = proven_error(
        evenly(0, 0.5), [](Bounded x) { return gloam_asin_half(x); },
        [](long double x) { return std::asin(x); });
    EXPECT_LT(half, 1.4e-7);
    const auto arc_cosine = [](Bounded x) { return gloam_acos(x); };
    const auto arc_sine = [](Bounded x) { return gloam_asin(x); };
    const auto exact_cosine = [](long double x) { return std::acos(x); };
    const auto exact_sine = [](long double x) { return std::asin(x); };
    for (const auto& ends : {evenly(-0.5, 0), evenly(0, 0.5), toward_one(1), toward_one(-1)}) {
        EXPECT_LT(proven_error(ends, arc_cosine, exact_cosine), 1e-6) << ends.front();
        EXPECT_LT(proven_error(ends, arc_sine, exact_sine), 1e-6) << ends.front();
    }
}

// In two parts, because the errors of the ratio and of what is made of it are not independent: the
// polynomial's for an exact ratio, and the change of the angle with the ratio, which is 1 / (1 + r^2).
TEST(ErrorBound, ArcTangent) {
    const double polynomial = proven_error(
        evenly(0, 1), [](Bounded r) { return detail::unit_arc_tangent(r); },
        [](long double r) { return std::atan(r); });
    double worst = 0.0;
    for (double r = 0.0; r < 1.0; r += 1e-3) {
        const double ratio = gloam_length_ratio(Bounded::box(r, r + 1e-3), Bounded(1)).error;
        worst = std::max(worst, polynomial + ratio / (1.0 + r * r));
    }
    EXPECT_LT(worst, 1e-6);
    // Taken from pi, where the last rounding is the coarsest.
    Bounded angle = Bounded::box(0, pi<double>() / 4);
    angle.error = worst;
    const Bounded direction = Bounded(3.141592654) - angle;
    EXPECT_LT(direction.error + 8.8e-8, 1e-6);  // and pi itself is a float
}

TEST(ErrorBound, SquareRoot) {
    // Relative, over two binades: an ULP is between 2^-24 and 2^-23 of the value.
    for (double x = 1.0; x < 4.0; x *= 1.001) {
        const Bounded root = gloam_sqrt(Bounded::box(x, x * 1.001));
        EXPECT_LT(root.error, 3.01 * 0x1p-23 * root.high);
    }
}

}  // namespace trigonometry_bound_test
}  // namespace gloam::reference::test

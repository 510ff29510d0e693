// SPDX-License-Identifier: MIT
// Vulkan lets a device read and return zero for subnormal numbers. What the functions do where that could
// hurt is looked at in everything that the rules permit, so that no device of either kind is needed.
#include <vector>

#include "numeric/interval.hpp"
#include "numeric/paths.hpp"
#include "reference/filter/shrink.hpp"
#include "reference/geometry/reprojection.hpp"
#include "reference/occlusion/fox_compton.hpp"
#include "reference/printed.hpp"
#include "reference/sampling/tangent_frame.hpp"
#include "reference/temporal/blend.hpp"
#include "reference/temporal/history.hpp"

namespace gloam::reference::test {
namespace flushed_subnormals_test {

using numeric::Interval;
using numeric::Paths;

constexpr float least = 0x1p-126F;
constexpr float below = -0x1p-149F;  // the negative subnormal nearest to 0

// Everything that f, a function without arguments on intervals, may return.
template <class F>
std::vector<Interval> permitted(F f) {
    std::vector<Interval> results;
    const auto outcome = Paths::explore(numeric::float32, 4096, [&] { results.push_back(f()); });
    EXPECT_EQ(outcome, Paths::Outcome::complete);
    EXPECT_FALSE(results.empty());
    return results;
}

template <class F>
void expect_within(F f, double low, double high) {
    for (const Interval& result : permitted(f)) {
        EXPECT_GE(result.low(), low);
        EXPECT_LE(result.high(), high);
        EXPECT_FALSE(result.may_be_nan());
    }
}

Interval input(float x) {
    return Interval::input(x);
}

TEST(FlushedSubnormals, AFrameKeepsTheSideOfItsNormal) {
    const auto tangent = [] {
        const vec3<Interval> normal(input(-3.4028235e38F), input(0.5F), input(-0.34F));
        return gloam_tangent_frame(normal)[0].z;
    };
    expect_within(tangent, -1.00001, -0.99999);
}

TEST(FlushedSubnormals, AHistoryBelowZeroIsReadAsZero) {
    const auto blended = [](float history, float k) {
        return
            [=] { return gloam_blend(input(history), input(8.0F), input(1.0F), input(k), input(500.0F)).x; };
    };
    expect_within(blended(below, 0.0F), 0.0, 0.0);
    expect_within(blended(below, std::numeric_limits<float>::infinity()), 0.0, 0.0);
    expect_within(blended(0.5F, below), 0.5, 0.5);
    const auto occlusion = [] {
        const GloamHistory<Interval> h{input(below), input(8.0F), 3U, input(1.0F)};
        return gloam_history_sanitize(h).occlusion;
    };
    expect_within(occlusion, 0.0, 0.0);
}

TEST(FlushedSubnormals, TheSupportOfAFilterWithATinyThresholdIsNone) {
    const float more = std::nextafter(least, 1.0F);
    expect_within([more] { return gloam_shrink(input(least), input(more)); }, 0.0, 0.0);
    // Just above the threshold the difference is still normal.
    const float small = 1.0000001e-30F;
    const float smaller = std::nextafter(small, 0.0F);
    expect_within([=] { return gloam_shrink(input(smaller), input(small)); }, 1e-8, 2e-7);
}

TEST(FlushedSubnormals, CoordinatesOfAPointAtTheEyeAreNotMadeUp) {
    for (const float w : {least, 1e-31F}) {
        const auto accepted = [w] {
            vec2<Interval> uv;
            return Interval(
                gloam_uv_from_clip(vec4<Interval>(input(w), input(w), input(w), input(w)), uv) ? 1 : 0);
        };
        expect_within(accepted, 0.0, 0.0);
    }
    const auto u = [] {
        vec2<Interval> uv;
        const float w = 1.1e-30F;
        (void)gloam_uv_from_clip(vec4<Interval>(input(w), input(w), input(w), input(w)), uv);
        return uv.x;
    };
    expect_within(u, 0.999999, 1.0);
}

TEST(FlushedSubnormals, CreaseShadingOfTouchingPointsIsFinite) {
    const auto contribution = [] {
        const vec3<Interval> p(input(least), input(least), input(least));
        const vec3<Interval> n(input(0.0F), input(-0.8F), input(-0.6F));
        const vec3<Interval> s(input(0.0F), input(0.0F), input(0.0F));
        return gloam_contribution_fox_compton(p, n, s, input(-0.0F));
    };
    expect_within(contribution, 0.0, 8.6e37);
}

}  // namespace flushed_subnormals_test
}  // namespace gloam::reference::test

// SPDX-License-Identifier: MIT
// What methods read and count, where no value of theirs tells: known/methods.txt has those.
#include "gathers.hpp"

namespace gloam::method_relatives_test {

using glm::dvec3;

// An orthographic eye whose pixels are `pixel` wide and high; the shaded point is in the middle of the middle
// one.
const glm::ivec2 size(65, 97);
const glm::ivec2 middle = size / 2;
const glm::dvec2 pixel(1.0 / 16.0, 1.0 / 24.0);
const Camera eye{glm::vec2(2.0 / (size.x * pixel.x), -2.0 / (size.y * pixel.y)), size, true};

// A surface over the image plane, y up.
struct Surface {
    std::function<double(double x, double y)> height;
    std::function<dvec3(double x, double y)> normal;

    static double x(glm::ivec2 p) { return pixel.x * (p.x - middle.x); }
    static double y(glm::ivec2 p) { return -pixel.y * (p.y - middle.y); }
    check::ImageSet view() const {
        return test::view_of(
            size, [&](glm::ivec2 p) { return static_cast<float>(5.0 - height(x(p), y(p))); },
            [&](glm::ivec2 p) { return glm::vec3(normal(x(p), y(p))); });
    }
};

class Relatives : public testing::Test {
  protected:
    test::Gathers gathers;

    check::Function<Gather> method(const std::string& name) const { return gathers[name]; }
    // The mean over that many frames of 256 samples at the middle of the view.
    double mean(const std::string& name, const Surface& surface, float radius, const Method& settings,
                unsigned frames) const {
        std::vector<test::GatherInputs> inputs;
        const glm::vec3 position(0, 0, surface.height(0, 0) - 5.0);
        for (unsigned f = 0; f < frames; ++f) {
            const Samples samples{
                .radius = radius, .bias = 1e-4F, .angle = 0.0F, .first = 256 * f, .count = 256};
            inputs.emplace_back(position, glm::vec3(surface.normal(0, 0)), eye, samples, settings);
        }
        glm::dvec2 sum(0);
        for (const glm::vec2 part : method(name)(inputs, surface.view())) sum += glm::dvec2(part);
        return sum.x / sum.y;
    }
};

// A cross reads the pixels at both ends of its two arms (CS-K): a quarter of a turn times the first
// coordinate of its point of the sequence, as long as the second says, from half the radius to all of it. The
// angle of the kernel shifts both.
TEST_F(Relatives, ACrossSeesThePixelsOfItsArms) {
    const auto curvature = method("curvature");
    const check::Function<glm::vec3(unsigned)> halton(gathers.lab(), "gloam/sampling/halton.glsl",
                                                      "gloam_halton_3d");
    constexpr float angle = 0.8F;
    const auto shifted = [](float x) {
        return glm::fract(double{x} + double{angle} / (2.0 * std::numbers::pi));
    };
    const auto at = [&](unsigned n, const auto& turns) {
        const auto view = test::view_of(
            size, [](glm::ivec2) { return 5.0F; },
            [&](glm::ivec2 p) { return turns(p) ? glm::vec3(0.3F, 0.2F, 1) : glm::vec3(0, 0, 1); });
        const Samples samples{.radius = 1.0F, .bias = 0.0F, .angle = angle, .first = 4 * n, .count = 4};
        return curvature.with_images(view, {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), eye, samples, Method{}});
    };
    int seen = 0;
    for (unsigned n = 0; n < 40; ++n) {
        const glm::vec3 random = halton(n + 1);
        const double turn = 0.5 * std::numbers::pi * shifted(random.x);
        const glm::dvec2 arm = 0.5 * (1.0 + shifted(random.y)) * glm::dvec2(std::cos(turn), std::sin(turn));
        std::vector<glm::ivec2> ends;
        bool certain = true;
        for (const glm::dvec2 end : {arm, -arm, glm::dvec2(-arm.y, arm.x), glm::dvec2(arm.y, -arm.x)}) {
            ends.push_back(middle + glm::ivec2(glm::round(end / pixel)));
            const glm::dvec2 within = glm::abs(glm::fract(end / pixel) - 0.5);
            certain = certain && std::min(within.x, within.y) > 0.02;
        }
        if (!certain) continue;
        const auto is_end = [&](glm::ivec2 p) { return std::ranges::find(ends, p) != ends.end(); };
        const glm::vec2 bare = at(n, [](glm::ivec2) { return false; });
        EXPECT_EQ(at(n, [&](glm::ivec2 p) { return p != middle && !is_end(p); }), bare) << n;
        const auto changes = [&](glm::ivec2 end) {
            return at(n, [&](glm::ivec2 p) { return p == end; }) != bare;
        };
        seen += std::ranges::any_of(ends, changes) ? 1 : 0;
    }
    EXPECT_GT(seen, 10);
}

// Each setting that a method's descriptor lists changes its result on a rough surface, and no other setting
// does. Methods with preparation passes are tested by the effect (tests/effect/settings_test.cpp).
class RelativesSettings : public testing::TestWithParam<std::string> {};

TEST_P(RelativesSettings, ThoseItReadsChangeItAndNoOthers) {
    const test::Gathers gathers;
    const check::Function<Gather> gather = gathers[GetParam()];
    std::vector<std::string> settings;
    for (const effect::MethodMember& member : effect::method_named(GetParam()).members)
        settings.push_back(setting_of(member));
    const auto bump = [](glm::ivec2 p) { return static_cast<float>((p.x * 31 + p.y * 17) % 11) / 11.0F; };
    const auto view = test::view_of(
        size, [&](glm::ivec2 p) { return 5.0F - bump(p); },
        [&](glm::ivec2 p) { return glm::vec3(4.0F * bump(p) - 2.0F, 2.0F - 4.0F * bump({p.y, p.x}), 1.0F); });
    const auto result = [&](const Method& method) {
        const Samples samples{.radius = 1.0F, .bias = 1e-4F, .angle = 0.5F, .first = 0, .count = 48};
        return gather.with_images(view, {glm::vec3(0, 0, -4.9F), glm::vec3(0, 0, 1), eye, samples, method});
    };
    const Method plain{.range = 0.8F,
                       .epsilon = 0.3F,
                       .intensity = 0.05F,
                       .thickness = 1e3F,
                       .angle_bias = 0.1F,
                       .steps = 4,
                       .feature_thickness = 1e18F};
    std::map<std::string, Method> changed;
    const auto change = [&](const char* name, auto Method::* member, auto value) {
        changed.emplace(name, plain).first->second.*member = value;
    };
    change("range", &Method::range, 0.3F);
    change("epsilon", &Method::epsilon, 0.02F);
    change("intensity", &Method::intensity, 0.03F);
    change("thickness", &Method::thickness, 0.1F);
    change("angle_bias", &Method::angle_bias, 0.3F);
    change("mip_distance", &Method::mip_distance, 2.0F);
    change("steps", &Method::steps, 3U);
    change("disagreement", &Method::disagreement, 0.5F);
    change("feature_thickness", &Method::feature_thickness, 0.1F);
    for (const auto& [name, method] : changed) {
        const bool read = std::ranges::find(settings, name) != settings.end();
        EXPECT_EQ(result(method) != result(plain), read) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, RelativesSettings,
                         testing::ValuesIn(test::method_names([](const effect::MethodInfo& method) {
                             return method.prepare == nullptr;
                         })),
                         test::parameter_name);

// Taps in one pixel count once. If the whole disc is in one pixel there is one sample; in a disc a few pixels
// wide there are at most as many samples as pixels. The mean is that over the pixels that were read.
TEST_F(Relatives, TapsInOnePixelCountOnce) {
    const check::Function<Gather> every = method("issao");
    const check::Function<Gather> distinct = method("issao_distinct");
    // One pixel beside the middle is raised: every tap in it counts, all others are 0.
    const Camera square{eye.p00_p11 * glm::vec2(1.0F, static_cast<float>(pixel.y / pixel.x)), size, true};
    const auto view = test::view_of(size, [](glm::ivec2 p) {
        return p == middle + glm::ivec2(1, 0) ? static_cast<float>(5.0 - 0.5 * pixel.x) : 5.0F;
    });
    const auto at = [&](const check::Function<Gather>& kernel, double pixels, unsigned count) {
        const Samples samples{.radius = static_cast<float>(pixels * pixel.x),
                              .bias = 0.0F,
                              .angle = 0.3F,
                              .first = 0,
                              .count = count};
        return glm::dvec2(kernel.with_images(
            view, {glm::vec3(0, 0, -5), glm::vec3(0, 0, 1), square, samples, Method{.intensity = 0.02F}}));
    };
    EXPECT_EQ(at(distinct, 0.4, 12).y, 1.0);
    EXPECT_EQ(at(every, 0.4, 12).y, 12.0);
    EXPECT_EQ(at(distinct, 1.4, 32).y, 9.0);  // 3 x 3 pixels
    // One of 9 pixels blocks, however many of the taps fall into it.
    const double one = at(distinct, 1.4, 32).x;
    EXPECT_GT(one, 0.0);
    EXPECT_EQ(at(distinct, 1.4, 24).x, one);
    EXPECT_GT(at(every, 1.4, 32).x, 1.5 * one);
}

// As in gloam/gather/pixels.glsl.
struct Distinct {
    glm::ivec2 center;
    glm::uvec2 seen;
};

// Of the 8 x 8 pixels around the shaded one each is new once, whatever others were seen before; the others
// always.
TEST_F(Relatives, EachOfThePixelsAroundIsNewOnce) {
    const check::Function<bool(Distinct&, glm::ivec2)> add(gathers.lab(), "gloam/gather/pixels.glsl",
                                                           "gloam_distinct_add");
    const glm::ivec2 center(20, 30);
    std::vector<glm::ivec2> around;
    for (int y = -6; y < 6; ++y)
        for (int x = -6; x < 6; ++x) around.emplace_back(x, y);
    for (const glm::ivec2 first : around) {
        const auto [fresh, known] = add(Distinct{center, glm::uvec2(0)}, center + first);
        EXPECT_TRUE(fresh);
        std::vector<std::tuple<Distinct, glm::ivec2>> inputs;
        for (const glm::ivec2 second : around) inputs.emplace_back(known, center + second);
        const auto results = add(inputs);
        const bool remembered = glm::clamp(first, -4, 3) == first;
        for (std::size_t i = 0; i < around.size(); ++i)
            EXPECT_EQ(std::get<0>(results[i]), !(remembered && around[i] == first))
                << first.x << ' ' << first.y << ", then " << around[i].x << ' ' << around[i].y;
    }
}

// Whatever stands in front of the ball of volumetric obscurance, on one side or all around, is another
// object: the floor below reads as if it went on under it (CS-3.5: no halo).
TEST_F(Relatives, WhatStandsInFrontOfTheBallHasNoHalo) {
    const auto floor = [](double, double) { return dvec3(0, 0, 1); };
    const Surface beside{[](double x, double) { return x > 0.2 ? 3.0 : 0.0; }, floor};
    const Surface around{[](double x, double y) { return x * x + y * y > 0.04 ? 3.0 : 0.0; }, floor};
    EXPECT_NEAR(mean("volumetric", beside, 1.0F, Method{}, 4), 0.5, 1e-6);
    EXPECT_NEAR(mean("volumetric", around, 1.0F, Method{}, 4), 0.5, 1e-6);
}

}  // namespace gloam::method_relatives_test

// SPDX-License-Identifier: MIT
// What methods make of the images that are prepared for them, in closed form, and the pixels that a sample of
// theirs has seen already.
#include "gathers.hpp"

namespace gloam::prepared_methods_test {

using glm::ivec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;

// A bare plane through (0, 0, -5).
struct Bare {
    Camera camera;
    vec3 normal{0, 0, 1};

    [[nodiscard]] vec3 point(ivec2 pixel) const { return test::plane_point(camera, normal, pixel); }
};

class PreparedMethods : public testing::Test {
  protected:
    test::Gathers gathers;
    check::Function<Gather> separable = gathers["separable"];
    check::Function<Gather> dual = gathers["dual_resolution"];

    // The occlusion of a pixel of the plane. prepared: of `size` pixels. further: from the plane at a pixel.
    template <class Prepared>
    static double occlusion(
        const check::Function<Gather>& gather, const Bare& bare, ivec2 pixel, const Samples& samples,
        const Method& settings, ivec2 size, const Prepared& prepared,
        const test::Depths& further = [](ivec2) { return 0.0F; }) {
        check::ImageSet images =
            test::view_of(bare.camera.size, [&](ivec2 p) { return -bare.point(p).z + further(p); });
        images.emplace("gloam_fetch_prepared", check::make_image<vec4>(size, prepared));
        const vec2 sum =
            gather.with_images(images, {bare.point(pixel), bare.normal, bare.camera, samples, settings});
        EXPECT_EQ(sum.y, static_cast<float>(samples.count));
        return double{sum.x} / double{sum.y};
    }
};

// An orthographic view of a floor whose pixels have that size.
Bare floor_of(ivec2 size, vec2 pixel) {
    return {{2.0F / (vec2(size) * pixel) * vec2(1, -1), size, true}, vec3(0, 0, 1)};
}

constexpr double pi = std::numbers::pi;
constexpr float sigma = 0.4F;

// The result of separable on a floor, twice: what it carries from the pixels on a line; the other slice is
// open.
Samples line_of(float angle) {
    return {.radius = 0.5F, .bias = 1e-3F, .angle = angle, .first = 0, .count = 64};
}

TEST_F(PreparedMethods, ALineCarriesFromBothOfItsSidesAlike) {
    const ivec2 middle(30, 48);
    const vec2 pixel(1.0F / 16.0F, 1.0F / 24.0F);
    const Bare floor = floor_of({61, 97}, pixel);
    for (const float angle : {0.0F, 0.6F, 1.5F, 2.9F, 4.4F}) {
        const auto carried = [&](const auto& prepared, const test::Depths& further) {
            return 2.0 * occlusion(separable, floor, middle, line_of(angle), Method{.epsilon = sigma},
                                   floor.camera.size, prepared, further);
        };
        const auto level = [](ivec2) { return 0.0F; };
        const auto ramp = [&](ivec2 p) {
            return vec4(0.5F + glm::dot(vec2(p - middle), vec2(0.004F, -0.006F)));
        };
        EXPECT_NEAR(carried(ramp, level), 0.5, 1e-5) << angle;
        // A pixel beside the middle that lies deeper is of another surface.
        const auto beside = [&](ivec2 p) { return p.x > 30 || (p.x == 30 && p.y > 48); };
        const auto apart = [&](ivec2 p) { return beside(p) ? vec4(1) : vec4(0.25F); };
        EXPECT_GT(carried(apart, level), 0.4) << angle;
        EXPECT_NEAR(carried(apart, [&](ivec2 p) { return beside(p) ? 0.5F : 0.0F; }), 0.25, 1e-6) << angle;
        const float just_within = 0.09F * sigma;
        EXPECT_GT(carried(apart, [&](ivec2 p) { return beside(p) ? just_within : 0.0F; }), 0.4) << angle;
    }
}

// The mean of the squared distances, by the Gaussian of the 16 steps to both sides up to two standard
// deviations.
TEST_F(PreparedMethods, ALineCarriesByItsGaussian) {
    const ivec2 middle(63, 90);
    const vec2 pixel(1.0F / 64.0F, 1.0F / 96.0F);
    const Bare floor = floor_of({127, 181}, pixel);
    double whole = 1.0;
    double squares = 0.0;
    for (int i = 1; i <= 16; ++i) {
        const double distance = 2.0 * double{sigma} * i / 16.0;
        const double weight = 2.0 * std::exp(-0.5 * std::pow(distance / double{sigma}, 2.0));
        whole += weight;
        squares += weight * distance * distance;
    }
    const auto squared = [&](ivec2 p) {
        const vec2 offset = vec2(p - middle) * pixel;
        return vec4(glm::dot(offset, offset));
    };
    for (const float angle : {0.0F, 0.7F, 2.0F, 5.0F}) {
        EXPECT_NEAR(2.0 * occlusion(separable, floor, middle, line_of(angle), Method{.epsilon = sigma},
                                    floor.camera.size, squared),
                    squares / whole, 0.01 * squares / whole)
            << angle;
    }
}

// dual_resolution on a plane in perspective and orthographic: between small pixels of the plane their results
// are interpolated.
class SmallPixels : public PreparedMethods, public testing::WithParamInterface<bool> {
  protected:
    static float value(vec2 small) { return 0.4F + 0.006F * small.x + 0.008F * small.y; }
    static float level(ivec2) { return 0.0F; }

    [[nodiscard]] vec4 ramp(ivec2 p) const { return {value(vec2(p)), bare.normal}; }
    // Those of another surface are turned away.
    template <class Which>
    [[nodiscard]] double without(const Which& which) const {
        return result(
            pixel, [&](ivec2 p) { return vec4(value(vec2(p)), which(p) ? -bare.normal : bare.normal); },
            level);
    }
    template <class Prepared>
    [[nodiscard]] double result(ivec2 at, const Prepared& prepared, const test::Depths& further) const {
        return occlusion(dual, bare, at, samples, settings, half, prepared, further);
    }

    const Samples samples{.radius = 0.5F, .bias = 1e-3F, .angle = 0.0F, .first = 0, .count = 32};
    const Method settings{.steps = 4, .disagreement = 0.1F};
    const Bare bare{{GetParam() ? vec2(0.5F, -0.7F) : vec2(1.5F, -2.5F), ivec2(22, 35), GetParam()},
                    glm::normalize(vec3(0.3F, -0.2F, 1.0F))};
    const ivec2 half{11, 18};
    const ivec2 pixel{7, 15};
    const ivec2 other{4, 7};  // one of the four around it
    const double three = double{value({3, 7}) + value({3, 8}) + value({4, 8})} / 3.0;
    const std::function<vec4(ivec2)> ramped = [this](ivec2 p) { return ramp(p); };
};

TEST_P(SmallPixels, OfTheSurfaceAreInterpolated) {
    check::ImageSet images = test::view_of(bare.camera.size, [&](ivec2 p) { return -bare.point(p).z; });
    images.emplace("gloam_fetch_prepared", check::make_image<vec4>(half, ramped));
    Samples uneven = samples;
    uneven.count = 36;
    EXPECT_EQ(dual.with_images(images, {bare.point(pixel), bare.normal, bare.camera, uneven, settings}).y,
              32.0F)
        << "both halves of whole slices";
    for (const ivec2 at : {pixel, ivec2(8, 15), ivec2(7, 16), ivec2(8, 16), ivec2(21, 33)}) {
        const vec2 small = glm::min(0.5F * vec2(at), vec2(half - 1));
        EXPECT_NEAR(result(at, ramped, level), double{value(small)}, 1e-4) << at.x << ' ' << at.y;
    }
}

// One of the four around a pixel, then the two to the right, then all do not lie on its surface.
TEST_P(SmallPixels, OfAnotherSurfaceAreLeftOut) {
    EXPECT_NEAR(without([&](ivec2 p) { return p == other; }), three, 1e-4);
    EXPECT_NEAR(without([](ivec2 p) { return p.x == 4; }), double{value({3, 7.5F})}, 1e-4);
    EXPECT_EQ(without([](ivec2) { return true; }), 0.0);  // hbao of the plane
    for (const float depth : {0.5F, infinity})
        EXPECT_NEAR(result(pixel, ramped, [&](ivec2 p) { return p == 2 * other ? depth : 0.0F; }), three,
                    2e-4);
}

// One at a height of a fiftieth of the radius counts a quarter, one whose normal is turned by w the eighth
// power of (1 + cos w) / 2. Of neighbours that disagree nothing is interpolated.
TEST_P(SmallPixels, CountByTheirHeightAndNormal) {
    const vec3 aside = glm::normalize(glm::cross(bare.normal, vec3(0, 1, 0)));
    for (const float turn : {0.0F, 0.6F}) {
        const vec3 other_normal = std::cos(turn) * bare.normal + std::sin(turn) * aside;
        const double share = turn == 0.0F ? 0.25 : std::pow(0.5 * (1.0 + std::cos(double{turn})), 8.0);
        const auto one_apart = [&](ivec2 p) {
            return vec4(p == other ? 0.5F : 0.45F, p == other ? other_normal : bare.normal);
        };
        const vec3 source = bare.point(2 * other);
        const float along = GetParam() ? bare.normal.z : glm::dot(bare.normal, source / source.z);
        const float rise = turn == 0.0F ? 0.02F * samples.radius / along : 0.0F;
        EXPECT_NEAR(result(pixel, one_apart, [&](ivec2 p) { return p == 2 * other ? -rise : 0.0F; }),
                    (3.0 * 0.45 + share * 0.5) / (3.0 + share), 1e-4)
            << turn;
    }
    const auto odd_one = [&](ivec2 p) { return p == ivec2(2, 6) ? vec4(0.6F, bare.normal) : ramp(p); };
    EXPECT_EQ(result(pixel, odd_one, level), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Both, SmallPixels, testing::Bool());

// Which level of an image of several resolutions a texel belongs to; 0 for values that are no means.
// size: of level 0, a multiple of the largest block.
int level_of_mean(ivec2 texel, ivec2 size) {
    ivec2 first(0);
    for (int level = 1; level <= 6; ++level) {
        const ivec2 end = first + size / (1 << level);
        if (glm::all(glm::greaterThanEqual(texel, first)) && glm::all(glm::lessThan(texel, end)))
            return level;
        first = end;
    }
    return 0;
}

// A sample reads the block that is as wide as a square of its part of the disc, or up to half as wide: of all
// levels that one alone. Here a level holds the floor and the others nothing.
TEST_F(PreparedMethods, ASampleIsABlockOfItsPartOfTheDisc) {
    const check::Function<Gather> area = gathers["volumetric_area"];
    const ivec2 size(256, 128);
    const vec2 pixel(1.0F / 64.0F, 1.0F / 32.0F);
    const Bare floor = floor_of(size, pixel);
    for (const auto& [radius, count] : std::vector<std::pair<float, unsigned>>{
             {1.0F, 2}, {1.0F, 8}, {1.0F, 32}, {1.0F, 128}, {1.0F, 512}, {1.0F, 2048}, {4.0F, 2}}) {
        const vec2 axes = radius / pixel;
        const double side = std::sqrt(pi * double{axes.x} * double{axes.y} / count);
        const int expected = std::clamp(static_cast<int>(std::floor(std::log2(side))), 0, 6);
        const Samples samples{.radius = radius, .bias = 0.0F, .angle = 0.4F, .first = 0, .count = count};
        for (int level = 1; level <= 6; ++level) {
            const auto filled = [&](ivec2 texel) {
                return level_of_mean(texel, size) == level
                           ? vec4(0, 0, -5, static_cast<float>(1 << 2 * level))
                           : vec4(0);
            };
            EXPECT_NEAR(occlusion(area, floor, size / 2, samples, Method{}, size, filled),
                        expected == 0 || expected == level ? 0.5 : 0.0, 1e-6)
                << side << ", level " << level;
        }
    }
}

// How far the surface of a block lies apart along the view vector is what counts, whatever the normal of the
// point. Half a radius in front of the point stands a rough wall.
TEST_F(PreparedMethods, TheRoughnessOfABlockCountsAlongTheViewVector) {
    constexpr int level = 3;  // of 32 samples here
    const ivec2 size(256, 128);
    const ivec2 blocks = size >> level;
    const ivec2 first = size / 2 + size / 4;  // of the levels before
    const check::Function<Gather> area = gathers["volumetric_area"];
    const Bare wall = floor_of(size, vec2(1.0F / 64.0F, 1.0F / 32.0F));
    const auto result = [&](vec3 normal, float variance) {
        const auto moments = [&](ivec2 texel) {
            const ivec2 kind = (texel - first) / blocks;  // means, variances, covariances
            if (kind != ivec2(0)) return kind == ivec2(1, 0) ? vec4(0, 0, variance, 0) : vec4(0);
            const ivec2 begin = (texel - first) << level;
            const vec3 middle = 0.5F * (wall.point(begin) + wall.point(begin + (1 << level) - 1));
            return vec4(middle + vec3(0, 0, 0.5F), static_cast<float>(1 << 2 * level));
        };
        const Samples samples{.radius = 1.0F, .bias = 0.0F, .angle = 0.4F, .first = 0, .count = 32};
        const Bare point{wall.camera, glm::normalize(normal)};
        return occlusion(area, point, size / 2, samples, Method{}, size, moments);
    };
    const double rough = result({0, 0, 1}, 0.3F);
    EXPECT_GT(result({0, 0, 1}, 0.0F), rough + 0.05);
    for (const vec3 normal : {vec3(0.75F, 0, 1), vec3(-0.4F, 0.6F, 1)})
        EXPECT_NEAR(result(normal, 0.3F), rough, 0.01);
}

// What MSSAO's finest resolution makes of the coarser ones, in closed form.

constexpr int side = 64;  // of the image, pixels
constexpr int half = 32;  // of level 1
constexpr float floor_depth = 5.0F;
constexpr float near_depth = 0.5F;

// (largest occlusion, its mean, levels in it) at a place of level 1, linear in it.
vec3 found_at(double x, double y) {
    return {0.2 + 0.01 * x, 0.1 + 0.005 * y, 1.5 + 0.01 * x};
}

// Level 1 of a bare floor: positions, normals and results in the quarters that mssao.glsl names.
vec4 level_one(ivec2 at) {
    if (at.x < half && at.y < half) return {0, 0, -floor_depth, 0};
    if (at.y < half) return {0, 0, 1, 0};
    return at.x < half ? vec4(found_at(at.x, at.y - half), 0) : vec4(0);
}

class MssaoLevels : public testing::Test {
  protected:
    test::Gathers gathers;
    check::Function<Gather> gather = gathers["mssao"];

    // At a pixel of a bare floor, over three levels.
    [[nodiscard]] double occlusion_at(ivec2 pixel, float depth, vec4 (*prepared)(ivec2)) const {
        check::ImageSet images = test::view_of(ivec2(side), [depth](ivec2) { return depth; });
        images.insert_or_assign("gloam_fetch_prepared", check::make_image<vec4>(ivec2(side), prepared));
        const Camera camera{glm::vec2(0.5F, -0.5F), ivec2(side), true};
        const Samples samples{.radius = 1.0F, .bias = 0.01F, .angle = 0.0F, .first = 0, .count = 8};
        const glm::dvec2 ndc = 2.0 * (glm::dvec2(pixel) + 0.5) / double{side} - 1.0;
        const vec3 position(2.0 * ndc.x, -2.0 * ndc.y, -depth);
        const glm::vec2 sum =
            gather.with_images(images, {position, vec3(0, 0, 1), camera, samples, Method{.steps = 3}});
        EXPECT_EQ(sum.y, 8.0F);
        return double{sum.x} / double{sum.y};
    }
};

// The floor's own level is open.
double combined(const glm::dvec3& known) {
    const double mean = known.z * known.y / (1.0 + known.z);
    return 1.0 - (1.0 - known.x) * (1.0 - mean);
}

TEST_F(MssaoLevels, CoarserOnesAreInterpolatedAndTheirMeanCountsByTheirNumber) {
    for (const ivec2 pixel : {ivec2(20, 12), ivec2(21, 12), ivec2(33, 40), ivec2(8, 51)}) {
        const glm::dvec2 at = (glm::dvec2(pixel) + 0.5) / 2.0 - 0.5;
        EXPECT_NEAR(occlusion_at(pixel, floor_depth, level_one), combined(found_at(at.x, at.y)), 2e-5)
            << pixel.x << ", " << pixel.y;
    }
}

// One of the four texels lies a twentieth of the radius above the surface.
vec4 with_one_raised(ivec2 at) {
    const ivec2 raised(10, 6);
    if (at == raised) return {0, 0, 0.05F - floor_depth, 0};
    if (at.y < half) return level_one(at);
    return at == raised + ivec2(0, half) ? vec4(0.5F, 0.4F, 1.5F, 0) : vec4(0.3F, 0.2F, 1.5F, 0);
}

TEST_F(MssaoLevels, ATexelATwentiethOfTheRadiusAwayCountsAQuarter) {
    const double raised = 0.25 * 0.75 * 0.75;
    const double others = 1.0 - 0.75 * 0.75;
    const auto mean = [=](double one, double other) {
        return (raised * one + others * other) / (raised + others);
    };
    EXPECT_NEAR(occlusion_at(ivec2(20, 12), floor_depth, with_one_raised),
                combined({mean(0.5, 0.3), mean(0.4, 0.2), 1.5}), 2e-5);
}

// The finest level counts in full, however small its kernel is, and a large one reaches six pixels.
TEST_F(MssaoLevels, TheFinestHasItsWeightAndItsReach) {
    const auto at = [&](float p11, float radius, const Samples& of, const test::Depths& depth) {
        check::ImageSet images = test::view_of(ivec2(side), depth);
        images.insert_or_assign("gloam_fetch_prepared", check::make_image<vec4>(ivec2(side), level_one));
        const Camera camera{glm::vec2(0.5F, p11), ivec2(side), true};  // a sixteenth wide
        const vec3 middle(1.0F / 32.0F, 1.0F / (64.0F * p11), -floor_depth);
        Samples samples = of;
        samples.radius = radius;
        return double{
            gather.with_images(images, {middle, vec3(0, 0, 1), camera, samples, Method{.steps = 1}}).x};
    };
    const check::Function<vec3(unsigned)> disc(gathers.lab(), "gloam/sampling/disc.glsl", "gloam_disc_point");
    const check::Function<float(vec3, vec3, float)> contribution(
        gathers.lab(), "gloam/occlusion/disc_taps.glsl", "gloam_contribution_mssao");
    unsigned beside = 0;  // a sample of a pixel beside the middle
    while (std::abs(glm::length(glm::round(1.5F * vec2(disc(beside + 1)))) - 1.0F) > 0.1F) ++beside;
    constexpr float radius = 1.5F / 16.0F;
    const double own = double{contribution(vec3(1.0F / 16.0F, 0, 0.03F), vec3(0, 0, 1), radius)};
    EXPECT_GT(own, 0.05);
    const auto around = [](ivec2 p) { return p == ivec2(half) ? floor_depth : floor_depth - 0.03F; };
    EXPECT_NEAR(at(-0.5F, radius, {.first = beside, .count = 1}, around), 1.0 - (1.0 - own) * (1.0 - own),
                1e-5);
    const auto beyond = [&](int rows) {
        return at(-2.0F, 3.0F / 16.0F, {.first = 0, .count = 64},
                  [=](ivec2 p) { return std::abs(p.y - half) > rows ? floor_depth - 0.05F : floor_depth; });
    };
    EXPECT_EQ(beyond(6), 0.0);
    EXPECT_GT(beyond(4), 0.01);
}

// Beyond a level's last texel the image of all levels goes on with other values, here those of a surface.
vec4 with_a_surface_beside(ivec2 at) {
    return at.x == half && at.y < half ? vec4(0, 0, -floor_depth, 0) : level_one(at);
}

TEST_F(MssaoLevels, NothingIsReadBeyondTheLastTexel) {
    for (const int y : {12, 63}) {
        const double row = std::min((y + 0.5) / 2.0 - 0.5, half - 1.0);
        EXPECT_NEAR(occlusion_at(ivec2(side - 1, y), floor_depth, with_a_surface_beside),
                    combined(found_at(half - 1, row)), 2e-5);
    }
}

// Every other texel of level 1 is background, whatever else stands there.
vec4 with_holes(ivec2 at) {
    const bool hole = (at.x + at.y) % 2 == 1;
    if (at.x < half && at.y < half) return hole ? vec4(0) : vec4(0, 0, -near_depth, 0);
    if (at.y < half) return {0, 0, 1, 0};
    return hole ? vec4(1, 1, 2, 0) : vec4(0.3F, 0.2F, 1.5F, 0);
}

TEST_F(MssaoLevels, TexelsOfTheBackgroundTellNothing) {
    EXPECT_NEAR(occlusion_at(ivec2(20, 12), near_depth, with_holes), combined({0.3, 0.2, 1.5}), 2e-5);
}

}  // namespace gloam::prepared_methods_test

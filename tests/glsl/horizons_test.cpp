// SPDX-License-Identifier: MIT
// Methods that search horizons: HBAO, GTAO and the visibility bitmask.
#include "support/lab.hpp"

namespace gloam::horizons_test {

using check::Function;
using glm::vec2;
using glm::vec3;

constexpr double pi = std::numbers::pi;
constexpr float degree = static_cast<float>(pi / 180.0);

class Horizons : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);

    template <class Type>
    Function<Type> fixture(const std::string& function) const {
        return {lab, "slices.glsl", function};
    }
    template <class Type>
    Function<Type> hbao(const std::string& function) const {
        return {lab, "gloam/occlusion/hbao.glsl", "gloam_" + function};
    }
    template <class Type>
    Function<Type> gtao(const std::string& function) const {
        return {lab, "gloam/occlusion/gtao.glsl", "gloam_gtao_" + function};
    }
    template <class Type>
    Function<Type> bitmask(const std::string& function) const {
        return {lab, "gloam/occlusion/visibility_bitmask.glsl", "gloam_" + function};
    }
};

vec2 turned_by(double angle) {
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

// A slice seen head-on whose normal is turned by an angle.
struct Slice {
    vec3 view{0, 0, 1};
    vec3 tangent{1, 0, 0};
    vec2 normal;
    float angle = 0.0F;
    float weight = 1.0F;
};
Slice slice_of(float angle, float weight = 1.0F) {
    return {.normal = turned_by(double{angle}), .angle = angle, .weight = weight};
}

using GtaoGroove = float(float, float, float, float, float, unsigned);
using BitmaskGroove = float(float, float, float, float, float, unsigned);

TEST_F(Horizons, HbaoLeavesABarePlaneOpenAtAnyTilt) {
    const auto plane = fixture<float(vec3, vec2, float)>("hbao_plane");
    for (const float tilt : {0.0F, 20.0F, 45.0F, 70.0F, 85.0F}) {
        const vec3 normal(std::sin(tilt * degree), 0.0F, std::cos(tilt * degree));
        for (const float azimuth : {0.0F, 40.0F, 90.0F, 170.0F, 250.0F}) {
            const vec2 direction(std::cos(azimuth * degree), std::sin(azimuth * degree));
            EXPECT_LT(plane(normal, direction, 0.0F), 1e-6F) << tilt << " " << azimuth;  // rounding alone
            EXPECT_EQ(plane(normal, direction, 1e-3F), 0.0F) << tilt << " " << azimuth;
        }
    }
}

// T12: HBAO counts all directions alike, so it differs from the cosine-weighted 0.146447.
TEST_F(Horizons, HbaoOfAGroove) {
    const auto groove = fixture<float(float, float, float, unsigned)>("hbao_groove");
    for (const float rise : {20.0F, 45.0F, 70.0F})
        EXPECT_NEAR(groove(rise * degree, 0.0F, 1e6F, 512U), rise / 180, 1e-5) << rise;
    EXPECT_LT(groove(45 * degree, 0.3F, 1e6F, 512U), 0.24);  // the bias
    EXPECT_LT(groove(45 * degree, 0.0F, 1.0F, 512U), 0.24);  // the falloff
}

// The study adds tangents: tan h_0 = tan t + tan bias, however steep the plane is.
TEST_F(Horizons, TheStudysMarchBeginsAtASumOfTangents) {
    const auto start = hbao<vec2(float, float)>("hbao_start_slope");
    for (const double degrees : {-60.0, 0.0, 30.0, 60.0, 75.0, 85.0}) {
        for (const double bias : {0.0, 0.1, 0.3, 0.5}) {
            const double slope = std::tan(degrees * std::numbers::pi / 180.0);
            const vec2 from = start(static_cast<float>(slope), static_cast<float>(bias));
            EXPECT_NEAR(from.x, std::sin(std::atan(slope + std::tan(bias))), 1e-6) << degrees << ' ' << bias;
            EXPECT_LT(from.x, 1.0F);
            EXPECT_EQ(from.y, 0.0F);
        }
    }
}

// The lesson: a slice that is not divided by what its own half plane holds makes a tilted plane brighter or
// darker than open.
TEST_F(Horizons, GtaoLeavesABarePlaneOpenAtAnyTilt) {
    const auto groove = fixture<GtaoGroove>("gtao_groove");
    const auto unnormalised = fixture<float(float, float, unsigned)>("gtao_plane_not_normalised");
    float lowest = 10.0F;
    float highest = 0.0F;
    for (const float tilt : {0.0F, 15.0F, 60.0F, 80.0F, 89.0F}) {
        for (const float azimuth : {0.0F, 35.0F, 90.0F, 200.0F}) {
            for (const unsigned slices : {1U, 2U, 3U}) {
                EXPECT_EQ(groove(tilt * degree, azimuth * degree, 0.3F, 0.0F, 2.0F, slices), 0.0F);
                EXPECT_LT(groove(tilt * degree, azimuth * degree, 0.3F, 0.0F, 1e-6F, slices), 2e-6F)
                    << tilt << " " << azimuth << " " << slices;
            }
            if (tilt != 60.0F) continue;
            lowest = std::min(lowest, unnormalised(tilt * degree, azimuth * degree, 1U));
            highest = std::max(highest, unnormalised(tilt * degree, azimuth * degree, 1U));
        }
    }
    EXPECT_NEAR(lowest, 0.5, 0.01);
    EXPECT_NEAR(highest, 1.407, 0.01);
    EXPECT_NEAR(unnormalised(60 * degree, 0.4F, 64U), 1.0, 1e-3);  // right in the mean only
}

// T12: cosine-weighted (1 - cos beta) / 2, whichever way the groove is turned before the eye.
TEST_F(Horizons, GtaoOfAGrooveFromAnySide) {
    const auto groove = fixture<GtaoGroove>("gtao_groove");
    for (const float rise : {30.0F, 45.0F}) {
        for (const float tilt : {0.0F, 25.0F, 40.0F}) {
            for (const float azimuth : {0.0F, 60.0F, 130.0F}) {
                for (const float turn : {0.0F, 2.0F, 4.0F}) {
                    EXPECT_NEAR(groove(tilt * degree, azimuth * degree, turn, rise * degree, 1e-6F, 256U),
                                0.5 * (1 - std::cos(rise * degree)), 2e-4)
                        << rise << " " << tilt << " " << turn;
                }
            }
        }
    }
    const float full = groove(0.3F, 0.0F, 0.0F, 0.8F, 1e-6F, 64U);
    const float faded = groove(0.3F, 0.0F, 0.0F, 0.8F, 0.5F, 64U);
    EXPECT_GT(faded, 0.0F);  // falloff draws the horizon towards the tangent plane
    EXPECT_LT(faded, 0.9F * full);
}

// The printed inner integral and what the library takes away are two halves of one.
TEST_F(Horizons, GtaoVisibleAndOccludedAreTheWhole) {
    const auto inner = fixture<float(float, float)>("gtao_inner");
    const auto arc = gtao<float(float, vec2, vec2)>("arc");
    for (const float n : {-1.2F, -0.4F, 0.0F, 0.9F, 1.5F}) {
        for (const float part : {0.0F, 0.3F, 0.8F, 1.0F}) {
            const auto low = static_cast<float>(n - pi / 2);
            const auto high = static_cast<float>(n + pi / 2);
            const float visible = inner(part * low, n) + inner(part * high, n);
            const float occluded =
                arc(part * low - low, turned_by(double{-part * low}), turned_by(double{-n})) +
                arc(high - part * high, turned_by(double{part * high}), turned_by(double{n}));
            EXPECT_NEAR(visible + occluded, std::cos(n) + n * std::sin(n), 2e-6) << n << " " << part;
        }
    }
}

TEST_F(Horizons, BitmaskOfThickThingsIsThatOfHorizons) {
    const auto groove = fixture<BitmaskGroove>("bitmask_groove");
    for (const float tilt : {0.0F, 25.0F, 40.0F}) {
        for (const float turn : {0.3F, 2.0F}) {
            const float rise = 45 * degree;
            EXPECT_NEAR(groove(tilt * degree, 0.4F, turn, rise, 1e6F, 256U), 0.146447, 4e-3) << tilt;
            EXPECT_EQ(groove(tilt * degree, 0.4F, turn, -0.02F, 1e6F, 8U), 0.0F) << tilt;
        }
    }
    // A single sample that is thin lets light through behind it.
    const float thin = groove(0.0F, 0.4F, 0.3F, 45 * degree, 0.2F, 256U);
    const float thicker = groove(0.0F, 0.4F, 0.3F, 45 * degree, 0.4F, 256U);
    EXPECT_GT(thin, 0.01F);
    EXPECT_GT(thicker, 1.2F * thin);
    EXPECT_LT(thicker, 0.14F);
}

// Over all places the rule of the sectors' centres covers what the sample is wide.
TEST_F(Horizons, BitmaskSectors) {
    const auto sectors = bitmask<unsigned(vec2)>("bitmask_sectors");
    const double width = 0.02;
    std::vector<std::tuple<vec2>> inputs;
    for (int i = 0; i < 4096; ++i) {
        const auto lower = static_cast<float>(0.1 + 0.5 * i / 4096);
        inputs.emplace_back(vec2(lower, lower + static_cast<float>(width)));
    }
    double centres = 0.0;
    for (const unsigned bits : sectors(inputs)) centres += std::popcount(bits) / 32.0 / 4096;
    EXPECT_NEAR(centres, width, 1e-4);
}

TEST_F(Horizons, SliceFractions) {
    const auto f = bitmask<float(vec2, Slice)>("slice_fraction_cosine");
    for (const float n : {-1.3F, 0.0F, 0.7F}) {
        const Slice slice = slice_of(n);
        EXPECT_NEAR(f(turned_by(n - pi / 2), slice), 0.0, 1e-6);
        EXPECT_NEAR(f(turned_by(n + pi / 2), slice), 1.0, 1e-6);
        float last = 0.0F;
        for (int i = 0; i <= 32; ++i) {
            const float now = f(turned_by(n - pi / 2 + pi * i / 32), slice);
            EXPECT_GE(now, last - 1e-6F) << n;
            last = now;
        }
    }
    EXPECT_NEAR(f(vec2(1, 0), slice_of(0.0F)), 0.5, 1e-6);
    const float of_nan = f(vec2(NAN), slice_of(0.0F));
    EXPECT_TRUE(of_nan >= 0.0F && of_nan <= 1.0F);
    EXPECT_NEAR(f(turned_by(pi / 4), slice_of(0.0F)), 0.75, 1e-6);
}

}  // namespace gloam::horizons_test

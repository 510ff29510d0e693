// SPDX-License-Identifier: MIT
// The comparative study's configurations (Aalund and Baerentzen 2013) as it prints them.
#include <gtest/gtest.h>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

struct Printed {
    const char* preset;
    const char* method;
    std::uint32_t samples;
};

// Samples of its tables and its published shader. A pair has two samples; 8 directions of 6 steps are 48.
constexpr Printed quality[] = {
    {"study-crytek-quality", "crytek", 200},  {"study-filion-quality", "filion", 80},
    {"study-hbao-quality", "hbao_study", 48}, {"study-volumetric-quality", "volumetric", 64},
    {"study-alchemy-quality", "alchemy", 64}, {"study-angle-quality", "angle", 64}};
constexpr Printed performance[] = {{"study-crytek-performance", "crytek", 24},
                                   {"study-filion-performance", "filion", 15},
                                   {"study-hbao-performance", "hbao_study", 48},
                                   {"study-angle-performance", "angle", 12}};

void expect_printed(const Printed& printed, Filter filter) {
    const Settings settings = preset_named(printed.preset).settings;
    EXPECT_EQ(settings.method, printed.method) << printed.preset;
    EXPECT_EQ(settings.samples, printed.samples) << printed.preset;
    EXPECT_EQ(settings.samples_converged, printed.samples) << printed.preset;
    EXPECT_EQ(settings.filter, filter) << printed.preset;
    EXPECT_FALSE(settings.history) << printed.preset;
}

TEST(StudyPresets, QualityHasNoBlurAndNoHistory) {
    for (const Printed& printed : quality) expect_printed(printed, Filter::none);
}

TEST(StudyPresets, PerformanceHasItsBlurAndNoHistory) {
    for (const Printed& printed : performance) expect_printed(printed, Filter::geometry);
    EXPECT_EQ(preset_named("study-volumetric-performance").settings.filter_half_width, 1);  // pixels
}

// 6 steps to each side of 4 slices, a bias of 0.3 radians.
TEST(StudyPresets, ItsHorizons) {
    const Settings settings = preset_named("study-hbao-quality").settings;
    EXPECT_EQ(settings.own.steps, 6U);
    EXPECT_EQ(settings.own.angle_bias, 0.3F);
    EXPECT_EQ(settings.own.intensity, 1.0F);
}

}  // namespace
}  // namespace gloam::effect

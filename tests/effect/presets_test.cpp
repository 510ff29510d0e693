// SPDX-License-Identifier: MIT
// gloam's own presets are the front of error and time; the comparative study's (Aalund and Baerentzen 2013)
// are as it prints them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

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

std::vector<Preset> front() {
    std::vector<Preset> own = presets();
    std::erase_if(own, &Preset::published);
    return own;
}

TEST(Presets, OwnOnesComeFirstFromFastToExact) {
    const std::vector<Preset> own = front();
    ASSERT_EQ(own.size(), 4U);
    EXPECT_TRUE(std::ranges::is_sorted(own, std::less{}, &Preset::copies));
    EXPECT_TRUE(std::ranges::is_sorted(own, std::greater{}, &Preset::error));
    EXPECT_FALSE(presets().at(3).published);
    EXPECT_EQ(own.at(1).name, "balanced");
}

// Whatever is published, one of our own has less error in less time.
TEST(Presets, NoneBeatsTheFront) {
    const std::vector<Preset> own = front();
    for (const Preset& preset : presets()) {
        if (!preset.published) continue;
        EXPECT_TRUE(std::ranges::any_of(own, [&](const Preset& one) {
            return one.error < preset.error && one.copies < preset.copies;
        })) << preset.name;
    }
}

TEST(Presets, AnOldNameGivesTheNewOne) {
    std::set<std::string> names;
    for (const Preset& preset : presets()) EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    const std::map<std::string, std::string> renamed{
        {"paper", "tssao-paper"},     {"moving", "balanced"},         {"sweep-half", "fast"},
        {"sweep-quality", "quality"}, {"gtao-plain", "xegtao-ultra"}, {"poisson-quality", "sourimant-most"}};
    for (const auto& [old, now] : renamed) {
        EXPECT_TRUE(names.contains(now)) << now;
        EXPECT_THAT([&] { (void)preset_named(old); },
                    testing::ThrowsMessage<std::invalid_argument>("unknown preset \"" + old + "\": use \"" +
                                                                  now + "\" instead"));
    }
    EXPECT_THAT([] { (void)preset_named("magic"); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("expected fast, balanced")));
}

}  // namespace
}  // namespace gloam::effect

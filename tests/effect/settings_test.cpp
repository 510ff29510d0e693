// SPDX-License-Identifier: MIT
// gloam's own presets are the front of error and time; the comparative study's (Aalund and Baerentzen 2013)
// are as it prints them.
#include "effect/settings.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/mesh.hpp"
#include "surface_views.hpp"

namespace gloam::effect::settings_test {

struct Printed {
    const char* preset;
    const char* method;
    std::uint32_t samples;
    Filter filter = Filter::none;
};

// Samples of its tables and its published shader. A pair has two samples; 8 directions of 6 steps are 48.
constexpr Printed study[] = {{"study-crytek-quality", "crytek", 200},
                             {"study-filion-quality", "filion", 80},
                             {"study-hbao-quality", "hbao_study", 48},
                             {"study-volumetric-quality", "volumetric", 64},
                             {"study-alchemy-quality", "alchemy", 64},
                             {"study-angle-quality", "angle", 64},
                             {"study-crytek-performance", "crytek", 24, Filter::geometry},
                             {"study-filion-performance", "filion", 15, Filter::geometry},
                             {"study-hbao-performance", "hbao_study", 48, Filter::geometry},
                             {"study-angle-performance", "angle", 12, Filter::geometry}};

// Without a history; its horizons have 6 steps to each side of 4 slices, a bias of 0.3 radians.
TEST(StudyPresets, AreAsItPrintsThem) {
    for (const Printed& printed : study) {
        const Settings settings = preset_named(printed.preset).settings;
        EXPECT_EQ(settings.method, printed.method) << printed.preset;
        EXPECT_EQ(settings.samples, printed.samples) << printed.preset;
        EXPECT_EQ(settings.samples_converged, printed.samples) << printed.preset;
        EXPECT_EQ(settings.filter, printed.filter) << printed.preset;
        EXPECT_FALSE(settings.history) << printed.preset;
    }
    EXPECT_EQ(preset_named("study-volumetric-performance").settings.filter_half_width, 1);  // pixels
    const MethodValues horizons = preset_named("study-hbao-quality").settings.own;
    EXPECT_EQ(horizons.steps, 6U);
    EXPECT_EQ(horizons.angle_bias, 0.3F);
    EXPECT_EQ(horizons.intensity, 1.0F);
}

TEST(Presets, OwnOnesComeFirstFromFastToExact) {
    const std::vector<Preset> own = own_presets();
    ASSERT_EQ(own.size(), 4U);
    EXPECT_TRUE(std::ranges::is_sorted(own, std::less{}, &Preset::time));
    EXPECT_TRUE(std::ranges::is_sorted(own, std::greater{}, &Preset::error));
    EXPECT_FALSE(presets().at(3).published);
    EXPECT_EQ(own.at(1).name, "balanced");
}

// Whatever is published, one of our own has less error in less time.
TEST(Presets, NoneBeatsTheFront) {
    const std::vector<Preset> own = own_presets();
    for (const Preset& preset : presets()) {
        if (!preset.published) continue;
        EXPECT_TRUE(std::ranges::any_of(own, [&](const Preset& one) {
            return one.error < preset.error && one.time < preset.time;
        })) << preset.name;
    }
}

// Of the sources TSSAO alone keeps a history. What a source has is named by its symbol, the rest is ours.
TEST(Presets, PublishedOnesRunWhatTheirSourceRan) {
    for (const Preset& preset : presets()) {
        if (!preset.published) continue;
        EXPECT_EQ(preset.settings.history, preset.name == "tssao-paper") << preset.name;
        EXPECT_FALSE(preset.printed.empty()) << preset.name;
        for (const auto& [setting, symbol] : preset.printed) {
            EXPECT_NO_THROW((void)setting_named(setting)) << preset.name;
            EXPECT_EQ(origin_of(preset, setting), symbol) << preset.name;
        }
        EXPECT_EQ(origin_of(preset, "output"), "ours") << preset.name;
    }
    // Also what the equation of another preset has.
    const std::pair<const char*, const char*> silent[] = {{"study-alchemy-performance", "samples"},
                                                          {"study-volumetric-performance", "samples"},
                                                          {"study-angle-performance", "samples"},
                                                          {"issao-figure5", "samples"},
                                                          {"toy-story-3", "samples"},
                                                          {"issao-figure4-basic", "bias"},
                                                          {"issao-figure4-basic", "epsilon"},
                                                          {"issao-figure4-basic", "intensity"},
                                                          {"issao-figure4-attenuated", "bias"},
                                                          {"issao-figure4-attenuated", "epsilon"},
                                                          {"tssao-paper", "weight_small"}};
    for (const auto& [preset, setting] : silent)
        EXPECT_EQ(origin_of(preset_named(preset), setting), "ours") << preset << ": " << setting;
}

// The table of settings; known_pixels_test.cpp shows that every line of it changes what is shown.

TEST(SettingTable, DefaultsAreThePaperPreset) {
    const Settings paper = preset_named("tssao-paper").settings;
    for (const Setting& setting : setting_table())
        EXPECT_EQ(setting.get(paper), setting.get(Settings{})) << setting.name;
}

TEST(SettingTable, TextReadsBack) {
    Settings changed = with_radius(preset_named("tssao-paper").settings, 0.3F);
    changed.filter = Filter::geometry;
    changed.taps = HistoryTaps::bilinear;
    changed.invalidation = Invalidation::clamp;
    changed.depth_tolerance = infinity;
    Settings read;
    for (const Setting& setting : setting_table()) {
        set(read, setting.name, text_of(setting.get(changed)));
        EXPECT_EQ(setting.get(read), setting.get(changed)) << setting.name;
    }
}

TEST(SettingTable, RangesEndWhereTheySay) {
    for (const Setting& setting : setting_table()) {
        if (!std::holds_alternative<double>(setting.get(Settings{}))) continue;
        const SettingRange& range = setting.range;
        const auto fits = [&](double value) {
            try {
                check(setting, value);
                return true;
            } catch (const std::invalid_argument&) {
                return false;
            }
        };
        EXPECT_EQ(fits(range.least), !range.above_least) << setting.name;
        EXPECT_TRUE(fits(range.most)) << setting.name;
        EXPECT_FALSE(fits(range.least - 1.0)) << setting.name;
        EXPECT_EQ(fits(1.01 * range.most + 1.0), std::isinf(range.most)) << setting.name;
        EXPECT_EQ(fits(range.least + 0.5), !range.whole) << setting.name;
        EXPECT_FALSE(fits(std::nan(""))) << setting.name;
    }
}

struct Refused {
    const char* name;
    const char* value;
    const char* message;
    const char* preset = "tssao-paper";
};
constexpr Refused refused[] = {
    {"no_such", "1", "unknown setting \"no_such\": expected passes, method, radius"},
    {"radius", "0", "radius 0: expected more than"},
    {"radius", "inf", "radius inf"},
    {"samples", "0", "samples 0: expected a whole number, 1 to 2048"},
    {"samples", "2049", "samples 2049: expected a whole number, 1 to 2048"},
    {"samples", "many", "samples \"many\""},
    {"samples", "", "samples \"\""},
    {"samples", "8 ", "samples \"8 \""},
    {"taps", "four", "taps four: expected nearest, bilinear or validated"},
    {"guard_history", "1", "expected on or off"},
    {"guard", "0.6", "guard 0.6: expected 0 to 0.5"},
    {"filter", "1", "filter 1: expected none, convergence, geometry, bilateral or sao"},
    {"depth_tolerance", "0", "more than 0"},
    {"method", "magic", "method magic: expected hemisphere"},
    {"layers", "2", "layers 2: expected 1, because gtao sees one layer", "xegtao-low"},
    {"history_range", "0.5", "history_range 0.5: the passes of this preset do not read it"},
    // A setting that the frame does not read, or a value that it does not take.
    {"method", "gtao", "method gtao: expected sweep", "balanced"},
    {"bias", "0.5", "bias 0.5: the passes of this preset do not read it", "balanced"},
    {"filter", "none", "filter none: the passes", "balanced"},
    {"taps", "bilinear", "taps bilinear: the passes", "quality"},
    {"filter_half_width", "1", "filter_half_width 1: the passes", "fast"},
    {"history_range", "2", "history_range 2: expected 0 to 1", "fast"}};

TEST(SettingTable, WhatCannotBeNamesTheSetting) {
    for (const auto& [name, value, message, preset] : refused) {
        Settings settings = preset_named(preset).settings;
        EXPECT_THAT(
            [&] {
                set(settings, name, value);
                validate(settings);
            },
            ThrowsMessage<std::invalid_argument>(HasSubstr(message)))
            << preset << ' ' << name << ' ' << value;
    }
}

}  // namespace gloam::effect::settings_test

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
    EXPECT_TRUE(std::ranges::is_sorted(own, std::less{}, &Preset::time));
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
    for (const char* silent : {"study-alchemy-performance", "study-volumetric-performance",
                               "study-angle-performance", "issao-figure5", "toy-story-3"})
        EXPECT_EQ(origin_of(preset_named(silent), "samples"), "ours") << silent;
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
                    ThrowsMessage<std::invalid_argument>("unknown preset \"" + old + "\": use \"" + now +
                                                         "\" instead"));
    }
    expect_error<std::invalid_argument>([] { (void)preset_named("magic"); }, {"expected fast, balanced"});
}

// The table of settings: complete, in range, and every line of it changes what is shown.

// Stands for a member of any type.
struct Any {
    template <class Member>
    operator Member() const;  // NOLINT(google-explicit-constructor): that is its purpose
};

// Members of an aggregate: as many as it can be given.
template <class Aggregate, class... Members>
constexpr std::size_t member_count() {
    if constexpr (requires { Aggregate{Members{}..., Any{}}; }) {
        return member_count<Aggregate, Members..., Any>();
    } else {
        return sizeof...(Members);
    }
}

TEST(SettingTable, HasEveryMemberOnce) {
    // One member of Settings holds what is a method's own.
    EXPECT_EQ(setting_table().size(), member_count<Settings>() - 1 + member_count<MethodValues>());
    std::set<std::string> names;
    for (const Setting& setting : setting_table()) {
        EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
        EXPECT_FALSE(setting.meaning.empty()) << setting.name;
        EXPECT_NO_THROW(check(setting, setting.get(Settings{}))) << setting.name;
    }
}

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

TEST(SettingTable, WhatCannotBeNamesTheSetting) {
    const auto refused = [](const char* name, const char* text, const char* expected) {
        Settings settings;
        EXPECT_THAT([&] { set(settings, name, text); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(expected)))
            << name << " " << text;
    };
    refused("no_such", "1", "unknown setting \"no_such\": expected passes, method, radius");
    refused("samples", "0", "samples 0: expected a whole number, 1 to 2048");
    refused("samples", "many", "samples \"many\"");
    refused("samples", "", "samples \"\"");
    refused("samples", "8 ", "samples \"8 \"");
    refused("taps", "four", "taps four: expected nearest, bilinear or validated");
    refused("guard_history", "1", "expected on or off");
    refused("filter", "1", "filter 1: expected none, convergence, geometry, bilateral or sao");
    refused("depth_tolerance", "0", "more than 0");
    refused("method", "magic", "method magic: expected hemisphere");
}

TEST(SettingTable, AFilterIsOnOrOffAsWell) {
    Settings settings;
    set(settings, "filter", "off");
    EXPECT_EQ(settings.filter, Filter::none);
    set(settings, "filter", "on");
    EXPECT_EQ(settings.filter, Filter::convergence);
}

// Settings by name, on top of those of the test.
using Changes = std::vector<std::pair<const char*, const char*>>;

struct Case {
    const char* value;  // another than that of the test
    Changes before{};   // without which it would not matter
};

const std::map<std::string, Case>& cases() {
    const Changes frame{{"passes", "frame"}, {"method", "sweep"}, {"steps", "6"}, {"samples", "12"}};
    static const std::map<std::string, Case> all{
        {"passes", {"frame", {{"method", "sweep"}, {"steps", "6"}, {"samples", "12"}}}},
        {"history_range", {"0.5", frame}},
        {"history_sharpness",
         {"1",
          {{"passes", "frame"},
           {"method", "sweep"},
           {"steps", "6"},
           {"samples", "12"},
           {"history_range", "0.1"}}}},
        {"method", {"disc"}},
        {"radius", {"0.25"}},
        {"bias", {"0.05"}},
        {"bias_depth", {"0.02"}},
        {"range", {"0.05"}},
        {"epsilon", {"0.05", {{"method", "disc"}}}},
        {"intensity", {"0.5", {{"method", "alchemy"}}}},
        {"thickness", {"0.05", {{"method", "bitmask"}}}},
        {"angle_bias", {"0.5", {{"method", "hbao"}}}},
        {"steps", {"2", {{"method", "gtao"}}}},
        {"layers", {"2"}},
        {"disagreement", {"0", {{"method", "dual_resolution"}}}},
        {"feature_thickness", {"0", {{"method", "sweep"}}}},
        {"mip_distance", {"1", {{"method", "sao"}}}},
        {"samples", {"24"}},
        {"samples_converged", {"8", {{"c_spatial", "0.1"}}}},
        {"samples_distance", {"10"}},
        {"samples_radius", {"40"}},
        {"samples_least", {"20", {{"samples_radius", "40"}}}},
        {"radius_cap", {"5"}},
        {"reject_taps", {"on", {{"range", "0.05"}}}},
        {"smoothing", {"0.3"}},
        {"c_spatial", {"0.1"}},
        {"table_size", {"64"}},
        {"weight_max", {"64"}},
        {"c_rot", {"0.1"}},
        {"rotation", {"lattice"}},
        {"c_adaptive", {"0.6"}},
        {"filter_cap", {"1", {{"c_adaptive", "1"}}}},
        {"depth_tolerance", {"1e-4"}},
        {"taps", {"nearest"}},
        {"invalidation", {"none"}},
        {"change_tolerance", {"0.02"}},
        {"weight_small", {"4", {{"invalidation", "clamp"}}}},
        {"confidence_factor", {"200"}},
        {"filter", {"off", {{"c_adaptive", "1"}}}},
        {"filter_half_width", {"1", {{"c_adaptive", "1"}}}},
        {"filter_sigma", {"1", {{"c_adaptive", "1"}}}},
        {"filter_depth", {"0.01", {{"filter", "bilateral"}}}},
        {"remap_a", {"0.1"}},
        {"remap_b", {"0.9"}},
        {"remap_c", {"2"}},
        {"output", {"r8"}},
        {"resolution", {"half", frame}},
        {"least_radius", {"12"}},
        {"guard", {"0.1"}},
        {"guard_history", {"off", {{"guard", "0.1"}}}},
        {"history", {"off"}},
    };
    return all;
}

class EverySetting : public OnDevice<testing::Test> {
  protected:
    // What the last of a few frames shows.
    const std::vector<float>& shown(const Changes& changes) {
        const bool frame = std::ranges::count(changes, "frame", [](const auto& one) {
                               return std::string_view(one.second);
                           }) > 0;
        Settings settings = with_radius(Settings{}, frame ? 1.0F : 0.5F);
        settings.radius = 0.5F;
        std::string key;
        for (const auto& [name, value] : changes) {
            set(settings, name, value);
            key += std::string(name) + "=" + value + " ";
        }
        const auto known = shown_.find(key);
        if (known != shown_.end()) return known->second;
        return shown_.emplace(key, render(settings)).first->second;
    }

  private:
    [[nodiscard]] std::vector<float> render(const Settings& settings) const {
        std::vector<float> image;
        for (int i = 0; i < 5; ++i) {
            const scene::GBuffer view = drawn(
                scene_, {72, 48},
                {.frame = i, .motion = true, .layers = settings.own.layers, .guard = double{settings.guard}});
            AmbientOcclusion& effect = effect_for(view.extent);
            i == 0 ? effect.begin(view, settings) : effect.advance(view);
            image = effect.next().filtered;
        }
        return image;
    }

    scene::Scene scene_ = panned(floor_and_wall(true), 0.04);
    std::map<std::string, std::vector<float>> shown_;
};

TEST_F(EverySetting, ChangesWhatIsShown) {
    std::map<std::string, std::vector<float>> seen;
    for (const Setting& setting : setting_table()) {
        const auto found = cases().find(setting.name);
        ASSERT_NE(found, cases().end()) << setting.name << ": which value changes something?";
        Changes changes = found->second.before;
        const std::vector<float> before = shown(changes);
        changes.emplace_back(setting.name.c_str(), found->second.value);
        const std::vector<float> after = shown(changes);
        EXPECT_NE(after, before) << setting.name;
        for (const auto& [other, image] : seen)
            EXPECT_NE(after, image) << setting.name << " does what " << other << " does";
        seen.emplace(setting.name, after);
    }
}

}  // namespace gloam::effect::settings_test

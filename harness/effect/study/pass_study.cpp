// SPDX-License-Identifier: MIT
#include "effect/study/pass_study.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/precision_name.hpp"
#include "effect/internal/work.hpp"
#include "effect/methods.hpp"
#include "effect/study/copy_clock.hpp"
#include "scene/rasterize.hpp"
#include "shader/variant.hpp"

namespace gloam::effect {
namespace {

constexpr int wide = 8;  // taps on each side

// The mean holds the samples of one frame only.
Settings at_once(Settings settings) {
    settings.weight_max = static_cast<float>(settings.samples);
    return settings;
}

Settings widened(Settings settings) {
    settings.filter_half_width = wide;
    return settings;
}

Settings filtered_by(Filter filter, Settings settings) {
    settings.filter = filter;
    return settings;
}

Settings held_in(HistoryPrecision precision, Settings settings) {
    settings.precision = precision;
    settings.table_size = 2048;
    return settings;
}

Settings unskipped(Settings settings) {
    settings.skip_filtered = false;
    return settings;
}

Settings computed_anew(Settings settings) {
    settings.sample_table = false;
    return settings;
}

Settings base() {
    Settings settings;
    settings.skip_settled = false;
    return settings;
}

// As many taps in each frame, of a method without a filter.
Settings few_taps(const std::string& method) {
    Settings settings = with_method(base(), method);
    settings.samples = settings.samples_converged = 4;
    settings.own.steps = 2;
    settings.filter = Filter::none;
    settings.skip_open = false;
    return settings;
}

PassCase few_taps_case(std::string name, std::string what, const std::string& method, bool moves) {
    return {.name = std::move(name),
            .what = std::move(what),
            .settings = few_taps(method),
            .warm = moves ? 1 : 0,
            .moves = moves,
            .scene = "moving"};
}

// And with loops as they are written.
PassCase rolled(PassCase of) {
    of.name += ", not hoisted";
    of.what = "the same, loops as they are written";
    of.hoists = false;
    return of;
}

Settings frozen() {
    Settings settings = at_once(base());
    settings.freeze = true;
    return settings;
}

// Runs the frames of one case; the last one is timed.
class Runner {
  public:
    Runner(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent)
        : effect_(device, passes, extent),
          unhoisted_(device, passes.with(shader::Optimization::performance), extent) {
        for (const PassCase& what : pass_cases()) {
            if (shown_.contains(what.scene)) continue;
            const scene::Scene scene = scene::make_scene(what.scene);
            Shown& shown = shown_[what.scene];
            shown.radius = static_cast<float>(scene.ao_radius);
            for (std::size_t i = 0; i < shown.views.size(); ++i)
                shown.views.at(i) =
                    scene::rasterize(device, passes, scene, extent,
                                     {.frame = static_cast<int>(i), .motion = what.scene == "moving"});
        }
    }

    [[nodiscard]] Frame frame_of(const PassCase& what) {
        AmbientOcclusion& effect = what.hoists ? effect_ : unhoisted_;
        const Shown& shown = shown_.at(what.scene);
        effect.begin(shown.views[0], with_radius(what.settings, shown.radius));
        for (int i = 0; i < what.warm; ++i) (void)effect.next();
        if (what.moves) effect.advance(shown.views[1]);
        // Several runs, because the first one may be the first to access an image's memory.
        return effect.next(3);
    }

  private:
    struct Shown {
        std::array<scene::GBuffer, 2> views;
        float radius = 0.0F;
    };
    std::map<std::string, Shown> shown_;  // by scene
    AmbientOcclusion effect_;
    AmbientOcclusion unhoisted_;
};

// The readings of a pass, one for each round.
struct Readings {
    std::string pass;
    std::vector<double> ms;
    std::vector<double> copies;

    void add(double time_ms, double copy_ms) {
        ms.push_back(time_ms);
        copies.push_back(time_ms / copy_ms);
    }
};

std::vector<PassCost> medians_of(const std::vector<Readings>& passes) {
    std::vector<PassCost> costs;
    for (const Readings& of : passes) costs.push_back({of.pass, median(of.ms), median(of.copies)});
    return costs;
}

void add_frame(std::vector<Readings>& passes, const Frame& frame, double copy_ms) {
    if (passes.empty()) {
        for (const PassTime& time : frame.times) passes.push_back({time.pass, {}, {}});
    }
    for (std::size_t p = 0; p < passes.size(); ++p) passes[p].add(frame.times.at(p).ms, copy_ms);
}

}  // namespace

std::vector<PassCase> pass_cases() {
    const Settings plain = base();
    const Settings converged = at_once(plain);
    const PassCase slice = few_taps_case("one slice", "`gtao`, two steps to each side", "gtao", false);
    const PassCase moved_slice =
        few_taps_case("one slice, objects moved", "the same in a sequence", "gtao", true);
    return {
        {"fresh", "nothing has converged: 5 x 5 taps", plain, 0, false},
        {"fresh, no table", "the same, each sample computes its own point", computed_anew(plain), 0, false},
        {"fresh, wide", "the same, 17 x 17", widened(plain), 0, false},
        {"geometry", "5 x 5 taps by normal and depth", filtered_by(Filter::geometry, plain), 0, false},
        {"bilateral", "5 x 5 taps by distance and depth", filtered_by(Filter::bilateral, plain), 0, false},
        {"slices", "`gtao`", with_method(plain, "gtao"), 0, false},
        {"slices, not hoisted", "the same, loops as they are written", with_method(plain, "gtao"), 0, false,
         false},
        {"sao", "5 x 5 taps two pixels apart", filtered_by(Filter::sao, plain), 0, false},
        {"converged", "nothing is filtered: 5 x 5", converged, 0, false},
        {"converged, not skipped", "the same, the filter runs on all tiles", unskipped(converged), 0, false},
        {"frozen", "all has converged and takes no samples", frozen(), 1, false},
        {"moved", "the history follows the camera", plain, 1, true},
        {"moved, float16", "the same, of half floats", held_in(HistoryPrecision::float16, plain), 1, true},
        {"moved, packed", "the same, of 64 bits", held_in(HistoryPrecision::packed, plain), 1, true},
        slice,
        rolled(slice),
        moved_slice,
        rolled(moved_slice),
        few_taps_case("four taps", "`alchemy`", "alchemy", false),
        few_taps_case("four taps, objects moved", "the same in a sequence", "alchemy", true),
        few_taps_case("four points", "`hemisphere`", "hemisphere", false),
        few_taps_case("four points, objects moved", "the same in a sequence", "hemisphere", true)};
}

PassStudy study_passes(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                       int rounds) {
    require_timestamps(device.info());
    if (rounds < 1) throw std::invalid_argument(fmt::format("rounds {}: expected 1 or more", rounds));
    Runner runner(device, passes, extent);
    CopyClock clock(device, passes, extent);
    std::vector<CopyClock> history_clocks;
    std::vector<Readings> histories;
    for (const auto precision :
         {HistoryPrecision::float32, HistoryPrecision::float16, HistoryPrecision::packed}) {
        history_clocks.emplace_back(device, passes, extent, format_of(precision));
        histories.push_back({name_of(precision), {}, {}});
    }
    const std::vector<PassCase> cases = pass_cases();
    std::vector<std::vector<Readings>> readings(cases.size());
    std::vector<double> copies;
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Frame frame = runner.frame_of(cases[i]);
            if (round == 0) continue;  // drivers compile in the first
            copies.push_back(clock.measure_now());
            add_frame(readings[i], frame, copies.back());
        }
        for (std::size_t i = 0; i < histories.size() && round > 0; ++i) {
            copies.push_back(clock.measure_now());
            histories[i].add(history_clocks[i].measure_now(), copies.back());
        }
    }
    PassStudy study{.copy_ms = median(copies), .history_copies = medians_of(histories), .cases = {}};
    for (std::size_t i = 0; i < cases.size(); ++i) study.cases.push_back({cases[i], medians_of(readings[i])});
    return study;
}

}  // namespace gloam::effect

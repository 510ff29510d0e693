// SPDX-License-Identifier: MIT
#include "effect/study/plain_study.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/internal/method_families.hpp"
#include "effect/internal/work.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

constexpr int runs_a_round = 3;  // the first run after other passes finds their data in the caches

// The two sides of a comparison, with what they have read so far.
class Contest {
  public:
    Contest(const gpu::Device& device, const scene::PassLibrary& passes, const scene::GBuffer& view,
            float radius, const std::string& method, SliceTaps taps)
        : view_(&view),
          settings_(with_radius(single_frame_of_slices(method, taps), radius)),
          plain_(device, passes, view.extent, taps),
          effect_(device, passes, view.extent) {
        plain_.take(view, radius);
        const PlainFrame plain = plain_.next();  // drivers compile at the first dispatch
        effect_.begin(view, settings_);
        found_ = {.method = method,
                  .taps = taps,
                  .difference = errors_of(effect_.next().occlusion, truth_from(view, plain.occlusion)).rmse};
    }

    void run(bool plain_first) {
        if (plain_first) read_plain();
        effect_.begin(*view_, settings_);
        found_.method_ms.push_back(sampling_ms(effect_.next(runs_a_round)));
        if (!plain_first) read_plain();
    }

    [[nodiscard]] const PlainComparison& found() const { return found_; }

  private:
    void read_plain() { found_.plain_ms.push_back(plain_.next(runs_a_round).slices_ms); }

    const scene::GBuffer* view_;
    Settings settings_;
    PlainSlices plain_;
    AmbientOcclusion effect_;
    PlainComparison found_;
};

}  // namespace

Settings single_frame_of_slices(const std::string& method, SliceTaps taps) {
    const MethodInfo& info = method_named(method);
    if (info.unit != SampleUnit::slice)
        throw std::invalid_argument(
            fmt::format("method {}: its samples are not slices, expected one whose are", method));
    Settings settings = slices(info, taps.slices, taps.steps);
    settings.history = false;
    settings.filter = Filter::none;
    return settings;
}

std::vector<PlainComparison> compare_with_plain(const gpu::Device& device, const scene::PassLibrary& passes,
                                                const scene::GBuffer& view, float radius,
                                                std::span<const std::string> methods,
                                                std::span<const SliceTaps> taps, int rounds) {
    if (rounds < 1) throw std::invalid_argument(fmt::format("{} rounds: expected 1 or more", rounds));
    std::vector<std::unique_ptr<Contest>> contests;
    for (const std::string& method : methods)
        for (const SliceTaps each : taps)
            contests.push_back(std::make_unique<Contest>(device, passes, view, radius, method, each));
    for (int i = 0; i < rounds; ++i)
        for (const auto& contest : contests) contest->run(i % 2 == 0);
    std::vector<PlainComparison> found;
    for (const auto& contest : contests) found.push_back(contest->found());
    return found;
}

}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
#include "effect/study/configuration_study.hpp"

#include <algorithm>

#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "effect/remap_fit.hpp"
#include "effect/similarity.hpp"

namespace gloam::effect {
namespace {

// Adds up the errors and counts of scored frames.
class Judge {
  public:
    explicit Judge(const BenchmarkViews& views) : views_(&views) {}

    void add(int number, const Frame& frame, const std::vector<float>& before) {
        if (views_->frames().rays == 0) return;
        const ScoredFrame& truth = views_->scored(number);
        sum_.raw_geometry += errors_of(frame.occlusion, truth.geometry).rmse;
        const Errors shown = errors_of(frame.filtered, truth.geometry);
        sum_.geometry += shown.rmse;
        sum_.bias += shown.bias;
        if (!truth.depth.empty()) {
            sum_.raw_depth += errors_of(frame.occlusion, truth.depth).rmse;
            sum_.depth += errors_of(frame.filtered, truth.depth).rmse;
        }
        if (!before.empty() && truth.history)
            sum_.flicker = sum_.flicker.value_or(0.0) + mean_change(*truth.history, frame.filtered, before);
        const std::uint64_t shaded = frame.work.pixels - frame.work.background;
        sum_.samples +=
            shaded == 0 ? 0.0 : static_cast<double>(frame.work.samples) / static_cast<double>(shaded);
        sum_.memory_bytes = std::max(sum_.memory_bytes, frame.memory_bytes);
        if (number + 1 < views_->frames().frames) return;
        sum_.similarity = structural_similarity(frame.filtered, truth.geometry, frame.extent);
        if (!views_->frames().remap) return;
        const Remap best = best_remap(frame.occlusion, truth.geometry);
        sum_.remapped = errors_of(remapped(frame.occlusion, best), truth.geometry).rmse;
    }

    // Nothing where there is no truth.
    [[nodiscard]] std::optional<FrameQuality> mean() const {
        if (views_->frames().rays == 0) return std::nullopt;
        const double frames = views_->frames().scored;
        FrameQuality mean = sum_;
        for (double* value :
             {&mean.raw_geometry, &mean.raw_depth, &mean.geometry, &mean.depth, &mean.bias, &mean.samples})
            *value /= frames;
        if (mean.flicker) *mean.flicker /= std::max(1.0, frames - (views_->first_scored() == 0 ? 1.0 : 0.0));
        return mean;
    }

  private:
    const BenchmarkViews* views_;
    FrameQuality sum_;
};

}  // namespace

Settings measured_settings(const std::string& method, std::uint32_t samples, bool temporal) {
    Settings settings = with_method(preset_named(temporal ? "moving" : "paper").settings, method);
    settings.samples = samples;
    settings.samples_converged = samples;
    if (temporal) settings.weight_max = std::max(settings.weight_max, 2.0F * static_cast<float>(samples));
    validate(settings);
    return settings;
}

ConfigurationStudy::ConfigurationStudy(const gpu::Device& device, const scene::PassLibrary& passes,
                                       gpu::Extent extent)
    : device_(&device), passes_(passes), clock_(device, passes, extent) {}

bool ConfigurationStudy::due(bool temporal, int round, int scored) {
    return !temporal || round % scored == 0;
}

AmbientOcclusion& ConfigurationStudy::effect_for(gpu::Extent extent) {
    const auto key = std::pair(extent.width, extent.height);
    const auto found = effects_.find(key);
    if (found != effects_.end()) return found->second;
    return effects_.emplace(key, AmbientOcclusion(*device_, passes_, extent)).first->second;
}

ConfigurationVisit ConfigurationStudy::visit(BenchmarkViews& views, const Settings& settings, bool temporal,
                                             int round) {
    return temporal ? this->temporal(views, settings, round) : single(views, settings, round);
}

ConfigurationVisit ConfigurationStudy::single(BenchmarkViews& views, const Settings& settings, int round) {
    const BenchmarkFrames& frames = views.frames();
    AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
    if (round > 0) {
        effect.begin(views.view(views.first_scored() + round % frames.scored, settings), settings);
        const double copy = clock_.measure();
        const Frame frame = effect.next(frames.repeat);
        return {.readings = {{frame.times, copy}}, .work = frame.work};
    }
    Judge judge(views);
    ConfigurationVisit visit;
    for (int i = views.first_scored(); i < frames.frames; ++i) {
        effect.begin(views.view(i, settings), settings);
        Frame frame = effect.next();
        judge.add(i, frame, {});
        visit.work = frame.work;
        visit.shown = std::move(frame.filtered);
    }
    visit.quality = judge.mean();
    return visit;
}

ConfigurationVisit ConfigurationStudy::temporal(BenchmarkViews& views, const Settings& settings, int round) {
    AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
    Judge judge(views);
    ConfigurationVisit visit;
    std::vector<float> before;
    for (int i = 0; i < views.frames().frames; ++i) {
        const scene::GBuffer& view = views.view(i, settings);
        if (i == 0) {
            effect.begin(view, settings);
        } else if (views.is_new(i)) {
            effect.advance(view);
        }
        const bool scored = i >= views.first_scored();
        const double copy = scored ? clock_.measure() : 0.0;
        Frame frame = effect.next(scored ? views.frames().repeat : 1);
        visit.work = frame.work;
        if (scored) visit.readings.push_back({frame.times, copy});
        if (scored && round == 0) judge.add(i, frame, before);
        before = std::move(frame.filtered);
    }
    if (round > 0) return visit;
    visit.quality = judge.mean();
    visit.shown = std::move(before);
    return visit;
}

}  // namespace gloam::effect

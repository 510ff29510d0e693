// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "effect/errors.hpp"

namespace gloam::experiment {

BenchmarkViews::BenchmarkViews(const gpu::Device& device, const scene::PassLibrary& passes,
                               scene::Scene scene, const BenchmarkFrames& frames,
                               const scene::TruthCache& cache, const std::function<void(double)>& progress)
    : device_(&device), passes_(passes), scene_(std::move(scene)), frames_(frames) {
    if (frames.scored < 1 || frames.scored > frames.frames) {
        throw std::invalid_argument(fmt::format("{} scored frames of {}: expected 1 to {}", frames.scored,
                                                frames.frames, frames.frames));
    }
    for (std::size_t i = 0; i < frames.shown.size(); ++i)
        numbers_.insert(numbers_.end(), static_cast<std::size_t>(frames.shown[i]), static_cast<int>(i));
    for (int i = 0; frames.shown.empty() && i < frames.frames; ++i) numbers_.push_back(i);
    if (frames.rays == 0) return;
    const scene::TruthSettings traced{.rays = {.radius = scene_.ao_radius, .rays = frames.rays},
                                      .thickness = frames.depth_thickness * scene_.ao_radius};
    for (int i = first_scored(); i < frames.frames; ++i) {
        const scene::GBuffer& view = this->view(i, {});
        ScoredFrame truth{.geometry =
                              effect::truth_from(view, cache.geometry(scene_, i, view, traced).occlusion)};
        if (frames.depth_truth) truth.depth = effect::truth_from(view, cache.depth(view, traced).occlusion);
        if (i > 0 && is_new(i)) truth.history.emplace(view, this->view(i - 1, {}));
        scored_.push_back(std::move(truth));
        if (progress) progress(static_cast<double>(scored_.size()) / static_cast<double>(frames.scored));
    }
}

const scene::GBuffer& BenchmarkViews::view(int frame, const effect::Settings& settings) {
    return views_with(double{settings.guard}, static_cast<int>(settings.layers))
        .at(static_cast<std::size_t>(numbers_.at(static_cast<std::size_t>(frame))));
}

bool BenchmarkViews::is_new(int frame) const {
    const auto at = static_cast<std::size_t>(frame);
    return frame == 0 || numbers_.at(at) != numbers_.at(at - 1);
}

const ScoredFrame& BenchmarkViews::scored(int frame) const {
    return scored_.at(static_cast<std::size_t>(frame - first_scored()));
}

std::vector<scene::GBuffer>& BenchmarkViews::views_with(double guard, int layers) {
    std::vector<scene::GBuffer>& views = views_[{guard, layers}];
    for (int i = static_cast<int>(views.size()); i <= numbers_.back(); ++i) {
        views.push_back(scene::rasterize(*device_, passes_, scene_, frames_.extent,
                                         {.frame = frames_.still ? 0 : i,
                                          .motion = frames_.motion && !scene_.objects.empty(),
                                          .layers = layers,
                                          .guard = guard}));
        if (frames_.edit) frames_.edit(views.back(), i);
    }
    return views;
}

namespace {

// Adds up the errors and counts of scored frames.
class Judge {
  public:
    explicit Judge(const BenchmarkViews& views) : views_(&views) {}

    void add(int number, const effect::Frame& frame, const std::vector<float>& before) {
        if (views_->frames().rays == 0) return;
        const ScoredFrame& truth = views_->scored(number);
        sum_.raw_geometry += effect::errors_of(frame.occlusion, truth.geometry).rmse;
        const effect::Errors shown = effect::errors_of(frame.filtered, truth.geometry);
        sum_.geometry += shown.rmse;
        sum_.bias += shown.bias;
        if (!truth.depth.empty()) {
            sum_.raw_depth += effect::errors_of(frame.occlusion, truth.depth).rmse;
            sum_.depth += effect::errors_of(frame.filtered, truth.depth).rmse;
        }
        if (!before.empty() && truth.history)
            sum_.flicker =
                sum_.flicker.value_or(0.0) + effect::mean_change(*truth.history, frame.filtered, before);
        const std::uint64_t shaded = frame.work.pixels - frame.work.background;
        sum_.samples +=
            shaded == 0 ? 0.0 : static_cast<double>(frame.work.samples) / static_cast<double>(shaded);
        sum_.memory_bytes = std::max(sum_.memory_bytes, frame.memory_bytes);
        if (number + 1 < views_->frames().frames) return;
        sum_.similarity = effect::structural_similarity(frame.filtered, truth.geometry, frame.extent);
        if (!views_->frames().remap) return;
        const effect::Remap best = effect::best_remap(frame.occlusion, truth.geometry);
        sum_.remapped = effect::errors_of(effect::remapped(frame.occlusion, best), truth.geometry).rmse;
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

// The part of one of the scored frames in the means.
void add(FrameQuality& mean, const effect::PlainFrame& frame, const effect::Truth& truth, int scored) {
    mean.raw_geometry += effect::errors_of(frame.occlusion, truth).rmse / scored;
    const effect::Errors shown = effect::errors_of(frame.blurred, truth);
    mean.geometry += shown.rmse / scored;
    mean.bias += shown.bias / scored;
}

}  // namespace

ConfigurationStudy::ConfigurationStudy(const gpu::Device& device, const scene::PassLibrary& passes,
                                       gpu::Extent extent)
    : device_(&device), passes_(passes), clock_(device, passes, extent) {}

effect::AmbientOcclusion& ConfigurationStudy::effect_for(gpu::Extent extent) {
    const auto key = std::pair(extent.width, extent.height);
    const auto found = effects_.find(key);
    if (found != effects_.end()) return found->second;
    return effects_.emplace(key, effect::AmbientOcclusion(*device_, passes_, extent)).first->second;
}

ConfigurationVisit ConfigurationStudy::visit(BenchmarkViews& views, const effect::Settings& settings,
                                             bool temporal, int round) {
    return temporal ? this->temporal(views, settings, round) : single(views, settings, round);
}

ConfigurationVisit ConfigurationStudy::single(BenchmarkViews& views, const effect::Settings& settings,
                                              int round) {
    const BenchmarkFrames& frames = views.frames();
    effect::AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
    if (round > 0) {
        effect.begin(views.view(views.first_scored() + round % frames.scored, settings), settings);
        const double copy = clock_.measure();
        const effect::Frame frame = effect.next(frames.repeat);
        return {.readings = {{frame.times, copy}}, .work = frame.work};
    }
    Judge judge(views);
    ConfigurationVisit visit;
    for (int i = views.first_scored(); i < frames.frames; ++i) {
        effect.begin(views.view(i, settings), settings);
        effect::Frame frame = effect.next();
        judge.add(i, frame, {});
        visit.work = frame.work;
        visit.shown = std::move(frame.filtered);
    }
    visit.quality = judge.mean();
    return visit;
}

ConfigurationVisit ConfigurationStudy::temporal(BenchmarkViews& views, const effect::Settings& settings,
                                                int round) {
    effect::AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
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
        effect::Frame frame = effect.next(scored ? views.frames().repeat : 1);
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

PlainRun::PlainRun(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                   effect::SliceTaps taps, int blurs)
    : slices_(device, passes, extent, taps, blurs) {}

ConfigurationVisit PlainRun::visit(BenchmarkViews& views, effect::CopyClock& clock, int round) {
    const BenchmarkFrames& frames = views.frames();
    const auto radius = static_cast<float>(views.scene().ao_radius);
    ConfigurationVisit visit;
    FrameQuality sum;
    for (int i = views.first_scored(); i < frames.frames; ++i) {
        slices_.take(views.view(i, {}), radius);
        const double copy = round > 0 ? clock.measure() : 0.0;
        effect::PlainFrame frame = slices_.next(round > 0 ? frames.repeat : 1);
        if (round > 0) {
            visit.readings.push_back(
                {{{"plain_slices", frame.slices_ms}, {"plain_blur", frame.blur_ms}}, copy});
            continue;
        }
        if (frames.rays > 0) add(sum, frame, views.scored(i).geometry, frames.scored);
        visit.shown = std::move(frame.blurred);
    }
    if (round == 0 && frames.rays > 0) visit.quality = sum;
    return visit;
}

}  // namespace gloam::experiment

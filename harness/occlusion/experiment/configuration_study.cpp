// SPDX-License-Identifier: MIT
#include "experiment/configuration_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "effect/errors.hpp"

namespace gloam::experiment {

effect::Remap remap_of(const effect::Settings& settings) {
    return {settings.remap_a, settings.remap_b, settings.remap_c};
}

BenchmarkViews::BenchmarkViews(scene::Scene scene, const BenchmarkFrames& frames,
                               const std::function<void(double)>& progress)
    : scene_(std::move(scene)), frames_(frames) {
    for (std::size_t i = 0; i < frames.shown.size(); ++i)
        numbers_.insert(numbers_.end(), static_cast<std::size_t>(frames.shown[i]), static_cast<int>(i));
    for (int i = 0; frames.shown.empty() && i < frames.frames; ++i) numbers_.push_back(i);
    for (int i = frames.frames - frames.scored; i < frames.frames; i += frames.every)
        scored_frames_.push_back(i);
    if (frames.rays > 0) score(progress);
    if (frames.rays > 0 && frames.measures.contains(Quantity::by_class)) classify();
}

void BenchmarkViews::score(const std::function<void(double)>& progress) {
    for (const int i : scored_frames_) {
        const int number = this->number(i);
        if (progress) progress(static_cast<double>(i + 1 - scored_frames_.front()) / frames_.scored);
        const auto [at, is_new] = scored_.try_emplace(number);
        if (!is_new) continue;
        ScoredView& truth = at->second;
        const scene::GBuffer& view = this->view(i, {});
        const scene::TruthSettings settings = traced({scene::Weighting::cosine, scene::Falloff::linear});
        truth.geometry = effect::truth_from(
            view, scene::trace_geometry(scene_, frames_.still ? 0 : number, view, settings).occlusion);
        if (frames_.depth_truth)
            truth.depth = effect::truth_from(view, scene::trace_depth(view, settings).occlusion);
        if (i == 0 || !this->is_new(i)) continue;
        truth.history.emplace(view, this->view(i - 1, {}));
        if (scene_.objects.empty() || frames_.still) continue;
        truth.due = scene::trace_before(scene_, number, view, settings);
        for (std::size_t pixel = 0; pixel < truth.due.size(); ++pixel)
            truth.due[pixel] = truth.geometry[pixel] - truth.due[pixel];
    }
}

void BenchmarkViews::classify() {
    effect::PixelClasses classes({.radius = scene_.ao_radius});
    const std::vector<scene::GBuffer>& views = views_with(0.0, 1);
    for (std::size_t i = 0; i < views.size(); ++i) {
        std::optional<effect::HistoryMap> history;
        if (i > 0) history.emplace(views[i], views[i - 1]);
        classes.advance(views[i], history);
        ClassMasks& masks = classed_.emplace_back(ClassMasks{{"all", {}}});
        for (std::size_t k = 0; k < effect::pixel_class_names.size(); ++k)
            masks.emplace_back(effect::pixel_class_names[k],
                               classes.mask(static_cast<effect::PixelClass>(k)));
        if (!frames_.measures.contains(Quantity::places)) continue;
        effect::HardPlaces places = effect::hard_places(views[i], scene_.ao_radius);
        masks.emplace_back("contacts", std::move(places.contacts));
        masks.emplace_back("thin", std::move(places.thin));
        masks.emplace_back("rim", std::move(places.rim));
    }
}

scene::TruthSettings BenchmarkViews::traced(const Measured& measured) const {
    const auto& [weighting, falloff] = measured;
    return {.rays = {scene_.ao_radius, falloff, frames_.rays, weighting},
            .thickness = frames_.depth_thickness * scene_.ao_radius,
            .cache = frames_.truth_cache};
}

const effect::Truth* BenchmarkViews::own_measure(const effect::MethodInfo& method) {
    const bool step = method.falloff == "none up to the radius";
    const auto falloff = step ? scene::Falloff::step : scene::falloff_named(method.falloff);
    const bool cosine = method.measure == effect::Measure::cosine;
    if (!falloff || (!cosine && method.measure != effect::Measure::uniform)) return nullptr;
    const Measured measured{cosine ? scene::Weighting::cosine : scene::Weighting::uniform, *falloff};
    const auto [at, is_new] = own_.try_emplace(measured);
    const int number = frames_.still ? 0 : this->number(last_scored());
    const scene::GBuffer& view = this->view(last_scored(), {});
    if (is_new)
        at->second =
            effect::truth_from(view, scene::trace_geometry(scene_, number, view, traced(measured)).occlusion);
    return &at->second;
}

const scene::GBuffer& BenchmarkViews::view(int frame, const effect::Settings& settings) {
    return views_with(double{settings.guard}, settings.own.layers)
        .at(static_cast<std::size_t>(number(frame)));
}

bool BenchmarkViews::is_new(int frame) const {
    return frame == 0 || number(frame) != number(frame - 1);
}

const ScoredView& BenchmarkViews::scored(int frame) const {
    return scored_.at(number(frame));
}

const ClassMasks& BenchmarkViews::classed(int frame) const {
    return classed_.at(static_cast<std::size_t>(number(frame)));
}

std::vector<scene::GBuffer>& BenchmarkViews::views_with(double guard, int layers) {
    std::vector<scene::GBuffer>& views = views_[{guard, layers}];
    for (int i = static_cast<int>(views.size()); i <= numbers_.back(); ++i) {
        views.push_back(scene::draw(scene_, frames_.extent,
                                    {.frame = frames_.still ? 0 : i,
                                     .motion = frames_.motion.value_or(!scene_.objects.empty()),
                                     .layers = layers,
                                     .guard = guard}));
        if (frames_.still && i > 0) views.back().camera.previous_from_current = glm::mat4(1.0F);
    }
    return views;
}

namespace {

// The scores of a frame against the references that are known.
std::vector<ClassScore> scores_of(const effect::Frame& frame, const ScoredView& truth,
                                  const ClassMasks& classes) {
    std::vector<ClassScore> scores;
    for (const auto& [name, mask] : classes) {
        for (const auto& [against, values] :
             {std::pair("depth", &truth.depth), std::pair("geometry", &truth.geometry)}) {
            ClassScore score{.pixels = name, .against = against};
            for (std::size_t i = 0; i < values->size(); ++i) {
                const double reference = double{(*values)[i]};
                if ((!mask.empty() && mask[i] == 0) || std::isnan(reference)) continue;
                const double raw = double{frame.occlusion[i]} - reference;
                const double shown = double{frame.filtered[i]} - reference;
                score.raw_squares += raw * raw;
                score.raw_errors += raw;
                score.squares += shown * shown;
                ++score.count;
            }
            if (score.count > 0) scores.push_back(std::move(score));
        }
    }
    return scores;
}

// Adds up the errors and counts of frames.
class Judge {
  public:
    // by_class: what the views ask for by class is judged.
    Judge(const BenchmarkViews& views, bool by_class) : views_(&views) {
        if (by_class && views.frames().measures.contains(Quantity::by_class) && views.frames().rays > 0)
            sum_.by_class.emplace();
    }

    // before: the frame's predecessor; empty: there is none.
    void add(int number, const effect::Frame& frame, const std::vector<float>& before) {
        if (views_->frames().rays == 0) return;
        taken_ += frame.samples;
        if (views_->is_scored(number)) score(number, frame, before);
    }

    // Nothing where there is no truth.
    [[nodiscard]] std::optional<FrameQuality> mean() const {
        if (views_->frames().rays == 0) return std::nullopt;
        const auto frames = static_cast<double>(views_->scored_frames().size());
        FrameQuality mean = sum_;
        for (double* value :
             {&mean.raw_geometry, &mean.raw_depth, &mean.geometry, &mean.depth, &mean.bias, &mean.samples})
            *value /= frames;
        if (mean.percentile_99) *mean.percentile_99 /= frames;
        for (const auto& [pixels, changes] : changes_) {
            const double sum = std::accumulate(changes.begin(), changes.end(), 0.0);
            const ClassFlicker flicker{pixels, sum / static_cast<double>(changes.size())};
            if (pixels == "all") mean.flicker = flicker.mean;
            if (mean.by_class) mean.by_class->flicker.push_back(flicker);
        }
        return mean;
    }

  private:
    void score(int number, const effect::Frame& frame, const std::vector<float>& before) {
        const ScoredView& truth = views_->scored(number);
        sum_.raw_geometry += effect::errors_of(frame.occlusion, truth.geometry).rmse;
        const effect::Errors shown = effect::errors_of(frame.filtered, truth.geometry);
        sum_.geometry += shown.rmse;
        sum_.bias += shown.bias;
        if (views_->frames().measures.contains(Quantity::fit)) {
            if (!sum_.bins) sum_.bins.emplace(128);
            effect::add_to_bins(*sum_.bins, frame.filtered, truth.geometry);
        }
        sum_.percentile_99 = sum_.percentile_99.value_or(0.0) + shown.percentile_99;
        if (!truth.depth.empty()) {
            sum_.raw_depth += effect::errors_of(frame.occlusion, truth.depth).rmse;
            sum_.depth += effect::errors_of(frame.filtered, truth.depth).rmse;
        }
        if (!before.empty() && truth.history) add_flicker(number, frame.filtered, before);
        sum_.samples += frame.samples;
        sum_.memory_bytes = std::max(sum_.memory_bytes, frame.memory_bytes);
        if (sum_.by_class)
            sum_.by_class->frames.push_back(
                {number + 1, taken_, scores_of(frame, truth, views_->classed(number))});
        if (number < views_->last_scored()) return;
        sum_.tiles = effect::shares_of(frame.tiles);
        sum_.similarity = effect::structural_similarity(frame.filtered, truth.geometry, frame.extent);
        if (!views_->frames().measures.contains(Quantity::remapped)) return;
        const effect::Remap best = effect::best_remap(frame.occlusion, truth.geometry);
        sum_.remapped = effect::errors_of(effect::remapped(frame.occlusion, best), truth.geometry).rmse;
    }

    void add_flicker(int number, const std::vector<float>& image, const std::vector<float>& before) {
        const ScoredView& truth = views_->scored(number);
        for (const auto& [name, mask] : sum_.by_class ? views_->classed(number) : ClassMasks{{"all", {}}}) {
            if (const auto change = effect::mean_change(*truth.history, image, before, truth.due, mask))
                changes_[name].push_back(*change);
        }
    }

    const BenchmarkViews* views_;
    FrameQuality sum_;
    double taken_ = 0.0;                                  // samples of a pixel so far
    std::map<std::string, std::vector<double>> changes_;  // of scored frames, by class
};

// Judges an image of each scored frame.
ConfigurationVisit judged(const BenchmarkViews& views, bool by_class,
                          const std::function<effect::Frame(int)>& frame_of) {
    Judge judge(views, by_class);
    ConfigurationVisit visit;
    for (const int i : views.scored_frames()) {
        visit.shown = frame_of(i);
        judge.add(i, visit.shown, {});
    }
    visit.quality = judge.mean();
    return visit;
}

// Compared with the geometry truth alone.
Converged converged_of(const effect::Metrics& metrics) {
    return {.geometry = metrics.raw, .remapped = metrics.after_remap, .similarity = metrics.similarity};
}

// What the last scored frame would converge to, compared.
Converged compared(const std::vector<float>& image, BenchmarkViews& views, const effect::Settings& settings) {
    const ScoredView& truth = views.scored(views.last_scored());
    Converged found = converged_of(effect::metrics_of(image, truth.geometry, views.frames().extent));
    if (!truth.depth.empty()) found.depth = effect::errors_of(image, truth.depth);
    if (const effect::Truth* own = views.own_measure(effect::method_named(settings.method)))
        found.own = effect::errors_of(image, *own);
    return found;
}

// The occlusion that the method would have after many samples in one frame, without rotation and filter.
std::vector<float> converged(effect::AmbientOcclusion& effect, const scene::GBuffer& view,
                             const effect::Settings& settings) {
    effect::Settings many = settings;
    many.samples = many.samples_converged = 1'024;
    many.c_rot = 0.0F;
    many.filter = effect::Filter::none;
    many.remap_a = 0.0F;
    many.remap_b = 1.0F;
    many.remap_c = 1.0F;
    effect.begin(view, many);
    return effect::remapped(effect.next().occlusion, remap_of(settings));
}

}  // namespace

ConfigurationStudy::ConfigurationStudy(const backend::vulkan::Device& device,
                                       const scene::PassLibrary& passes)
    : device_(&device), passes_(passes) {}

effect::AmbientOcclusion& ConfigurationStudy::effect_for(backend::Extent extent) {
    const auto key = std::pair(extent.width, extent.height);
    return effects_.try_emplace(key, *device_, passes_).first->second;
}

ConfigurationVisit ConfigurationStudy::visit(BenchmarkViews& views, const effect::Settings& settings,
                                             bool temporal, int round) {
    return temporal ? this->temporal(views, settings, round) : single(views, settings, round);
}

ConfigurationVisit ConfigurationStudy::single(BenchmarkViews& views, effect::Settings settings, int round) {
    if (settings.passes == effect::Passes::frame) settings.history = false;  // nothing is kept for a next one
    const BenchmarkFrames& frames = views.frames();
    effect::AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
    if (round > 0) {
        const std::vector<int>& scored = views.scored_frames();
        effect.begin(views.view(scored[static_cast<std::size_t>(round) % scored.size()], settings), settings);
        const effect::Frame frame = effect.next(frames.repeat);
        return {.readings = {{frame.times}}};
    }
    ConfigurationVisit visit = judged(views, true, [&](int i) {
        effect.begin(views.view(i, settings), settings);
        return effect.next();
    });
    if (!frames.measures.contains(Quantity::converged) || !visit.quality) return visit;
    visit.converged = converged(effect, views.view(views.last_scored(), settings), settings);
    visit.quality->converged = compared(visit.converged, views, settings);
    return visit;
}

ConfigurationVisit ConfigurationStudy::temporal(BenchmarkViews& views, const effect::Settings& settings,
                                                int round) {
    effect::AmbientOcclusion& effect = effect_for(views.view(0, settings).extent);
    Judge judge(views, true);
    ConfigurationVisit visit;
    std::vector<float> before;
    for (int i = 0; i < views.frames().frames; ++i) {
        const scene::GBuffer& view = views.view(i, settings);
        if (i == 0) {
            effect.begin(view, settings);
        } else if (views.is_new(i)) {
            effect.advance(view);
        }
        const bool scored = views.is_scored(i);
        effect::Frame frame = effect.next(scored ? views.frames().repeat : 1);
        if (scored) visit.readings.push_back({frame.times});
        if (round == 0) judge.add(i, frame, before);
        before = frame.filtered;
        if (scored && round == 0) visit.shown = std::move(frame);
    }
    if (round == 0) visit.quality = judge.mean();
    return visit;
}

ConfigurationVisit plain_visit(effect::PlainSlices& loop, BenchmarkViews& views, int round) {
    const BenchmarkFrames& frames = views.frames();
    const auto radius = static_cast<float>(views.scene().ao_radius);
    const auto next = [&](int i) {
        loop.take(views.view(i, {}), radius);
        return loop.next(round > 0 ? frames.repeat : 1);
    };
    if (round == 0)
        return judged(views, false, [&](int i) -> effect::Frame {
            effect::PlainFrame frame = next(i);
            return {.extent = frames.extent,
                    .occlusion = std::move(frame.occlusion),
                    .filtered = std::move(frame.blurred)};
        });
    ConfigurationVisit visit;
    for (const int i : views.scored_frames()) {
        const effect::PlainFrame frame = next(i);
        visit.readings.push_back({{{"plain_slices", frame.slices_ms}, {"plain_blur", frame.blur_ms}}});
    }
    return visit;
}

ConfigurationVisit depth_truth_of(const BenchmarkViews& views, int round) {
    if (round > 0 || views.frames().rays == 0) return {};
    const BenchmarkFrames& frames = views.frames();
    ConfigurationVisit visit = judged(views, false, [&](int i) -> effect::Frame {
        const effect::Truth& depth = views.scored(i).depth;
        return {.extent = frames.extent, .occlusion = depth, .filtered = depth};
    });
    if (frames.measures.contains(Quantity::converged))
        visit.quality->converged = converged_of(effect::metrics_of(
            visit.shown.filtered, views.scored(views.last_scored()).geometry, frames.extent));
    return visit;
}

}  // namespace gloam::experiment

// SPDX-License-Identifier: MIT
#include "effect/study/method_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "effect/errors.hpp"
#include "effect/internal/work.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

constexpr float most_weight = 8'388'608.0F;  // 2^23: no sample is forgotten

// The mean of all samples, without a rotation, a filter or a remap.
Settings accumulated(Settings settings, std::uint32_t samples) {
    settings.history = true;
    settings.samples = samples;
    settings.samples_converged = samples;
    settings.weight_max = most_weight;
    settings.table_size = 1U << 24U;
    settings.precision = HistoryPrecision::float32;
    settings.c_rot = 0.0F;
    settings.filter = Filter::none;
    settings.remap_a = 0.0F;
    settings.remap_b = 1.0F;
    settings.remap_c = 1.0F;
    settings.guard_history = false;
    return settings;
}

Estimate mean_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

Remap remap_of(const Settings& settings) {
    return {settings.remap_a, settings.remap_b, settings.remap_c};
}

}  // namespace

ClosedFormStudy::ClosedFormStudy(const gpu::Device& device, const scene::PassLibrary& passes,
                                 std::uint32_t pixels)
    : effect_(device, passes, {pixels, pixels}), pixels_(pixels) {}

Estimate ClosedFormStudy::measure(const scene::ClosedFormView& view, const Settings& settings,
                                  const ClosedFormOptions& options) {
    if (options.frames < 2)
        throw std::invalid_argument(fmt::format("{} frames: expected 2 or more", options.frames));
    if (options.pixels != pixels_)
        throw std::invalid_argument(fmt::format("{} pixels: expected {}", options.pixels, pixels_));
    scene::GBuffer buffer = scene::draw(view, options.pixels);
    if (options.reconstruct_normals) buffer.normal.clear();
    effect_.begin(buffer, accumulated(settings, options.samples));
    std::vector<double> means;
    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < options.frames; ++i) {
        const Frame frame = effect_.next();
        const double counted = double{frame.convergence.front()} * double{most_weight};
        const double total = double{frame.occlusion.front()} * counted;
        if (counted > weight) means.push_back((total - sum) / (counted - weight));
        sum = total;
        weight = counted;
    }
    if (means.size() < 2) return {weight > 0.0 ? sum / weight : 0.0, 0.0};
    return {sum / weight, mean_of(means).error};
}

std::vector<MethodConfiguration> method_configurations() {
    const std::vector<Preset> all = presets();
    std::vector<MethodConfiguration> list;
    for (const MethodInfo& method : methods()) {
        list.push_back({method.name, with_method(Settings{}, method.name)});
        const auto quality = std::ranges::find(all, method.name + "-quality", &Preset::name);
        if (quality != all.end()) list.push_back({quality->name, quality->settings});
    }
    return list;
}

bool same_estimate(const Settings& a, const Settings& b) {
    return std::ranges::all_of(setting_table(), [&](const Setting& setting) {
        const bool apart = setting.name.starts_with("samples") || setting.name.starts_with("filter");
        return apart || setting.get(a) == setting.get(b);
    });
}

std::vector<ViewResult> study_views(ClosedFormStudy& study, const MethodConfiguration& configuration,
                                    const ClosedFormOptions& options) {
    std::vector<ViewResult> results;
    for (const scene::ClosedFormView& view : scene::closed_form_views(scene::Projection::perspective)) {
        const Estimate measured = study.measure(view, configuration.settings, options);
        const bool of_pixels = own_value_of(configuration.settings.method).of_pixels;
        const std::uint32_t pixels = of_pixels ? options.pixels : 0;
        const double visible = remap_of(configuration.settings)(1.0 - measured.value);
        results.push_back({.view = view.name,
                           .truth = view.occlusion,
                           .measured = measured,
                           .own = own_value(view, configuration.settings, pixels, 5e-4),
                           .shown = 1.0 - visible});
    }
    return results;
}

SceneStudy::SceneStudy(const gpu::Device& device, const scene::PassLibrary& passes,
                       const scene::TruthCache& cache, scene::Scene scene, SceneOptions options)
    : cache_(&cache),
      scene_(std::move(scene)),
      options_(std::move(options)),
      view_(scene::rasterize(device, passes, scene_, options_.extent)),
      effect_(device, passes, options_.extent),
      geometry_(traced({scene::Weighting::cosine, scene::Falloff::linear})) {
    const scene::TruthSettings settings{.rays = {.radius = scene_.ao_radius, .rays = options_.rays},
                                        .progress = options_.progress};
    depth_ = truth_from(view_, cache_->depth(view_, settings).occlusion);
}

Truth SceneStudy::traced(const Measured& measured) const {
    const scene::TruthSettings settings{.rays = {.radius = scene_.ao_radius,
                                                 .falloff = measured.second,
                                                 .rays = options_.rays,
                                                 .weighting = measured.first},
                                        .progress = options_.progress};
    return truth_from(view_, cache_->geometry(scene_, 0, view_, settings).occlusion);
}

// nullptr for a method that does not estimate occlusion by rays, or that has a falloff of its own.
const Truth* SceneStudy::own_truth(const MethodInfo& method) {
    const bool step = method.falloff == "none up to the radius";
    const auto falloff = step ? scene::Falloff::step : scene::falloff_named(method.falloff);
    if (!falloff || (method.measure != Measure::cosine && method.measure != Measure::uniform)) return nullptr;
    const bool cosine = method.measure == Measure::cosine;
    const Measured measured{cosine ? scene::Weighting::cosine : scene::Weighting::uniform, *falloff};
    if (!own_.contains(measured)) own_.emplace(measured, traced(measured));
    return &own_.at(measured);
}

// One frame of many samples without rotation: the same low-discrepancy sequence for all pixels.
std::vector<float> SceneStudy::limit_of(const Settings& settings) {
    Settings many = settings;
    many.samples = options_.limit_samples;
    many.samples_converged = options_.limit_samples;
    many.c_rot = 0.0F;
    many.filter = Filter::none;
    many.remap_a = 0.0F;
    many.remap_b = 1.0F;
    many.remap_c = 1.0F;
    effect_.begin(view_, many);
    return remapped(effect_.next().occlusion, remap_of(settings));
}

SceneResult SceneStudy::run(const MethodConfiguration& configuration) {
    const Settings settings = with_radius(configuration.settings, static_cast<float>(scene_.ao_radius));
    SceneResult result{.limit = limit_of(settings), .samples = settings.samples};
    result.geometry = metrics_of(result.limit, geometry_, options_.extent);
    result.depth = errors_of(result.limit, depth_);
    if (const Truth* own = own_truth(method_named(settings.method)))
        result.own = errors_of(result.limit, *own);
    effect_.begin(view_, settings);
    const Frame frame = effect_.next(options_.repeat);
    result.frame = errors_of(frame.filtered, geometry_);
    result.gather_ms = sampling_ms(frame);
    result.frame_ms = total_ms(frame);
    return result;
}

}  // namespace gloam::effect

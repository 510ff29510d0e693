// SPDX-License-Identifier: MIT
#include "effect/study/still_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "effect/study/sequence.hpp"

namespace gloam::effect {
namespace {

double rmse_of(std::span<const float> image, const Truth& truth) {
    return truth.empty() ? std::numeric_limits<double>::quiet_NaN() : errors_of(image, truth).rmse;
}

}  // namespace

std::vector<StillFrame> study_still(const gpu::Device& device, const scene::PassLibrary& passes,
                                    const scene::GBuffer& view, const Settings& settings,
                                    const References& truth, int frames,
                                    const std::function<void(double)>& progress) {
    AmbientOcclusion effect(device, passes, view.extent);
    effect.begin(standing_still(view), settings);
    std::vector<StillFrame> study;
    double samples = 0.0;
    for (int i = 0; i < frames; ++i) {
        const Frame frame = effect.next();
        const Work& work = frame.work;
        const std::uint64_t left_out = work.background + work.below_radius;
        samples += static_cast<double>(work.samples) /
                   static_cast<double>(std::max<std::uint64_t>(1, work.pixels - left_out));
        StillFrame entry{.samples = samples, .weight = std::min(samples, double{settings.weight_max})};
        for (std::size_t r = 0; r < references; ++r) {
            entry.raw.at(r) = rmse_of(frame.occlusion, truth.at(r));
            entry.filtered.at(r) = rmse_of(frame.filtered, truth.at(r));
        }
        if (!truth[0].empty()) entry.bias = errors_of(frame.occlusion, truth[0]).bias;
        study.push_back(entry);
        if (progress) progress(static_cast<double>(i + 1) / frames);
    }
    return study;
}

double convergence_slope(const std::vector<StillFrame>& frames, double weight_max) {
    double n = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const StillFrame& frame : frames) {
        if (frame.samples >= weight_max || !(frame.raw[0] > 0.0)) continue;
        const double log_samples = std::log(frame.samples);
        const double log_error = 2.0 * std::log(frame.raw[0]);
        n += 1.0;
        x += log_samples;
        y += log_error;
        xx += log_samples * log_samples;
        xy += log_samples * log_error;
    }
    if (n < 2.0) return std::numeric_limits<double>::quiet_NaN();
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace gloam::effect

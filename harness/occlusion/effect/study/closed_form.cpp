// SPDX-License-Identifier: MIT
#include "effect/study/closed_form.hpp"

#include <cmath>
#include <vector>

namespace gloam::effect {
namespace {

constexpr float most_weight = 8'388'608.0F;  // 2^23: no sample is forgotten

// The mean of all samples, without a rotation, a filter or a remap.
Settings accumulated(Settings settings) {
    settings.history = true;
    settings.samples = settings.samples_converged = 1'024;
    settings.weight_max = most_weight;
    settings.table_size = 1U << 24U;
    settings.c_rot = 0.0F;
    settings.filter = Filter::none;
    settings.remap_a = 0.0F;
    settings.remap_b = 1.0F;
    settings.remap_c = 1.0F;
    settings.guard_history = false;
    return settings;
}

// The standard error of the mean of some values.
double error_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / (count * (count - 1.0)));
}

}  // namespace

Estimate measured(AmbientOcclusion& effect, const scene::GBuffer& view, const Settings& settings,
                  int frames) {
    effect.begin(view, accumulated(settings));
    std::vector<double> means;
    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < frames; ++i) {
        const Frame frame = effect.next();
        const double counted = double{frame.convergence.front()} * double{most_weight};
        const double total = double{frame.occlusion.front()} * counted;
        if (counted > weight) means.push_back((total - sum) / (counted - weight));
        sum = total;
        weight = counted;
    }
    if (means.size() < 2) return {weight > 0.0 ? sum / weight : 0.0, 0.0};
    return {sum / weight, error_of(means)};
}

}  // namespace gloam::effect

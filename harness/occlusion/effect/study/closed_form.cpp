// SPDX-License-Identifier: MIT
#include "effect/study/closed_form.hpp"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>
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

Estimate mean_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

}  // namespace

ClosedFormStudy::ClosedFormStudy(const gpu::Device& device, const scene::PassLibrary& passes,
                                 std::uint32_t pixels)
    : effect_(device, passes, {pixels, pixels}), pixels_(pixels) {}

Estimate ClosedFormStudy::measure(const scene::ClosedFormView& view, const Settings& settings, int frames) {
    if (frames < 2) throw std::invalid_argument(fmt::format("{} frames: expected 2 or more", frames));
    effect_.begin(scene::draw(view, pixels_), accumulated(settings));
    std::vector<double> means;
    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < frames; ++i) {
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

}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
#include "effect/study/limit.hpp"

namespace gloam::effect {

Limit::Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent)
    : effect_(device, passes, extent) {}

std::vector<float> Limit::of(const scene::GBuffer& view, const Settings& settings) {
    // k_1 samples in the first frame, k_2 in each later frame.
    constexpr float weight_max = 8'192.0F;
    static_assert(limit_first + limit_samples < 8'192 && limit_samples % most_samples == 0);
    Settings many = settings;
    many.history = true;
    many.samples = limit_first;
    many.samples_converged = most_samples;
    many.c_spatial = 0.5F * static_cast<float>(limit_first) / weight_max;
    many.weight_max = weight_max;
    many.table_size = 1U << 24U;
    many.precision = HistoryPrecision::float32;
    many.c_rot = 0.0F;
    many.filter = Filter::none;
    effect_.begin(view, many);
    const Frame first = effect_.next();
    Frame last;
    for (std::uint32_t taken = 0; taken < limit_samples; taken += most_samples) last = effect_.next();
    std::vector<float> limit = last.occlusion;
    for (std::size_t i = 0; i < limit.size(); ++i) {
        const double before = double{first.convergence[i]} * double{weight_max};
        const double after = double{last.convergence[i]} * double{weight_max};
        if (after <= before) continue;  // known without samples
        limit[i] = static_cast<float>(
            (after * double{last.occlusion[i]} - before * double{first.occlusion[i]}) / (after - before));
    }
    return limit;
}

}  // namespace gloam::effect

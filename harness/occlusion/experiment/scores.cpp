// SPDX-License-Identifier: MIT
#include "experiment/scores.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gloam::experiment {

std::vector<float> Limit::of(const scene::GBuffer& view, const effect::Settings& settings) {
    // k_1 samples in the first frame, k_2 in each later frame.
    constexpr float weight_max = 8'192.0F;
    static_assert(limit_first + limit_samples < 8'192 && limit_samples % effect::most_samples == 0);
    effect::Settings many = settings;
    many.history = true;
    many.samples = limit_first;
    many.samples_converged = effect::most_samples;
    many.c_spatial = 0.5F * static_cast<float>(limit_first) / weight_max;
    many.weight_max = weight_max;
    many.table_size = 1U << 24U;
    many.c_rot = 0.0F;
    many.filter = effect::Filter::none;
    effect_.begin(view, many);
    const effect::Frame first = effect_.next();
    effect::Frame last;
    for (std::uint32_t taken = 0; taken < limit_samples; taken += effect::most_samples) last = effect_.next();
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

const std::vector<std::string>& pixel_classes() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"all", "contacts", "thin", "rim"};
        all.insert(all.begin() + 1, effect::pixel_class_names.begin(), effect::pixel_class_names.end());
        return all;
    }();
    return names;
}

bool is_place(const std::string& name) {
    return name == "contacts" || name == "thin" || name == "rim";
}

effect::Mask mask_of(const ClassedView& view, const std::string& name) {
    if (name == "all") return {};
    if (name == "contacts") return view.places.value().contacts;
    if (name == "thin") return view.places.value().thin;
    if (name == "rim") return view.places.value().rim;
    const auto* const found = std::ranges::find(effect::pixel_class_names, name);
    return view.classes.mask(static_cast<effect::PixelClass>(found - effect::pixel_class_names.begin()));
}

std::vector<ClassScore> scores_of(const effect::Frame& frame, const ScoredView& truth,
                                  const ClassedView& view) {
    const std::vector<std::pair<std::string, const effect::Truth*>> known{
        {"limit", &truth.limit}, {"depth", &truth.depth}, {"geometry", &truth.geometry}};
    std::vector<ClassScore> scores;
    for (const std::string& name : pixel_classes()) {
        if (is_place(name) && !view.places) continue;
        const effect::Mask mask = mask_of(view, name);
        for (const auto& [against, values] : known) {
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

}  // namespace gloam::experiment

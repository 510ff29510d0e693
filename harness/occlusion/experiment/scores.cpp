// SPDX-License-Identifier: MIT
#include "experiment/scores.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gloam::experiment {

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
    const std::vector<std::pair<std::string, const effect::Truth*>> known{{"depth", &truth.depth},
                                                                          {"geometry", &truth.geometry}};
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

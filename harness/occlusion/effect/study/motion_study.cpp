// SPDX-License-Identifier: MIT
#include "effect/study/motion_study.hpp"

#include <limits>
#include <utility>

#include "effect/internal/work.hpp"

namespace gloam::effect {

std::vector<SequenceFrame> sequence_of(const gpu::Device& device, const scene::PassLibrary& passes,
                                       const scene::Scene& scene, gpu::Extent extent, int frames) {
    std::vector<SequenceFrame> sequence;
    PixelClasses classes({.radius = scene.ao_radius});
    for (int i = 0; i < frames; ++i) {
        scene::GBuffer view = scene::rasterize(device, passes, scene, extent, {.frame = i, .motion = true});
        std::optional<HistoryMap> history;
        if (i > 0) history.emplace(view, sequence.back().view);
        classes.advance(view, history);
        scene::GBuffer wide = scene::rasterize(device, passes, scene, extent,
                                               {.frame = i, .motion = true, .guard = study_guard});
        sequence.push_back({std::move(view), std::move(wide), std::move(history), classes});
    }
    return sequence;
}

scene::GBuffer standing_still(scene::GBuffer view) {
    view.motion.clear();
    view.previous_position.clear();
    view.camera.previous_view.reset();
    view.camera.previous_from_current.reset();
    return view;
}

namespace {

constexpr float never = 2.0F;    // a convergence that is never reached
constexpr float without = 1e6F;  // samples: a cap that is never reached

// The cap is the unit of convergence, so the thresholds are scaled to the same numbers of samples.
Settings uncapped(Settings settings) {
    const float part = settings.weight_max / without;
    settings.weight_max = without;
    settings.c_spatial *= part;
    settings.c_rot *= part;
    settings.c_adaptive *= part;
    return settings;
}

// Runs one variant through the sequence.
class Runner {
  public:
    Runner(const gpu::Device& device, const scene::PassLibrary& passes, const SequenceFrame& first,
           Variant variant)
        : effect_(device, passes, view_for(first, variant).extent), run_{.variant = std::move(variant)} {}

    const Frame& advance(const SequenceFrame& frame, bool second_half) {
        std::vector<float> before = std::move(last_.filtered);
        if (before.empty()) {
            effect_.begin(view_for(frame, run_.variant), run_.variant.settings);
        } else {
            effect_.advance(view_for(frame, run_.variant));
        }
        last_ = effect_.next();
        run_.times_ms.push_back(total_ms(last_));
        if (second_half && frame.history && !before.empty()) add_flicker(frame, before);
        return last_;
    }

    void score(Score score) {
        run_.scores.push_back(std::move(score));
        run_.last = last_;
    }

    [[nodiscard]] MotionRun finish() && {
        for (double& value : run_.flicker) value /= std::max(1, flickers_);
        return std::move(run_);
    }

  private:
    static const scene::GBuffer& view_for(const SequenceFrame& frame, const Variant& variant) {
        return variant.settings.guard > 0.0F ? frame.wide : frame.view;
    }

    void add_flicker(const SequenceFrame& frame, std::span<const float> before) {
        ++flickers_;
        for (const PixelClass which : all_classes) {
            run_.flicker.at(static_cast<std::size_t>(which)) +=
                mean_change(*frame.history, last_.filtered, before, mask_of(frame.classes, which));
        }
    }

    AmbientOcclusion effect_;
    MotionRun run_;
    Frame last_;
    int flickers_ = 0;
};

}  // namespace

std::vector<Variant> ablations_of(const Settings& full) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<Variant> variants{{"full", "", full}};
    const auto off = [&](const char* name, const char* instead, const auto& change) {
        Settings settings = full;
        change(settings);
        variants.push_back({name, instead, settings});
    };
    off("disocclusion test (8)", "every surface is the same",
        [](Settings& s) { s.depth_tolerance = infinity; });
    off("neighbourhood (9)", "the history counts in full",
        [](Settings& s) { s.invalidation = Invalidation::none; });
    off("smooth invalidation by confidence", "at most 48 samples count", [](Settings& s) {
        s.invalidation = Invalidation::clamp;
        s.weight_small = 48.0F;
    });
    off("both smooth invalidations", "a changed neighbourhood starts afresh", [](Settings& s) {
        s.invalidation = Invalidation::clamp;
        s.weight_small = 0.0F;
    });
    off("adaptive k", "always k1", [](Settings& s) { s.c_spatial = never; });
    off("adaptive k, the other way", "always k2", [](Settings& s) { s.c_spatial = 0.0F; });
    off("filter", "none", [](Settings& s) { s.filter = Filter::none; });
    off("shrink", "always the full window", [](Settings& s) { s.c_adaptive = infinity; });
    off("trust in what has converged (10)", "at most that in the pixel itself",
        [](Settings& s) { s.filter_cap = 1.0F; });
    off("rotation switch", "always rotated", [](Settings& s) { s.c_rot = never; });
    off("rotation", "never rotated", [](Settings& s) { s.c_rot = 0.0F; });
    off("nearest index", "interpolated", [](Settings& s) { s.nearest_index = false; });
    off("validation of each tap", "bilinear where the nearest is valid",
        [](Settings& s) { s.taps = HistoryTaps::bilinear; });
    off("bilinear taps", "the nearest texel", [](Settings& s) { s.taps = HistoryTaps::nearest; });
    off("frame without a guard band", "10 % on each side, rendered, shaded and cropped",
        [](Settings& s) { s.guard = 0.1F; });
    variants.push_back({"weight cap", "all samples count alike", uncapped(full)});
    return variants;
}

MotionStudy study_motion(const gpu::Device& device, const scene::PassLibrary& passes,
                         const std::vector<SequenceFrame>& sequence, const std::vector<Variant>& variants,
                         const ReferencesOf& references_of, const MotionOptions& options) {
    MotionStudy study;
    const gpu::Extent extent = sequence.front().view.extent;
    const Settings& full = variants.front().settings;
    std::vector<Runner> runners;
    for (const Variant& variant : variants) runners.emplace_back(device, passes, sequence.front(), variant);
    AmbientOcclusion alone(device, passes, extent);
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        const SequenceFrame& frame = sequence[i];
        const bool scored = i % static_cast<std::size_t>(options.every) == 0;
        const References truth = scored ? references_of(static_cast<int>(i), frame) : References{};
        for (Runner& runner : runners) {
            const Frame& result = runner.advance(frame, 2 * i >= sequence.size());
            if (scored) runner.score(score_of(result, truth, frame.classes));
        }
        if (scored) {
            study.last = truth;
            study.frames.push_back(static_cast<int>(i));
            alone.begin(standing_still(frame.view), full);
            Frame result = alone.next();
            study.single.push_back(score_of(result, truth, frame.classes));
            for (std::size_t again = 0; again < i; ++again) result = alone.next();
            study.still.push_back(score_of(result, truth, frame.classes));
        }
        if (options.progress)
            options.progress(static_cast<double>(i + 1) / static_cast<double>(sequence.size()));
    }
    for (Runner& runner : runners) study.runs.push_back(std::move(runner).finish());
    return study;
}

double time_ratio(const MotionRun& run, const MotionRun& base) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < run.times_ms.size() && i < base.times_ms.size(); ++i)
        ratios.push_back(run.times_ms[i] / base.times_ms[i]);
    return median(ratios);
}

Score total(const std::vector<Score>& scores, std::size_t first) {
    Score sum;
    for (std::size_t i = first; i < scores.size(); ++i) sum += scores[i];
    return sum;
}

}  // namespace gloam::effect

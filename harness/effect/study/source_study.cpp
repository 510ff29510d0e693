// SPDX-License-Identifier: MIT
#include "effect/study/source_study.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <ranges>
#include <utility>

#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "effect/remap_fit.hpp"
#include "effect/study/benchmark_views.hpp"
#include "effect/study/configuration_study.hpp"

namespace gloam::effect {
namespace {

constexpr std::array table_methods{"hbao_study", "crytek", "alchemy", "issao_distinct"};
constexpr std::uint32_t table_taps = 12;
constexpr std::array study_presets{"crytek-performance", "filion-performance",     "hbao-performance",
                                   "angle-performance",  "volumetric-performance", "alchemy-performance"};

constexpr std::array quality_presets{"crytek-quality", "filion-quality",     "hbao-quality",
                                     "angle-quality",  "volumetric-quality", "alchemy-quality",
                                     "unreal-quality"};

// The frames of an experiment: a scene with the truth for one radius.
BenchmarkViews views_of(const gpu::Device& device, const scene::PassLibrary& passes,
                        const scene::TruthCache& cache, const std::string& name, double radius,
                        const SourceOptions& options) {
    scene::Scene scene = scene::make_scene(name);
    scene.ao_radius *= radius;
    return {device,
            passes,
            std::move(scene),
            {.extent = options.extent, .frames = 1, .scored = 1, .rays = options.rays},
            cache};
}

bool of_filter(const std::string& pass) {
    return pass.starts_with("filter_");
}

// Updates the row's least times with a reading.
void take_times(SourceRow& row, const FrameReading& reading) {
    double occlusion = 0.0;
    double filter = 0.0;
    for (const PassTime& time : reading.passes) (of_filter(time.pass) ? filter : occlusion) += time.ms;
    row.occlusion_ms = std::min(row.occlusion_ms, occlusion);
    row.filter_ms = std::min(row.filter_ms, filter);
}

// Rows for the views of one radius each, visited in turn.
class Experiment {
  public:
    Experiment(const gpu::Device& device, const scene::PassLibrary& passes, const SourceOptions& options)
        : options_(options), study_(device, passes, options.extent) {}

    // views: for the row's radius. before: the views for the scene's own radius.
    void add(SourceRow row, BenchmarkViews& views, BenchmarkViews& before) {
        row.occlusion_ms = row.filter_ms = std::numeric_limits<double>::infinity();
        row.scene = before.scene().name;
        all_.push_back({std::move(row), &views, &before});
    }

    [[nodiscard]] std::vector<SourceRow> run() {
        const double steps = static_cast<double>(all_.size()) * (options_.rounds + 1);
        double done = 0.0;
        for (int round = 0; round <= options_.rounds; ++round) {
            for (Visited& one : all_) {
                visit(one, round);
                if (options_.progress) options_.progress(++done / steps);
            }
        }
        std::vector<SourceRow> rows;
        for (Visited& one : all_) rows.push_back(std::move(one.row));
        return rows;
    }

  private:
    struct Visited {
        SourceRow row;
        BenchmarkViews* views;
        BenchmarkViews* before;
    };

    void visit(Visited& one, int round) {
        SourceRow& row = one.row;
        const Settings settings = with_radius(row.settings, static_cast<float>(one.views->scene().ao_radius));
        const ConfigurationVisit visit = study_.visit(*one.views, settings, false, round);
        for (const FrameReading& reading : visit.readings) take_times(row, reading);
        if (!visit.quality) return;
        row.taken = visit.quality->samples;
        row.error = visit.quality->geometry;
        row.error_before = study_.visit(*one.before, settings, false, 0).quality->geometry;
    }

    const SourceOptions& options_;
    ConfigurationStudy study_;
    std::vector<Visited> all_;
};

// The method's defaults are the lengths of the paper's figure 3.
Settings of_table(const std::string& method, Filter filter) {
    Settings settings = measured_settings(method, table_taps, false);
    if (method == "issao_distinct")
        settings.samples_radius = preset_named("issao-figure3").settings.samples_radius;
    settings.history = false;
    settings.filter = filter;
    return settings;
}

// Errors of single frames of one view, without a filter.
class SampleSearch {
  public:
    SampleSearch(const gpu::Device& device, const scene::PassLibrary& passes, BenchmarkViews& views)
        : views_(&views), effect_(device, passes, views.frames().extent) {}

    // The settings with the fewest samples whose error more samples do not lower by a hundredth.
    [[nodiscard]] Settings found(Settings settings) {
        settings.filter = Filter::none;
        settings.history = false;
        std::vector<std::pair<std::uint32_t, double>> errors;
        for (std::uint32_t samples = unit_of(method_named(settings.method), settings.own.steps);
             samples <= most_samples; samples *= 2) {
            set_samples(settings, samples);
            errors.emplace_back(samples, error_of(occlusion(settings)));
        }
        double best = errors.back().second;
        for (const auto& [samples, error] : errors | std::views::reverse) {
            best = std::min(best, error);
            if (error > best / (1.0 - least_gain)) break;
            set_samples(settings, samples);
        }
        return settings;
    }

    [[nodiscard]] double remapped_error(const Settings& settings) {
        const std::vector<float> image = occlusion(settings);
        return error_of(remapped(image, best_remap(image, views_->scored(0).geometry)));
    }

  private:
    static constexpr double least_gain = 0.01;

    static void set_samples(Settings& settings, std::uint32_t samples) {
        settings.samples = settings.samples_converged = samples;
    }

    [[nodiscard]] std::vector<float> occlusion(const Settings& settings) {
        const Settings scaled = with_radius(settings, static_cast<float>(views_->scene().ao_radius));
        effect_.begin(views_->view(0, scaled), scaled);
        return effect_.next().occlusion;
    }

    [[nodiscard]] double error_of(const std::vector<float>& image) const {
        return errors_of(image, views_->scored(0).geometry).rmse;
    }

    BenchmarkViews* views_;
    AmbientOcclusion effect_;
};

Settings of_twice_the_samples(Settings settings) {
    settings.samples *= 2;
    settings.samples_converged = settings.samples;
    return settings;
}

}  // namespace

std::vector<SourceRow> study_issao_table(const gpu::Device& device, const scene::PassLibrary& passes,
                                         const scene::TruthCache& cache, const std::string& scene,
                                         const SourceOptions& options) {
    BenchmarkViews views = views_of(device, passes, cache, scene, 1.0, options);
    Experiment experiment(device, passes, options);
    for (const char* method : table_methods) {
        for (const auto& [filter, what] :
             {std::pair(Filter::none, "no filter"), {Filter::bilateral, "bilateral"}})
            experiment.add({.name = method, .what = what, .settings = of_table(method, filter)}, views,
                           views);
    }
    return experiment.run();
}

std::vector<SourceRow> study_quality(const gpu::Device& device, const scene::PassLibrary& passes,
                                     const scene::TruthCache& cache, const std::string& scene,
                                     const SourceOptions& options) {
    BenchmarkViews views = views_of(device, passes, cache, scene, 1.0, options);
    SampleSearch search(device, passes, views);
    Experiment experiment(device, passes, options);
    for (const char* name : quality_presets) {
        const Settings settings = search.found(preset_named(name).settings);
        experiment.add({.name = name, .what = "error no longer falls", .settings = settings}, views, views);
    }
    std::vector<SourceRow> rows = experiment.run();
    for (SourceRow& row : rows) row.error_remapped = search.remapped_error(row.settings);
    return rows;
}

std::vector<SourceRow> study_radius(const gpu::Device& device, const scene::PassLibrary& passes,
                                    const scene::TruthCache& cache, const std::string& scene,
                                    const SourceOptions& options) {
    BenchmarkViews own = views_of(device, passes, cache, scene, 1.0, options);
    BenchmarkViews twice = views_of(device, passes, cache, scene, 2.0, options);
    Experiment experiment(device, passes, options);
    for (const char* name : study_presets) {
        const Settings settings = preset_named(name).settings;
        experiment.add({.name = name, .what = "as it is", .settings = settings}, own, own);
        experiment.add({.name = name, .what = "radius doubled", .settings = settings, .radius = 2.0}, twice,
                       own);
        experiment.add({.name = name,
                        .what = "radius and samples doubled",
                        .settings = of_twice_the_samples(settings),
                        .radius = 2.0},
                       twice, own);
    }
    return experiment.run();
}

}  // namespace gloam::effect

// SPDX-License-Identifier: MIT
#include "effect/study/source_study.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "effect/presets.hpp"
#include "effect/study/benchmark_views.hpp"
#include "effect/study/configuration_study.hpp"

namespace gloam::effect {
namespace {

constexpr std::array table_methods{"hbao_study", "crytek", "alchemy", "issao_distinct"};
constexpr std::uint32_t table_taps = 12;
constexpr std::array study_presets{"crytek-performance", "filion-performance",     "hbao-performance",
                                   "angle-performance",  "volumetric-performance", "alchemy-performance"};

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

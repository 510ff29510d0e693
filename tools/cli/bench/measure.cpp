// SPDX-License-Identifier: MIT
#include "cli/bench/measure.hpp"

#include <fmt/format.h>

#include <map>

#include "cli/bench/configurations.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/environment.hpp"
#include "cli/progress.hpp"
#include "experiment/configuration_study.hpp"
#include "report/benchmark/journal.hpp"

namespace gloam::cli {
namespace {

constexpr int most_scored = 8;

experiment::BenchmarkFrames frames_of(const BenchmarkOptions& options) {
    return {.extent = image_size(options.size),
            .frames = options.frames,
            .scored = std::min(most_scored, std::max(1, options.frames / 2)),
            .rays = options.rays};
}

report::JournalSetup setup_of(const experiment::BenchmarkFrames& frames, const gpu::DeviceInfo& device) {
    return {.device = device.name,
            .driver = device.driver,
            .width = frames.extent.width,
            .height = frames.extent.height,
            .frames = frames.frames,
            .scored = frames.scored,
            .rays = frames.rays};
}

report::Quality quality_of(const experiment::FrameQuality& found) {
    return {.raw_geometry = found.raw_geometry,
            .raw_depth = found.raw_depth,
            .geometry = found.geometry,
            .depth = found.depth,
            .similarity = found.similarity,
            .flicker = found.flicker.value_or(report::Quality::unknown),
            .samples = found.samples,
            .memory_bytes = found.memory_bytes};
}

report::Visit visit_of(const report::Configuration& configuration, int round,
                       const experiment::ConfigurationVisit& found) {
    report::Visit visit{.configuration = configuration, .round = round};
    if (found.quality) visit.quality = quality_of(*found.quality);
    for (const experiment::FrameReading& reading : found.readings) {
        report::Reading kept{.copy_ms = reading.copy_ms};
        for (const effect::PassTime& time : reading.passes) kept.passes.emplace_back(time.pass, time.ms);
        visit.readings.push_back(std::move(kept));
    }
    return visit;
}

std::map<std::string, experiment::BenchmarkViews> views_of(const BenchmarkOptions& options,
                                                           const experiment::BenchmarkFrames& frames,
                                                           const gpu::Device& device,
                                                           const scene::PassLibrary& passes) {
    const scene::TruthCache cache(truth_cache_directory());
    std::map<std::string, experiment::BenchmarkViews> views;
    for (const std::string& name : options.scenes) {
        views.try_emplace(name, device, passes, scene::make_scene(name), frames, cache,
                          progress_bar(name + ", truth"));
    }
    return views;
}

// A visit that is due and not in the journal.
struct Due {
    const MeasuredConfiguration* what = nullptr;
    int round = 0;
};

std::vector<Due> due_visits(const std::vector<MeasuredConfiguration>& all, int rounds, int scored,
                            const report::Journal& journal) {
    std::vector<Due> due;
    for (int round = 0; round <= rounds; ++round) {
        for (const MeasuredConfiguration& one : all) {
            if (experiment::ConfigurationStudy::due(one.configuration.temporal, round, scored) &&
                !journal.has(one.configuration, round))
                due.push_back({&one, round});
        }
    }
    return due;
}

}  // namespace

report::Benchmark measured_benchmark(const BenchmarkOptions& options, const gpu::Device& device,
                                     const scene::PassLibrary& passes) {
    const std::vector<MeasuredConfiguration> all = configurations_of(options);
    const experiment::BenchmarkFrames frames = frames_of(options);
    experiment::ConfigurationStudy study(device, passes, frames.extent);
    report::Journal journal(options.out.empty() ? options.out : options.out / "journal.jsonl",
                            setup_of(frames, device.info()), options.resume);
    const std::vector<Due> due = due_visits(all, options.repeat, frames.scored, journal);
    if (!due.empty()) {
        auto views = views_of(options, frames, device, passes);
        const auto progress = progress_bar("benchmark");
        for (std::size_t i = 0; i < due.size(); ++i) {
            const auto& [one, round] = due[i];
            experiment::BenchmarkViews& scene = views.at(one->configuration.scene);
            const effect::Settings settings =
                with_radius(one->settings, static_cast<float>(scene.scene().ao_radius));
            journal.add(visit_of(one->configuration, round,
                                 study.visit(scene, settings, one->configuration.temporal, round)));
            progress(static_cast<double>(i + 1) / static_cast<double>(due.size()));
        }
    }
    report::Benchmark benchmark{.device = device.info().name,
                                .driver = device.info().driver,
                                .width = frames.extent.width,
                                .height = frames.extent.height,
                                .frames = frames.frames,
                                .scored = frames.scored,
                                .repeat = options.repeat,
                                .rays = frames.rays,
                                .copy_ms = journal.copies()};
    for (const MeasuredConfiguration& one : all) benchmark.rows.push_back(journal.row_of(one.configuration));
    return benchmark;
}

}  // namespace gloam::cli

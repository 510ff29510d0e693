// SPDX-License-Identifier: MIT
#include "cli/bench/temporal.hpp"

#include <fmt/format.h>

#include <memory>

#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/progress.hpp"
#include "effect/presets.hpp"
#include "effect/study/limit.hpp"
#include "effect/study/motion_study.hpp"
#include "scene/truth_cache.hpp"

namespace gloam::cli {
namespace {

using namespace effect;

void print_motion(const MotionStudy& study) {
    const auto line = [](const std::string& name, const std::vector<Score>& scores, std::size_t first, double time,
                         const MotionRun* run) {
        const Score sum = total(scores, first);
        fmt::print("{:34}", name);
        for (const Against a : {Against::limit, Against::geometry})
            for (const PixelClass c : {PixelClass::settled, PixelClass::young, PixelClass::disoccluded, PixelClass::near_moving, PixelClass::all})
                fmt::print(" {:.4f}/{:.4f}", sum.rmse_raw(a, c), sum.rmse_filtered(a, c));
        fmt::print(" t {:.2f}", time);
        if (run) for (double f : run->flicker) fmt::print(" {:.5f}", f);
        fmt::print("\n");
    };
    const std::size_t first = study.frames.size() / 4;
    line("single", study.single, first, 0, nullptr);
    line("still", study.still, first, 0, nullptr);
    for (const MotionRun& run : study.runs) line(run.variant.name, run.scores, first, time_ratio(run, study.runs[0]), &run);
}

}  // namespace

int run_bench_temporal(const BenchTemporalOptions& options) {
    const gpu::Device device({.device = options.device, .validation = options.validation ? gpu::Validation::on : gpu::Validation::off, .cache_directory = cache_directory()});
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const gpu::Extent extent{192, 108};
    const scene::TruthCache cache(cache_directory().empty() ? "" : cache_directory() / "truth");
    for (const std::string& name : options.scenes) {
        const scene::Scene scene = scene::make_scene(name);
        const Settings settings = with_radius(preset_named(options.preset).settings, static_cast<float>(scene.ao_radius));
        const auto sequence = sequence_of(device, passes, scene, extent, options.frames);
        Limit limit(device, passes, extent);
        const auto truth = [&](int frame, const SequenceFrame& f) {
            const scene::TruthSettings ts{.rays = {.radius = scene.ao_radius, .rays = options.rays}};
            return References{truth_from(f.view, limit.of(f.view, settings)), truth_from(f.view, cache.depth(f.view, ts).occlusion),
                              truth_from(f.view, cache.geometry(scene, frame, f.view, ts).occlusion)};
        };
        const auto study = study_motion(device, passes, sequence, ablations_of(settings), truth, {.every = options.every, .progress = progress_bar(name)});
        fmt::print("{}\n", name);
        print_motion(study);
    }
    return 0;
}

void add_bench_temporal(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchTemporalOptions>();
    CLI::App* command = bench.add_subcommand("temporal", "the temporal effect, still and moving, and each mechanism switched off alone");
    command->add_option("--scene", options->scenes, "scenes");
    command->add_option("--preset", options->preset, "preset");
    command->add_option("--frames", options->frames, "frames");
    command->add_option("--every", options->every, "frames from one that is scored to the next");
    command->add_option("--rays", options->rays, "rays of the truth for each pixel");
    add_driver_option(*command);
    command->callback([options, &status] { status = run_bench_temporal(*options); });
}

}  // namespace gloam::cli

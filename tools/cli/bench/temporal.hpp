// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "effect/study/motion_study.hpp"
#include "effect/study/still_study.hpp"
#include "gpu/device.hpp"
#include "report/output.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench temporal`.
struct BenchTemporalOptions {
    std::vector<std::string> scenes{"moving", "columns"};
    std::string preset = "paper";
    std::string size = "192x108";
    int frames = 48;        // of the moving scene
    int still_frames = 32;  // of its first view alone
    int every = 4;          // every how many frames one is scored
    int rays = 256;         // of the truth, for each pixel
    bool quick = false;
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path out;   // empty: no pictures
};

// Measures the temporal effect on moving and still scenes, and prints the results. Returns the exit status:
// 0, or 1 if the validation layers reported messages.
[[nodiscard]] int run_bench_temporal(BenchTemporalOptions options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_temporal(CLI::App& bench, int& status);

// The results of one scene.
struct TemporalReport {
    std::string scene;
    std::string preset;
    gpu::DeviceInfo device;
    gpu::Extent extent;
    double weight_max = 0.0;  // of the full effect
    std::vector<effect::StillFrame> still;
    effect::MotionStudy motion;
};

// A requirement, and the measured value.
struct Criterion {
    std::string what;
    double measured = 0.0;  // NaN where the scene has no such pixels
    double allowed = 0.0;
};
[[nodiscard]] std::vector<Criterion> criteria_of(const TemporalReport& report);

// Tables as Markdown: criteria, convergence, errors by class for each mechanism that is switched off.
[[nodiscard]] std::string to_markdown(const TemporalReport& report);

// All scenes, with every number of every frame.
[[nodiscard]] std::string to_json(const std::vector<TemporalReport>& reports);

// Curves of error (SVG), and the last frame's images (PNG): occlusion, error, convergence, samples kept;
// their names begin with the scene's. Throws std::runtime_error when gnuplot is missing.
void write_pictures(report::OutputFolder& folder, const TemporalReport& report);

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/bench/page_blocks.hpp"
#include "effect/study/method_study.hpp"
#include "gpu/device.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench methods`.
struct BenchMethodsOptions {
    std::vector<std::string> scenes{"columns", "corner", "knot"};
    std::vector<std::string> methods;  // empty: all
    std::string size = "192x108";
    int pixels = 257;  // of a side of the views in closed form, odd
    int frames = 8;    // of them, of 1,024 samples
    int rays = 256;    // of the truth, for each pixel
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path out;   // empty: no pictures
    std::filesystem::path page;  // page whose tables are replaced; empty: none
};

// Compares all methods on closed-form views and on scenes, and prints the tables. Returns the exit status: 0,
// or 1 if the validation layers reported messages.
[[nodiscard]] int run_bench_methods(const BenchMethodsOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_methods(CLI::App& bench, int& status);

// The results of one configuration: on views, and on scenes in the order of MethodsReport::scenes.
struct MethodRow {
    effect::MethodConfiguration configuration;
    std::vector<effect::ViewResult> views;
    std::vector<effect::SceneResult> scenes;
};

struct MethodsReport {
    gpu::DeviceInfo device;
    gpu::Extent extent;  // of the scenes' images
    int pixels = 0;      // of a side of the views
    std::vector<std::string> scenes;
    std::vector<effect::Metrics>
        depth;  // of each scene: the truth of its depth buffer against that of its geometry
    std::vector<MethodRow> rows;
};

// Tables as Markdown, for the blocks of a page: what methods estimate, their results on closed-form views,
// the differences from the truth, their errors on scenes, and the paths of their pictures.
[[nodiscard]] std::vector<PageBlock> to_blocks(const MethodsReport& report);

// All numbers as JSON.
[[nodiscard]] std::string to_json(const MethodsReport& report);

// The file of a picture; what: a method's name, "truth" or "depth".
[[nodiscard]] std::string picture_name(const std::string& scene, const std::string& what);

}  // namespace gloam::cli

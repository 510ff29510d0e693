// SPDX-License-Identifier: MIT
#include "cli/bench.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/bench/experiments.hpp"
#include "cli/bench/framework.hpp"
#include "cli/names.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "report/output.hpp"

namespace gloam::cli {
namespace {

struct FrameworkOptions {
    int repeat = 5;
    std::string device;
    bool validation = false;
    std::filesystem::path json;
};

int run_framework(const FrameworkOptions& options) {
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const std::vector<Figure> figures =
        framework_figures(options.device, options.repeat, progress_bar("framework"));
    nlohmann::ordered_json document{{"versions", versions()},
                                    {"device", device.info().name},
                                    {"framework", nlohmann::ordered_json::array()}};
    fmt::print("| figure | value |\n| --- | --- |\n");
    for (const Figure& figure : figures) {
        fmt::print("| {} | {:.4g} {} |\n", figure.name, figure.value, figure.unit);
        document["framework"].push_back(
            {{"name", figure.name}, {"unit", figure.unit}, {"value", figure.value}});
    }
    json.write(document.dump(2) + "\n");
    return validation_status(device);
}

void add_framework(CLI::App& bench, int& status) {
    auto options = std::make_shared<FrameworkOptions>();
    CLI::App* command = bench.add_subcommand("framework", "what the shader-test framework itself costs");
    command->add_option("--repeat", options->repeat, "rounds, whose medians are printed")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->callback([options, &status] { status = run_framework(*options); });
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
    CLI::App* group =
        app.add_subcommand("bench", "time against error: which method with how many samples, on this device");
    group->require_subcommand(0, 1);
    add_experiments(*group, status);
    add_framework(*group, status);
}

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#include "cli/bench/passes.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/bench/image_size.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/versions.hpp"
#include "effect/study/pass_study.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;

scene::Inputs inputs_named(const std::string& name) {
    if (name == "sampled") return scene::Inputs::sampled;
    if (name == "storage") return scene::Inputs::storage;
    return scene::Inputs::by_device;
}

std::string pass_table(const effect::PassStudy& study) {
    std::string text = "| state | | pass | copies |\n|---|---|---|--:|\n";
    for (const effect::PassCost& copy : study.history_copies)
        text += fmt::format("| history, {} | one texel read and one written | copy | {:.2f} |\n", copy.pass,
                            copy.copies);
    for (const effect::PassCosts& row : study.cases) {
        for (const effect::PassCost& cost : row.passes)
            text += fmt::format("| {} | {} | {} | {:.2f} |\n", row.pass_case.name, row.pass_case.what,
                                cost.pass, cost.copies);
    }
    return text;
}

// `named`: the key of the passes' names in the file.
ordered_json costs_json(const std::vector<effect::PassCost>& costs, const char* named) {
    ordered_json passes = ordered_json::array();
    for (const effect::PassCost& cost : costs)
        passes.push_back({{named, cost.pass}, {"ms", cost.ms}, {"copies", cost.copies}});
    return passes;
}

ordered_json pass_json(const effect::PassStudy& study) {
    ordered_json cases = ordered_json::array();
    for (const effect::PassCosts& row : study.cases)
        cases.push_back({{"state", row.pass_case.name},
                         {"what", row.pass_case.what},
                         {"passes", costs_json(row.passes, "pass")}});
    return cases;
}

}  // namespace

int run_bench_passes(const BenchPassesOptions& options) {
    const gpu::Extent extent = image_size(options.size);
    const report::OutputFile json(options.json);
    gpu::Device device = open_device(options.device, options.validation);
    const scene::PassLibrary passes =
        scene::PassLibrary(glsl_directory(), cache_directory()).reading(inputs_named(options.inputs));
    const effect::PassStudy study = effect::study_passes(device, passes, extent, options.rounds);
    fmt::print("{}, {} x {} pixels, a copy takes {:.3f} ms\n\n{}", device.info().name, extent.width,
               extent.height, study.copy_ms, pass_table(study));
    const ordered_json document{
        {"versions", versions()},   {"device", device.info().name},
        {"width", extent.width},    {"height", extent.height},
        {"copy_ms", study.copy_ms}, {"history_copies", costs_json(study.history_copies, "precision")},
        {"cases", pass_json(study)}};
    json.write(document.dump(2) + "\n");
    return validation_status(device);
}

void add_bench_passes(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchPassesOptions>();
    CLI::App* command = bench.add_subcommand("passes", "cost of each pass of a frame, in copies");
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command->add_option("--rounds", options->rounds, "over all states of the history")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--inputs", options->inputs,
                     "images that passes only read: sampled, storage, or device (storage on a CPU)")
        ->check(CLI::IsMember({"device", "sampled", "storage"}))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->callback([options, &status] { status = run_bench_passes(*options); });
}

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "effect/method_functions.hpp"
#include "record/output.hpp"
#include "stress/run.hpp"

namespace gloam::cli {
namespace {

// The options of `gloam stress`.
struct StressOptions {
    std::string only;                    // name of one run; empty: all
    std::vector<std::string> equations;  // none: all
    std::string device;                  // name or index; empty: the default
    std::uint64_t seed = 1;
    std::uint64_t frames = 1'000'000;
    bool brief = false;
    bool validation = false;
    std::filesystem::path json;
};

// Shows one line on a terminal, which is overwritten; prints nothing elsewhere.
void show_progress(const std::string& text) {
    if (on_terminal()) fmt::print(stderr, "\r\033[K{}", text);
}

// Each row is printed as it is found.
stress::Rows make_runs(const std::vector<stress::Run>& runs, stress::Context context) {
    stress::Rows all;
    std::size_t printed = 0;  // rows of this run
    context.found = [&](const stress::Row& row) {
        context.progress("");
        fmt::print("{}\n", stress::table_line(row));
        std::fflush(stdout);
        ++printed;
    };
    for (const stress::Run& run : runs) {
        printed = 0;
        const stress::Rows rows = run.go(context);
        while (printed < rows.size()) context.found(rows[printed]);
        all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
}

int run_stress(const StressOptions& options) {
    const std::vector<stress::Run> runs = stress::select_runs(options.only);
    (void)catalogue::select(catalogue::all_entries(glsl_directory()),
                            options.equations);  // invalid names are reported before anything runs
    const record::OutputFile json(options.json);
    require_good_drivers();
    const effect::MethodFunctions methods;
    const check::Lab lab({.device = options.device,
                          .validation = options.validation,
                          .include_roots = {glsl_directory(), data_directory("stress"), methods.folder()},
                          .cache_directory = cache_directory()});
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const gpu::DeviceInfo& device = lab.device().info();
    fmt::print("device: {} ({})\n{}\n", device.name, device.driver, stress::table_header());
    const stress::Rows rows = make_runs(runs, {.lab = lab,
                                               .passes = passes,
                                               .brief = options.brief,
                                               .seed = options.seed,
                                               .frames = options.frames,
                                               .equations = options.equations,
                                               .progress = show_progress});
    const auto broken = std::ranges::count_if(rows, [](const stress::Row& row) { return !row.passed(); });
    fmt::print("{} numbers, {} bounds broken\n", rows.size(), broken);
    json.write(stress::to_json(device, rows, versions()));
    return broken == 0 ? 0 : 1;
}

}  // namespace

Command stress_command() {
    static StressOptions options;
    std::string runs;
    for (const stress::Run& run : stress::all_runs) runs += (runs.empty() ? "" : ", ") + run.name;
    return {.name = "stress",
            .about = "test long runs, far places, invalid buffers and worst inputs against the documentation",
            .options =
                {{"--only", &options.only, "one run: " + runs},
                 {"--equation", &options.equations,
                  "search the worst inputs of these only: by any name of equations (gloam list equations)"},
                 {"--seed", &options.seed, "seed of noise and points"},
                 {"--frames", &options.frames, between(4, 1e9), "frames of the long runs"},
                 {"--brief", &options.brief, "fewer inputs and places"},
                 {"--json", &options.json, "write the numbers to this file"},
                 device_option(options.device),
                 validation_option(options.validation),
                 driver_option()},
            .run = [] { return run_stress(options); },
            .examples =
                "  gloam stress --brief                           seconds instead of minutes\n"
                "  gloam stress --only worst-inputs --equation 'TSSAO-*'\n"};
}

}  // namespace gloam::cli

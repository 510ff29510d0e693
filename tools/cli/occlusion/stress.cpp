// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ranges>
#include <stdexcept>

#include "base/version.hpp"
#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "effect/method_functions.hpp"
#include "record/members.hpp"
#include "record/output.hpp"
#include "stress/run.hpp"

namespace gloam::stress {

template <class Io>
void members(Io& io, Row& row) {
    record::each(io, "run", row.run, "varied", row.varied, "quantity", row.quantity, "measured", row.measured,
                 "bound", row.bound, "passed", row.passed());
}

}  // namespace gloam::stress

namespace gloam::cli {
namespace {

// The options of `gloam stress`.
struct StressOptions {
    std::string only;  // name of one run; empty: all
    stress::Scope scope;
    std::string device;  // name or index; empty: the default
    bool validation = false;
    std::filesystem::path json;
};

// One way to stress the library: `name` is one word. Another one is another line here.
struct Run {
    std::string name;
    std::vector<void (*)(const stress::Context&)> parts;
};
const std::vector<Run> all_runs{
    {"worst-inputs", {stress::worst_inputs}},
    {"long-run", {stress::long_run}},
    {"far", {stress::far_away}},
    {"poison", {stress::poisoned_passes, stress::poisoned_gathers, stress::poisoned_history}}};

std::string run_names() {
    return fmt::format("{}", fmt::join(all_runs | std::views::transform(&Run::name), ", "));
}

constexpr const char* layout = "{:9} {:58} {:50} {:>11} {:>11} {}\n";

void print(const stress::Row& row) {
    const std::string bound = row.bound ? fmt::format("{:.4g}", *row.bound) : "-";
    fmt::print(layout, row.run, row.varied, row.quantity, fmt::format("{:.4g}", row.measured), bound,
               !row.bound     ? "measured"
               : row.passed() ? "ok"
                              : "BROKEN");
    std::fflush(stdout);
}

// Shows one line on a terminal, which is overwritten; prints nothing elsewhere.
void show_progress(const std::string& text) {
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K{}", text);
}

// {"gloam", "device": {"name", "driver"}, "versions", "rows": [{"run", "varied", "quantity", "measured",
// "bound", "passed"}]}. bound is null where nothing is promised; "inf", "-inf" and "nan" are strings.
std::string to_json(const backend::DeviceInfo& device, const std::vector<stress::Row>& rows) {
    return record::to_text({{"gloam", base::version()},
                            {"device", {{"name", device.name}, {"driver", device.driver}}},
                            {"versions", versions()},
                            {"rows", record::json_of(rows)}});
}

int run_stress(const StressOptions& options) {
    const bool known = options.only.empty() || std::ranges::count(all_runs, options.only, &Run::name) > 0;
    if (!known)
        throw std::invalid_argument(
            fmt::format("unknown stress run \"{}\": expected {}", options.only, run_names()));
    (void)catalogue::select(catalogue::all_entries(glsl_directory()),
                            options.scope.equations);  // invalid names are reported before anything runs
    const record::OutputFile json(options.json);
    require_good_drivers();
    const effect::MethodFunctions methods;
    const subject::Lab lab({.device = options.device,
                            .validation = options.validation,
                            .include_roots = {glsl_directory(), data_directory("stress"), methods.folder()},
                            .cache_directory = cache_directory()});
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const backend::DeviceInfo& device = lab.device().info();
    fmt::print("device: {} ({})\n", device.name, device.driver);
    fmt::print(layout, "run", "varied", "measured", "value", "bound", "verdict");
    std::vector<stress::Row> rows;
    stress::Context context{.lab = lab, .passes = passes, .scope = options.scope};
    context.found = [&](const stress::Row& row) {
        show_progress("");
        print(row);
        rows.push_back(row);
    };
    context.progress = [&](const std::string& what) { show_progress(context.run + ": " + what); };
    for (const Run& run : all_runs) {
        context.run = run.name;
        if (options.only.empty() || options.only == run.name)
            for (const auto& part : run.parts) part(context);
    }
    const auto broken = std::ranges::count_if(rows, [](const stress::Row& row) { return !row.passed(); });
    fmt::print("{} numbers, {} bounds broken\n", rows.size(), broken);
    json.write(to_json(device, rows));
    return broken == 0 ? 0 : 1;
}

}  // namespace

Command stress_command() {
    static StressOptions options;
    return {.name = "stress",
            .about = "test long runs, far places, invalid buffers and worst inputs against the documentation",
            .options =
                {{"--only", &options.only, "one run: " + run_names()},
                 {"--equation", &options.scope.equations,
                  "search the worst inputs of these only: by any name of equations (gloam list equations)"},
                 {"--seed", &options.scope.seed, "seed of noise and points"},
                 {"--frames", &options.scope.frames, between(4, 1e9), "frames of the long runs"},
                 {"--brief", &options.scope.brief, "fewer inputs and places"},
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

// SPDX-License-Identifier: MIT
#include "cli/check.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/variant.hpp"
#include "report/check_report.hpp"
#include "report/output_file.hpp"
#include "report/row_of.hpp"

namespace gloam::cli {
namespace {

std::vector<std::string> devices_to_check(const std::string& device) {
    if (device != "all") return {device};
    std::vector<std::string> all;
    for (const gpu::DeviceInfo& info : gpu::list_devices()) all.push_back(std::to_string(info.index));
    if (all.empty()) all.emplace_back();  // opening the default then says that there is none
    return all;
}

report::DeviceSummary summary_of(const gpu::DeviceInfo& info) {
    return {.name = info.name,
            .driver = info.driver,
            .type = info.type,
            .api_version = info.api_version,
            .preserves_signed_zero_inf_nan = info.float32.preserves_signed_zero_inf_nan,
            .preserves_denormals = info.float32.preserves_denormals,
            .flushes_denormals = info.float32.flushes_denormals,
            .rounds_to_even = info.float32.rounds_to_even};
}

check::Lab make_lab(const CheckOptions& options, const std::string& device, const Variant& variant) {
    return check::Lab({.device = device,
                       .validation = options.validation,
                       .include_roots = {glsl_directory()},
                       .cache_directory = cache_directory(),
                       .optimization = variant.optimization});
}

report::CheckRow check_equation(const check::Lab& lab, const catalogue::Entry& entry, const Variant& variant,
                                const CheckOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    report::CheckRow row;
    try {
        row = report::row_of(
            entry.description.id, variant.name,
            check::run(lab, entry.check_case, {.inputs = options.inputs, .seed = options.seed}));
    } catch (const std::exception& error) {
        row = {.equation = entry.description.id,
               .function = entry.description.function,
               .file = entry.description.file,
               .variant = variant.name,
               .error = error.what(),
               .reason = report::Reason::error};
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
}

void print_failure(const report::CheckRow& row) {
    fmt::print("\n{} {}: {}\n", row.equation, row.variant, row.ran() ? row.story : row.error);
}

report::CheckReport check_device(const CheckOptions& options, const std::string& device,
                                 const catalogue::Entries& entries) {
    report::CheckReport report;
    for (const Variant& variant : select_variants(options.variant)) {
        const check::Lab lab = make_lab(options, device, variant);
        if (report.rows.empty()) {
            report.device = summary_of(lab.device().info());
            fmt::print("device: {} ({})\n{}\n", report.device.name, report.device.driver,
                       report::table_header());
        }
        for (const catalogue::Entry& entry : entries) {
            report.rows.push_back(check_equation(lab, entry, variant, options));
            fmt::print("{}\n", report::table_line(report.rows.back()));
            std::fflush(stdout);
        }
    }
    return report;
}

}  // namespace

int run_check(const CheckOptions& options) {
    const catalogue::Entries entries = catalogue::select(catalogue::all_entries(), options.equations);
    report::OutputFile json(options.json);
    report::OutputFile junit(options.junit);
    std::vector<report::CheckReport> reports;
    std::size_t failures = 0;
    std::size_t checks = 0;
    for (const std::string& device : devices_to_check(options.device)) {
        reports.push_back(check_device(options, device, entries));
        failures += reports.back().failures();
        checks += reports.back().rows.size();
    }
    for (const report::CheckReport& report : reports) {
        for (const report::CheckRow& row : report.rows) {
            if (!row.passed()) print_failure(row);
        }
    }
    fmt::print("{} checks, {} failed\n", checks, failures);
    json.write(report::to_json(reports));
    junit.write(report::to_junit(reports));
    return failures == 0 ? 0 : 1;
}

void add_check(CLI::App& app, int& status) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "run equations on a Vulkan device and judge every result");
    command->add_option("equation", options->equations, "IDs, functions or globs (all when none is given)");
    command->add_option("--device", options->device, "name or index of the device, or all");
    command
        ->add_option("--variant", options->variant,
                     "how the shaders are compiled (gloam list variants), or all")
        ->capture_default_str();
    command->add_option("--inputs", options->inputs, "inputs for each equation")
        ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "seed of the inputs")->capture_default_str();
    command->add_flag("--validation", options->validation,
                      "Vulkan validation layers on; any message fails the check");
    command->add_option("--json", options->json, "write the results to this file");
    command->add_option("--junit", options->junit, "write the results as JUnit XML");
    command->callback([options, &status] { status = run_check(*options); });
}

}  // namespace gloam::cli

// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "check/audit.hpp"
#include "cli/check/checker.hpp"
#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "interpreter/program.hpp"
#include "report/audit_report.hpp"
#include "report/output.hpp"
#include "shader/include.hpp"

namespace gloam::cli {
namespace {

struct AuditCommand {
    std::filesystem::path file;
    std::vector<std::string> functions;
    std::vector<std::string> ranges;
    std::vector<std::string> includes;
    std::string json;
    std::string html;
    check::AuditOptions options;
};

int run_audit(const AuditCommand& command) {
    const OwnFile own = own_file(command.file.string(), command.functions, command.ranges, command.includes);
    for (const check::LeftOut& function : own.functions.left_out)
        fmt::print("{}\n", base::one_line(fmt::format("{}: {} was left out: {}", command.file.string(),
                                                      function.name, function.why)));
    if (own.functions.found.empty())
        throw std::runtime_error(fmt::format("{}: nothing was audited", command.file.string()));
    const std::string text = shader::read_text(command.file);
    const auto roots = include_roots_of(std::filesystem::absolute(command.file), command.includes);
    const check::Lab lab(
        {.device = std::string(check::interpreter_name),
         .include_roots = roots,
         .cache_directory = cache_directory(),
         .excerpts =
             shader::excerpts({std::filesystem::absolute(command.file).string(), text}, roots).functions});
    const report::OutputFile json(command.json);
    const report::OutputFile html(command.html);
    report::AuditReport report{.file = command.file.string(), .source = text, .audits = {}};
    int status = 0;
    for (const check::OwnFunction& function : own.functions.found) {
        try {
            report.audits.push_back(check::audit(lab, command.file.filename().string(), function, text,
                                                 ranges_from(command.ranges), command.options));
            fmt::print("{}\n", to_text(report.audits.back()));
            if (report.audits.back().is_broken()) status = 1;
        } catch (const interpreter::Error& error) {
            throw std::runtime_error(
                fmt::format("{}: {}: {}", command.file.string(), function.name, error.what()));
        }
    }
    if (!command.json.empty()) json.write(to_audit_json(report));
    if (!command.html.empty()) html.write(to_audit_page(report));
    return status;
}

}  // namespace

void add_audit(CLI::App& app, int& status) {
    auto command = std::make_shared<AuditCommand>();
    CLI::App* audit = app.add_subcommand(
        "audit",
        "show where a shader function itself goes wrong: NaN, lost digits, jumps, what drivers may do");
    audit->add_option("file", command->file, "a GLSL file")->required();
    audit->add_option("function", command->functions, "functions that it defines (all when none is given)");
    audit->add_option("--range", command->ranges, "NAME=LOW:HIGH: what a parameter is drawn from");
    add_include_option(*audit, command->includes);
    audit->add_option("--inputs", command->options.inputs, "inputs for each function, half of them by search")
        ->check(CLI::Range(std::size_t{2}, std::size_t{10'000'000}))
        ->capture_default_str();
    audit->add_option("--seed", command->options.seed, "seed of the inputs")->capture_default_str();
    audit->add_option("--json", command->json, "file for all results");
    audit->add_option("--html", command->html,
                      "file for a page: the source coloured by what its lines lose, worst inputs, rewrites");
    audit->callback([command, &status] { status = run_audit(*command); });
}

}  // namespace gloam::cli
